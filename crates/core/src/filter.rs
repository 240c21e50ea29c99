//! Recursive filters as a cascade of second-order sections, in transposed direct form II:
//!
//!   y = b₀x + z₁,   z₁ ← b₁x − a₁y + z₂,   z₂ ← b₂x − a₂y
//!
//! Source: Oppenheim & Schafer, Discrete-Time Signal Processing, section 6.3.

/// Second-order section: b₀, b₁, b₂, a₁, a₂ (a₀ = 1).
pub type Section = [f64; 5];

/// Filters a signal in place; `state` holds z₁ and z₂ of each section, before and after.
pub fn cascade(sections: &[Section], state: &mut [[f64; 2]], signal: &mut [f64]) {
    for value in signal {
        for (&[b0, b1, b2, a1, a2], z) in sections.iter().zip(state.iter_mut()) {
            let x = *value;
            let y = b0 * x + z[0];
            z[0] = b1 * x - a1 * y + z[1];
            z[1] = b2 * x - a2 * y;
            *value = y;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_sections_give_what_is_found_by_hand() {
        // y = x + ½ y₋₁ and then y = x + x₋₁ + x₋₂: 1, ½, ¼, … summed over three.
        let sections = [[1.0, 0.0, 0.0, -0.5, 0.0], [1.0, 1.0, 1.0, 0.0, 0.0]];
        let mut signal = [1.0, 0.0, 0.0, 0.0];
        let mut state = [[0.0; 2]; 2];
        cascade(&sections, &mut state, &mut signal);
        assert_eq!(signal, [1.0, 1.5, 1.75, 0.875]);
        assert_eq!(state, [[0.0625, 0.0], [0.375, 0.125]]);
    }
}
