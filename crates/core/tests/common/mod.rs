//! A planar simple line built in Rust, for tests and benchmarks: two wires, droppers, supports.
#![allow(dead_code)] // every test file uses a part

pub mod chain;
pub mod lanes;
pub mod space;

use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::model::LinearModel;
use arcless_core::pantograph::excitation::Excitation;
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::strip::Strip;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::inputs::Trajectory;
use arcless_core::simulation::recording::record::{Record, RecordPlan};
use arcless_core::slideline::Slideline;
use arcless_core::statics::Geometry;
use arcless_core::structure::Section;
use arcless_core::structure::{
    Link, PointMass, Rayleigh, Spring, SpringMode, Structure, TensionedEnd, Wire,
};

pub const CONTACT_TENSION: f64 = 22e3;
pub const MESSENGER_TENSION: f64 = 16e3;
pub const SPAN: f64 = 55.0;
const DROPPERS: [f64; 9] = [4.5, 10.25, 16.0, 21.75, 27.5, 33.25, 39.0, 44.75, 50.5];
const HEIGHT: f64 = 1.2;
const DAMPING: Rayleigh = Rayleigh {
    alpha: 0.0125,
    beta: 1e-4,
};

/// Stations of a wire: all special places, and equal elements between them.
fn stations(spans: usize, longest: f64) -> Vec<f64> {
    let mut places = vec![0.0];
    for span in 0..spans {
        let start = span as f64 * SPAN;
        places.extend(DROPPERS.iter().map(|x| start + x));
        places.push(start + SPAN);
    }
    let mut x = vec![0.0];
    for pair in places.windows(2) {
        let count = ((pair[1] - pair[0]) / longest - 1e-9).ceil().max(1.0) as usize;
        x.extend((1..=count).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / count as f64));
    }
    x
}

fn wire(a: usize, b: usize, length: f64, contact: bool) -> Wire {
    let (ea, ei, mass, tension) = if contact {
        (15e6, 195.0, 1.35, CONTACT_TENSION)
    } else {
        (11.64e6, 131.7, 1.08, MESSENGER_TENSION)
    };
    Wire {
        nodes: [a, b],
        slope_nodes: [a, b],
        section: Section {
            rest_length: length / (1.0 + tension / ea),
            axial_stiffness: ea,
            bending_stiffness: ei,
        },
        mass,
        turn: 0.0,
        damping: DAMPING,
        design_tension: tension,
    }
}

/// Unit data of the 55 m line with level contact wire; also the wire numbers of the contact wire.
pub fn simple_line(spans: usize) -> (Structure, Vec<usize>) {
    simple_line_of(spans, [1.45, 2.9])
}

/// Line of `simple_line` with given longest elements of contact and messenger wire, m.
pub fn simple_line_of(spans: usize, [longest, above]: [f64; 2]) -> (Structure, Vec<usize>) {
    let (contact, messenger) = (stations(spans, longest), stations(spans, above));
    let mut nodes: Vec<(f64, bool)> = messenger.iter().map(|&x| (x, false)).collect();
    nodes.extend(contact.iter().map(|&x| (x, true)));
    nodes.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let at = |x: f64, upper: bool| {
        let near = |n: &(f64, bool)| n.1 != upper && (n.0 - x).abs() < 1e-6;
        nodes
            .iter()
            .position(near)
            .expect("a node stands at every station")
    };
    let load = (1.35 + 1.08) * 9.81;
    let sag = |x: f64| {
        let local = x.rem_euclid(SPAN);
        load * local * (SPAN - local) / (2.0 * MESSENGER_TENSION)
    };
    let mut s = Structure {
        dim: 2,
        gravity: 9.81,
        ..Structure::default()
    };
    for &(x, is_contact) in &nodes {
        s.positions
            .push([x, if is_contact { 0.0 } else { HEIGHT - sag(x) }, 0.0]);
        s.slopes.push([1.0014, 0.0, 0.0]);
    }
    let mut path = Vec::new();
    for (x, is_contact) in [(&contact, true), (&messenger, false)] {
        for pair in x.windows(2) {
            let (a, b) = (at(pair[0], !is_contact), at(pair[1], !is_contact));
            if is_contact {
                path.push(s.wires.len());
            }
            s.wires.push(wire(a, b, pair[1] - pair[0], is_contact));
        }
        let (first, last) = (at(x[0], !is_contact), at(x[x.len() - 1], !is_contact));
        s.fixed
            .extend([(first, 0), (first, 1), (last, 0), (last, 1)]);
        let force = if is_contact {
            CONTACT_TENSION
        } else {
            MESSENGER_TENSION
        };
        s.ends.push(TensionedEnd {
            node: last,
            force,
            released: false,
        });
    }
    add_droppers_and_supports(&mut s, spans, &at);
    (s, path)
}

