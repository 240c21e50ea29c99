//! Functions of FMI 3.0 for co-simulation that do something.

use crate::fmi2::{ERROR, null, write_state};
use crate::instance::{Instance, Log, Saved, Status};
use crate::pointers::{c_string, list, list_mut, text};
use arcless_device::Failure;
use std::ffi::{c_char, c_int, c_uint, c_void};

/// Function of an importer for messages.
pub type Logger = unsafe extern "C" fn(*mut c_void, c_int, *const c_char, *const c_char);

/// Log of an importer.
#[derive(Debug)]
pub struct Log3 {
    logger: Option<Logger>,
    environment: *mut c_void,
}

impl Log for Log3 {
    fn message(&self, status: Status, message: &str) {
        let Some(logger) = self.logger else { return };
        let (category, message) = (c_string(status.category()), c_string(message));
        // SAFETY: the importer gave its function and what it wants to be called with.
        unsafe {
            logger(
                self.environment,
                status as c_int,
                category.as_ptr(),
                message.as_ptr(),
            );
        }
    }
}

/// Instance of FMI 3.0.
pub type Instance3 = Instance<Log3>;

/// Does something with an instance.
///
/// # Safety
/// Null, or an instance of [`fmi3InstantiateCoSimulation`] that nothing else uses meanwhile.
pub(crate) unsafe fn with(
    component: *mut c_void,
    work: impl FnOnce(&mut Instance3) -> Result<(), Failure>,
) -> c_int {
    // SAFETY: the caller has an instance for itself.
    match unsafe { component.cast::<Instance3>().as_mut() } {
        Some(instance) => instance.attempt(work) as c_int,
        None => ERROR,
    }
}

/// Version of the FMI.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

/// Switches debug messages; there are none, failures are always said.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetDebugLogging(
    component: *mut c_void,
    _on: u8,
    _count: usize,
    _categories: *const *const c_char,
) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, |_| Ok(())) }
}

/// Makes an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    _name: *const c_char,
    token: *const c_char,
    resources: *const c_char,
    _visible: u8,
    _logging_on: u8,
    _event_mode_used: u8,
    _early_return_allowed: u8,
    _intermediate_variables: *const c_uint,
    _intermediate_count: usize,
    environment: *mut c_void,
    logger: Option<Logger>,
    _intermediate_update: *mut c_void,
) -> *mut c_void {
    let log = Log3 {
        logger,
        environment,
    };
    // SAFETY: the importer passes strings that end with a zero.
    let (token, resources) = unsafe { (text(token), text(resources)) };
    let made = Instance::open(
        resources.unwrap_or_default(),
        token.unwrap_or_default(),
        log,
    );
    made.map_or(std::ptr::null_mut(), |made| {
        Box::into_raw(Box::new(made)).cast()
    })
}

/// Frees an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(component: *mut c_void) {
    if !component.is_null() {
        // SAFETY: it came from `fmi3InstantiateCoSimulation`, and is not used again.
        drop(unsafe { Box::from_raw(component.cast::<Instance3>()) });
    }
}

/// Begins the initialization at a time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterInitializationMode(
    component: *mut c_void,
    _tolerance_defined: u8,
    _tolerance: f64,
    start_time: f64,
    _stop_time_defined: u8,
    _stop_time: f64,
) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, |instance| instance.begin(Some(start_time))) }
}

/// Ends the initialization.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3ExitInitializationMode(component: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, Instance::end_initialization) }
}

/// Ends the simulation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Terminate(component: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, Instance::terminate) }
}

/// Returns to the start.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Reset(component: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, Instance::reset) }
}

