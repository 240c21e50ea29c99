//! Functions of FMI 3.0 for co-simulation that do something.

use crate::calls::{
    deserialize, free, free_state, get, new, restore, save, serialize, serialized_size, set, with,
};
use crate::instance::{Instance, Log, Status};
use crate::pointers::{c_string, text};
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
    unsafe { with(component, |_: &mut Instance3| Ok(())) }
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
    new(resources, token, log)
}

/// Frees an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(component: *mut c_void) {
    // SAFETY: as the standard has it.
    unsafe { free::<Log3>(component) }
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
    unsafe {
        with(component, |instance: &mut Instance3| {
            instance.begin(Some(start_time))
        })
    }
}

/// Ends the initialization.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3ExitInitializationMode(component: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, Instance3::end_initialization) }
}

/// Ends the simulation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Terminate(component: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, Instance3::terminate) }
}

/// Returns to the start.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Reset(component: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, Instance3::reset) }
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
    let (numbers, values) = ((references, count), (values, value_count));
    // SAFETY: as the standard has it.
    unsafe { get::<Log3>(component, "fmi3GetFloat64", numbers, values) }
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
    let (numbers, values) = ((references, count), (values, value_count));
    // SAFETY: as the standard has it.
    unsafe { set::<Log3>(component, "fmi3SetFloat64", numbers, values) }
}

/// Saves the state, into the memory of an older one where there is one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFMUState(component: *mut c_void, state: *mut *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { save::<Log3>(component, "fmi3GetFMUState", state) }
}

/// Restores a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFMUState(component: *mut c_void, state: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { restore::<Log3>(component, "fmi3SetFMUState", state) }
}

/// Frees a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeFMUState(
    component: *mut c_void,
    state: *mut *mut c_void,
) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { free_state::<Log3>(component, state) }
}

/// Gets the size of a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializedFMUStateSize(
    component: *mut c_void,
    state: *mut c_void,
    size: *mut usize,
) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { serialized_size::<Log3>(component, "fmi3SerializedFMUStateSize", state, size) }
}

/// Copies a state to bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializeFMUState(
    component: *mut c_void,
    state: *mut c_void,
    bytes: *mut u8,
    size: usize,
) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { serialize::<Log3>(component, "fmi3SerializeFMUState", state, (bytes, size)) }
}

/// Makes a state of bytes; it is checked when it is restored.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DeserializeFMUState(
    component: *mut c_void,
    bytes: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { deserialize::<Log3>(component, "fmi3DeserializeFMUState", (bytes, size), state) }
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
