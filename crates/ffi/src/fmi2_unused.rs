//! Functions of FMI 2.0 that have to exist, for what an FMU of Arcless does not have.

use crate::absent;
use crate::calls::with;
use crate::fmi2::Log2;
use crate::instance::{Instance, none_of, not_offered};
use std::ffi::{c_char, c_int, c_uint, c_void};

absent::no_values! {
    Log2;
    fmi2GetInteger(*mut c_int);
    fmi2GetBoolean(*mut c_int);
    fmi2GetString(*mut *const c_char);
    fmi2SetInteger(*const c_int);
    fmi2SetBoolean(*const c_int);
    fmi2SetString(*const *const c_char);
}

absent::not_offered! {
    Log2;
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
