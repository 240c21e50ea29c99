//! Energy of a line that is stepped explicitly, and what its steps take of it.
//!
//! The steps (module documentation of [`explicit`](super)) are, with d = yₙ₊₁ − yₙ the last increment of the predictor and
//! Δz = h vₙ₊₁ = ½ (yₙ₊₂ − yₙ) what multiplies their balance,
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
//! (central differences: Krenk, Comput. Methods Appl. Mech. Eng. 195 (2006) 6110; the split: Hughes & Liu,
//! J. Appl. Mech. 45 (1978) 371; both from memory, the sums above are derived here.) E is positive for ω h < 2, as
//! yₙ₊₁ᵀK yₙ = zᵀK z − ¼ dᵀK d.
//!
//! Along the wire clusters read the predictor, ũ_x = y_x and h ṽ_x = d_x; across h ṽ = Δz. So their K_xx has the form of K_E,
//! and what couples along with across leaves S = −¼ (h² a_x)ᵀK_xr Δz_r, which the scheme takes or gives.
//!
//! Nothing here uses forces of the steps: forms go along the wires, from point to point, and know no strands but
//! for where each point lies.

pub(crate) mod field;
pub(crate) mod filtered;
pub(crate) mod form;
pub(crate) mod halves;
pub(crate) mod joined;
pub(crate) mod tables;

use crate::integrator::explicit::{Explicit, Grid};
use crate::linalg::{Kernel, widest};
use form::Room;

pub(in crate::integrator::explicit) use form::Form;

/// What the line has stored, J.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Stored {
    pub kinetic: f64,
    pub elastic: f64,
}

impl Stored {
    pub fn all(self) -> f64 {
        self.kinetic + self.elastic
    }
}

/// What a step takes, J.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Lost {
    /// By all dampers, those of links and springs included.
    pub damped: f64,
    /// S, by the scheme.
    pub scheme: f64,
}

/// Energies of all islands.
#[derive(Debug, Clone)]
pub(crate) struct Forms {
    rooms: Vec<Room>,
}

impl Forms {
    pub fn new<const DIM: usize>(steps: &Explicit<DIM>) -> Self {
        let rooms = steps.forms().iter().map(|form| form.room(DIM - 1));
        Self {
            rooms: rooms.collect(),
        }
    }

    /// Read what moves on an island after a step: what follows is of that.
    pub fn read<const DIM: usize>(&mut self, steps: &Explicit<DIM>, island: usize, grid: &Grid) {
        self.work(steps, island, Work::Read(grid));
    }

    /// What an island has stored half a step after the last one.
    pub fn stored<const DIM: usize>(&mut self, steps: &Explicit<DIM>, island: usize) -> Stored {
        let mut found = Stored::default();
        self.work(steps, island, Work::Store(&mut found));
        found
    }

    /// Keep the increments before a step.
    pub fn remember(&mut self, island: usize) {
        let room = &mut self.rooms[island];
        std::mem::swap(&mut room.old, &mut room.d);
    }

    /// What the step since has taken.
    pub fn lost<const DIM: usize>(&mut self, steps: &Explicit<DIM>, island: usize) -> Lost {
        let mut found = Lost::default();
        self.work(steps, island, Work::Lose(&mut found));
        found
    }

    fn work<const DIM: usize>(&mut self, steps: &Explicit<DIM>, island: usize, work: Work<'_>) {
        widest(On {
            steps,
            form: &steps.forms()[island],
            room: &mut self.rooms[island],
            work,
        });
    }
}

impl<const DIM: usize> Explicit<DIM> {
    /// What energies are formed with, made when somebody asks for them first.
    fn forms(&self) -> &[Form] {
        let new = || (0..self.own.len()).map(|island| Form::new(self, island));
        self.forms.get_or_init(|| new().collect())
    }
}

/// Something to do with the numbers of an island.
enum Work<'a> {
    Read(&'a Grid),
    Store(&'a mut Stored),
    Lose(&'a mut Lost),
}

struct On<'a, const DIM: usize> {
    steps: &'a Explicit<DIM>,
    form: &'a Form,
    room: &'a mut Room,
    work: Work<'a>,
}

impl<const DIM: usize> Kernel for On<'_, DIM> {
    #[inline(always)]
    fn run(self) {
        match self.work {
            Work::Read(grid) => self.form.read(grid, self.room),
            Work::Store(found) => *found = self.form.stored(self.steps, self.room),
            Work::Lose(found) => *found = self.form.lost(self.steps, self.room),
        }
    }
}

impl Lost {
    #[inline(always)]
    pub fn and(self, other: Self) -> Self {
        Self {
            damped: self.damped + other.damped,
            scheme: self.scheme + other.scheme,
        }
    }
}
