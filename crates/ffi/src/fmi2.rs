//! Functions of FMI 2.0 for co-simulation that do something.

use crate::calls::{
    deserialize, free, free_state, get, new, restore, save, serialize, serialized_size, set, with,
};
use crate::instance::{Instance, Log, Phase, Status};
use crate::pointers::{c_string, text};
use arcless_device::{Failure, Kind};
use std::ffi::{CString, c_char, c_int, c_uint, c_void};

/// Function of an importer for messages.
pub type Logger =
    unsafe extern "C" fn(*mut c_void, *const c_char, c_int, *const c_char, *const c_char, ...);

/// Functions of an importer.
#[repr(C)]
#[derive(Debug)]
pub struct Callbacks {
    logger: Option<Logger>,
    allocate_memory: Option<unsafe extern "C" fn(usize, usize) -> *mut c_void>,
    free_memory: Option<unsafe extern "C" fn(*mut c_void)>,
    step_finished: Option<unsafe extern "C" fn(*mut c_void, c_int)>,
    environment: *mut c_void,
}

/// Log of an importer.
#[derive(Debug)]
pub struct Log2 {
    logger: Option<Logger>,
    environment: *mut c_void,
    name: CString,
}

impl Log for Log2 {
    fn message(&self, status: Status, message: &str) {
        let Some(logger) = self.logger else { return };
        let category = c_string(status.category());
        // The logger takes a format; not all importers do as it says.
        let message = c_string(&message.replace('%', " per cent"));
        // SAFETY: the importer gave its function and what it wants to be called with.
        unsafe {
            logger(
                self.environment,
                self.name.as_ptr(),
                status as c_int,
                category.as_ptr(),
                message.as_ptr(),
            );
        }
    }
}

/// Instance of FMI 2.0.
pub type Instance2 = Instance<Log2>;

const OK: c_int = Status::Ok as c_int;
const CO_SIMULATION: c_int = 1;
/// Kinds of status that are asked for: whether a step is done, the last time reached, the end.
const DO_STEP: c_int = 0;
const LAST_SUCCESSFUL_TIME: c_int = 2;
const TERMINATED: c_int = 3;

/// Name of the types that pointers are to: the usual ones.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

/// Version of the FMI.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

/// Switches debug messages; there are none, failures are always said.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetDebugLogging(
    component: *mut c_void,
    _on: c_int,
    _count: usize,
    _categories: *const *const c_char,
) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, |_: &mut Instance2| Ok(())) }
}

/// Makes an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Instantiate(
    name: *const c_char,
    kind: c_int,
    guid: *const c_char,
    location: *const c_char,
    callbacks: *const Callbacks,
    _visible: c_int,
    _logging_on: c_int,
) -> *mut c_void {
    // SAFETY: the importer passes null or functions, and strings that end with a zero.
    let (callbacks, name, guid, location) =
        unsafe { (callbacks.as_ref(), text(name), text(guid), text(location)) };
    let log = Log2 {
        logger: callbacks.and_then(|c| c.logger),
        environment: callbacks.map_or(std::ptr::null_mut(), |c| c.environment),
        name: c_string(name.unwrap_or_default()),
    };
    if kind != CO_SIMULATION {
        log.message(Status::Error, "only for co-simulation: it steps itself");
        return std::ptr::null_mut();
    }
    new(location, guid, log)
}

/// Frees an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeInstance(component: *mut c_void) {
    // SAFETY: as the standard has it.
    unsafe { free::<Log2>(component) }
}

/// Sets the time of the start.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetupExperiment(
    component: *mut c_void,
    _tolerance_defined: c_int,
    _tolerance: f64,
    start_time: f64,
    _stop_time_defined: c_int,
    _stop_time: f64,
) -> c_int {
    let work = |instance: &mut Instance2| {
        instance.expect("the experiment is set up", &[Phase::Instantiated])?;
        instance.stepper.begin(start_time)
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Begins the initialization.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2EnterInitializationMode(component: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, |instance: &mut Instance2| instance.begin(None)) }
}

