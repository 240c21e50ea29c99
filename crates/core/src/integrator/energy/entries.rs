//! Entries of the energy ledger of a run.

/// Entries in J, summed since the start of the run (stored energies: their change).
#[derive(Debug, Clone, Copy, Default)]
pub struct EnergyTerms {
    /// Kinetic energy of the line.
    pub kinetic: f64,
    /// Elastic energy of the line about its equilibrium (gravity and prestress included).
    pub elastic: f64,
    /// Energy in the contact compliances, and in the stops of the riders.
    pub contact: f64,
    /// Kinetic and elastic energy of the riders.
    pub riders: f64,
    /// Dissipated in wires and struts.
    pub dissipated_line: f64,
    /// Dissipated in links.
    pub dissipated_links: f64,
    /// Dissipated in springs to ground.
    pub dissipated_springs: f64,
    /// Dissipated in riders.
    pub dissipated_riders: f64,
    /// Taken out (or put in, when negative) by the time-stepping scheme.
    pub dissipated_scheme: f64,
    /// Lost when contacts and links open or close, impacts included.
    pub switching: f64,
    /// Work of preload, lift and given forces on the riders, and of the ground that moves them.
    pub work_uplift: f64,
    /// Work of the actuators of the riders.
    pub work_control: f64,
    /// Work of the traction that moves the contact along the sloping wire.
    pub work_traction: f64,
    /// Work of friction along the wire.
    pub work_friction: f64,
    /// Work of the loads given on the line.
    pub work_loads: f64,
}

impl EnergyTerms {
    /// Stored + dissipated + lost − supplied: zero but for rounding.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.kinetic
            + self.elastic
            + self.contact
            + self.riders
            + self.dissipated_line
            + self.dissipated_links
            + self.dissipated_springs
            + self.dissipated_riders
            + self.dissipated_scheme
            + self.switching
            - self.work_uplift
            - self.work_control
            - self.work_traction
            - self.work_friction
            - self.work_loads
    }

    /// Energy turned over: the scale a residual is compared with.
    #[must_use]
    pub fn turnover(&self) -> f64 {
        let supplied = self.work_uplift.abs() + self.work_traction.abs() + self.work_friction.abs();
        let supplied = supplied + self.work_loads.abs() + self.work_control.abs();
        supplied.max(self.kinetic.abs() + self.elastic.abs() + self.riders.abs())
    }

    /// Of a row at which nothing was settled.
    pub(crate) fn unknown() -> Self {
        let mut new = Self::default();
        new.all_mut()
            .into_iter()
            .for_each(|entry| *entry = f64::NAN);
        new
    }

    /// Whether nothing was settled there.
    pub(crate) fn is_unknown(&self) -> bool {
        self.kinetic.is_nan() && self.work_uplift.is_nan() && self.work_loads.is_nan()
    }

    /// All of them, to go through.
    pub(crate) fn all_mut(&mut self) -> [&mut f64; 15] {
        [
            &mut self.kinetic,
            &mut self.elastic,
            &mut self.contact,
            &mut self.riders,
            &mut self.dissipated_line,
            &mut self.dissipated_links,
            &mut self.dissipated_springs,
            &mut self.dissipated_riders,
            &mut self.dissipated_scheme,
            &mut self.switching,
            &mut self.work_uplift,
            &mut self.work_control,
            &mut self.work_traction,
            &mut self.work_friction,
            &mut self.work_loads,
        ]
    }
}
