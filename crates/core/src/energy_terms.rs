//! Terms of the energy balance of a run.

/// Defines the entries of the ledger by one table: sign in the balance, field, name in results.
macro_rules! entries {
    ($($(#[$doc:meta])+ $sign:tt $field:ident $name:literal,)+) => {
        /// Entries in J, summed since the start of the run (stored energies: their change).
        #[derive(Debug, Clone, Copy, Default)]
        pub struct EnergyTerms {
            $($(#[$doc])+ pub $field: f64,)+
        }

        impl EnergyTerms {
            /// Names of the entries in results.
            pub const NAMES: &[&str] = &[$($name),+];

            /// Stored + dissipated + lost − supplied: zero up to rounding.
            #[must_use]
            pub fn residual(&self) -> f64 {
                // To −0 every number adds up to itself, −0 as well.
                -0.0 $($sign self.$field)+
            }

            /// Values of the entries, in the order of [`EnergyTerms::NAMES`].
            #[must_use]
            pub fn values(&self) -> [f64; EnergyTerms::NAMES.len()] {
                [$(self.$field),+]
            }

            /// All entries, to go through.
            pub(crate) fn all_mut(&mut self) -> [&mut f64; EnergyTerms::NAMES.len()] {
                [$(&mut self.$field),+]
            }
        }
    };
}

entries! {
    /// Kinetic energy of the line.
    + kinetic "kinetic",
    /// Elastic energy of the line about its equilibrium (gravity and prestress included).
    + elastic "elastic",
    /// Energy in the contact compliances, and in the bump stops of pantographs.
    + contact "contact",
    /// Kinetic and elastic energy of the pantographs.
    + pantographs "pantograph",
    /// Dissipated in wires and struts.
    + dissipated_line "dissipated_line",
    /// Dissipated in links.
    + dissipated_links "dissipated_droppers",
    /// Dissipated in springs to ground.
    + dissipated_springs "dissipated_supports",
    /// Energy dissipated in pantographs.
    + dissipated_pantographs "dissipated_pantograph",
    /// Taken out (or put in, when negative) by the time-stepping scheme.
    + dissipated_scheme "dissipated_scheme",
    /// Lost when contacts and links open or close, impacts included.
    + switching "switching",
    /// Work of preload, lift and prescribed forces on the pantographs, and of their base motion.
    - work_uplift "work_uplift",
    /// Work of the actuators of the pantographs.
    - work_control "work_control",
    /// Work of the traction that moves the contact along the sloping wire.
    - work_traction "work_traction",
    /// Work of friction along the wire.
    - work_friction "work_friction",
    /// Work of the loads given on the line.
    - work_loads "work_wind",
}

impl EnergyTerms {
    /// Energy turned over: the scale a residual is compared with.
    #[must_use]
    pub fn turnover(&self) -> f64 {
        let supplied = self.work_uplift.abs() + self.work_traction.abs() + self.work_friction.abs();
        let supplied = supplied + self.work_loads.abs() + self.work_control.abs();
        supplied.max(self.kinetic.abs() + self.elastic.abs() + self.pantographs.abs())
    }

    /// Returns the terms of a row at which the balance was not evaluated: NaN.
    pub(crate) fn unknown() -> Self {
        let mut new = Self::default();
        new.all_mut()
            .into_iter()
            .for_each(|entry| *entry = f64::NAN);
        new
    }

    /// Returns whether the balance was not evaluated at this row.
    pub(crate) fn is_unknown(&self) -> bool {
        self.kinetic.is_nan() && self.work_uplift.is_nan() && self.work_loads.is_nan()
    }
}
