//! Library that other programs load: devices of [`arcless_device`] behind C functions.
//!
//! * [`c`] — the C interface of `include/arcless_loop.h`;
//! * [`fmi2`], [`fmi3`] — co-simulation by the Functional Mock-up Interface, versions 2.0 and 3.0
//!   (Modelica Association, fmi-standard.org), and [`fmi2_unused`], [`fmi3_unused`]: functions that
//!   have to exist and say that they are not offered;
//! * `calls`, `absent` — bodies of functions of both versions: those that do something, and those
//!   that do not;
//! * [`instance`] — instance of either version;
//! * [`location`] — where the resources of an FMU are;
//! * [`pointers`] — strings and lists from C.
//!
//! A panic does not leave a function: it becomes the status Fatal, with its message.

mod absent;
pub mod c;
mod calls;
pub mod fmi2;
pub mod fmi2_unused;
pub mod fmi3;
pub mod fmi3_unused;
pub mod instance;
pub mod location;
pub mod pointers;

#[cfg(test)]
mod tests;