fn add_droppers_and_supports(s: &mut Structure, spans: usize, at: &impl Fn(f64, bool) -> usize) {
    for span in 0..spans {
        let start = span as f64 * SPAN;
        for x in DROPPERS.map(|x| start + x) {
            let nodes = [at(x, true), at(x, false)];
            s.links.push(Link {
                nodes,
                rest_length: HEIGHT,
                stiffness: 2e5,
                viscosity: 0.0,
                damping: DAMPING,
                mass: 0.117,
                unilateral: true,
                adjust: true,
            });
            s.masses.push(PointMass {
                node: nodes[0],
                mass: 0.195,
                alpha: DAMPING.alpha,
            });
            s.masses.push(PointMass {
                node: nodes[1],
                mass: 0.165,
                alpha: DAMPING.alpha,
            });
        }
        if span > 0 {
            let held = |node, stiffness, viscosity, mode| Spring {
                node,
                component: 1,
                stiffness,
                viscosity,
                rest: 0.0,
                mode,
            };
            s.springs
                .push(held(at(start, true), 5e5, 1e3, SpringMode::Held));
            s.springs
                .push(held(at(start, false), 267.0, 0.0, SpringMode::Unloaded));
        }
    }
}

/// Bar without mass from the lower node of a dropper of `simple_line` to the upper one of the next:
/// a pure damper where its stiffness is 0.
pub fn oblique(s: &Structure, dropper: usize, stiffness: f64, viscosity: f64) -> Link {
    Link {
        nodes: [s.links[dropper + 1].nodes[0], s.links[dropper].nodes[1]],
        rest_length: 0.0,
        stiffness,
        viscosity,
        damping: Rayleigh::default(),
        mass: 0.0,
        unilateral: false,
        adjust: false,
    }
}

/// The line at rest, ready to step.
pub fn prepared(spans: usize, scheme: Scheme, h: f64, contact: f64) -> WireModel<2, 4> {
    prepare(simple_line(spans), |_| (), scheme, h, contact)
}

/// The three-mass pantograph of the 55 m data set.
pub fn three_masses(force: f64) -> Pantograph {
    let (k, c) = ([160.0, 15_500.0, 7_000.0], [100.0, 0.1, 45.0]);
    let chain = |v: [f64; 3]| {
        vec![
            v[0] + v[1],
            -v[1],
            0.0,
            -v[1],
            v[1] + v[2],
            -v[2],
            0.0,
            -v[2],
            v[2],
        ]
    };
    Pantograph {
        mass: vec![6.0, 0.0, 0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 7.5],
        damping: chain(c),
        stiffness: chain(k),
        strips: vec![Strip::plain(vec![0.0, 0.0, 1.0])],
        preload: vec![1.0, 0.0, 0.0],
        lift: vec![0.0; 3],
        start_force: force,
        excitation: Excitation::default(),
        stops: Vec::new(),
        piecewise_forces: Vec::new(),
        actuator: None,
        is_external: false,
    }
}

/// Design calculation, a change of what it found, service equilibrium, matrices of the scheme.
pub fn prepare(
    line: (Structure, Vec<usize>),
    change: impl FnOnce(&mut Structure),
    scheme: Scheme,
    h: f64,
    contact: f64,
) -> WireModel<2, 4> {
    prepare_any(line, change, scheme, h, contact)
}

/// Model of a line as of `prepare`, in any dimension and with any wire model.
pub fn prepare_any<const DIM: usize, const D: usize>(
    (structure, path): (Structure, Vec<usize>),
    change: impl FnOnce(&mut Structure),
    scheme: Scheme,
    h: f64,
    contact: f64,
) -> WireModel<DIM, D> {
    let mut geometry = Geometry::<DIM, D>::new(structure).expect("a valid structure");
    let start = geometry.design().expect("the design converges");
    change(&mut geometry.structure);
    let shape = geometry
        .find_equilibrium(&start)
        .expect("the equilibrium converges");
    let lanes = Slideline::from_elements(&geometry, &shape, &[path]).expect("the wire is a path");
    WireModel::new(
        LinearModel::new(&geometry, shape),
        lanes,
        scheme,
        h,
        contact,
    )
    .expect("regular")
}

/// Model of a line as of `prepare_any`, with residual flexibility.
pub fn yielding<const DIM: usize, const D: usize>(
    (structure, path): (Structure, Vec<usize>),
    change: impl FnOnce(&mut Structure),
    scheme: Scheme,
    h: f64,
    contact: f64,
) -> WireModel<DIM, D> {
    let mut geometry = Geometry::<DIM, D>::new(structure).expect("a valid structure");
    geometry.add_residual_flexibility();
    let start = geometry.design().expect("the design converges");
    change(&mut geometry.structure);
    let shape = geometry
        .find_equilibrium(&start)
        .expect("the equilibrium converges");
    let lanes = [path];
    let paths = Slideline::from_elements(&geometry, &shape, &lanes).expect("the wire is a path");
    let paths = Slideline::with_residual_flexibility(paths, &geometry, &shape, &lanes);
    WireModel::new(
        LinearModel::new(&geometry, shape),
        paths,
        scheme,
        h,
        contact,
    )
    .expect("regular")
}

