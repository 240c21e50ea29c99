//! Bodies of the functions that FMI 2.0 and 3.0 have in common. Each version gives them its log,
//! and the name of the function for messages.

use crate::instance::{Instance, Log, Saved, Status};
use crate::pointers::{list, list_mut, null};
use arcless_device::Failure;
use std::ffi::{c_int, c_uint, c_void};

/// Status of a function that was given no instance.
const ERROR: c_int = Status::Error as c_int;

/// Does something with an instance.
///
/// # Safety
/// Null, or an instance of [`new`] with the same log that nothing else uses meanwhile.
pub(crate) unsafe fn with<L: Log>(
    component: *mut c_void,
    work: impl FnOnce(&mut Instance<L>) -> Result<(), Failure>,
) -> c_int {
    // SAFETY: the caller has an instance for itself.
    match unsafe { component.cast::<Instance<L>>().as_mut() } {
        Some(instance) => instance.attempt(work) as c_int,
        None => ERROR,
    }
}

/// Makes an instance from the folder of its resources and the token of the description; null after
/// a message to the log.
pub(crate) fn new<L: Log>(location: Option<&str>, token: Option<&str>, log: L) -> *mut c_void {
    let made = Instance::open(location.unwrap_or_default(), token.unwrap_or_default(), log);
    made.map_or(std::ptr::null_mut(), |made| {
        Box::into_raw(Box::new(made)).cast()
    })
}

/// Frees an instance.
///
/// # Safety
/// Null, or an instance of [`new`] with the same log that is not used again.
pub(crate) unsafe fn free<L: Log>(component: *mut c_void) {
    if !component.is_null() {
        // SAFETY: it came from `new`, and is not used again.
        drop(unsafe { Box::from_raw(component.cast::<Instance<L>>()) });
    }
}

/// Gets the values of variables: arrays of numbers and of values, each with its length.
///
/// # Safety
/// The conditions of [`with`] hold, and the arrays have these lengths.
pub(crate) unsafe fn get<L: Log>(
    component: *mut c_void,
    name: &str,
    (references, count): (*const c_uint, usize),
    (values, value_count): (*mut f64, usize),
) -> c_int {
    let work = |instance: &mut Instance<L>| {
        // SAFETY: the importer has arrays of that many elements.
        let (numbers, values) = unsafe { (list(references, count), list_mut(values, value_count)) };
        let (Some(numbers), Some(values)) = (numbers, values) else {
            return Err(null(name));
        };
        instance.get(numbers, values)
    };
    // SAFETY: as the caller has it.
    unsafe { with(component, work) }
}

/// Sets inputs: arrays of numbers and of values, each with its length.
///
/// # Safety
/// The conditions of [`with`] hold, and the arrays have these lengths.
pub(crate) unsafe fn set<L: Log>(
    component: *mut c_void,
    name: &str,
    (references, count): (*const c_uint, usize),
    (values, value_count): (*const f64, usize),
) -> c_int {
    let work = |instance: &mut Instance<L>| {
        // SAFETY: the importer has arrays of that many elements.
        let (numbers, values) = unsafe { (list(references, count), list(values, value_count)) };
        let (Some(numbers), Some(values)) = (numbers, values) else {
            return Err(null(name));
        };
        instance.set(numbers, values)
    };
    // SAFETY: as the caller has it.
    unsafe { with(component, work) }
}

/// Saves the state, into the memory of an older one where there is one.
///
/// # Safety
/// The conditions of [`with`] hold, and `state` is null or a place with null or a state that came
/// from here.
pub(crate) unsafe fn save<L: Log>(
    component: *mut c_void,
    name: &str,
    state: *mut *mut c_void,
) -> c_int {
    let work = |instance: &mut Instance<L>| {
        // SAFETY: the importer has a place for a state.
        let place = unsafe { state.as_mut() }.ok_or_else(|| null(name))?;
        let saved = instance.save()?;
        // SAFETY: null, or a state that came from here.
        match unsafe { place.cast::<Saved>().as_mut() } {
            Some(older) => *older = saved,
            None => *place = Box::into_raw(Box::new(saved)).cast(),
        }
        Ok(())
    };
    // SAFETY: as the caller has it.
    unsafe { with(component, work) }
}

