//! Structure from tables of numbers: for each kind of part one integer and one float array.

use arcless_core::element::hermite::Section;
use arcless_core::statics::Alteration;
use arcless_core::structure::{
    Bend, Link, PointMass, Rayleigh, Segment, Spring, SpringMode, Structure, Strut, TensionedEnd,
    Wire,
};
use numpy::PyReadonlyArray2;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// A table: integer and float columns of the same number of rows, one row after the other.
struct Table {
    rows: usize,
    widths: [usize; 2],
    integers: Vec<usize>,
    floats: Vec<f64>,
}

fn table(parts: &Bound<'_, PyDict>, name: &str, widths: [usize; 2]) -> PyResult<Table> {
    let item = parts.get_item(name)?;
    let item = item.ok_or_else(|| PyValueError::new_err(format!("part {name} is missing")))?;
    let (integers, floats): (PyReadonlyArray2<'_, i64>, PyReadonlyArray2<'_, f64>) =
        item.extract()?;
    let (integers, floats) = (integers.as_array(), floats.as_array());
    if integers.nrows() != floats.nrows() || [integers.ncols(), floats.ncols()] != widths {
        let message = format!("part {name}: expected {widths:?} columns and equal rows");
        return Err(PyValueError::new_err(message));
    }
    let unsigned = |&v: &i64| {
        usize::try_from(v)
            .map_err(|_| PyValueError::new_err(format!("part {name}: negative index {v}")))
    };
    Ok(Table {
        rows: integers.nrows(),
        widths,
        integers: integers.iter().map(unsigned).collect::<PyResult<_>>()?,
        floats: floats.iter().copied().collect(),
    })
}

fn each<T>(t: &Table, make: impl Fn(&[usize], &[f64]) -> T) -> Vec<T> {
    let [integers, floats] = t.widths;
    let row = |k: usize| {
        make(
            &t.integers[k * integers..(k + 1) * integers],
            &t.floats[k * floats..(k + 1) * floats],
        )
    };
    (0..t.rows).map(row).collect()
}

pub fn triples(array: &PyReadonlyArray2<'_, f64>) -> PyResult<Vec<[f64; 3]>> {
    let view = array.as_array();
    if view.ncols() != 3 {
        return Err(PyValueError::new_err(
            "positions, slopes and loads have three columns",
        ));
    }
    Ok(view
        .rows()
        .into_iter()
        .map(|r| [r[0], r[1], r[2]])
        .collect())
}

/// Assemble the structure; the columns are documented in `arcless.mesh`.
pub fn build(
    dim: usize,
    positions: &PyReadonlyArray2<'_, f64>,
    slopes: &PyReadonlyArray2<'_, f64>,
    parts: &Bound<'_, PyDict>,
    gravity: f64,
) -> PyResult<Structure> {
    let mut structure = Structure {
        dim,
        positions: triples(positions)?,
        slopes: triples(slopes)?,
        wires: each(&table(parts, "wires", [4, 7])?, wire),
        segments: each(&table(parts, "segments", [2, 6])?, segment),
        bends: each(&table(parts, "bends", [2, 2])?, |i, f| Bend {
            segments: [i[0], i[1]],
            stiffness: f[0],
            beta: f[1],
        }),
        links: each(&table(parts, "links", [4, 6])?, link),
        struts: each(&table(parts, "struts", [2, 10])?, strut),
        springs: each(&table(parts, "springs", [3, 3])?, spring),
        masses: each(&table(parts, "masses", [1, 2])?, |i, f| PointMass {
            node: i[0],
            mass: f[0],
            alpha: f[1],
        }),
        fixed: each(&table(parts, "fixed", [2, 0])?, |i, _| (i[0], i[1])),
        ends: each(&table(parts, "ends", [2, 1])?, |i, f| TensionedEnd {
            node: i[0],
            force: f[0],
            released: i[1] != 0,
        }),
        loads: each(&table(parts, "loads", [2, 1])?, |i, f| (i[0], i[1], f[0])),
        wire_loads: each(&table(parts, "wire_loads", [0, 3])?, |_, f| {
            [f[0], f[1], f[2]]
        }),
        fitted_bends: false,
        across_only: false,
        residual: None,
        gravity,
    };
    turn(&mut structure, &table(parts, "turns", [0, 1])?.floats)?;
    Ok(structure)
}

