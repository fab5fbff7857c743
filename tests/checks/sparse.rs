//! The optimizer on problems of many variables with sparse derivatives: the same problems dense and sparse, and with closed forms.

#[path = "../problems/scalable.rs"]
mod scalable;

use longdrive::optimize::{
    Domain, Exact, Observer, Options, Snapshot, Solution, SparseEvaluation, SparseProblem, SparseTaylor, Status,
    minimize, minimize_sparse,
};
use scalable::{Scalable, bryson_denham, chained_rosenbrock, double_wells, hanging_chain, membrane};
use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::Ordering;

/// The problem, solved and judged.
fn solved(problem: Scalable) -> Solution {
    let (name, domain, start) = (problem.name, problem.domain.clone(), problem.start.clone());
    let problem = Exact(problem);
    let found = minimize_sparse(&problem, &domain, &start, &Options::default(), Observer::default()).unwrap();
    assert_eq!(found.status, Status::Converged, "{name}: {}", found.message);
    let residual = kkt_residual(&problem, &domain, &found);
    assert!(residual <= 1e-8, "{name}: KKT residual {residual:e}");
    found
}

/// What the KKT conditions are missed by, reckoned here from the functions and the multipliers, in the problem's own units.
fn kkt_residual(problem: &impl SparseProblem, domain: &Domain, found: &Solution) -> f64 {
    let at = problem.evaluate(&found.x).unwrap();
    let mut slopes = vec![0.0; found.x.len()];
    let weights = found.constraints.iter().map(|constraint| constraint.multiplier);
    for (function, weight) in std::iter::once((&at.objective, 1.0)).chain(at.constraints.iter().zip(weights)) {
        function.gradient.iter().for_each(|(i, slope)| slopes[*i] += weight * slope);
    }
    let mut worst = 0.0_f64;
    for (i, x) in found.x.iter().enumerate() {
        let (low, high) = (domain.variables.low[i], domain.variables.high[i]);
        let (lower, upper) = (found.lower_multipliers[i], found.upper_multipliers[i]);
        assert!(low <= *x && *x <= high && lower >= 0.0 && upper >= 0.0);
        assert!((lower == 0.0 || *x == low) && (upper == 0.0 || *x == high));
        worst = worst.max((slopes[i] - lower + upper).abs());
    }
    for (j, constraint) in found.constraints.iter().enumerate() {
        let (low, high) = (domain.constraints.low[j], domain.constraints.high[j]);
        let value = at.constraints[j].value;
        worst = worst.max((value - value.clamp(low, high)).abs());
        let limit = if constraint.multiplier > 0.0 { high } else { low };
        if constraint.multiplier != 0.0 {
            worst = worst.max((constraint.multiplier * (value - limit)).abs());
        }
    }
    worst
}

/// The optimum that Ipopt prints for it, in whose distribution it is an example: 6.2324586324379885.
#[test]
fn published_optimum_of_the_chained_rosenbrock_function_in_1000_variables() {
    let found = solved(chained_rosenbrock(1000, true));
    assert!((found.value.unwrap() - 6.232_458_632_437_988_5).abs() < 1e-9, "{:?}", found.value);
}

/// Where the links hang at rest the horizontal pull H is one and the same, and the vertical one grows by the weight of a link from each to
/// the next: the slopes of the links are an arithmetic sequence over H. H follows from the width, a number found here by bisection.
#[test]
fn exact_shape_of_a_chain_of_500_links() {
    let (links, h) = (500, 2.0 / 500.0);
    let slope = |k: usize, pull: f64| h * (k as f64 - 0.5 * (links as f64 - 1.0)) / pull;
    let width = |pull: f64| (0..links).map(|k| h / slope(k, pull).hypot(1.0)).sum::<f64>();
    let (mut low, mut high) = (1e-3, 1e3);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if width(middle) < 1.0 { low = middle } else { high = middle }
    }
    let found = solved(hanging_chain(links));
    let mut at = (0.0, 0.0);
    for k in 0..links {
        let length = slope(k, low).hypot(1.0);
        at = (at.0 + h / length, at.1 + h * slope(k, low) / length);
        let off = (found.x[2 * k + 2] - at.0).hypot(found.x[2 * k + 3] - at.1);
        assert!(off < 1e-8, "joint {}: {off:e}", k + 1);
    }
}

/// u = 4x² − 2x up to where it touches the floor at ¼ with slope 0, and likewise from the other end. Linear elements are exact at the
/// nodes, of which ¼ is one.
#[test]
fn exact_membrane_of_1000_elements_on_a_floor() {
    let found = solved(membrane(1000));
    for (i, u) in found.x.iter().enumerate() {
        let x = (i as f64 / 1000.0).min(1.0 - i as f64 / 1000.0);
        let exact = if x < 0.25 { 4.0 * x * x - 2.0 * x } else { -0.25 };
        assert!((u - exact).abs() < 1e-9, "node {i}: {u} instead of {exact}");
    }
    let on_the_floor = found.x[1..1000].iter().filter(|u| **u == -0.25).count();
    assert!(on_the_floor >= 499, "{on_the_floor} nodes on the floor");
}

/// The least ∫ ½ u² is 4/(9 · 1/9) = 4 (Bryson & Ho 1975).
#[test]
fn order_of_bryson_and_denhams_cart_is_the_square_of_the_step() {
    let off = |steps: usize| solved(bryson_denham(steps)).value.unwrap() - 4.0;
    let (coarse, fine) = (off(168), off(336));
    assert!(fine.abs() < 1e-3, "{fine}");
    let order = (coarse / fine).log2();
    assert!((1.9..2.1).contains(&order), "order {order}: {coarse:e}, {fine:e}");
}

