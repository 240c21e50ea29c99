//! Structure of wires, links, springs and masses, as plain data: the input of the core.
//!
//! Wires are Hermite elements ([`Wire`]) or chains of point masses ([`Segment`], [`Bend`]), not
//! both. Nodes carry a position and, for Hermite elements, a slope (the derivative of position
//! along the unstretched wire). Components are ordered along the track, (across,) up; the last one
//! is vertical. Nodes must be ordered along the track so that the matrices stay narrow.

/// Elastic data of a wire element.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Section {
    /// Unstretched length L, m.
    pub rest_length: f64,
    /// Axial stiffness EA, N.
    pub axial_stiffness: f64,
    /// Bending stiffness EI, N·m².
    pub bending_stiffness: f64,
}

/// Proportional damping `alpha · M + beta · K`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Rayleigh {
    /// Mass-proportional part, 1/s.
    pub alpha: f64,
    /// Stiffness-proportional part, s.
    pub beta: f64,
}

/// Piece of wire between two nodes.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Wire {
    /// First and second node.
    pub nodes: [usize; 2],
    /// Nodes that hold the slopes of the two ends: the same as `nodes` where the wire runs
    /// through, an extra node (whose position is unused) where it is hinged.
    pub slope_nodes: [usize; 2],
    /// Rest length and stiffnesses.
    pub section: Section,
    /// Mass per metre of rest length, kg/m.
    pub mass: f64,
    /// Angle by which the track turns to the left along it, rad; lines in space only.
    pub turn: f64,
    /// Damping of this wire.
    pub damping: Rayleigh,
    /// Horizontal tension that the design calculation gives this element, N; 0 for a beam.
    pub design_tension: f64,
}

impl Wire {
    /// Node and slot (0 position, 1 slope) of the four coordinates r₁, r₁′, r₂, r₂′.
    #[must_use]
    pub fn coordinate_slots(&self) -> [(usize, usize); 4] {
        let ([a, b], [c, d]) = (self.nodes, self.slope_nodes);
        [(a, 0), (c, 1), (b, 0), (d, 1)]
    }

    /// Tells whether both slopes are held by the end nodes themselves.
    #[must_use]
    pub fn runs_through(&self) -> bool {
        self.nodes == self.slope_nodes
    }
}

/// Piece of a wire that is a chain of point masses: elastic, straight between its two nodes, with
/// half of its mass on each.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Segment {
    /// First and second node.
    pub nodes: [usize; 2],
    /// Unstretched length, m.
    pub rest_length: f64,
    /// Axial stiffness EA, N.
    pub axial_stiffness: f64,
    /// Angle by which the track turns to the left along it, rad; lines in space only.
    pub turn: f64,
    /// Mass per metre of rest length, kg/m.
    pub mass: f64,
    /// Damping of this segment.
    pub damping: Rayleigh,
    /// Horizontal tension that the design calculation gives this segment, N; 0 for a beam.
    pub design_tension: f64,
}

/// Bending element at the node that two consecutive segments share.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Bend {
    /// Segments before and behind the node.
    pub segments: [usize; 2],
    /// Bending stiffness EI, N·m².
    pub stiffness: f64,
    /// Stiffness-proportional damping, s.
    pub beta: f64,
}

/// Bar between two nodes. A unilateral link pulls but never pushes. A pure damper, of stiffness 0,
/// is neither unilateral nor adjusted: it has no tension at rest.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Link {
    /// First (upper) and second (lower) node.
    pub nodes: [usize; 2],
    /// Unstretched length, m; found by the design calculation when `adjust` is set.
    pub rest_length: f64,
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// Viscous damping along the link, N·s/m, in addition to the proportional one.
    pub viscosity: f64,
    /// Proportional damping.
    pub damping: Rayleigh,
    /// Mass per metre, kg/m; half of it hangs on each end.
    pub mass: f64,
    /// Tension only.
    pub unilateral: bool,
    /// Length unknown: the lower node's height is held in the design calculation.
    pub adjust: bool,
}

impl Link {
    /// Tells whether the link can pull at rest: a pure damper cannot.
    #[must_use]
    pub fn is_elastic(&self) -> bool {
        self.stiffness > 0.0
    }
}

