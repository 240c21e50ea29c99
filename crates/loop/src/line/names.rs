//! Names of the parts of a line, for its variables and for messages.

use crate::line::OnLine;
use crate::model::strip_prefixes;
use crate::variable::identifiers;
use arcless_core::CoreError;

/// Names of the parts of a line.
#[derive(Debug, Clone, Default)]
pub struct LineNames {
    /// Pantographs, as identifiers.
    pub(crate) pantographs: Vec<String>,
    /// Strips: that of the pantograph, and its number where there are several.
    pub(crate) strips: Vec<String>,
    /// Parts of pantographs that have a height.
    pub(crate) heights: Vec<String>,
    /// Pantographs that have an actuator.
    pub(crate) driven: Vec<String>,
    /// Supports.
    pub(crate) supports: Vec<String>,
    /// True for a line in three dimensions.
    pub(crate) is_spatial: bool,
}

impl LineNames {
    /// Names of a line in the plane; `driven` are the numbers of pantographs with an actuator.
    pub(crate) fn new(pantographs: &[OnLine], supports: &[String], driven: &[usize]) -> Self {
        let names: Vec<String> = pantographs.iter().map(|p| p.name.clone()).collect();
        let names = identifiers(&names);
        let pairs = || names.iter().zip(pantographs);
        let strips = pairs().flat_map(|(name, pantograph)| {
            let prefixes = strip_prefixes(pantograph.strips);
            let full = |prefix: &String| format!("{name}.{prefix}");
            let full = prefixes.iter().map(full).collect::<Vec<_>>();
            full.into_iter()
                .map(|name| name.trim_end_matches('.').to_string())
        });
        let heights = pairs().flat_map(|(name, pantograph)| {
            let own: Vec<String> = pantograph.heights.iter().map(|(_, n)| n.clone()).collect();
            let own = identifiers(&own).into_iter();
            own.map(|part| format!("{name}.{part}")).collect::<Vec<_>>()
        });
        let driven = driven
            .iter()
            .filter_map(|&number| names.get(number).cloned());
        Self {
            strips: strips.collect(),
            heights: heights.collect(),
            driven: driven.collect(),
            supports: identifiers(supports),
            pantographs: names,
            is_spatial: false,
        }
    }

    /// Message of a failure. `by_strip`: numbers of the core are those of strips.
    pub(crate) fn explain(&self, error: &CoreError, by_strip: bool) -> String {
        let names = if by_strip {
            &self.strips
        } else {
            &self.pantographs
        };
        let named = |number: &usize| names.get(*number).map_or("a pantograph", String::as_str);
        match error {
            CoreError::OffWire {
                pantograph,
                position,
                ..
            } => format!(
                "`{}` is at {position} m, where there is no contact wire: the line ends before",
                named(pantograph)
            ),
            CoreError::OutOfReach {
                pantograph,
                position,
                lateral,
                half_width,
                ..
            } => format!(
                "the contact wire at {position} m is {lateral:.3} m from the middle of `{}`, whose \
                 strip reaches {half_width} m",
                named(pantograph)
            ),
            CoreError::NotFinite { .. } => "the motion has grown beyond all bounds: a force or a \
                                            coupling that is unstable"
                .into(),
            other => other.to_string(),
        }
    }
}
