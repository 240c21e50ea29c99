//! Structure from tables of parts: one structured array for each kind, whose columns are read by
//! their names, which are those of the fields of the core.

use arcless_core::statics::Alteration;
use arcless_core::structure::Section;
use arcless_core::structure::{
    Bend, Link, PointMass, Rayleigh, Segment, Spring, SpringMode, Structure, Strut, TensionedEnd,
    Wire,
};
use numpy::ndarray::{ArrayView1, Dimension, Ix1, Ix2};
use numpy::{Element, PyArrayMethods, PyReadonlyArray, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Table of one kind of part.
struct Table<'py> {
    kind: &'static str,
    array: Bound<'py, PyAny>,
    rows: usize,
}

impl<'py> Table<'py> {
    fn of(parts: &Bound<'py, PyDict>, kind: &'static str) -> PyResult<Self> {
        let array = parts.get_item(kind)?;
        let array = array.ok_or_else(|| PyValueError::new_err(format!("no table {kind}")))?;
        let rows = array.len()?;
        Ok(Self { kind, array, rows })
    }

    /// Values of a column, row by row.
    fn column<T: Value>(&self, name: &str) -> PyResult<Vec<T>> {
        let refused = |reason: &str| {
            PyValueError::new_err(format!("table {}: column {name}: {reason}", self.kind))
        };
        let column = self.array.get_item(name);
        let column = column.map_err(|_| refused("there is none"))?;
        let values = T::read(&column).map_err(refused)?;
        if values.len() != self.rows {
            return Err(refused("not as many rows as the table"));
        }
        Ok(values)
    }
}

/// Value that a column holds in each row.
trait Value: Sized {
    /// Reads a column, or tells what it should have been.
    fn read(column: &Bound<'_, PyAny>) -> Result<Vec<Self>, &'static str>;
}

/// Column of numbers as an array of so many dimensions; `None` if it is not one.
fn numbers<'py, T: Element, D: Dimension>(
    column: &Bound<'py, PyAny>,
    row: &[usize],
) -> Option<PyReadonlyArray<'py, T, D>> {
    let array: PyReadonlyArray<'_, T, D> = column.extract().ok()?;
    let steps = array.strides();
    // Rows of a structured array may lie anywhere.
    let is_aligned = array.data().is_aligned()
        && steps
            .iter()
            .all(|step| step % align_of::<T>().cast_signed() == 0);
    (is_aligned && array.shape()[1..] == *row).then_some(array)
}

/// One number in each row.
fn single<T: Element + Copy>(column: &Bound<'_, PyAny>) -> Option<Vec<T>> {
    let array = numbers::<T, Ix1>(column, &[])?;
    Some(array.as_array().iter().copied().collect())
}

/// `N` numbers in each row.
fn several<T: Element + Copy, const N: usize>(column: &Bound<'_, PyAny>) -> Option<Vec<[T; N]>> {
    let array = numbers::<T, Ix2>(column, &[N])?;
    let rows = array.as_array();
    let row = |row: ArrayView1<'_, T>| std::array::from_fn(|k| row[k]);
    Some(rows.rows().into_iter().map(row).collect())
}

fn index(number: i64) -> Result<usize, &'static str> {
    usize::try_from(number).map_err(|_| "a number is negative")
}

