//! Elements on a track that turns.
//!
//! Positions are counted along the track and from it, slopes in its directions, so a wire that is
//! straight in space seems bent, and motion across seems to stretch it: by y′ v′, of which a part
//! is not real. Stretching and bending are those in space. The frame of an element has the
//! direction of the track in its middle; it turns by τ along it, from −τ/2 to τ/2, on a circle of
//! radius Δx/τ. With c = cos τ/2, s = sin τ/2, k = s/(τ/2), at its first and second end (upper and
//! lower sign)
//!
//!   position   (k x ± s y, c y)            slope   (c x′ ± s y′, c y′ ∓ s x′)
//!
//! up to a constant: linear, e* = A e, so forces are Aᵀ f* and stiffnesses Aᵀ K* A. The tension N
//! of a straight wire then pulls at y with N τ towards the inside, whatever N is. Slopes that two
//! elements share stay smooth where the curvature of the track jumps. Left out: that masses turn.

/// Frame of an element along which the track turns.
#[derive(Debug, Clone, Copy)]
pub struct Frame {
    sin: f64,
    cos: f64,
    chord: f64,
}

impl Frame {
    /// Frame for a turn to the left, rad; `None` on a straight track, and in the plane.
    #[must_use]
    pub fn new<const DIM: usize>(turn: f64) -> Option<Self> {
        let (sin, cos) = (0.5 * turn).sin_cos();
        let chord = 2.0 * sin / turn;
        let frame = Self { sin, cos, chord };
        (DIM == 3 && turn != 0.0).then_some(frame)
    }

    /// Matrix A of a position (`slope` false) or slope at the first or second end (0, 1).
    #[must_use]
    pub fn matrix<const DIM: usize>(&self, end: usize, slope: bool) -> [[f64; DIM]; DIM] {
        let sin = if end == 0 { self.sin } else { -self.sin };
        let mut a = [[0.0; DIM]; DIM];
        (2..DIM).for_each(|c| a[c][c] = 1.0);
        a[0][0] = if slope { self.cos } else { self.chord };
        a[1][0] = if slope { -sin } else { 0.0 };
        (a[0][1], a[1][1]) = (sin, self.cos);
        a
    }
}

/// Coordinates A x in the frame.
#[must_use]
pub fn to_frame<const DIM: usize>(a: &[[f64; DIM]; DIM], x: &[f64; DIM]) -> [f64; DIM] {
    a.map(|row| (0..DIM).map(|c| row[c] * x[c]).sum())
}

/// Forces Aᵀ f of forces f in the frame.
#[must_use]
pub fn from_frame<const DIM: usize>(a: &[[f64; DIM]; DIM], f: &[f64; DIM]) -> [f64; DIM] {
    std::array::from_fn(|c| (0..DIM).map(|r| a[r][c] * f[r]).sum())
}

