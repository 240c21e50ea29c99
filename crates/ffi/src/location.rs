//! Where the resources of an FMU are, as a path or as a URI (RFC 3986, RFC 8089).

use std::path::PathBuf;

/// Name of the exported model among the resources.
pub const MODEL: &str = "model.loop";

/// Path of the model in the folder that an importer names: `file:///…`, `file:/…`, or a path.
///
/// # Errors
/// A message for a URI that is no local file.
pub fn model_path(location: &str) -> Result<PathBuf, String> {
    let Some(rest) = location.strip_prefix("file:") else {
        if location.contains("://") {
            return Err(refusal(location));
        }
        return Ok(PathBuf::from(location).join(MODEL));
    };
    let path = match rest.strip_prefix("//") {
        None => rest,
        Some(with_host) => {
            let from = with_host.find('/').unwrap_or(with_host.len());
            let (host, path) = with_host.split_at(from);
            if !host.is_empty() && host != "localhost" {
                return Err(refusal(location));
            }
            path
        }
    };
    let decoded = decode(path).ok_or_else(|| refusal(location))?;
    Ok(PathBuf::from(without_slash_before_drive(&decoded)).join(MODEL))
}

fn refusal(location: &str) -> String {
    format!(
        "the resources of the FMU are at `{location}`: expected a folder of this machine, as a \
         path or as file:///PATH"
    )
}

/// Text with its %XX replaced; `None` where that is no text.
fn decode(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, others @ ..] = rest {
        if *first == b'%' {
            let digits = std::str::from_utf8(others.get(..2)?).ok()?;
            bytes.push(u8::from_str_radix(digits, 16).ok()?);
            rest = &others[2..];
        } else {
            bytes.push(*first);
            rest = others;
        }
    }
    String::from_utf8(bytes).ok()
}

/// `C:/…` of `/C:/…`, as URIs have paths of Windows.
fn without_slash_before_drive(path: &str) -> &str {
    match path.as_bytes() {
        [b'/', drive, b':', ..] if drive.is_ascii_alphabetic() => &path[1..],
        _ => path,
    }
}

#[cfg(test)]
mod tests {
    use super::{MODEL, model_path};
    use std::path::Path;

    fn folder(location: &str) -> String {
        let path = model_path(location).expect("a place");
        assert_eq!(path.file_name(), Some(MODEL.as_ref()));
        path.parent()
            .map_or_else(String::new, |p: &Path| p.display().to_string())
    }

    #[test]
    fn places_are_found_from_paths_and_uris() {
        for (location, expected) in [
            ("/tmp/a b/resources", "/tmp/a b/resources"),
            ("/tmp/x/resources/", "/tmp/x/resources"),
            ("file:///tmp/a%20b/resources", "/tmp/a b/resources"),
            ("file:/tmp/x", "/tmp/x"),
            ("file://localhost/tmp/x", "/tmp/x"),
            ("file:///tmp/%C3%BC", "/tmp/ü"),
            ("file:///C:/Users/x", "C:/Users/x"),
        ] {
            assert_eq!(folder(location), expected, "{location}");
        }
    }

    #[test]
    fn other_machines_are_refused() {
        for location in [
            "https://x.org/y",
            "file://server/share",
            "file:///a%2",
            "file:///a%zz",
        ] {
            assert!(model_path(location).is_err(), "{location}");
        }
    }
}