/// One horizontal wire between fixed ends: nodes from left to right, all elements on the path.
#[derive(Clone, Copy)]
pub struct Single {
    pub length: f64,
    pub elements: usize,
    pub mass: f64,
    pub axial: f64,
    pub bending: f64,
    pub tension: f64,
    pub gravity: f64,
}

impl Single {
    /// Strain δ of the straight wire: EA (δ + ½δ²)(1 + δ) = T for Green's strain, by iteration.
    pub fn stretch(&self) -> f64 {
        let ratio = self.tension / self.axial;
        (0..60).fold(ratio, |d, _| ratio / ((1.0 + 0.5 * d) * (1.0 + d)))
    }

    pub fn structure(&self, dim: usize) -> (Structure, Vec<usize>) {
        let step = self.length / self.elements as f64;
        let mut s = Structure {
            dim,
            gravity: self.gravity,
            ..Structure::default()
        };
        let curvature = self.mass * self.gravity / self.tension;
        for i in 0..=self.elements {
            // The parabola is a first guess.
            let x = i as f64 * step;
            let (mut position, mut slope) =
                ([x, 0.0, 0.0], [1.0 + self.tension / self.axial, 0.0, 0.0]);
            position[dim - 1] = -0.5 * curvature * x * (self.length - x);
            slope[dim - 1] = curvature * (x - 0.5 * self.length);
            s.positions.push(position);
            s.slopes.push(slope);
        }
        for i in 0..self.elements {
            s.wires.push(Wire {
                nodes: [i, i + 1],
                slope_nodes: [i, i + 1],
                section: Section {
                    rest_length: step / (1.0 + self.tension / self.axial),
                    axial_stiffness: self.axial,
                    bending_stiffness: self.bending,
                },
                mass: self.mass,
                turn: 0.0,
                damping: Rayleigh::default(),
                design_tension: self.tension,
            });
        }
        s.fixed.extend(
            [0, self.elements]
                .iter()
                .flat_map(|&n| (0..dim).map(move |c| (n, c))),
        );
        s.ends.push(TensionedEnd {
            node: self.elements,
            force: self.tension,
            released: false,
        });
        (s, (0..self.elements).collect())
    }
}

/// Pantograph of one unsupported mass: its contact force differs from the preload by its inertia
/// alone.
pub fn free_mass(mass: f64, force: f64) -> Pantograph {
    Pantograph {
        mass: vec![mass],
        damping: vec![0.0],
        stiffness: vec![0.0],
        strips: vec![Strip::plain(vec![1.0])],
        preload: vec![1.0],
        lift: vec![0.0],
        start_force: force,
        excitation: Excitation::default(),
        stops: Vec::new(),
        piecewise_forces: Vec::new(),
        actuator: None,
        is_external: false,
    }
}

/// Travel at constant speed.
pub fn travel(start: f64, end: f64, speed: f64, h: f64) -> Trajectory {
    let steps = ((end - start) / (speed * h)).floor() as usize;
    steady(start, speed, h, steps)
}

/// Travel at constant speed for a number of steps.
pub fn steady(start: f64, speed: f64, h: f64, steps: usize) -> Trajectory {
    Trajectory {
        positions: (0..=steps).map(|i| start + speed * h * i as f64).collect(),
        speeds: vec![speed; steps + 1],
        distances: vec![0.0],
        friction: 0.0,
        loads: Vec::new(),
    }
}

/// Record everything at every step, with the ledger.
pub fn everything() -> RecordPlan {
    RecordPlan {
        contact_every: 1,
        line_every: 1,
        links: true,
        nodes: Vec::new(),
        supports: Vec::new(),
        points: Vec::new(),
        ledger: true,
        ledger_every: 1,
        near: None,
        motion: None,
    }
}

pub fn run<const DIM: usize, const D: usize>(
    p: &WireModel<DIM, D>,
    pantographs: &[Pantograph],
    travel: &Trajectory,
    plan: &RecordPlan,
) -> Record {
    p.run(pantographs, travel, plan, &mut |_| true)
        .expect("the run completes")
}

/// Largest absolute value.
pub fn peak(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m: f64, v| m.max(v.abs()))
}

/// Largest difference relative to the largest value of `b`.
pub fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let deltas: Vec<f64> = a.iter().zip(b).map(|(x, y)| x - y).collect();
    peak(&deltas) / peak(b).max(f64::MIN_POSITIVE)
}

/// Observed order of convergence between neighbouring meshes of halved size.
pub fn orders(errors: &[f64]) -> Vec<f64> {
    errors.windows(2).map(|e| (e[0] / e[1]).log2()).collect()
}