/// Stiffness Aᵀ K B of a stiffness K in the frame.
#[must_use]
pub fn congruence<const DIM: usize>(
    a: &[[f64; DIM]; DIM],
    k: &[[f64; DIM]; DIM],
    b: &[[f64; DIM]; DIM],
) -> [[f64; DIM]; DIM] {
    let mut product = [[0.0; DIM]; DIM];
    for (p, q) in (0..DIM * DIM).map(|pair| (pair / DIM, pair % DIM)) {
        for (m, n) in (0..DIM * DIM).map(|pair| (pair / DIM, pair % DIM)) {
            product[p][q] += a[m][p] * k[m][n] * b[n][q];
        }
    }
    product
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::hermite;
    use crate::structure::Section;

    const SECTION: Section = Section {
        rest_length: 1.4,
        axial_stiffness: 15.0e6,
        bending_stiffness: 195.0,
    };
    const RADIUS: f64 = 300.0;
    /// Distance of the chord from the centre of the curve, m.
    const NEAR: f64 = 299.8;
    const STRETCH: f64 = 1.001;

    /// A chord seen from the track: position and slope at the angle φ from its middle. A place of
    /// it is NEAR/cos φ from the centre, and NEAR tan φ along it.
    fn on_chord(phi: f64) -> [[f64; 3]; 2] {
        let (sin, cos) = phi.sin_cos();
        // The slope is counted in the directions of the track there, as in space.
        let place = [RADIUS * phi, RADIUS - NEAR / cos, 5.0];
        [place, [STRETCH * cos, -STRETCH * sin, 0.0]]
    }

    fn seen(half: f64) -> ([[f64; 3]; 4], Frame) {
        let ([a, b], [c, d]) = (on_chord(-half), on_chord(half));
        let frame = Frame::new::<3>(2.0 * half).expect("a curve");
        (e_star(&frame, [a, b, c, d]), frame)
    }

    fn e_star(frame: &Frame, e: [[f64; 3]; 4]) -> [[f64; 3]; 4] {
        std::array::from_fn(|k| to_frame(&frame.matrix(k / 2, k % 2 == 1), &e[k]))
    }

    /// Nothing bends it, it has the tension of its stretch, and it pulls at its ends as it leans
    /// there.
    #[test]
    fn a_straight_wire_seen_from_a_curve_is_straight() {
        let half = (0.5 * STRETCH * SECTION.rest_length / NEAR).atan();
        let (e, frame) = seen(half);
        // Rounding of positions of 300 m.
        let exact = 15e6 * 0.5 * (STRETCH * STRETCH - 1.0) * STRETCH;
        for xi in [0.0, 0.3, 0.5, 1.0] {
            let found = hermite::tension(&SECTION, &e, xi);
            assert!(
                (found / exact - 1.0).abs() < 1e-7,
                "{found} N for {exact} N"
            );
        }
        let mut force = [[0.0; 3]; 4];
        hermite::add_force(&SECTION, &e, &mut force);
        let force: [[f64; 3]; 4] =
            std::array::from_fn(|k| from_frame(&frame.matrix(k / 2, k % 2 == 1), &force[k]));
        let lean = exact * half.sin();
        assert!(lean > 30.0, "the partner: it leans");
        for end in [0, 2] {
            assert!((force[end][1] + lean).abs() < 1e-3, "{force:?}");
        }
        // Slopes are pulled along the wire alone, by the same at both ends and turned round.
        assert!(
            force[1][1].abs() < 1e-2 && force[3][1].abs() < 1e-2,
            "{force:?}"
        );
    }

    /// A motion normal to the chord, seen from the track, stretches nothing.
    #[test]
    fn a_motion_across_a_straight_wire_does_not_stretch_it() {
        let half = (0.5 * STRETCH * SECTION.rest_length / NEAR).atan();
        let (e, frame) = seen(half);
        // A parabola, normal to the chord: 1 mm in the middle, and 0 at the ends.
        let bow = 4e-3 / SECTION.rest_length;
        let chord = [[0.0; 3], [0.0, bow, 0.0], [0.0; 3], [0.0, -bow, 0.0]];
        // Back to the directions of the track, which turn by ∓ half.
        let moved = |k: usize| -> [f64; 3] {
            let (sin, cos) = half.sin_cos();
            let sin = if k < 2 { sin } else { -sin };
            let [along, across, up] = chord[k];
            [cos * along - sin * across, sin * along + cos * across, up]
        };
        let by = e_star(&frame, std::array::from_fn(moved));
        let bent: [[f64; 3]; 4] =
            std::array::from_fn(|k| std::array::from_fn(|c| e[k][c] + by[k][c]));
        let more = hermite::tension(&SECTION, &bent, 0.5) - hermite::tension(&SECTION, &e, 0.5);
        assert!(more.abs() < 1.0, "{more} N");
        // Without the frame the slopes of the track, ± half, stretch it: EA times half times the
        // bow, at the ends.
        let plain = SECTION.axial_stiffness * half * bow;
        assert!(plain > 50.0, "the partner: {plain} N");
    }
}
