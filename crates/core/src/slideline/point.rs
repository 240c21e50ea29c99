//! A place on a wire: where a contact acts, and on which degrees of freedom.

/// Vectors of a node, each of which takes a share of a force on the wire: its position, and its
/// slope where it has one.
#[must_use]
pub const fn slots<const DIM: usize, const D: usize>() -> usize {
    D / DIM
}

/// Vectors of nodes.
pub trait Nodal<const D: usize> {
    /// Vector of a node.
    fn at(&self, node: usize) -> &[f64; D];
}

impl<const D: usize> Nodal<D> for [[f64; D]] {
    #[inline(always)]
    fn at(&self, node: usize) -> &[f64; D] {
        &self[node]
    }
}

impl<const D: usize> Nodal<D> for Vec<[f64; D]> {
    #[inline(always)]
    fn at(&self, node: usize) -> &[f64; D] {
        &self[node]
    }
}

/// A place on a lane. It needs no lane to read a field there or to put a force on the wire.
#[derive(Debug, Clone, Copy, Default)]
pub struct SlidelinePoint<const DIM: usize> {
    /// Element of the lane.
    pub element: usize,
    /// Nodes that take part, the last one again where there are fewer than four.
    pub nodes: [usize; 4],
    /// How many they are.
    pub count: usize,
    /// Number of its first node among the nodes of all lanes, for influence columns.
    pub number: usize,
    /// Shape functions: with S [`slots`], number k belongs to slot k % S of node k / S.
    pub weights: [f64; 4],
    /// Static height, m.
    pub height: f64,
    /// Static lateral position, m (zero when planar).
    pub lateral: f64,
}

impl<const DIM: usize> SlidelinePoint<DIM> {
    /// Component `c` of a displacement field.
    #[inline(always)]
    #[must_use]
    pub fn displacement<const D: usize>(&self, x: &(impl Nodal<D> + ?Sized), c: usize) -> f64 {
        let (w, [n0, n1, n2, n3]) = (&self.weights, self.nodes);
        let (a, b) = (x.at(n0), x.at(n1));
        if slots::<DIM, D>() == 1 {
            let outer = w[2] * x.at(n2)[c] + w[3] * x.at(n3)[c];
            return w[0] * a[c] + w[1] * b[c] + outer;
        }
        w[0] * a[c] + w[1] * a[DIM + c] + w[2] * b[c] + w[3] * b[DIM + c]
    }

    /// Numbers of the influence columns of a force here.
    #[inline(always)]
    #[must_use]
    pub fn columns<const D: usize>(&self) -> std::ops::Range<usize> {
        let slots = slots::<DIM, D>();
        slots * self.number..slots * (self.number + self.count)
    }

    /// Degrees of freedom that share component `c` of a force: node, component, share.
    pub fn shares<const D: usize>(&self, c: usize) -> impl Iterator<Item = (usize, usize, f64)> {
        let (slots, nodes, weights) = (slots::<DIM, D>(), self.nodes, self.weights);
        (0..self.count * slots).map(move |k| (nodes[k / slots], k % slots * DIM + c, weights[k]))
    }

    /// Add a force on component `c`.
    pub fn add_force<const D: usize>(&self, force: f64, c: usize, f: &mut [[f64; D]]) {
        for (node, component, share) in self.shares::<D>(c) {
            f[node][component] += share * force;
        }
    }
}
