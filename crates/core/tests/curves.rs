//! Lines on a track that turns: tangents, and explicit steps against those of a matrix.

use crate::tests::common;

use arcless_core::scheme::Scheme;
use arcless_core::statics::Geometry;
use arcless_core::statics::assembly::{LinkLaw, Shape};
use arcless_core::structure::Structure;
use common::chain::{explicit, lumped, settled, yielding};
use common::space::staggered;
use common::{peak, prepare_any, run, simple_line_of, three_masses, travel};

const SPANS: usize = 4;
const RADIUS: f64 = 600.0;
const STEP: f64 = 1e-3;
const CONTACT: f64 = 50e3;

/// On a curve to the left; arms that pull to the outside of it, as all are on a tight one.
fn curved(elements: [f64; 2]) -> (Structure, Vec<usize>) {
    let (s, path) = simple_line_of(SPANS, elements);
    let mut s = staggered(&s, SPANS, -1e-6);
    s.struts
        .iter_mut()
        .for_each(|arm| arm.direction = [0.0, -1.0, 0.0]);
    let at: Vec<f64> = s.positions.iter().map(|p| p[0]).collect();
    for wire in &mut s.wires {
        wire.turn = (at[wire.nodes[1]] - at[wire.nodes[0]]) / RADIUS;
    }
    (s, path)
}

/// Forces of everything in a shape.
fn forces<const D: usize>(g: &Geometry<3, D>, shape: &Shape<D>) -> Shape<D> {
    let mut residual = vec![[0.0; D]; shape.len()];
    g.wire_and_weight_residual(shape, &mut residual);
    g.add_link_and_support_forces(shape, LinkLaw::Linear, &mut residual);
    residual
}

/// Largest difference of K times a motion from central differences of the forces, N.
fn off<const D: usize>(s: Structure) -> f64 {
    let (g, shape) = settled::<3, D>(s);
    let mut k = g.empty_matrix();
    g.tangent(&shape, LinkLaw::Linear, &mut k);
    // No pattern, and the same at both ends of nothing.
    let motion = |i: usize, c: usize| ((7 * i + 3 * c) as f64 * 0.77).sin();
    let h = 1e-6;
    let moved = |by: f64| -> Shape<D> {
        let node = |(i, r): (usize, &[f64; D])| std::array::from_fn(|c| r[c] + by * motion(i, c));
        shape.iter().enumerate().map(node).collect()
    };
    let [up, down] = [h, -h].map(|by| forces(&g, &moved(by)));
    let mut product = vec![[0.0; D]; shape.len()];
    for i in 0..k.rows() {
        for at in k.row_start[i]..k.row_start[i + 1] {
            let j = k.columns[at];
            for (p, q) in (0..D * D).map(|pair| (pair / D, pair % D)) {
                product[i][p] += k.blocks[at][p][q] * motion(j, q);
                if i != j {
                    product[j][q] += k.blocks[at][p][q] * motion(i, p);
                }
            }
        }
    }
    let all = product
        .iter()
        .flatten()
        .zip(up.iter().flatten().zip(down.iter().flatten()));
    let apart = |(k, (up, down)): (&f64, (&f64, &f64))| (k - (up - down) / (2.0 * h)).abs();
    all.map(apart).fold(0.0, f64::max)
}

#[test]
fn tangents_in_curves_are_the_gradients_of_the_forces() {
    let (s, _) = curved([1.45, 2.9]);
    // Tolerance in N/m, of EA/L = 1e7 N/m: rounding of forces of EA over h, 1e-3, and the weight of
    // droppers, whose length changes.
    let (cubic, chain) = (off::<6>(s.clone()), off::<3>(lumped(&s)));
    assert!(cubic < 50.0 && chain < 50.0, "{cubic} {chain}");
}

#[test]
fn explicit_steps_in_a_curve_follow_those_of_a_matrix() {
    let (s, path) = curved([0.45, 0.6]);
    let chain = lumped(&s);
    let travel = travel(60.0, 160.0, 275.0 / 3.6, STEP);
    let plan = arcless_core::simulation::recording::record::RecordPlan {
        ledger: false,
        ..common::everything()
    };
    let pantograph = three_masses(150.0);
    let steps = explicit::<3, 3>(&(chain.clone(), vec![path.clone()]), STEP, CONTACT);
    let fast = run(
        &steps.expect("short steps"),
        std::slice::from_ref(&pantograph),
        &travel,
        &plan,
    );
    let scheme = Scheme::generalised_alpha(0.9);
    let solved = prepare_any::<3, 3>((yielding(&chain), path), |_| (), scheme, STEP, CONTACT);
    let slow = run(&solved, &[pantograph], &travel, &plan);
    // Steps with a matrix see polygons, whose corners change forces of single steps, not heights.
    // These were 3 mm apart before ends of reaches were drawn to the inside of the curve.
    let count = fast.height.len().min(slow.height.len());
    let apart: Vec<f64> = (0..count)
        .map(|k| fast.height[k] - slow.height[k])
        .collect();
    assert!(peak(&apart) < 1e-3, "{}", peak(&apart));
}
