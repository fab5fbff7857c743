//! A batch refuses a source of points whose length or parameters are wrong, and a block that
//! belongs to another batch.

use crate::common::panic_of;
use longdrive::batch::{Batch, Points, Run, Status};
use longdrive::parameters::{Parameter, Vary};
#[cfg(feature = "full")]
use longdrive::report::SweepParquet;
use longdrive::report::{SweepCsv, SweepJsonLines};
use longdrive::units::TableUnits;
use longdrive::{Error, Outcome, Result, Setup};

/// A faulty source of points. It appends `appended` values for each row, and up to `more` rows more
/// than requested.
struct CustomPoints {
    parameters: Vec<&'static Parameter>,
    rows: Vec<[f64; 2]>,
    next: usize,
    appended: usize,
    more: usize,
}

impl CustomPoints {
    fn new(parameters: &[&'static Parameter], count: usize) -> Self {
        let rows = (0..count).map(|i| [0.15 + 1e-5 * i as f64, 45.0]).collect();
        Self {
            parameters: parameters.to_vec(),
            rows,
            next: 0,
            appended: parameters.len(),
            more: 0,
        }
    }
}

impl Points for CustomPoints {
    fn parameters(&self) -> &[&'static Parameter] {
        &self.parameters
    }
    fn ranges(&self) -> Vec<Vary> {
        vec![]
    }
    fn rows(&self) -> u64 {
        self.rows.len() as u64
    }
    fn seek(&mut self, row: u64) -> Result<()> {
        self.next = usize::try_from(row).unwrap().min(self.rows.len());
        Ok(())
    }
    fn read(&mut self, most: usize, values: &mut Vec<f64>) -> Result<usize> {
        let rows = (most + self.more).min(self.rows.len() - self.next);
        for row in &self.rows[self.next..][..rows] {
            values.extend(&row[..self.appended]);
        }
        self.next += rows;
        Ok(rows)
    }
    fn identity(&self) -> String {
        "mine".into()
    }
}

fn loft_and_speed(setup: &Setup<f64>) -> [&'static Parameter; 2] {
    ["club.loft", "swing.speed"].map(|name| setup.variable(name).unwrap())
}

/// Values of other parameters would give wrong drives.
#[test]
fn points_of_other_parameters_than_the_batch_are_refused_with_both_lists() {
    let setup = Setup::modern_driver();
    let [loft, speed] = loft_and_speed(&setup);
    let batch = Batch::new(&setup, &[loft, speed], &[Outcome::Carry], &[]).unwrap();
    for (parameters, named) in [
        (vec![loft], "points of club.loft: "),
        (vec![speed, loft], "swing.speed, club.loft: "),
    ] {
        let mut handed_on = 0;
        let run = batch.run(
            &mut CustomPoints::new(&parameters, 3),
            &Run::default(),
            |block| block,
            |_| {
                handed_on += 1;
                Ok(())
            },
        );
        let error = run.unwrap_err();
        assert!(
            matches!(error, Error::Together { .. }) && handed_on == 0,
            "{error:?}"
        );
        let error = error.to_string();
        assert!(
            error.contains(named)
                && error.contains("the parameters of the batch are club.loft, swing.speed"),
            "{error}"
        );
    }
    assert_eq!(
        batch
            .run(
                &mut CustomPoints::new(&[loft, speed], 3),
                &Run::default(),
                |_| (),
                |()| Ok(())
            )
            .unwrap(),
        3
    );
}

/// After a missing value, all later values would belong to wrong parameters.
#[test]
fn points_with_wrong_numbers_of_values_are_refused_after_the_rows_before() {
    let setup = Setup::modern_driver();
    let of_both = loft_and_speed(&setup);
    let short = CustomPoints {
        appended: 1,
        ..CustomPoints::new(&of_both, 10)
    };
    let long = CustomPoints {
        more: 5,
        ..CustomPoints::new(&of_both, 5000)
    };
    for (mut points, says) in [
        (
            short,
            "called for at most 10 rows, returned 10 and appended 10 values: it must append 2 values \
             for each row",
        ),
        (
            long,
            "called for at most 1024 rows, returned 1029 and appended 2058 values",
        ),
    ] {
        let error = Batch::new(&setup, points.parameters(), &[Outcome::BallSpeed], &[])
            .unwrap()
            .run(&mut points, &Run::default(), |block| block, |_| Ok(()));
        let error = error.unwrap_err().to_string();
        assert!(error.contains(says), "{error}");
    }
    // only the last chunk lacks a value
    struct ShortAtTheEnd(CustomPoints);
    impl Points for ShortAtTheEnd {
        fn parameters(&self) -> &[&'static Parameter] {
            self.0.parameters()
        }
        fn ranges(&self) -> Vec<Vary> {
            vec![]
        }
        fn rows(&self) -> u64 {
            self.0.rows()
        }
        fn seek(&mut self, row: u64) -> Result<()> {
            self.0.seek(row)
        }
        fn read(&mut self, most: usize, values: &mut Vec<f64>) -> Result<usize> {
            let rows = self.0.read(most, values)?;
            if self.0.next == self.0.rows.len() {
                values.pop();
            }
            Ok(rows)
        }
        fn identity(&self) -> String {
            "late".into()
        }
    }
    let mut rows = 0;
    let mut points = ShortAtTheEnd(CustomPoints::new(&of_both, 1500));
    let end = Batch::new(
        &setup,
        points.parameters(),
        &[Outcome::BallSpeed],
        &of_both[..1],
    )
    .unwrap()
    .run(
        &mut points,
        &Run::default(),
        |block| block,
        |block| {
            rows += block.rows();
            Ok(())
        },
    );
    assert!(
        end.unwrap_err().to_string().contains("951 values") && rows == 1024,
        "{rows}"
    );
}

/// A batch whose first row is after the last point delivers no block, and returns this row.
#[test]
fn a_batch_that_starts_after_its_last_point_has_no_blocks() {
    let setup = Setup::modern_driver();
    let run = Run {
        first_row: 99_999,
        ..Run::default()
    };
    let mut points = CustomPoints::new(&loft_and_speed(&setup), 20);
    assert_eq!(
        Batch::new(&setup, points.parameters(), &[Outcome::Carry], &[])
            .unwrap()
            .run(&mut points, &run, |block| block, |_| panic!("no block"))
            .unwrap(),
        99_999
    );
}

/// Wrong lengths are programming errors: they panic, with both lengths.
#[test]
fn points_and_blocks_of_wrong_lengths_panic_with_both_lengths() {
    let setup = Setup::modern_driver();
    let [loft, speed] = loft_and_speed(&setup);
    let batch = Batch::new(&setup, &[loft, speed], &[Outcome::Carry], &[loft]).unwrap();
    for points in [vec![0.2], vec![0.2, 45.0, 0.1]] {
        let output = panic_of(|| batch.evaluate(0, points.clone()));
        assert!(
            output.contains(&format!(
                "a multiple of 2 values; there are {}",
                points.len()
            )),
            "{output}"
        );
    }
    let block = batch.evaluate(0, vec![0.2, 45.0]);
    assert_eq!(
        (block.status(0), batch.evaluate(0, vec![]).rows()),
        (Status::Landed, 0)
    );

    let other = Batch::new(&setup, &[loft], &[Outcome::Carry], &[]).unwrap();
    let written: &[&dyn Fn()] = &[
        &|| drop(SweepCsv::new(&other, TableUnits::Si).rows(&block)),
        &|| drop(SweepJsonLines::new(&other).rows(&block)),
        #[cfg(feature = "full")]
        &|| {
            let parquet = SweepParquet::new(&other, "").unwrap();
            drop(parquet.group(std::slice::from_ref(&block)))
        },
    ];
    for write in written {
        let output = panic_of(write);
        assert!(
            output.contains("the table has [1, 1, 0]")
                && output.contains("the block has [2, 1, 1]"),
            "{output}"
        );
    }
    assert!(
        !SweepCsv::new(&batch, TableUnits::Si)
            .rows(&block)
            .is_empty()
            && block.result(7).next().is_none()
    );
    let beyond: [&dyn Fn() -> usize; 6] = [
        &|| block.status(1).name().len(),
        &|| block.point(1).len(),
        &|| usize::from(block.exceeded(1).law),
        &|| block.outcome(1, 0).iter().count(),
        &|| block.outcome(0, 1).iter().count(),
        &|| block.derivatives(1).count(),
    ];
    for read in beyond {
        panic_of(read);
    }
}
