//! Rows of a record before the first number that is not finite, which a failed step may leave.

use crate::simulation::recording::record::Record;

const LINE_TIME: &str = "line_time";
/// Series that begin the rows of contacts, of the line, and of motion.
const TIMES: [&str; 3] = ["time", LINE_TIME, "motion_time"];
/// Series without NaN for what is not there.
const ALWAYS_FINITE: [&str; 4] = ["force", "masses", "link_force", "uplift"];

impl Record {
    /// Removes the rows from the first one on in which a number is not finite that always is in a
    /// sound run, and later rows of the other tables.
    pub(crate) fn keep_finite(&mut self) {
        let end = self.finite_until();
        let (mut rows, mut kept, mut kept_of_line) = (0, 0, 0);
        for (name, series) in Self::SERIES.iter().zip(self.series_mut()) {
            if TIMES.contains(name) {
                rows = series.len();
                kept = series.partition_point(|time| *time < end);
            }
            if *name == LINE_TIME {
                kept_of_line = kept;
            }
            series.truncate(kept * series.len().checked_div(rows).unwrap_or(0));
        }
        self.energy.truncate(kept_of_line);
        let columns = self.motion.len().checked_div(rows).unwrap_or(0);
        self.motion.truncate(kept * columns);
    }

    /// Returns the first time with a number that is not finite, s; infinite without one.
    fn finite_until(&mut self) -> f64 {
        let motion = self.motion.iter().position(|v| !v.is_finite());
        let (values, mut end, mut times) = (self.motion.len(), f64::INFINITY, Vec::new());
        for (name, series) in Self::SERIES.iter().zip(self.series_mut()) {
            if TIMES.contains(name) {
                times.clone_from(series);
            }
            let found = series.iter().position(|v| !v.is_finite());
            if let (true, Some(at)) = (ALWAYS_FINITE.contains(name), found) {
                end = end.min(times[at * times.len() / series.len()]);
            }
        }
        // The last times are those of motion.
        motion.map_or(end, |at| end.min(times[at * times.len() / values]))
    }
}

#[cfg(test)]
mod tests {
    use crate::energy_terms::EnergyTerms;
    use crate::simulation::recording::record::Record;

    type Spoil = fn(&mut Record);

    fn record() -> Record {
        Record {
            time: vec![0.0, 1.0, 2.0, 3.0],
            force: vec![1.0; 8],
            gap: vec![f64::INFINITY; 8],
            height: vec![f64::NAN; 8],
            line_time: vec![0.0, 2.0],
            uplift: vec![0.1; 6],
            energy: vec![EnergyTerms::unknown(); 2],
            motion_time: vec![0.0, 1.0, 2.0, 3.0],
            motion_first: vec![5.0; 8],
            motion: vec![0.5; 12],
            ..Record::default()
        }
    }

    fn rows(r: &Record) -> [usize; 8] {
        let (contacts, lines) = ([&r.time, &r.force, &r.height], [&r.line_time, &r.uplift]);
        let [time, force, height] = contacts.map(Vec::len);
        let [line, uplift] = lines.map(Vec::len);
        let motion = [r.motion_time.len(), r.motion.len()];
        [
            time,
            force,
            height,
            line,
            uplift,
            r.energy.len(),
            motion[0],
            motion[1],
        ]
    }

    #[test]
    fn rows_from_the_first_number_on_that_is_not_finite_are_removed() {
        let spoils: [(Spoil, [usize; 8]); 5] = [
            (|_| (), [4, 8, 8, 2, 6, 2, 4, 12]),
            (|r| r.force[5] = f64::NAN, [2, 4, 4, 1, 3, 1, 2, 6]),
            (|r| r.uplift[4] = f64::INFINITY, [2, 4, 4, 1, 3, 1, 2, 6]),
            (|r| r.motion[11] = f32::INFINITY, [3, 6, 6, 2, 6, 2, 3, 9]),
            (|r| r.force[0] = f64::NAN, [0; 8]),
        ];
        for (spoil, expected) in spoils {
            let mut found = record();
            spoil(&mut found);
            found.keep_finite();
            assert_eq!(rows(&found), expected);
            assert_eq!(found.motion_first.len(), 2 * expected[6]);
        }
    }
}
