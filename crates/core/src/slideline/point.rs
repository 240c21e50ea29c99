//! Point of a slideline: where a contact acts, and on which degrees of freedom.

/// Number of vectors of a node with a share of a force on the wire: its position, and its slope
/// where it has one.
#[must_use]
pub const fn slots<const DIM: usize, const D: usize>() -> usize {
    D / DIM
}

/// Vectors by node.
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

/// Point of a slideline. Reading a field there, or applying a force to the wire, needs the point
/// alone.
#[derive(Debug, Clone, Copy, Default)]
pub struct SlidelinePoint<const DIM: usize> {
    /// Element of the slideline.
    pub element: usize,
    /// Nodes with shape functions, the last one repeated where there are fewer than four.
    pub nodes: [usize; 4],
    /// Number of nodes with shape functions.
    pub count: usize,
    /// Number of its first node among the nodes of all slidelines, for influence columns.
    pub number: usize,
    /// Shape functions: with S [`slots`], number k belongs to slot k % S of node k / S.
    pub weights: [f64; 4],
    /// Static height, m.
    pub height: f64,
    /// Static lateral position, m (zero when planar).
    pub lateral: f64,
}

impl<const DIM: usize> SlidelinePoint<DIM> {
    /// Component `c` of a displacement field at the point, m.
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

    /// Numbers of the influence columns of a force at the point.
    #[inline(always)]
    #[must_use]
    pub fn columns<const D: usize>(&self) -> std::ops::Range<usize> {
        let slots = slots::<DIM, D>();
        slots * self.number..slots * (self.number + self.count)
    }

    /// Equivalent nodal forces of a unit force in component `c`: node, component, share.
    pub fn shares<const D: usize>(&self, c: usize) -> impl Iterator<Item = (usize, usize, f64)> {
        let (slots, nodes, weights) = (slots::<DIM, D>(), self.nodes, self.weights);
        (0..self.count * slots).map(move |k| (nodes[k / slots], k % slots * DIM + c, weights[k]))
    }

    /// Adds a force at the point in component `c`, N, to nodal forces `f`.
    pub fn add_force<const D: usize>(&self, force: f64, c: usize, f: &mut [[f64; D]]) {
        for (node, component, share) in self.shares::<D>(c) {
            f[node][component] += share * force;
        }
    }
}