impl Value for f64 {
    fn read(column: &Bound<'_, PyAny>) -> Result<Vec<Self>, &'static str> {
        single(column).ok_or("expected a float64 in each row")
    }
}

impl Value for [f64; 3] {
    fn read(column: &Bound<'_, PyAny>) -> Result<Vec<Self>, &'static str> {
        several(column).ok_or("expected three float64 in each row")
    }
}

impl Value for bool {
    fn read(column: &Bound<'_, PyAny>) -> Result<Vec<Self>, &'static str> {
        single(column).ok_or("expected a bool in each row")
    }
}

impl Value for usize {
    fn read(column: &Bound<'_, PyAny>) -> Result<Vec<Self>, &'static str> {
        let all = single(column).ok_or("expected an int64 in each row")?;
        all.into_iter().map(index).collect()
    }
}

impl Value for [usize; 2] {
    fn read(column: &Bound<'_, PyAny>) -> Result<Vec<Self>, &'static str> {
        let all = several::<i64, 2>(column).ok_or("expected two int64 in each row")?;
        all.into_iter()
            .map(|[a, b]| Ok([index(a)?, index(b)?]))
            .collect()
    }
}

impl Value for SpringMode {
    fn read(column: &Bound<'_, PyAny>) -> Result<Vec<Self>, &'static str> {
        let modes = usize::read(column)?.into_iter().map(|mode| match mode {
            0 => Ok(Self::Given),
            1 => Ok(Self::Held),
            2 => Ok(Self::Unloaded),
            _ => Err("expected 0, 1 or 2 in each row"),
        });
        modes.collect()
    }
}

/// Reads a table: names of its columns, and the part that a row of them makes.
macro_rules! rows {
    ($parts:expr, $kind:ident [$($column:ident),+] => $row:expr) => {{
        let table = Table::of($parts, stringify!($kind))?;
        $(let mut $column = table.column(stringify!($column))?.into_iter();)+
        let row = || { $(let $column = $column.next()?;)+ Some($row) };
        std::iter::from_fn(row).collect()
    }};
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

/// Assembles the structure; the columns are documented in `arcless.mesh.tables.columns`.
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
        wires: wires(parts)?,
        segments: rows!(parts, segments [nodes, rest_length, axial_stiffness, mass, alpha, beta,
            design_tension] => Segment { nodes, rest_length, axial_stiffness, turn: 0.0, mass,
            damping: Rayleigh { alpha, beta }, design_tension }),
        bends: rows!(parts, bends [segments, bending_stiffness, beta] => Bend {
            segments, stiffness: bending_stiffness, beta }),
        links: rows!(parts, links [nodes, unilateral, adjust, rest_length, stiffness, viscosity,
            alpha, beta, mass] => Link { nodes, unilateral, adjust, rest_length, stiffness,
            viscosity, damping: Rayleigh { alpha, beta }, mass }),
        struts: rows!(parts, struts [node, adjust, direction, anchor, rest_length, stiffness,
            moving_mass, hanging_mass] => Strut { node, adjust, direction, anchor, rest_length,
            stiffness, moving_mass, hanging_mass }),
        springs: rows!(parts, springs [node, component, mode, stiffness, viscosity, rest] =>
            Spring { node, component, mode, stiffness, viscosity, rest }),
        masses: rows!(parts, masses [node, mass, alpha] => PointMass { node, mass, alpha }),
        fixed: rows!(parts, fixed [node, component] => (node, component)),
        ends: rows!(parts, ends [node, force, released] => TensionedEnd { node, force, released }),
        loads: rows!(parts, loads [node, component, force] => (node, component, force)),
        wire_loads: Table::of(parts, "wire_loads")?.column("force")?,
        fitted_bends: false,
        across_only: false,
        residual: None,
        gravity,
    };
    turn(&mut structure, &Table::of(parts, "turns")?.column("angle")?)?;
    Ok(structure)
}

fn wires(parts: &Bound<'_, PyDict>) -> PyResult<Vec<Wire>> {
    Ok(
        rows!(parts, wires [nodes, slope_nodes, rest_length, axial_stiffness, bending_stiffness,
        mass, alpha, beta, design_tension] => {
            let section = Section { rest_length, axial_stiffness, bending_stiffness };
            let damping = Rayleigh { alpha, beta };
            Wire { nodes, slope_nodes, section, turn: 0.0, mass, damping, design_tension }
        }),
    )
}

/// Set the angle by which the track turns along each element, rad; without angles it is straight.
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
