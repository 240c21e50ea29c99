//! C interface: see `include/arcless_loop.h`, which says what each function does.

use crate::pointers::{c_string, list, list_mut, null, text, without_panic};
use arcless_device::{Causality, Failure, Kind, Stepper};
use std::ffi::{CString, c_char, c_int, c_uint};

/// Version of the interface: changes with any change that old programs would notice.
pub const VERSION: c_uint = 1;
/// Number that is of no variable.
const NONE: c_uint = c_uint::MAX;

/// Device with the texts that C programs read.
pub struct Loop {
    stepper: Stepper,
    names: Vec<CString>,
    units: Vec<CString>,
    descriptions: Vec<CString>,
    message: CString,
}

/// Code of a result: 0, or the kind of a failure. Kinds that only the FMI has have a code too.
fn code(kind: Kind) -> c_int {
    match kind {
        Kind::Data => 1,
        Kind::Value => 2,
        Kind::Time => 3,
        Kind::Step => 4,
        Kind::NotOffered => 5,
    }
}
/// Fault of the library.
const FAULT: c_int = 9;

unsafe fn with(device: *mut Loop, work: impl FnOnce(&mut Loop) -> Result<(), Failure>) -> c_int {
    // SAFETY: null, or a device of `arcless_loop_open` that nothing else uses meanwhile.
    let Some(device) = (unsafe { device.as_mut() }) else {
        return code(Kind::Value);
    };
    match without_panic(|| work(device)) {
        Ok(Ok(())) => 0,
        Ok(Err(failure)) => {
            device.message = c_string(&failure.message);
            code(failure.kind)
        }
        Err(message) => {
            device.message = c_string(&message);
            FAULT
        }
    }
}

/// Version of the interface.
#[unsafe(no_mangle)]
pub extern "C" fn arcless_loop_version() -> c_uint {
    VERSION
}

/// Device of a file, or null and a message.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn arcless_loop_open(
    version: c_uint,
    path: *const c_char,
    message: *mut c_char,
    room: usize,
) -> *mut Loop {
    // SAFETY: null, or a string that ends with a zero.
    let path = unsafe { text(path) };
    let opened = without_panic(|| open(version, path));
    let reason = match opened.and_then(|found| found) {
        Ok(made) => return Box::into_raw(Box::new(made)),
        Err(reason) => c_string(&reason),
    };
    // SAFETY: null, or room for that many characters.
    if let Some(out) = unsafe { list_mut(message.cast::<u8>(), room) } {
        let bytes = reason.as_bytes();
        let count = bytes.len().min(room.saturating_sub(1));
        if room > 0 {
            out[..count].copy_from_slice(&bytes[..count]);
            out[count] = 0;
        }
    }
    std::ptr::null_mut()
}

fn open(version: c_uint, path: Option<&str>) -> Result<Loop, String> {
    if version != VERSION {
        return Err(format!(
            "the program was compiled for version {version} of the interface, the library has \
             {VERSION}: compile it again with the header of the library"
        ));
    }
    let path = path.ok_or("the path is no text in UTF-8")?;
    let bytes = std::fs::read(path).map_err(|error| format!("`{path}`: {error}"))?;
    let stepper = Stepper::open(&bytes).map_err(|failure| format!("`{path}`: {failure}"))?;
    let texts = |read: fn(&arcless_device::Variable) -> &str| {
        let variables = stepper.variables().iter();
        variables.map(|v| c_string(read(v))).collect::<Vec<_>>()
    };
    Ok(Loop {
        names: texts(|v| &v.name),
        units: texts(|v| v.unit),
        descriptions: texts(|v| &v.description),
        message: CString::default(),
        stepper,
    })
}

/// Frees a device.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn arcless_loop_close(device: *mut Loop) {
    if !device.is_null() {
        // SAFETY: it came from `arcless_loop_open`, and is not used again.
        drop(unsafe { Box::from_raw(device) });
    }
}

/// Message of the last failure; empty without one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn arcless_loop_message(device: *const Loop) -> *const c_char {
    // SAFETY: null, or a device.
    match unsafe { device.as_ref() } {
        Some(device) => device.message.as_ptr(),
        None => c"no device: a null pointer".as_ptr(),
    }
}

/// Number of variables.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn arcless_loop_count(device: *const Loop) -> c_uint {
    // SAFETY: null, or a device.
    unsafe { device.as_ref() }.map_or(0, |device| device.names.len() as c_uint)
}

/// Number of the variable with a name, or `ARCLESS_LOOP_NONE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn arcless_loop_find(device: *const Loop, name: *const c_char) -> c_uint {
    // SAFETY: null, or a device and a string that ends with a zero.
    let (device, name) = unsafe { (device.as_ref(), text(name)) };
    let (Some(device), Some(name)) = (device, name) else {
        return NONE;
    };
    device
        .stepper
        .find(name)
        .map_or(NONE, |number| number as c_uint)
}

