//! Strings and lists from C, and panics on their way there.

use arcless_device::{Failure, Kind};
use std::any::Any;
use std::ffi::{CStr, CString, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Text of a C string; `None` for a null pointer or text that is not UTF-8.
///
/// # Safety
/// Null, or a string that ends with a zero and lives as long as the result is used.
#[must_use]
pub unsafe fn text<'a>(string: *const c_char) -> Option<&'a str> {
    if string.is_null() {
        return None;
    }
    // SAFETY: the caller has a string that ends with a zero.
    unsafe { CStr::from_ptr(string) }.to_str().ok()
}

/// List of a C array; empty for no elements, `None` for a null pointer with some.
///
/// # Safety
/// Null, or an array of `count` elements that lives as long as the result is used.
#[must_use]
pub unsafe fn list<'a, T>(first: *const T, count: usize) -> Option<&'a [T]> {
    if count == 0 {
        return Some(&[]);
    }
    if first.is_null() {
        return None;
    }
    // SAFETY: the caller has an array of that many elements.
    Some(unsafe { std::slice::from_raw_parts(first, count) })
}

/// List of a C array to write to, as [`list`].
///
/// # Safety
/// As [`list`], and nothing else reads or writes it meanwhile.
#[must_use]
pub unsafe fn list_mut<'a, T>(first: *mut T, count: usize) -> Option<&'a mut [T]> {
    if count == 0 {
        return Some(&mut []);
    }
    if first.is_null() {
        return None;
    }
    // SAFETY: the caller has an array of that many elements for itself.
    Some(unsafe { std::slice::from_raw_parts_mut(first, count) })
}

/// Failure of a function that was given a null pointer.
#[must_use]
pub fn null(function: &str) -> Failure {
    Failure::new(Kind::Value, format!("{function}: a null pointer"))
}

/// C string of a text; what comes after a zero in it is left out.
#[must_use]
pub fn c_string(text: &str) -> CString {
    let whole = text.split('\0').next().unwrap_or_default();
    CString::new(whole).unwrap_or_default()
}

/// Result of a function, or the message of its panic.
///
/// # Errors
/// The message.
pub fn without_panic<T>(function: impl FnOnce() -> T) -> Result<T, String> {
    silence_panics();
    catch_unwind(AssertUnwindSafe(function)).map_err(|panic| message_of(&*panic))
}

fn message_of(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(ToString::to_string);
    let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
    let reason = text.unwrap_or_else(|| "without a message".into());
    format!("a fault in Arcless itself, please report it: {reason}")
}

/// Keeps panics of this library from printing; they are reported by status and message.
fn silence_panics() {
    #[cfg(not(test))]
    {
        static ONCE: std::sync::Once = std::sync::Once::new();
        ONCE.call_once(|| std::panic::set_hook(Box::new(|_| {})));
    }
}
