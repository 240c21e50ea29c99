//! Variables of a device: names, units, descriptions.

/// Role of a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Causality {
    /// Time.
    Independent,
    /// Given from outside, and held until it is given again.
    Input,
    /// Found by the device.
    Output,
    /// Number that stays the same.
    Constant,
}

impl Causality {
    /// Name, as the FMI writes it where it has one.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Independent => "independent",
            Self::Input => "input",
            Self::Output => "output",
            Self::Constant => "constant",
        }
    }
}

/// Variable of a device. Its number in the list of all is the one it is asked for by.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Name, of letters, digits, underscores, points and indices in brackets.
    pub name: String,
    /// Unit, SI; "1" for a number without one.
    pub unit: &'static str,
    /// Description, one sentence without a full stop.
    pub description: String,
    /// Role.
    pub causality: Causality,
    /// Value at the start.
    pub start: f64,
    /// Outputs that say what the next step would bring: they change with the inputs for it.
    pub is_prediction: bool,
}

impl Variable {
    /// Input with its value at the start.
    #[must_use]
    pub fn input(name: String, unit: &'static str, description: String, start: f64) -> Self {
        Self {
            name,
            unit,
            description,
            causality: Causality::Input,
            start,
            is_prediction: false,
        }
    }

    /// Output of the last step.
    #[must_use]
    pub fn output(name: String, unit: &'static str, description: String) -> Self {
        Self {
            causality: Causality::Output,
            ..Self::input(name, unit, description, 0.0)
        }
    }

    /// Output that says what the next step would bring with the inputs that stand.
    #[must_use]
    pub fn prediction(name: String, unit: &'static str, description: String) -> Self {
        Self {
            is_prediction: true,
            ..Self::output(name, unit, description)
        }
    }

    /// Number that is the same at all times.
    #[must_use]
    pub fn constant(name: &str, unit: &'static str, description: &str, value: f64) -> Self {
        Self {
            causality: Causality::Constant,
            ..Self::input(name.into(), unit, description.into(), value)
        }
    }

    /// Time since the start, s.
    #[must_use]
    pub fn time() -> Self {
        Self {
            causality: Causality::Independent,
            ..Self::input("time".into(), "s", "Time since the start".into(), 0.0)
        }
    }
}

/// Name that programs accept: letters, digits and underscores, no digit first.
#[must_use]
pub fn identifier(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let mut found: String = name.trim().chars().map(plain).collect();
    if found.is_empty() || found.starts_with(|c: char| c.is_ascii_digit()) {
        found.insert(0, '_');
    }
    found
}

/// Identifiers of names, numbered where two would be the same.
#[must_use]
pub fn identifiers(names: &[String]) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for name in names {
        let plain = identifier(name);
        let mut own = plain.clone();
        let mut number = 2;
        while found.contains(&own) {
            own = format!("{plain}_{number}");
            number += 1;
        }
        found.push(own);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::identifiers;

    #[test]
    fn names_become_identifiers_that_differ() {
        let names = ["P1", "rear pan", "rear-pan", "2nd", "Süd"].map(String::from);
        let expected = ["P1", "rear_pan", "rear_pan_2", "_2nd", "S_d"];
        assert_eq!(identifiers(&names), expected);
    }
}