/// Restores a state.
///
/// # Safety
/// The conditions of [`with`] hold, and `state` is null or a state that came from here.
pub(crate) unsafe fn restore<L: Log>(
    component: *mut c_void,
    name: &str,
    state: *mut c_void,
) -> c_int {
    let work = |instance: &mut Instance<L>| {
        // SAFETY: null, or a state that came from here.
        let saved = unsafe { state.cast::<Saved>().as_ref() };
        instance.restore(saved.ok_or_else(|| null(name))?)
    };
    // SAFETY: as the caller has it.
    unsafe { with(component, work) }
}

/// Frees a state; the importer gets null in its place.
///
/// # Safety
/// The conditions of [`with`] hold, and `state` is null or a place with null or a state that came
/// from here.
pub(crate) unsafe fn free_state<L: Log>(component: *mut c_void, state: *mut *mut c_void) -> c_int {
    let work = |_: &mut Instance<L>| {
        // SAFETY: null, or a place with null or a state that came from here.
        let Some(place) = (unsafe { state.as_mut() }) else {
            return Ok(());
        };
        if !place.is_null() {
            // SAFETY: it came from `save` or `deserialize`.
            drop(unsafe { Box::from_raw(place.cast::<Saved>()) });
            *place = std::ptr::null_mut();
        }
        Ok(())
    };
    // SAFETY: as the caller has it.
    unsafe { with(component, work) }
}

/// Gets the size of a state in bytes.
///
/// # Safety
/// The conditions of [`with`] hold; `state` is null or a state that came from here, `size` null or
/// a place for a number.
pub(crate) unsafe fn serialized_size<L: Log>(
    component: *mut c_void,
    name: &str,
    state: *mut c_void,
    size: *mut usize,
) -> c_int {
    let work = |_: &mut Instance<L>| {
        // SAFETY: a state that came from here, and a place for a number.
        let (saved, size) = unsafe { (state.cast::<Saved>().as_ref(), size.as_mut()) };
        let (Some(saved), Some(size)) = (saved, size) else {
            return Err(null(name));
        };
        *size = saved.len();
        Ok(())
    };
    // SAFETY: as the caller has it.
    unsafe { with(component, work) }
}

/// Copies a state to an array of bytes that has room for it.
///
/// # Safety
/// The conditions of [`with`] hold; `state` is null or a state that came from here, and the array
/// has this length.
pub(crate) unsafe fn serialize<L: Log>(
    component: *mut c_void,
    name: &str,
    state: *mut c_void,
    (bytes, size): (*mut u8, usize),
) -> c_int {
    let work = |_: &mut Instance<L>| {
        // SAFETY: a state that came from here, and an array of that many bytes.
        let (saved, bytes) = unsafe { (state.cast::<Saved>().as_ref(), list_mut(bytes, size)) };
        let (Some(saved), Some(bytes)) = (saved, bytes) else {
            return Err(null(name));
        };
        let Some(room) = bytes.get_mut(..saved.len()) else {
            let message = format!("{size} bytes for a state of {}", saved.len());
            return Err(Failure::data(message));
        };
        room.copy_from_slice(saved);
        Ok(())
    };
    // SAFETY: as the caller has it.
    unsafe { with(component, work) }
}

/// Makes a state of bytes; it is checked when it is restored.
///
/// # Safety
/// The conditions of [`with`] hold; the array has this length, and `state` is null or a place for
/// a state.
pub(crate) unsafe fn deserialize<L: Log>(
    component: *mut c_void,
    name: &str,
    (bytes, size): (*const u8, usize),
    state: *mut *mut c_void,
) -> c_int {
    let work = |_: &mut Instance<L>| {
        // SAFETY: an array of that many bytes, and a place for a state.
        let (bytes, place) = unsafe { (list(bytes, size), state.as_mut()) };
        let (Some(bytes), Some(place)) = (bytes, place) else {
            return Err(null(name));
        };
        let saved: Saved = bytes.to_vec();
        *place = Box::into_raw(Box::new(saved)).cast();
        Ok(())
    };
    // SAFETY: as the caller has it.
    unsafe { with(component, work) }
}
