//! Macros for functions of the FMI that have to exist, for what an FMU of Arcless does not have.
//! Each takes the log of the version.

/// Defines functions on values of a type that no variable has: fine for none, refused for some.
/// They take the numbers of variables and how many there are, then arguments of these types.
macro_rules! no_values {
    ($log:ty; $($name:ident($($type:ty),*);)*) => {$(
        #[doc = concat!("`", stringify!($name), "`: no variable has this type.")]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(
            component: *mut c_void,
            _references: *const c_uint,
            count: usize
            $(, _: $type)*
        ) -> c_int {
            let work = |_: &mut Instance<$log>| none_of(stringify!($name), count);
            // SAFETY: as the standard has it.
            unsafe { with(component, work) }
        }
    )*};
}

/// Defines functions that are not offered.
macro_rules! not_offered {
    ($log:ty; $($name:ident($($type:ty),*);)*) => {$(
        #[doc = concat!("`", stringify!($name), "`: not offered.")]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(component: *mut c_void $(, _: $type)*) -> c_int {
            let work = |_: &mut Instance<$log>| Err(not_offered(stringify!($name)));
            // SAFETY: as the standard has it.
            unsafe { with(component, work) }
        }
    )*};
}

pub(crate) use {no_values, not_offered};
