//! Decisions and numbers read from bytes; when they are used up, all decisions are zero.

use arbitrary::Unstructured;

/// Numbers that break arithmetic, each in its own way.
const HOSTILE: [f64; 16] = [
    0.0,
    -0.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    f64::MIN_POSITIVE,
    5e-324,
    1e300,
    -1e300,
    1e-300,
    1e160,
    1e-160,
    1.0,
    -1.0,
];

/// A stream of decisions.
pub struct Feed<'a>(Unstructured<'a>);

impl<'a> Feed<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self(Unstructured::new(bytes))
    }

    pub fn byte(&mut self) -> u8 {
        self.0.arbitrary().unwrap_or(0)
    }

    /// A number below `limit`, which is at most 256.
    pub fn below(&mut self, limit: usize) -> usize {
        usize::from(self.byte()) % limit
    }

    pub fn flag(&mut self) -> bool {
        self.byte() % 2 == 1
    }

    /// One of many.
    pub fn place(&mut self, limit: usize) -> usize {
        let word: u16 = self.0.arbitrary().unwrap_or(0);
        usize::from(word) % limit.max(1)
    }

    /// The usual number, a multiple of it, or a hostile one.
    pub fn number(&mut self, usual: f64) -> f64 {
        match self.byte() {
            0..=127 => usual,
            b @ 128..=199 => usual * 2.0_f64.powi(i32::from(b) - 164),
            b @ 200..=223 => -usual * 2.0_f64.powi(i32::from(b) - 212),
            b @ 224..=239 => HOSTILE[usize::from(b - 224)],
            240..=247 => usual * (1.0 + f64::from(self.byte()) / 256.0),
            _ => f64::from_bits(self.0.arbitrary().unwrap_or(0)),
        }
    }

    /// A number like the one that stands there, or a hostile one; never the same again.
    pub fn spoil(&mut self, number: &mut f64) {
        let usual = if *number == 0.0 { 1.0 } else { *number };
        let found = self.number(usual);
        *number = if found.to_bits() == number.to_bits() {
            -found
        } else {
            found
        };
    }

    /// An index near those of a small problem, or far beyond any.
    pub fn index(&mut self, usual: usize) -> usize {
        match self.byte() {
            b @ 0..=223 => usize::from(b) % (usual + 3),
            224..=231 => usize::MAX,
            232..=239 => 1 << 40,
            _ => usize::from(self.byte()),
        }
    }

    /// Leave out or repeat one entry.
    pub fn disturb<T: Clone>(&mut self, list: &mut Vec<T>) {
        if list.is_empty() {
            return;
        }
        let (at, to) = (self.place(list.len()), self.place(list.len() + 1));
        if self.flag() {
            list.insert(to, list[at].clone());
        } else {
            list.remove(at);
        }
    }
}