/// By what the track turns along each wire element or segment, or nothing at all.
fn turn(s: &mut Structure, turns: &[f64]) -> PyResult<()> {
    let elements = s.wires.len() + s.segments.len();
    if !turns.is_empty() && turns.len() != elements {
        let message = format!("part turns: {} rows for {elements} elements", turns.len());
        return Err(PyValueError::new_err(message));
    }
    let wires = s.wires.iter_mut().map(|wire| &mut wire.turn);
    let all = wires.chain(s.segments.iter_mut().map(|segment| &mut segment.turn));
    all.zip(turns).for_each(|(turn, &given)| *turn = given);
    Ok(())
}

/// Changes after the design; the arrays are documented in `arcless.mesh`.
pub fn alteration(arrays: &Bound<'_, PyDict>) -> PyResult<Alteration> {
    let item = |name: &str| {
        let found = arrays.get_item(name)?;
        found.ok_or_else(|| PyValueError::new_err(format!("array {name} is missing")))
    };
    let floats = |name: &str| -> PyResult<Vec<f64>> { item(name)?.extract() };
    Ok(Alteration {
        length_factor: floats("length_factor")?,
        axial_factor: floats("axial_factor")?,
        bending_factor: floats("bending_factor")?,
        mass: floats("mass")?,
        load: triples(&item("load")?.extract()?)?,
        link_factor: floats("link_factor")?,
        link_offset: floats("link_offset")?,
        spring_offset: floats("spring_offset")?,
        strut_offset: floats("strut_offset")?,
        end_force: item("end_force")?.extract()?,
        removed: item("removed")?.extract()?,
    })
}

fn wire(i: &[usize], f: &[f64]) -> Wire {
    Wire {
        nodes: [i[0], i[1]],
        slope_nodes: [i[2], i[3]],
        section: Section {
            rest_length: f[0],
            axial_stiffness: f[1],
            bending_stiffness: f[2],
        },
        turn: 0.0,
        mass: f[3],
        damping: Rayleigh {
            alpha: f[4],
            beta: f[5],
        },
        design_tension: f[6],
    }
}

fn segment(i: &[usize], f: &[f64]) -> Segment {
    Segment {
        nodes: [i[0], i[1]],
        rest_length: f[0],
        axial_stiffness: f[1],
        turn: 0.0,
        mass: f[2],
        damping: Rayleigh {
            alpha: f[3],
            beta: f[4],
        },
        design_tension: f[5],
    }
}

fn link(i: &[usize], f: &[f64]) -> Link {
    Link {
        nodes: [i[0], i[1]],
        unilateral: i[2] != 0,
        adjust: i[3] != 0,
        rest_length: f[0],
        stiffness: f[1],
        viscosity: f[2],
        damping: Rayleigh {
            alpha: f[3],
            beta: f[4],
        },
        mass: f[5],
    }
}

fn strut(i: &[usize], f: &[f64]) -> Strut {
    Strut {
        node: i[0],
        adjust: i[1] != 0,
        direction: [f[0], f[1], f[2]],
        anchor: [f[3], f[4], f[5]],
        rest_length: f[6],
        stiffness: f[7],
        moving_mass: f[8],
        hanging_mass: f[9],
    }
}

fn spring(i: &[usize], f: &[f64]) -> Spring {
    let mode = match i[2] {
        0 => SpringMode::Given,
        1 => SpringMode::Held,
        _ => SpringMode::Unloaded,
    };
    Spring {
        node: i[0],
        component: i[1],
        mode,
        stiffness: f[0],
        viscosity: f[1],
        rest: f[2],
    }
}