/// Ends the initialization.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2ExitInitializationMode(component: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, Instance2::end_initialization) }
}

/// Ends the simulation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Terminate(component: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, Instance2::terminate) }
}

/// Returns to the start.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Reset(component: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, Instance2::reset) }
}

/// Gets values.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetReal(
    component: *mut c_void,
    references: *const c_uint,
    count: usize,
    values: *mut f64,
) -> c_int {
    let (numbers, values) = ((references, count), (values, count));
    // SAFETY: as the standard has it.
    unsafe { get::<Log2>(component, "fmi2GetReal", numbers, values) }
}

/// Sets inputs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetReal(
    component: *mut c_void,
    references: *const c_uint,
    count: usize,
    values: *const f64,
) -> c_int {
    let (numbers, values) = ((references, count), (values, count));
    // SAFETY: as the standard has it.
    unsafe { set::<Log2>(component, "fmi2SetReal", numbers, values) }
}

/// Saves the state, into the memory of an older one where there is one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetFMUstate(component: *mut c_void, state: *mut *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { save::<Log2>(component, "fmi2GetFMUstate", state) }
}

/// Restores a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetFMUstate(component: *mut c_void, state: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { restore::<Log2>(component, "fmi2SetFMUstate", state) }
}

/// Frees a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeFMUstate(
    component: *mut c_void,
    state: *mut *mut c_void,
) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { free_state::<Log2>(component, state) }
}

/// Gets the size of a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializedFMUstateSize(
    component: *mut c_void,
    state: *mut c_void,
    size: *mut usize,
) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { serialized_size::<Log2>(component, "fmi2SerializedFMUstateSize", state, size) }
}

/// Copies a state to bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializeFMUstate(
    component: *mut c_void,
    state: *mut c_void,
    bytes: *mut u8,
    size: usize,
) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { serialize::<Log2>(component, "fmi2SerializeFMUstate", state, (bytes, size)) }
}

/// Makes a state of bytes; it is checked when it is restored.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DeSerializeFMUstate(
    component: *mut c_void,
    bytes: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { deserialize::<Log2>(component, "fmi2DeSerializeFMUstate", (bytes, size), state) }
}

/// Takes a communication step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DoStep(
    component: *mut c_void,
    from: f64,
    length: f64,
    _no_state_before: c_int,
) -> c_int {
    // SAFETY: as the standard has it.
    unsafe {
        with(component, |instance: &mut Instance2| {
            instance.advance(from, length)
        })
    }
}

/// Tells whether a step is done: it always is when its function returns.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetStatus(
    component: *mut c_void,
    kind: c_int,
    value: *mut c_int,
) -> c_int {
    let work = |_: &mut Instance2| {
        // SAFETY: null or a place for a number.
        match unsafe { value.as_mut() } {
            Some(value) if kind == DO_STEP => *value = OK,
            _ => return Err(unknown_status(kind)),
        }
        Ok(())
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

fn unknown_status(kind: c_int) -> Failure {
    Failure::new(
        Kind::Value,
        format!("there is no status {kind} of this type"),
    )
}

/// Gets the time that the last step has reached.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealStatus(
    component: *mut c_void,
    kind: c_int,
    value: *mut f64,
) -> c_int {
    let work = |instance: &mut Instance2| {
        // SAFETY: null or a place for a number.
        match unsafe { value.as_mut() } {
            Some(value) if kind == LAST_SUCCESSFUL_TIME => *value = instance.stepper.time(),
            _ => return Err(unknown_status(kind)),
        }
        Ok(())
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Tells whether the device wants to end: it never does.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBooleanStatus(
    component: *mut c_void,
    kind: c_int,
    value: *mut c_int,
) -> c_int {
    let work = |_: &mut Instance2| {
        // SAFETY: null or a place for a number.
        match unsafe { value.as_mut() } {
            Some(value) if kind == TERMINATED => *value = 0,
            _ => return Err(unknown_status(kind)),
        }
        Ok(())
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}
