//! Any bytes as input of `hostile::lcp`.
#![no_main]

#[path = "../../tests/hostile/mod.rs"]
mod hostile;
#[allow(dead_code)]
#[path = "../../tests/lcp_oracle/mod.rs"]
mod lcp_oracle;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let _ = hostile::lcp::solve(bytes);
});
