//! Any bytes as input of `hostile::border`.
#![no_main]

#[path = "../../tests/hostile/mod.rs"]
mod hostile;
#[allow(dead_code)]
#[path = "../../tests/lcp_oracle/mod.rs"]
mod lcp_oracle;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let _ = hostile::border::cross(bytes);
});
