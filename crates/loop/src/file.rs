//! File of an exported model: a header, and the model in `postcard`.
//!
//! | bytes | what |
//! | --- | --- |
//! | 8 | `ARCLOOP` and a byte 1A, at which text tools stop |
//! | 4 | number of the format |
//! | 16 | digest of the rest: FNV-1a with 128 bits |
//! | 8 | length of the rest |
//! | … | the model |
//!
//! Numbers are little-endian. The digest tells a damaged file from a whole one, and one model from
//! another: a description and a saved state belong to it.

use crate::failure::Failure;
use crate::model::Model;

/// Number of the format, which changes with every change of the model's data.
pub const FORMAT: u32 = 1;
const MAGIC: [u8; 8] = *b"ARCLOOP\x1a";
const HEADER: usize = 36;

/// Digest of bytes: FNV-1a (Fowler, Noll & Vo) with 128 bits.
#[must_use]
pub fn digest(bytes: &[u8]) -> u128 {
    const BASIS: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
    let mix = |hash: u128, byte: &u8| (hash ^ u128::from(*byte)).wrapping_mul(PRIME);
    bytes.iter().fold(BASIS, mix)
}

/// Digest as text, in the form of a GUID.
#[must_use]
pub fn token(digest: u128) -> String {
    let hex = format!("{digest:032x}");
    let [a, b, c, d, e] = [
        &hex[..8],
        &hex[8..12],
        &hex[12..16],
        &hex[16..20],
        &hex[20..],
    ];
    format!("{{{a}-{b}-{c}-{d}-{e}}}")
}

/// Bytes with a header, from which [`contents`] returns them.
#[must_use]
pub fn wrap(body: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(HEADER + body.len());
    bytes.extend(MAGIC);
    bytes.extend(FORMAT.to_le_bytes());
    bytes.extend(digest(body).to_le_bytes());
    bytes.extend((body.len() as u64).to_le_bytes());
    bytes.extend(body);
    bytes
}

/// Digest and bytes behind a header.
///
/// # Errors
/// [`Failure`]: no file of this kind, another format, cut off or damaged.
pub fn contents(bytes: &[u8]) -> Result<(u128, &[u8]), Failure> {
    let whole = (bytes.len() >= HEADER).then(|| bytes.split_at(HEADER));
    let Some((header, body)) = whole.filter(|_| bytes.starts_with(&MAGIC)) else {
        let message = "no model of `arcless fmu export`: it does not begin as one";
        return Err(Failure::data(message));
    };
    let number = |from: usize, count: usize| {
        let bytes = header[from..from + count].iter().rev();
        bytes.fold(0_u128, |sum, byte| (sum << 8) | u128::from(*byte))
    };
    let (format, expected, length) = (number(8, 4), number(12, 16), number(28, 8));
    if format != u128::from(FORMAT) {
        return Err(Failure::data(format!(
            "the model has format {format}, this library reads {FORMAT}: export it again with \
             the version that the library is of"
        )));
    }
    if length != body.len() as u128 {
        return Err(Failure::data(format!(
            "the model is cut off: it has {} bytes, expected {length}",
            body.len()
        )));
    }
    if digest(body) != expected {
        let message = "the model was changed after its export: its digest is another one; \
                       export it again";
        return Err(Failure::data(message));
    }
    Ok((expected, body))
}

/// File of a model.
///
/// # Errors
/// [`Failure`] when it cannot be written as bytes.
pub fn pack(model: &Model) -> Result<Vec<u8>, Failure> {
    let body = postcard::to_allocvec(model);
    let body = body.map_err(|error| Failure::data(format!("the model cannot be written: {error}")));
    Ok(wrap(&body?))
}

/// Digest and model of a file.
///
/// # Errors
/// As [`contents`], or a model that another version wrote.
pub fn unpack(bytes: &[u8]) -> Result<(u128, Model), Failure> {
    let (digest, body) = contents(bytes)?;
    let model: Model = postcard::from_bytes(body)
        .map_err(|error| Failure::data(format!("the model cannot be read: {error}")))?;
    if model.version != env!("CARGO_PKG_VERSION") {
        return Err(Failure::data(format!(
            "the model is from Arcless {}, this library from {}: export it again",
            model.version,
            env!("CARGO_PKG_VERSION")
        )));
    }
    Ok((digest, model))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Published test values of FNV-1a with 128 bits: of nothing, and of "a".
    #[test]
    fn digests_are_those_published() {
        assert_eq!(digest(b""), 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d);
        assert_eq!(digest(b"a"), 0xd228_cb69_6f1a_8caf_7891_2b70_4e4a_8964);
        assert_eq!(
            token(digest(b"a")),
            "{d228cb69-6f1a-8caf-7891-2b704e4a8964}"
        );
    }

    #[test]
    fn what_is_wrapped_comes_back() {
        let bytes = wrap(b"a model");
        assert_eq!(contents(&bytes), Ok((digest(b"a model"), &b"a model"[..])));
    }

    /// Every single byte that changes is noticed, and every length that is too short.
    #[test]
    fn damage_is_noticed() {
        let bytes = wrap(b"a model");
        for place in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[place] ^= 4;
            assert!(contents(&damaged).is_err(), "byte {place}");
            assert!(contents(&bytes[..place]).is_err(), "{place} bytes");
        }
    }
}