#[test]
fn exact_minimum_of_1000_double_wells_from_their_saddle() {
    let found = solved(double_wells(1000));
    assert!(found.value.unwrap() < 1e-16, "{:?}", found.value);
    assert!(found.x.iter().all(|x| (x.abs() - 1.0).abs() < 1e-8));
}

#[test]
fn independent_dense_search_ends_at_the_same_points() {
    let both = |build: &dyn Fn() -> Scalable| {
        let sparse = solved(build());
        let problem = build();
        let (name, domain, start) = (problem.name, problem.domain.clone(), problem.start.clone());
        let dense = minimize(&Exact(problem), &domain, &start, &Options::default()).unwrap();
        assert_eq!(dense.status, Status::Converged, "{name}: {}", dense.message);
        let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart(&sparse.x, &dense.x) < 1e-8, "{name}: points {:e} apart", apart(&sparse.x, &dense.x));
        let prices = |found: &Solution| found.constraints.iter().map(|c| c.multiplier).collect::<Vec<_>>();
        let off = apart(&prices(&sparse), &prices(&dense));
        assert!(off < 1e-7, "{name}: multipliers {off:e} apart");
    };
    both(&|| chained_rosenbrock(20, true));
    both(&|| chained_rosenbrock(20, false));
    both(&|| hanging_chain(12));
    both(&|| membrane(32));
    both(&|| bryson_denham(12));
}

/// x₁ + … + xₙ = 2 n, with every x at most 1.
#[test]
fn exact_contradiction_of_sparse_constraints_is_infeasible() {
    let n = 200;
    let problem = |x: &[f64]| {
        let objective = SparseTaylor {
            value: x.iter().map(|x| x * x).sum(),
            gradient: x.iter().map(|x| 2.0 * x).enumerate().collect(),
            hessian: (0..x.len()).map(|i| (i, i, 2.0)).collect(),
        };
        let gradient = (0..x.len()).map(|i| (i, 1.0)).collect();
        let constraints = vec![SparseTaylor { value: x.iter().sum(), gradient, hessian: vec![] }];
        Ok(SparseEvaluation { objective, constraints })
    };
    let limit = 2.0 * n as f64;
    let domain = Domain::new(vec![-1.0; n], vec![1.0; n]).unwrap().subject_to(vec![limit], vec![limit]).unwrap();
    let found = minimize_sparse(&problem, &domain, &vec![0.0; n], &Options::default(), Observer::default()).unwrap();
    assert_eq!(found.status, Status::Infeasible, "{}", found.message);
    assert!((found.constraints[0].violation + n as f64).abs() < 1e-6, "{:?}", found.constraints);
    assert!(found.message.contains("start elsewhere"), "{}", found.message);
}

#[test]
fn exact_reasons_where_a_sparse_evaluation_does_not_fit_the_domain() {
    let reason = |constraints: Vec<SparseTaylor>, gradient: Vec<(usize, f64)>| {
        let problem = move |_: &[f64]| {
            let objective = SparseTaylor { value: 0.0, gradient: gradient.clone(), hessian: vec![] };
            Ok(SparseEvaluation { objective, constraints: constraints.clone() })
        };
        let domain = Domain::new(vec![0.0; 2], vec![1.0; 2]).unwrap();
        let found = minimize_sparse(&problem, &domain, &[0.5; 2], &Options::default(), Observer::default()).unwrap();
        assert_eq!(found.status, Status::Undefined);
        found.message
    };
    let beyond = reason(vec![], vec![(2, 1.0)]);
    assert!(beyond.contains("a derivative by variable 2, but 2 variables, counted from 0"), "{beyond}");
    let unlimited = reason(vec![SparseTaylor::default()], vec![]);
    assert!(unlimited.contains("1 constraint function, but limits for 0"), "{unlimited}");
    let infinite = reason(vec![], vec![(0, f64::NAN)]);
    assert!(infinite.contains("not finite"), "{infinite}");
}

#[test]
fn independent_resumed_sparse_search_ends_with_the_same_bits() {
    let whole = solved(hanging_chain(24));
    let problem = hanging_chain(24);
    let (domain, start) = (problem.domain.clone(), problem.start.clone());
    let problem = Exact(problem);
    let kept: Rc<RefCell<Option<Snapshot>>> = Rc::default();
    let (keep, mut observer) = (kept.clone(), Observer::default());
    let interrupt = observer.interrupt.clone();
    observer.keep = Some(Box::new(move |snapshot| {
        *keep.borrow_mut() = Some(snapshot.clone());
        if snapshot.iterations() >= 3 {
            interrupt.store(true, Ordering::Relaxed);
        }
        Ok(())
    }));
    let stopped = minimize_sparse(&problem, &domain, &start, &Options::default(), observer).unwrap();
    assert_eq!(stopped.status, Status::Interrupted);
    let text = serde_json::to_string(&kept.borrow().clone().unwrap()).unwrap();
    let resume = Some(serde_json::from_str(&text).unwrap());
    let observer = Observer { resume, interrupt: Arc::default(), ..Observer::default() };
    let resumed = minimize_sparse(&problem, &domain, &start, &Options::default(), observer).unwrap();
    assert_eq!((resumed.x, resumed.status, resumed.iterations), (whole.x, whole.status, whole.iterations));
}
