//! Values that the core may return: errors with a text, and finite numbers.

use arcless_core::CoreError;
use arcless_core::simulation::recording::record::Record;

/// Nothing when there is an error; its text must be there all the same.
pub fn told<T>(found: Result<T, CoreError>) -> Option<T> {
    found
        .map_err(|error| assert!(!error.to_string().is_empty()))
        .ok()
}

pub fn assert_finite(what: &str, values: impl IntoIterator<Item = f64>) {
    for (at, value) in values.into_iter().enumerate() {
        assert!(value.is_finite(), "{what}: {value} at {at}");
    }
}

/// Check that a record holds NaN only where there is no wire, and infinite gaps only there.
pub fn check(r: &Record) {
    for (at, height) in r.height.iter().enumerate() {
        let absent = height.is_nan();
        assert!(height.is_finite() || absent, "height {height}");
        assert!(r.lateral[at].is_finite() || absent, "lateral");
        assert!(r.gap[at].is_finite() || absent, "gap {}", r.gap[at]);
    }
    let series: [(&str, &[f64]); 13] = [
        ("time", &r.time),
        ("force", &r.force),
        ("position", &r.position),
        ("speed", &r.speed),
        ("control", &r.control),
        ("masses", &r.masses),
        ("link force", &r.link_force),
        ("uplift", &r.uplift),
        ("point uplift", &r.point_uplift),
        ("point along", &r.point_along),
        ("link extremes", &r.link_max),
        ("stops", &r.stop_max),
        ("laws", &r.law_ranges),
    ];
    for (what, values) in series {
        assert_finite(what, values.iter().copied());
    }
    assert_finite("energy", r.energy.iter().map(|e| e.residual()));
    assert!(r.force.iter().all(|&f| f >= 0.0), "a contact that pulls");
}