/// Gets values.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFloat64(
    component: *mut c_void,
    references: *const c_uint,
    count: usize,
    values: *mut f64,
    value_count: usize,
) -> c_int {
    let work = |instance: &mut Instance3| {
        // SAFETY: the importer has arrays of that many elements.
        let (numbers, values) = unsafe { (list(references, count), list_mut(values, value_count)) };
        let (Some(numbers), Some(values)) = (numbers, values) else {
            return Err(null("fmi3GetFloat64"));
        };
        instance.get(numbers, values)
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Sets inputs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFloat64(
    component: *mut c_void,
    references: *const c_uint,
    count: usize,
    values: *const f64,
    value_count: usize,
) -> c_int {
    let work = |instance: &mut Instance3| {
        // SAFETY: the importer has arrays of that many elements.
        let (numbers, values) = unsafe { (list(references, count), list(values, value_count)) };
        let (Some(numbers), Some(values)) = (numbers, values) else {
            return Err(null("fmi3SetFloat64"));
        };
        instance.set(numbers, values)
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Saves the state, into the memory of an older one where there is one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFMUState(component: *mut c_void, state: *mut *mut c_void) -> c_int {
    let work = |instance: &mut Instance3| {
        // SAFETY: the importer has a place for a state.
        let place = unsafe { state.as_mut() }.ok_or_else(|| null("fmi3GetFMUState"))?;
        let saved = instance.save()?;
        // SAFETY: null, or a state that came from here.
        match unsafe { place.cast::<Saved>().as_mut() } {
            Some(older) => *older = saved,
            None => *place = Box::into_raw(Box::new(saved)).cast(),
        }
        Ok(())
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Restores a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFMUState(component: *mut c_void, state: *mut c_void) -> c_int {
    let work = |instance: &mut Instance3| {
        // SAFETY: null, or a state that came from here.
        let saved = unsafe { state.cast::<Saved>().as_ref() };
        instance.restore(saved.ok_or_else(|| null("fmi3SetFMUState"))?)
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Frees a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeFMUState(
    component: *mut c_void,
    state: *mut *mut c_void,
) -> c_int {
    let work = |_: &mut Instance3| {
        // SAFETY: null, or a place with null or a state that came from here.
        let Some(place) = (unsafe { state.as_mut() }) else {
            return Ok(());
        };
        if !place.is_null() {
            // SAFETY: it came from `fmi3GetFMUState`, and the importer gets null in its place.
            drop(unsafe { Box::from_raw(place.cast::<Saved>()) });
            *place = std::ptr::null_mut();
        }
        Ok(())
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Gets the size of a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializedFMUStateSize(
    component: *mut c_void,
    state: *mut c_void,
    size: *mut usize,
) -> c_int {
    let work = |_: &mut Instance3| {
        // SAFETY: a state that came from here, and a place for a number.
        let (saved, size) = unsafe { (state.cast::<Saved>().as_ref(), size.as_mut()) };
        let (Some(saved), Some(size)) = (saved, size) else {
            return Err(null("fmi3SerializedFMUStateSize"));
        };
        *size = saved.len();
        Ok(())
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Copies a state to bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializeFMUState(
    component: *mut c_void,
    state: *mut c_void,
    bytes: *mut u8,
    size: usize,
) -> c_int {
    let work = |_: &mut Instance3| {
        // SAFETY: a state that came from here, and an array of that many bytes.
        let (saved, bytes) = unsafe { (state.cast::<Saved>().as_ref(), list_mut(bytes, size)) };
        let (Some(saved), Some(bytes)) = (saved, bytes) else {
            return Err(null("fmi3SerializeFMUState"));
        };
        write_state(saved, bytes)
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Makes a state of bytes; it is looked at when it is restored.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DeserializeFMUState(
    component: *mut c_void,
    bytes: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> c_int {
    let work = |_: &mut Instance3| {
        // SAFETY: an array of that many bytes, and a place for a state.
        let (bytes, place) = unsafe { (list(bytes, size), state.as_mut()) };
        let (Some(bytes), Some(place)) = (bytes, place) else {
            return Err(null("fmi3DeserializeFMUState"));
        };
        let saved: Saved = bytes.to_vec();
        *place = Box::into_raw(Box::new(saved)).cast();
        Ok(())
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Takes a communication step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DoStep(
    component: *mut c_void,
    from: f64,
    length: f64,
    _no_state_before: u8,
    event_handling_needed: *mut bool,
    terminate_simulation: *mut bool,
    early_return: *mut bool,
    last_successful_time: *mut f64,
) -> c_int {
    let work = |instance: &mut Instance3| {
        let taken = instance.advance(from, length);
        for flag in [event_handling_needed, terminate_simulation, early_return] {
            // SAFETY: null, or the importer has a place for a flag.
            if let Some(flag) = unsafe { flag.as_mut() } {
                *flag = false;
            }
        }
        // SAFETY: null, or the importer has a place for a number.
        if let Some(time) = unsafe { last_successful_time.as_mut() } {
            *time = instance.stepper.time();
        }
        taken
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}
