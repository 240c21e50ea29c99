//! Energy of a line that is stepped explicitly, and its losses in a step.
//!
//! The steps (module documentation of [`explicit`](super)) are, with d = yₙ₊₁ − yₙ the last
//! increment of the predictor and Δz = h vₙ₊₁ = ½ (yₙ₊₂ − yₙ) the multiplier of their balance,
//!
//!   M* aₙ₊₁ + C_I ṽ + K_I ũ + K_E (yₙ₊₁ + B d) + (α/h) M d = f,     h² aₙ₊₁ = yₙ₊₂ − 2 yₙ₊₁ + yₙ
//!
//! M* is the inverse of M⁻¹ + M⁻¹ E M⁻¹, B = β/h of the wires. Since
//!
//!   Δz·M* a    = ½ |dₙ₊₂|²/h² − ½ |dₙ₊₁|²/h²                    (norm of M*)
//!   Δz·K_E y   = ½ yₙ₊₂ᵀK_E yₙ₊₁ − ½ yₙ₊₁ᵀK_E yₙ
//!   Δz·K_I u   = ½ zᵀK_I z |ₙ₊½^ₙ₊₃⁄₂,      zₙ₊½ = ½ (yₙ + yₙ₊₁),   uₙ₊₁ = ½ (zₙ₊½ + zₙ₊₃⁄₂)
//!
//! there is an energy half-way between two steps that obeys its balance exactly,
//!
//!   E = ½ (d/h)ᵀM*(d/h) + ½ yₙ₊₁ᵀK_E yₙ + ½ zᵀK_I z
//!   ΔE = Δz·f − (B d)ᵀK_E Δz − (α/h) dᵀM Δz − ṽᵀC_I Δz − S
//!
//! (central differences: Krenk, Comput. Methods Appl. Mech. Eng. 195 (2006) 6110; the split: Hughes
//! & Liu, J. Appl. Mech. 45 (1978) 371; both from memory, the sums above are derived here.) E is
//! positive for ω h < 2, as yₙ₊₁ᵀK yₙ = zᵀK z − ¼ dᵀK d.
//!
//! Along the wire stiff groups read the predictor, ũ_x = y_x and h ṽ_x = d_x; across h ṽ = Δz. So
//! their K_xx has the form of K_E, and the coupling of along with across leaves S = −¼ (h²
//! a_x)ᵀK_xr Δz_r, which the scheme takes or gives.
//!
//! Nothing here uses forces of the steps: the forms follow the wires, from point to point, and
//! depend on stripes only in where each point is stored.

pub(crate) mod filtered_mass;
pub(crate) mod form;
pub(crate) mod half_step;
pub(crate) mod island_field;
pub(crate) mod stiff;
pub(crate) mod tables;

use crate::integrator::explicit::{ChainState, Explicit};
use crate::linalg::{Kernel, widest};
use island_field::Workspace;

pub(in crate::integrator::explicit) use form::EnergyForm;

/// Energy stored by the line, J.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct StoredEnergy {
    pub kinetic: f64,
    pub elastic: f64,
}

impl StoredEnergy {
    pub fn all(self) -> f64 {
        self.kinetic + self.elastic
    }
}

/// Energy lost in a step, J.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct StepLosses {
    /// Dissipation by all dampers, those of links and springs included, J.
    pub damped: f64,
    /// Loss S by the scheme, J.
    pub scheme: f64,
}

/// Energies of all islands.
#[derive(Debug, Clone)]
pub(crate) struct IslandEnergies {
    workspaces: Vec<Workspace>,
}

impl IslandEnergies {
    pub fn new<const DIM: usize>(steps: &Explicit<DIM>) -> Self {
        let workspaces = steps
            .energy_forms()
            .iter()
            .map(|form| form.workspace(DIM - 1));
        Self {
            workspaces: workspaces.collect(),
        }
    }

    /// Reads the motion of an island after a step; the energies below refer to it.
    pub fn read<const DIM: usize>(
        &mut self,
        steps: &Explicit<DIM>,
        island: usize,
        chain: &ChainState,
    ) {
        self.work(steps, island, Work::Read(chain));
    }

    /// Returns the energy stored by an island half a step after the last one, J.
    pub fn stored<const DIM: usize>(
        &mut self,
        steps: &Explicit<DIM>,
        island: usize,
    ) -> StoredEnergy {
        let mut result = StoredEnergy::default();
        self.work(steps, island, Work::Store(&mut result));
        result
    }

    /// Keeps the increments before a step.
    pub fn remember(&mut self, island: usize) {
        let workspace = &mut self.workspaces[island];
        std::mem::swap(&mut workspace.old, &mut workspace.d);
    }

    /// Returns the energy lost in the step since [`Self::remember`], J.
    pub fn losses<const DIM: usize>(&mut self, steps: &Explicit<DIM>, island: usize) -> StepLosses {
        let mut result = StepLosses::default();
        self.work(steps, island, Work::Lose(&mut result));
        result
    }

    fn work<const DIM: usize>(&mut self, steps: &Explicit<DIM>, island: usize, work: Work<'_>) {
        widest(IslandWork {
            steps,
            form: &steps.energy_forms()[island],
            workspace: &mut self.workspaces[island],
            work,
        });
    }
}

impl<const DIM: usize> Explicit<DIM> {
    /// Returns the constants of the energy forms, built at the first request.
    fn energy_forms(&self) -> &[EnergyForm] {
        let new = || (0..self.islands.len()).map(|island| EnergyForm::new(self, island));
        self.forms.get_or_init(|| new().collect())
    }
}

/// Operation on the numbers of an island.
enum Work<'a> {
    Read(&'a ChainState),
    Store(&'a mut StoredEnergy),
    Lose(&'a mut StepLosses),
}

struct IslandWork<'a, const DIM: usize> {
    steps: &'a Explicit<DIM>,
    form: &'a EnergyForm,
    workspace: &'a mut Workspace,
    work: Work<'a>,
}

impl<const DIM: usize> Kernel for IslandWork<'_, DIM> {
    #[inline(always)]
    fn run(self) {
        match self.work {
            Work::Read(chain) => self.form.read(chain, self.workspace),
            Work::Store(result) => *result = self.form.stored(self.steps, self.workspace),
            Work::Lose(result) => *result = self.form.losses(self.steps, self.workspace),
        }
    }
}

impl StepLosses {
    #[inline(always)]
    pub fn plus(self, other: Self) -> Self {
        Self {
            damped: self.damped + other.damped,
            scheme: self.scheme + other.scheme,
        }
    }
}
