//! Functions of FMI 3.0 that have to exist, for what an FMU of Arcless does not have.

use crate::fmi3::with;
use crate::instance::{none_of, not_offered};
use std::ffi::{c_char, c_int, c_uint, c_void};

/// Functions on values of a type that no variable has.
macro_rules! no_values {
    ($($name:ident: $values:ty;)*) => {$(
        #[doc = concat!("`", stringify!($name), "`: no variable has this type.")]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            component: *mut c_void,
            _references: *const c_uint,
            count: usize,
            _values: $values,
            _value_count: usize,
        ) -> c_int {
            // SAFETY: as the standard has it.
            unsafe { with(component, |_| none_of(stringify!($name), count)) }
        }
    )*};
}

no_values! {
    fmi3GetFloat32: *mut f32;
    fmi3GetInt8: *mut i8;
    fmi3GetUInt8: *mut u8;
    fmi3GetInt16: *mut i16;
    fmi3GetUInt16: *mut u16;
    fmi3GetInt32: *mut i32;
    fmi3GetUInt32: *mut u32;
    fmi3GetInt64: *mut i64;
    fmi3GetUInt64: *mut u64;
    fmi3GetBoolean: *mut bool;
    fmi3GetString: *mut *const c_char;
    fmi3SetFloat32: *const f32;
    fmi3SetInt8: *const i8;
    fmi3SetUInt8: *const u8;
    fmi3SetInt16: *const i16;
    fmi3SetUInt16: *const u16;
    fmi3SetInt32: *const i32;
    fmi3SetUInt32: *const u32;
    fmi3SetInt64: *const i64;
    fmi3SetUInt64: *const u64;
    fmi3SetBoolean: *const bool;
    fmi3SetString: *const *const c_char;
}

/// Functions on values of other shapes, where none are there.
macro_rules! no_others {
    ($($name:ident($($type:ty),*);)*) => {$(
        #[doc = concat!("`", stringify!($name), "`: no variable has this type.")]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            component: *mut c_void,
            _references: *const c_uint,
            count: usize
            $(, _: $type)*
        ) -> c_int {
            // SAFETY: as the standard has it.
            unsafe { with(component, |_| none_of(stringify!($name), count)) }
        }
    )*};
}

no_others! {
    fmi3GetBinary(*mut usize, *mut *const u8, usize);
    fmi3SetBinary(*const usize, *const *const u8, usize);
    fmi3GetClock(*mut bool);
    fmi3SetClock(*const bool);
    fmi3GetIntervalDecimal(*mut f64, *mut c_int);
    fmi3GetIntervalFraction(*mut u64, *mut u64, *mut c_int);
    fmi3GetShiftDecimal(*mut f64);
    fmi3GetShiftFraction(*mut u64, *mut u64);
    fmi3SetIntervalDecimal(*const f64);
    fmi3SetIntervalFraction(*const u64, *const u64);
    fmi3SetShiftDecimal(*const f64);
    fmi3SetShiftFraction(*const u64, *const u64);
    fmi3GetOutputDerivatives(*const i32, *mut f64, usize);
}

/// Functions that are not offered.
macro_rules! absent {
    ($($name:ident($($type:ty),*);)*) => {$(
        #[doc = concat!("`", stringify!($name), "`: not offered.")]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(component: *mut c_void $(, _: $type)*) -> c_int {
            // SAFETY: as the standard has it.
            unsafe { with(component, |_| Err(not_offered(stringify!($name)))) }
        }
    )*};
}

absent! {
    fmi3EnterEventMode();
    fmi3GetNumberOfVariableDependencies(c_uint, *mut usize);
    fmi3GetVariableDependencies(
        c_uint, *mut usize, *mut c_uint, *mut usize, *mut c_int, usize
    );
    fmi3GetDirectionalDerivative(
        *const c_uint, usize, *const c_uint, usize, *const f64, usize, *mut f64, usize
    );
    fmi3GetAdjointDerivative(
        *const c_uint, usize, *const c_uint, usize, *const f64, usize, *mut f64, usize
    );
    fmi3EnterConfigurationMode();
    fmi3ExitConfigurationMode();
    fmi3EvaluateDiscreteStates();
    fmi3UpdateDiscreteStates(*mut bool, *mut bool, *mut bool, *mut bool, *mut bool, *mut f64);
    fmi3EnterStepMode();
    // Of model exchange and of scheduled execution.
    fmi3EnterContinuousTimeMode();
    fmi3CompletedIntegratorStep(u8, *mut bool, *mut bool);
    fmi3SetTime(f64);
    fmi3SetContinuousStates(*const f64, usize);
    fmi3GetContinuousStateDerivatives(*mut f64, usize);
    fmi3GetEventIndicators(*mut f64, usize);
    fmi3GetContinuousStates(*mut f64, usize);
    fmi3GetNominalsOfContinuousStates(*mut f64, usize);
    fmi3GetNumberOfEventIndicators(*mut usize);
    fmi3GetNumberOfContinuousStates(*mut usize);
    fmi3ActivateModelPartition(c_uint, f64);
}

/// Makes no instance: only co-simulation is offered.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3InstantiateModelExchange(
    _name: *const c_char,
    _token: *const c_char,
    _resources: *const c_char,
    _visible: u8,
    _logging_on: u8,
    _environment: *mut c_void,
    _logger: *mut c_void,
) -> *mut c_void {
    std::ptr::null_mut()
}

/// Makes no instance: only co-simulation is offered.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3InstantiateScheduledExecution(
    _name: *const c_char,
    _token: *const c_char,
    _resources: *const c_char,
    _visible: u8,
    _logging_on: u8,
    _environment: *mut c_void,
    _logger: *mut c_void,
    _clock_update: *mut c_void,
    _lock: *mut c_void,
    _unlock: *mut c_void,
) -> *mut c_void {
    std::ptr::null_mut()
}
