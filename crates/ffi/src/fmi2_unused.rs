//! Functions of FMI 2.0 that have to exist, for what an FMU of Arcless does not have.

use crate::fmi2::with;
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
        ) -> c_int {
            // SAFETY: as the standard has it.
            unsafe { with(component, |_| none_of(stringify!($name), count)) }
        }
    )*};
}

no_values! {
    fmi2GetInteger: *mut c_int;
    fmi2GetBoolean: *mut c_int;
    fmi2GetString: *mut *const c_char;
    fmi2SetInteger: *const c_int;
    fmi2SetBoolean: *const c_int;
    fmi2SetString: *const *const c_char;
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
    fmi2GetDirectionalDerivative(
        *const c_uint, usize, *const c_uint, usize, *const f64, *mut f64
    );
    fmi2SetRealInputDerivatives(*const c_uint, usize, *const c_int, *const f64);
    fmi2GetRealOutputDerivatives(*const c_uint, usize, *const c_int, *mut f64);
    fmi2CancelStep();
    fmi2GetIntegerStatus(c_int, *mut c_int);
    fmi2GetStringStatus(c_int, *mut *const c_char);
    // Of model exchange.
    fmi2EnterEventMode();
    fmi2NewDiscreteStates(*mut c_void);
    fmi2EnterContinuousTimeMode();
    fmi2CompletedIntegratorStep(c_int, *mut c_int, *mut c_int);
    fmi2SetTime(f64);
    fmi2SetContinuousStates(*const f64, usize);
    fmi2GetDerivatives(*mut f64, usize);
    fmi2GetEventIndicators(*mut f64, usize);
    fmi2GetContinuousStates(*mut f64, usize);
    fmi2GetNominalsOfContinuousStates(*mut f64, usize);
}
