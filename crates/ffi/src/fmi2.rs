//! Functions of FMI 2.0 for co-simulation that do something.

use crate::instance::{Instance, Log, Phase, Saved, Status};
use crate::pointers::{c_string, list, list_mut, text};
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
pub(crate) const ERROR: c_int = Status::Error as c_int;
const CO_SIMULATION: c_int = 1;
/// Kinds of status that are asked for: whether a step is done, the last time reached, the end.
const DO_STEP: c_int = 0;
const LAST_SUCCESSFUL_TIME: c_int = 2;
const TERMINATED: c_int = 3;

/// Does something with an instance.
///
/// # Safety
/// Null, or an instance of [`fmi2Instantiate`] that nothing else uses meanwhile.
pub(crate) unsafe fn with(
    component: *mut c_void,
    work: impl FnOnce(&mut Instance2) -> Result<(), Failure>,
) -> c_int {
    // SAFETY: the caller has an instance for itself.
    match unsafe { component.cast::<Instance2>().as_mut() } {
        Some(instance) => instance.attempt(work) as c_int,
        None => ERROR,
    }
}

pub(crate) fn null(what: &str) -> Failure {
    Failure::new(Kind::Value, format!("{what}: a null pointer"))
}

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
    unsafe { with(component, |_| Ok(())) }
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
    let made = Instance::open(location.unwrap_or_default(), guid.unwrap_or_default(), log);
    made.map_or(std::ptr::null_mut(), |made| {
        Box::into_raw(Box::new(made)).cast()
    })
}

/// Frees an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeInstance(component: *mut c_void) {
    if !component.is_null() {
        // SAFETY: it came from `fmi2Instantiate`, and is not used again.
        drop(unsafe { Box::from_raw(component.cast::<Instance2>()) });
    }
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
    unsafe { with(component, |instance| instance.begin(None)) }
}

/// Ends the initialization.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2ExitInitializationMode(component: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, Instance::end_initialization) }
}

/// Ends the simulation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Terminate(component: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, Instance::terminate) }
}

/// Returns to the start.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Reset(component: *mut c_void) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, Instance::reset) }
}

/// Gets values.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetReal(
    component: *mut c_void,
    references: *const c_uint,
    count: usize,
    values: *mut f64,
) -> c_int {
    let work = |instance: &mut Instance2| {
        // SAFETY: the importer has arrays of that many elements.
        let (numbers, values) = unsafe { (list(references, count), list_mut(values, count)) };
        let (Some(numbers), Some(values)) = (numbers, values) else {
            return Err(null("fmi2GetReal"));
        };
        instance.get(numbers, values)
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Sets inputs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetReal(
    component: *mut c_void,
    references: *const c_uint,
    count: usize,
    values: *const f64,
) -> c_int {
    let work = |instance: &mut Instance2| {
        // SAFETY: the importer has arrays of that many elements.
        let (numbers, values) = unsafe { (list(references, count), list(values, count)) };
        let (Some(numbers), Some(values)) = (numbers, values) else {
            return Err(null("fmi2SetReal"));
        };
        instance.set(numbers, values)
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Saves the state, into the memory of an older one where there is one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetFMUstate(component: *mut c_void, state: *mut *mut c_void) -> c_int {
    let work = |instance: &mut Instance2| {
        // SAFETY: the importer has a place for a state.
        let place = unsafe { state.as_mut() }.ok_or_else(|| null("fmi2GetFMUstate"))?;
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
pub unsafe extern "C" fn fmi2SetFMUstate(component: *mut c_void, state: *mut c_void) -> c_int {
    let work = |instance: &mut Instance2| {
        // SAFETY: null, or a state that came from here.
        let saved = unsafe { state.cast::<Saved>().as_ref() };
        instance.restore(saved.ok_or_else(|| null("fmi2SetFMUstate"))?)
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Frees a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeFMUstate(
    component: *mut c_void,
    state: *mut *mut c_void,
) -> c_int {
    let work = |_: &mut Instance2| {
        // SAFETY: null, or a place with null or a state that came from here.
        let Some(place) = (unsafe { state.as_mut() }) else {
            return Ok(());
        };
        if !place.is_null() {
            // SAFETY: it came from `fmi2GetFMUstate`, and the importer gets null in its place.
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
pub unsafe extern "C" fn fmi2SerializedFMUstateSize(
    component: *mut c_void,
    state: *mut c_void,
    size: *mut usize,
) -> c_int {
    let work = |_: &mut Instance2| {
        // SAFETY: a state that came from here, and a place for a number.
        let (saved, size) = unsafe { (state.cast::<Saved>().as_ref(), size.as_mut()) };
        let (Some(saved), Some(size)) = (saved, size) else {
            return Err(null("fmi2SerializedFMUstateSize"));
        };
        *size = saved.len();
        Ok(())
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Copies a state to bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializeFMUstate(
    component: *mut c_void,
    state: *mut c_void,
    bytes: *mut u8,
    size: usize,
) -> c_int {
    let work = |_: &mut Instance2| {
        // SAFETY: a state that came from here, and an array of that many bytes.
        let (saved, bytes) = unsafe { (state.cast::<Saved>().as_ref(), list_mut(bytes, size)) };
        let (Some(saved), Some(bytes)) = (saved, bytes) else {
            return Err(null("fmi2SerializeFMUstate"));
        };
        write_state(saved, bytes)
    };
    // SAFETY: as the standard has it.
    unsafe { with(component, work) }
}

/// Copies a state to bytes that have room for it.
pub(crate) fn write_state(saved: &Saved, bytes: &mut [u8]) -> Result<(), Failure> {
    let Some(room) = bytes.get_mut(..saved.len()) else {
        let (room, length) = (bytes.len(), saved.len());
        let message = format!("{room} bytes for a state of {length}");
        return Err(Failure::data(message));
    };
    room.copy_from_slice(saved);
    Ok(())
}

/// Makes a state of bytes; it is looked at when it is restored.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DeSerializeFMUstate(
    component: *mut c_void,
    bytes: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> c_int {
    let work = |_: &mut Instance2| {
        // SAFETY: an array of that many bytes, and a place for a state.
        let (bytes, place) = unsafe { (list(bytes, size), state.as_mut()) };
        let (Some(bytes), Some(place)) = (bytes, place) else {
            return Err(null("fmi2DeSerializeFMUstate"));
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
pub unsafe extern "C" fn fmi2DoStep(
    component: *mut c_void,
    from: f64,
    length: f64,
    _no_state_before: c_int,
) -> c_int {
    // SAFETY: as the standard has it.
    unsafe { with(component, |instance| instance.advance(from, length)) }
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
