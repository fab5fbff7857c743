//! Times of derivatives and of the optimum, divided by the time of the value alone. The drive is
//! the drive of mae494: loft 10°, attack angle 0°, 276 steps of 0.01 s.
//!
//! `cargo bench --bench drive` measures all tasks in one run and prints the ratios of the fastest
//! samples, because machines are shared and noisy.

use criterion::Criterion;
use longdrive::derivative::{Order, evaluate};
use longdrive::optimize::Observer;
use longdrive::parameters::Parameter;
use longdrive::study::{Search, Vary, optimum};
use longdrive::{Drive, Outcome, Setup};
use std::cell::RefCell;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// The twelve parameters by which the other programs differentiate. Their names there are lam, eps,
/// M, m, R, Ib, d, Iyy, e, V, rho, delta.
const TWELVE: [&str; 12] = [
    "club.loft",
    "swing.attack_angle",
    "club.mass",
    "ball.mass",
    "ball.radius",
    "ball.inertia",
    "club.cg_depth",
    "club.inertia.yy",
    "impact.restitution",
    "swing.speed",
    "air.density",
    "aero.spin_decay",
];

/// The fastest sample of each task, in the order of measurement.
#[derive(Default)]
struct Fastest(RefCell<Vec<(String, Duration)>>);

impl Fastest {
    /// Measures a task with criterion and keeps its fastest sample.
    fn measure<R>(&self, criterion: &mut Criterion, name: &str, task: impl Fn() -> R) {
        criterion.bench_function(&format!("mae494/{name}"), |bencher| {
            bencher.iter_custom(|iterations| {
                let start = Instant::now();
                for _ in 0..iterations {
                    black_box(task());
                }
                let elapsed = start.elapsed();
                self.keep(name, elapsed.div_f64(iterations as f64));
                elapsed
            });
        });
    }

    fn keep(&self, name: &str, sample: Duration) {
        let mut all = self.0.borrow_mut();
        match all.iter_mut().find(|(known, _)| known == name) {
            Some((_, fastest)) => *fastest = sample.min(*fastest),
            None => all.push((name.into(), sample)),
        }
    }

    fn print_ratios(&self) {
        let all = self.0.borrow();
        let Some((_, value)) = all.first() else {
            return;
        };
        println!(
            "\n{:<40} {:>12} {:>10}",
            "mae494, step 0.01 s, fastest samples", "time", "/ value"
        );
        for (name, time) in all.iter() {
            println!(
                "{name:<40} {:>9.2} µs {:>10.2}",
                time.as_secs_f64() * 1e6,
                time.as_secs_f64() / value.as_secs_f64()
            );
        }
    }
}

fn main() {
    let setup = Setup::preset("mae494").expect("a preset of this name");
    let named = |names: &[&str]| -> Vec<&'static Parameter> {
        setup
            .variables_named(names)
            .expect("parameters of these names")
    };
    let (two, twelve, all) = (named(&TWELVE[..2]), named(&TWELVE), setup.variables());
    let derivatives = |wrt: &[&'static Parameter], order| {
        evaluate(black_box(&setup), &[Outcome::Carry], wrt, order)
    };
    let ranges = ["club.loft=0deg..20deg", "swing.attack_angle=-10deg..10deg"];
    let vary = Vary::read_all(&setup, ranges).expect("ranges");
    let search = Search {
        vary,
        ..Search::longest_drive(&setup).expect("the default search")
    };

    let mut criterion = Criterion::default().configure_from_args();
    let fastest = Fastest::default();
    fastest.measure(&mut criterion, "value", || Drive::new(black_box(&setup)));
    fastest.measure(&mut criterion, "gradient, 2 parameters", || {
        derivatives(&two, Order::First)
    });
    fastest.measure(&mut criterion, "gradient, 12 parameters", || {
        derivatives(&twelve, Order::First)
    });
    fastest.measure(
        &mut criterion,
        &format!("gradient, all {} parameters", all.len()),
        || derivatives(&all, Order::First),
    );
    fastest.measure(&mut criterion, "Hessian, 2 parameters", || {
        derivatives(&two, Order::Second)
    });
    fastest.measure(&mut criterion, "optimum from (10°, 0°)", || {
        optimum(&setup, search.clone(), Observer::default())
    });
    criterion.final_summary();
    fastest.print_ratios();
}
