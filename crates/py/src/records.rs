//! What a run records: the plan that comes from Python, and the arrays that go there.

use arcless_core::checkpoint::Checkpoint;
use arcless_core::integrator::energy::implicit::EnergyTerms;
use arcless_core::simulation::recording::record::{Record, RecordPlan};
use arcless_core::simulation::recording::window::{Near, SortedStations};
use numpy::{IntoPyArray, ToPyArray};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Distance behind the last rider in m; links; nodes.
type NearData = (f64, OrderedData, OrderedData);

/// Numbers in the order along the track, coordinates in m, and how many a row holds.
type OrderedData = (Vec<usize>, Vec<f64>, usize);

fn near((behind, links, nodes): NearData) -> Near {
    let ordered = |(of, x, count): OrderedData| SortedStations { of, x, count };
    Near {
        behind,
        links: ordered(links),
        nodes: ordered(nodes),
    }
}

pub fn read_plan(plan: &Bound<'_, PyDict>) -> PyResult<RecordPlan> {
    let get = |key: &str| plan.as_any().get_item(key);
    Ok(RecordPlan {
        contact_every: get("contact_every")?.extract()?,
        line_every: get("line_every")?.extract()?,
        links: get("links")?.extract()?,
        nodes: get("nodes")?.extract()?,
        points: get("points")?.extract()?,
        ledger: get("ledger")?.extract()?,
        ledger_every: get("ledger_every")?.extract()?,
        near: plan
            .get_item("near")?
            .map(|v| v.extract::<Option<NearData>>())
            .transpose()?
            .flatten()
            .map(near),
    })
}

pub fn numbers<'py>(py: Python<'py>, state: &Checkpoint) -> PyResult<Bound<'py, PyDict>> {
    let out = PyDict::new(py);
    for (name, values) in &state.numbers {
        out.set_item(name, values.to_pyarray(py))?;
    }
    Ok(out)
}

pub fn arrays(py: Python<'_>, r: Record) -> PyResult<Bound<'_, PyDict>> {
    let out = PyDict::new(py);
    out.set_item("contacts", &r.contacts)?;
    out.set_item("energy", energies(py, &r.energy)?)?;
    out.set_item("slack_max", r.slack_max)?;
    out.set_item("pivots", r.pivots)?;
    out.set_item("pivots_max", r.pivots_max)?;
    out.set_item("pivot_counts", &r.pivot_counts)?;
    out.set_item("fallbacks", r.fallbacks)?;
    out.set_item("lcp_residual", r.lcp_residual)?;
    out.set_item("steps", r.steps)?;
    out.set_item("energy_residual", r.energy_residual)?;
    out.set_item("energy_turnover", r.energy_turnover)?;
    out.set_item("energy_switching", r.energy_switching)?;
    // The arrays take over the memory of the record: nothing is copied.
    let series: [(&str, Vec<f64>); 22] = [
        ("time", r.time),
        ("force", r.force),
        ("gap", r.gap),
        ("height", r.height),
        ("lateral", r.lateral),
        ("position", r.position),
        ("speed", r.speed),
        ("masses", r.masses),
        ("line_time", r.line_time),
        ("link_force", r.link_force),
        ("uplift", r.uplift),
        ("link_first", r.link_first),
        ("uplift_first", r.uplift_first),
        ("point_uplift", r.point_uplift),
        ("point_along", r.point_along),
        ("slack", r.slack),
        ("link_min", r.link_min),
        ("link_max", r.link_max),
        ("uplift_max", r.uplift_max),
        ("stop_max", r.stop_max),
        ("law_ranges", r.law_ranges),
        ("control", r.control),
    ];
    for (name, values) in series {
        out.set_item(name, values.into_pyarray(py))?;
    }
    Ok(out)
}

fn energies<'py>(py: Python<'py>, ledger: &[EnergyTerms]) -> PyResult<Bound<'py, PyDict>> {
    type Entry = (&'static str, fn(&EnergyTerms) -> f64);
    let entries: [Entry; 16] = [
        ("kinetic", |e| e.kinetic),
        ("elastic", |e| e.elastic),
        ("contact", |e| e.contact),
        ("riders", |e| e.riders),
        ("dissipated_line", |e| e.dissipated_line),
        ("dissipated_links", |e| e.dissipated_links),
        ("dissipated_springs", |e| e.dissipated_springs),
        ("dissipated_riders", |e| e.dissipated_riders),
        ("dissipated_scheme", |e| e.dissipated_scheme),
        ("switching", |e| e.switching),
        ("work_uplift", |e| e.work_uplift),
        ("work_control", |e| e.work_control),
        ("work_traction", |e| e.work_traction),
        ("work_friction", |e| e.work_friction),
        ("work_loads", |e| e.work_loads),
        ("residual", EnergyTerms::residual),
    ];
    let energy = PyDict::new(py);
    for (name, read) in entries {
        let values: Vec<f64> = ledger.iter().map(read).collect();
        energy.set_item(name, values.to_pyarray(py))?;
    }
    Ok(energy)
}
