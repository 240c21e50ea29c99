//! Motion of an external pantograph in a step.

use crate::pantograph::state::PantographState;

/// Deviation of a compliance matrix from symmetry, and from positive semi-definiteness, that is
/// accepted as a share of its largest entry: differences of a program's results have it. The
/// problem of a step has one solution all the same, as wires add some 10 µm/N and more.
const COMPLIANCE_ROUNDING: f64 = 1e-6;

impl PantographState {
    /// Sets the motion of the coming step: heights above the datum at its end without contact
    /// forces, m, and the compliance, m/N, row by row. After a refusal nothing has changed.
    ///
    /// # Errors
    /// A reason.
    pub(crate) fn set_external_motion(
        &mut self,
        heights: &[f64],
        datum: f64,
        compliance: &[f64],
    ) -> Result<(), String> {
        let n = self.u.len();
        if heights.len() != n || compliance.len() != n * n {
            return Err(format!(
                "{} heights and {} compliances, expected {n} and {}",
                heights.len(),
                compliance.len(),
                n * n
            ));
        }
        if let Some(height) = heights.iter().find(|z| !z.is_finite()) {
            return Err(format!("the height is {height} m"));
        }
        check_compliance(compliance, n, &mut self.external.work)?;
        for (free, height) in self.external.free.iter_mut().zip(heights) {
            *free = height - datum;
        }
        self.set_response(compliance);
        Ok(())
    }

    /// Replaces the predicted heights above the datum at the end of the step by those that the
    /// program has reached, m.
    ///
    /// # Errors
    /// A reason.
    pub(crate) fn set_reached_heights(
        &mut self,
        heights: &[f64],
        datum: f64,
    ) -> Result<(), String> {
        if let Some(height) = heights.iter().find(|z| !z.is_finite()) {
            return Err(format!("the height is {height} m"));
        }
        for ((delta, u), height) in self.delta.iter_mut().zip(&self.u).zip(heights) {
            *delta = height - datum - u;
        }
        Ok(())
    }

    /// Writes the heights at the end of the step, in the datum of the line, m.
    pub(crate) fn write_heights(&self, datum: f64, out: &mut [f64]) {
        for ((out, u), delta) in out.iter_mut().zip(&self.u).zip(&self.delta) {
            *out = datum + u + delta;
        }
    }

    /// Commits the increment of an external pantograph in a step of `h` s.
    pub(crate) fn commit_external(&mut self, h: f64) {
        for ((u, v), delta) in self.u.iter_mut().zip(&mut self.v).zip(&self.delta) {
            *u += delta;
            *v = delta / h;
        }
    }
}

/// Refuses a matrix that is not symmetric and positive semi-definite up to rounding; `work` has
/// room for it.
fn check_compliance(s: &[f64], n: usize, work: &mut [f64]) -> Result<(), String> {
    if let Some(value) = s.iter().find(|v| !v.is_finite()) {
        return Err(format!("the compliance is {value} m/N"));
    }
    let largest = s.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    let tolerance = COMPLIANCE_ROUNDING * largest;
    for i in 0..n {
        for j in 0..i {
            let [lower, upper] = [s[i * n + j], s[j * n + i]];
            if (lower - upper).abs() > tolerance {
                return Err(format!(
                    "the compliance is not symmetric: {lower} and {upper} m/N"
                ));
            }
        }
    }
    // Cholesky's pivots of S + tolerance · 1.
    for i in 0..n {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| work[i * n + k] * work[j * n + k]).sum();
            let reduced = 0.5 * (s[i * n + j] + s[j * n + i]) - known;
            if i != j {
                work[i * n + j] = reduced / work[j * n + j];
            } else if reduced + tolerance > 0.0 {
                work[i * n + i] = (reduced + tolerance).sqrt();
            } else if largest > 0.0 {
                return Err("the compliance is negative for some forces".into());
            } else {
                work[i * n + i] = 1.0;
            }
        }
    }
    Ok(())
}