/// Bar between a node and a point of the ground.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Strut {
    /// Node.
    pub node: usize,
    /// Unit vector from the node to the ground point in the design position.
    pub direction: [f64; 3],
    /// Ground point, m; found by the design calculation when `adjust` is set.
    pub anchor: [f64; 3],
    /// Unstretched length, m.
    pub rest_length: f64,
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// Mass that moves with the node, kg (a third of a bar hinged at the ground).
    pub moving_mass: f64,
    /// Mass whose weight hangs on the node, kg (half of the bar).
    pub hanging_mass: f64,
    /// Ground point unknown: the node's lateral position is held in the design calculation.
    pub adjust: bool,
}

/// Spring and damper between one component of a node and the ground.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spring {
    /// Node.
    pub node: usize,
    /// Component of its position.
    pub component: usize,
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// Damping, N·s/m.
    pub viscosity: f64,
    /// Coordinate at which the spring is free of force, m; found unless `mode` is `Given`.
    pub rest: f64,
    /// Treatment of the rest coordinate by the design calculation.
    pub mode: SpringMode,
}

/// Knowledge of a spring when the design calculation begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum SpringMode {
    /// The rest coordinate is given.
    Given,
    /// The position is given and held; the spring carries the reaction.
    Held,
    /// The spring is free of force in the design position, wherever that is.
    Unloaded,
}

/// End of a wire that a device of constant force may hold.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TensionedEnd {
    /// Node.
    pub node: usize,
    /// Force applied along the track, N; positive in the direction of travel.
    pub force: f64,
    /// In service the end stays free under this force; otherwise it is fixed
    /// where the design calculation left it.
    pub released: bool,
}

/// Mass at the position of a node.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PointMass {
    /// Node.
    pub node: usize,
    /// Mass, kg.
    pub mass: f64,
    /// Mass-proportional damping, 1/s.
    pub alpha: f64,
}

/// Residual flexibility of the wires at point forces; see [`crate::residual_flexibility`].
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ResidualFlexibility {
    /// Stiffness of each link alone, N/m; that in the list of links contains R at both ends.
    pub links: Vec<f64>,
    /// Stiffness of each strut alone, N/m.
    pub struts: Vec<f64>,
    /// Stiffness of each spring alone, N/m; springs along the track do not contain R.
    pub springs: Vec<f64>,
    /// Residual flexibility R: node, node with a force, height of the first above the mesh per
    /// force, m/N.
    pub pairs: Vec<(usize, usize, f64)>,
}

/// Complete description of a structure.
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Structure {
    /// Components of space: 2 (along, up) or 3 (along, across, up).
    pub dim: usize,
    /// Positions, m: targets where held, first guesses elsewhere. Unused components are zero.
    pub positions: Vec<[f64; 3]>,
    /// First guesses of the slopes; ignored where the wires are chains of point masses.
    pub slopes: Vec<[f64; 3]>,
    /// Wires as Hermite elements.
    pub wires: Vec<Wire>,
    /// Wires as chains of point masses.
    pub segments: Vec<Segment>,
    /// Bending elements between segments.
    pub bends: Vec<Bend>,
    /// Links.
    pub links: Vec<Link>,
    /// Struts.
    pub struts: Vec<Strut>,
    /// Springs to ground.
    pub springs: Vec<Spring>,
    /// Point masses.
    pub masses: Vec<PointMass>,
    /// Fixed components of node positions.
    pub fixed: Vec<(usize, usize)>,
    /// Wire ends under tension.
    pub ends: Vec<TensionedEnd>,
    /// Forces on nodes: node, component, N.
    pub loads: Vec<(usize, usize, f64)>,
    /// Steady force per metre of rest length on each wire element or segment, N/m, in addition to
    /// its weight; empty where there is none.
    pub wire_loads: Vec<[f64; 3]>,
    /// Choice of bends for which forces on points displace points as on the wires: see
    /// [`Geometry::bending`](crate::statics::Geometry::bending).
    pub fitted_bends: bool,
    /// Restriction to motion across the track, with the tensions at rest: see
    /// [`LinearModel`](crate::linear::model::LinearModel). The statics do not use it.
    pub across_only: bool,
    /// Residual flexibility, contained in links, struts and springs; `None` when it is left out.
    pub residual: Option<ResidualFlexibility>,
    /// Acceleration of gravity, m/s², acting against the last component.
    pub gravity: f64,
}

impl Structure {
    /// Nodes of a bending element, three in order.
    #[must_use]
    pub fn bend_nodes(&self, bend: &Bend) -> [usize; 3] {
        let [before, behind] = bend.segments.map(|k| self.segments[k].nodes);
        [before[0], before[1], behind[1]]
    }
}
