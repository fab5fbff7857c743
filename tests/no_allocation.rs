//! A flight allocates no heap memory with any number type, after the first flight with a law, and
//! an iteration of the optimizer allocates little. This test is a program of its own, because it
//! counts all allocations of its process.

use longdrive::flight::fly;
use longdrive::impact::strike;
use longdrive::number::{Jet, Mixed, Number, Taylor};
use longdrive::optimize::{Domain, Evaluation, Options, Status, minimize};
use longdrive::{Drive, Setup};

fn allocations<T: Number>(setup: &Setup<f64>, variable: impl Fn(f64) -> T) -> u64 {
    let lifted = setup.map(|row, value| {
        if row.name == "club.loft" {
            variable(value)
        } else {
            T::constant(value)
        }
    });
    let launch = strike(&lifted).unwrap().launch;
    let counted = allocation_counter::measure(|| {
        fly(&lifted, &launch).unwrap();
        Drive::new(&lifted).unwrap();
    });
    counted.count_total
}

#[test]
fn exact_no_allocations_in_a_drive() {
    for law in longdrive::parameters::Law::NAMES {
        let mut setup = Setup::modern_driver();
        setup.set_law(law).unwrap();
        // the first flight with a law may prepare its splines
        Drive::new(&setup).unwrap();
        assert_eq!(allocations(&setup, |value| value), 0);
        assert_eq!(
            allocations(&setup, |value| Jet::<12>::variable(value, 3)),
            0
        );
        assert_eq!(
            allocations(&setup, |value| Mixed::variable(Jet::variable(value, 0), 0)),
            0
        );
    }
}

/// f = eˣ + e⁻ʸ + (x − y)², convex everywhere.
fn bowl(at: &[f64]) -> Result<Evaluation, String> {
    let (x, y) = (at[0], at[1]);
    let (rising, falling, apart) = (x.exp(), (-y).exp(), x - y);
    let objective = Taylor {
        value: rising + falling + apart * apart,
        gradient: vec![rising + 2.0 * apart, -falling - 2.0 * apart],
        hessian: vec![vec![rising + 2.0, -2.0], vec![-2.0, falling + 2.0]],
    };
    Ok(Evaluation::unconstrained(objective))
}

/// Largest number of allocations in an iteration. They are for the active set with its equations
/// and factors, the step, the point, and argmin's copy of the best point.
const PER_ITERATION: u64 = 24;

#[test]
fn regress_allocations_in_an_iteration_within_bounds() {
    let domain = Domain::new(vec![0.0, -1.0], vec![20.0, 20.0]).unwrap();
    let search = |most: u64| {
        let options = Options {
            max_iterations: most,
            ..Options::default()
        };
        let mut solution = None;
        let counted = allocation_counter::measure(|| {
            solution = Some(minimize(&bowl, &domain, &[20.0, 18.0], &options))
        });
        (counted.count_total, solution.unwrap().unwrap())
    };
    let evaluation = allocation_counter::measure(|| drop(bowl(&[0.0, 0.0]))).count_total;
    let (_, end) = search(500);
    assert_eq!((end.status, end.x[0]), (Status::Converged, 0.0));
    assert!(
        end.effort.warm_starts > end.effort.clarabel,
        "{:?}",
        end.effort
    );
    assert!(end.iterations > 10, "{}", end.iterations);
    // the first iteration allocates the workspace, and the last writes the verdict
    for iterations in 2..end.iterations {
        let ((before, first), (after, second)) = (search(iterations - 1), search(iterations));
        if second.effort.clarabel > first.effort.clarabel {
            // Clarabel's own memory is not counted
            continue;
        }
        if second.message.len() > first.message.len() {
            // the memory of the message grows in steps
            continue;
        }
        let evaluations = (second.effort.evaluations - first.effort.evaluations) * evaluation;
        let own = after - before - evaluations;
        assert!(
            own <= PER_ITERATION,
            "{own} allocations in iteration {iterations}"
        );
    }
}