/// Texts of variables.
macro_rules! texts {
    ($($function:ident: $field:ident;)*) => {$(
        #[doc = concat!("Text of a variable: one of the ", stringify!($field), "; null for none.")]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $function(device: *const Loop, number: c_uint) -> *const c_char {
            // SAFETY: null, or a device.
            let device = unsafe { device.as_ref() };
            let found = device.and_then(|device| device.$field.get(number as usize));
            found.map_or(std::ptr::null(), |text| text.as_ptr())
        }
    )*};
}

texts! {
    arcless_loop_name: names;
    arcless_loop_unit: units;
    arcless_loop_description: descriptions;
}

/// Role of a variable; -1 for none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn arcless_loop_role(device: *const Loop, number: c_uint) -> c_int {
    // SAFETY: null, or a device.
    let device = unsafe { device.as_ref() };
    let found = device.and_then(|device| device.stepper.variables().get(number as usize));
    found.map_or(-1, |variable| match variable.causality {
        Causality::Independent => 0,
        Causality::Input => 1,
        Causality::Output => 2,
        Causality::Constant => 3,
    })
}

/// Length of a step, s; 0 for no device.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn arcless_loop_step_length(device: *const Loop) -> f64 {
    // SAFETY: null, or a device.
    unsafe { device.as_ref() }.map_or(0.0, |device| device.stepper.step_length())
}

/// Sets inputs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn arcless_loop_set(
    device: *mut Loop,
    numbers: *const c_uint,
    values: *const f64,
    count: usize,
) -> c_int {
    let work = |device: &mut Loop| {
        // SAFETY: null, or arrays of that many elements.
        let (numbers, values) = unsafe { (list(numbers, count), list(values, count)) };
        let (Some(numbers), Some(values)) = (numbers, values) else {
            return Err(null("arcless_loop_set"));
        };
        let mut pairs = numbers.iter().zip(values);
        pairs.try_for_each(|(&number, &value)| device.stepper.set(number as usize, value))
    };
    // SAFETY: as the header has it.
    unsafe { with(device, work) }
}

/// Gets values.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn arcless_loop_get(
    device: *mut Loop,
    numbers: *const c_uint,
    values: *mut f64,
    count: usize,
) -> c_int {
    let work = |device: &mut Loop| {
        // SAFETY: null, or arrays of that many elements.
        let (numbers, values) = unsafe { (list(numbers, count), list_mut(values, count)) };
        let (Some(numbers), Some(values)) = (numbers, values) else {
            return Err(null("arcless_loop_get"));
        };
        let mut pairs = numbers.iter().zip(values);
        pairs.try_for_each(|(&number, value)| {
            *value = device.stepper.get(number as usize)?;
            Ok(())
        })
    };
    // SAFETY: as the header has it.
    unsafe { with(device, work) }
}

/// Takes a step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn arcless_loop_step(device: *mut Loop) -> c_int {
    // SAFETY: as the header has it.
    unsafe { with(device, |device| device.stepper.step()) }
}

/// Saves the state where there is room for it; `size` becomes its size in any case.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn arcless_loop_save(
    device: *mut Loop,
    bytes: *mut u8,
    room: usize,
    size: *mut usize,
) -> c_int {
    let work = |device: &mut Loop| {
        let saved = device.stepper.save()?;
        // SAFETY: null, or a place for a number; null, or room for that many bytes.
        let (size, bytes) = unsafe { (size.as_mut(), list_mut(bytes, room)) };
        let (Some(size), Some(bytes)) = (size, bytes) else {
            return Err(null("arcless_loop_save"));
        };
        *size = saved.len();
        if let Some(out) = bytes.get_mut(..saved.len()) {
            out.copy_from_slice(&saved);
            return Ok(());
        }
        if room == 0 {
            return Ok(()); // the size alone is asked for
        }
        let message = format!("{room} bytes for a state of {}", saved.len());
        Err(Failure::data(message))
    };
    // SAFETY: as the header has it.
    unsafe { with(device, work) }
}

/// Restores a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn arcless_loop_restore(
    device: *mut Loop,
    bytes: *const u8,
    size: usize,
) -> c_int {
    let work = |device: &mut Loop| {
        // SAFETY: null, or an array of that many bytes.
        let bytes = unsafe { list(bytes, size) };
        device
            .stepper
            .restore(bytes.ok_or_else(|| null("arcless_loop_restore"))?)
    };
    // SAFETY: as the header has it.
    unsafe { with(device, work) }
}

/// Returns to the start.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn arcless_loop_reset(device: *mut Loop) -> c_int {
    // SAFETY: as the header has it.
    unsafe { with(device, |device| device.stepper.reset()) }
}
