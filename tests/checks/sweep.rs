//! Batches in the library: points in order, values compared with single drives, statuses, tables,
//! and the bytes of the formats.

use crate::common::{all_blocks, close};
use longdrive::batch::{
    Batch, Block, CHUNK, Grid, GridAxis, Points, Run, Sequence, Status, StatusCounts,
};
use longdrive::derivative::Order;
use longdrive::parameters::{Parameter, Vary};
use longdrive::report::{SweepCsv, SweepJsonLines};
use longdrive::statistics::{Histogram, Ranking, SummarySpec};
use longdrive::table::open_table;
use longdrive::units::TableUnits;
use longdrive::{Drive, Error, Outcome, Setup, derivative};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

fn grid(setup: &Setup<f64>, axes: &[&str]) -> Grid {
    Grid::new(
        axes.iter()
            .map(|text| GridAxis::read(setup, text).unwrap())
            .collect(),
    )
    .unwrap()
}

pub fn all(points: &mut dyn Points) -> Vec<f64> {
    let mut values = vec![];
    points.seek(0).unwrap();
    while points.read(7, &mut values).unwrap() > 0 {}
    values
}

/// Coarse steps: many drives in little time.
fn quick() -> Setup<f64> {
    let mut setup = Setup::modern_driver();
    setup.set("flight.step", "0.5 s").unwrap();
    setup
}

#[test]
fn exact_grid_has_its_first_axis_outermost_and_both_ends() {
    let setup = Setup::modern_driver();
    let mut points = grid(
        &setup,
        &[
            "swing.speed=40m/s..50m/s:3",
            "club.loft=0.1..0.4rad:4",
            "air.density=1..1kg/m^3:1",
        ],
    );
    assert_eq!(
        (points.rows(), points.parameters()[0].name),
        (12, "swing.speed")
    );
    let step = 0.4 - 0.1;
    let lofts = [0.1, 0.1 + step * 1.0 / 3.0, 0.1 + step * 2.0 / 3.0, 0.4];
    let expected = [40.0, 45.0, 50.0]
        .into_iter()
        .flat_map(|v| lofts.into_iter().flat_map(move |loft| [v, loft, 1.0]));
    assert_eq!(all(&mut points), expected.collect::<Vec<f64>>());
    let mut values = vec![];
    points.seek(5).unwrap();
    assert_eq!(
        (points.read(1, &mut values).unwrap(), values),
        (1, vec![45.0, lofts[1], 1.0])
    );
}

#[test]
fn same_values_and_gradients_in_a_sweep_and_alone() {
    let setup = Setup::modern_driver();
    let of = [
        Outcome::Carry,
        Outcome::Lateral,
        Outcome::SpinAxis,
        Outcome::LandingSpeed,
    ];
    let wrt = ["swing.face_angle", "air.density"].map(|name| setup.variable(name).unwrap());
    let axes = ["club.loft=8deg..14deg:3", "swing.face_angle=-2deg..3deg:4"];
    let mut seen = 0;
    let mut points = grid(&setup, &axes);
    let batch = Batch::new(&setup, points.parameters(), &of, &wrt).unwrap();
    for block in all_blocks(&batch, &mut points) {
        for row in 0..block.rows() {
            let mut moved = setup;
            [moved.club.loft, moved.swing.face_angle] = block.point(row).try_into().unwrap();
            assert_eq!(block.status(row), Status::Landed);
            let taylors = derivative::evaluate(&moved, &of, &wrt, Order::First).unwrap();
            let drive = Drive::new(&moved).unwrap();
            let mut derivatives = block.derivatives(row);
            for (at, (outcome, taylor)) in of.iter().zip(&taylors).enumerate() {
                let value = outcome.value(&drive).unwrap();
                close(
                    block.outcome(row, at).unwrap(),
                    value,
                    value.abs().max(1.0),
                    1e-12,
                    outcome.name(),
                );
                for d in &taylor.gradient {
                    close(
                        derivatives.next().unwrap().unwrap(),
                        *d,
                        d.abs().max(1.0),
                        1e-12,
                        outcome.name(),
                    );
                }
            }
            seen += 1;
        }
    }
    assert_eq!(seen, 12);
}

#[test]
fn drives_of_every_kind_have_a_status_and_no_nan() {
    let mut setup = quick();
    let status = |setup: &Setup<f64>, axis: &str| {
        let mut found = vec![];
        let of = [Outcome::Carry, Outcome::LaunchAngle];
        let wrt = [setup.variable("club.loft").unwrap()];
        let mut points = grid(setup, &[axis]);
        let batch = Batch::new(setup, points.parameters(), &of, &wrt).unwrap();
        for block in all_blocks(&batch, &mut points) {
            for row in 0..block.rows() {
                let numbers = block.outcomes(row).chain(block.derivatives(row));
                assert!(numbers.flatten().all(f64::is_finite));
                let exist: Vec<_> = block
                    .outcomes(row)
                    .chain(block.derivatives(row))
                    .map(|x| x.is_some())
                    .collect();
                found.push((block.status(row), exist));
            }
        }
        found
    };
    let launch_only = vec![false, true, false, true];
    assert_eq!(
        status(&setup, "club.loft=-20deg..10deg:2"),
        [
            (Status::NoFlight, launch_only.clone()),
            (Status::Landed, vec![true; 4])
        ]
    );
    // only the status of the drive with a square face is checked, not that of the drive at 89.9°
    assert_eq!(
        status(&setup, "swing.face_angle=0deg..89.9deg:2")[0].0,
        Status::Landed
    );
    setup.set("club.roll_radius", "100 mm").unwrap();
    assert_eq!(
        status(&setup, "strike.high=0mm..200mm:2"),
        [
            (Status::Landed, vec![true; 4]),
            (Status::NoStrike, vec![false; 4])
        ]
    );
    // no body has this tensor of inertia
    assert_eq!(
        status(&setup, "club.inertia.xz=0..0.5kg m^2:2"),
        [
            (Status::Landed, vec![true; 4]),
            (Status::OutOfRange, vec![false; 4])
        ]
    );
    setup.set("flight.time_limit", "1 s").unwrap();
    assert_eq!(
        status(&setup, "club.loft=10deg..10deg:1"),
        [(Status::Aloft, launch_only)]
    );
}

/// All blocks of a batch.
fn blocks(run: &Run<'_>) -> Vec<Block> {
    let setup = quick();
    let mut points = grid(
        &setup,
        &[
            "club.loft=-2deg..20deg:41",
            "swing.attack_angle=-5deg..5deg:100",
        ],
    );
    let mut blocks = vec![];
    Batch::new(
        &setup,
        points.parameters(),
        &[Outcome::Carry, Outcome::LaunchAngle],
        &[],
    )
    .unwrap()
    .run(
        &mut points,
        run,
        |block| block,
        |block| {
            blocks.push(block.clone());
            Ok(())
        },
    )
    .unwrap();
    blocks
}

/// All numbers of blocks, with missing values, as a text that differs if a bit differs.
fn bits(blocks: &[Block]) -> String {
    format!("{blocks:?}")
}

/// In such a batch no row reads the parameter, so its derivative would be 0.
#[test]
fn a_derivative_by_a_parameter_that_swept_parameters_replace_is_refused() {
    let setup = Setup::modern_driver();
    let refusal = |swept: &[&str], wrt: &str| {
        let swept: Vec<_> = swept
            .iter()
            .map(|name| setup.column(name).unwrap())
            .collect();
        let wrt = [setup.variable(wrt).unwrap()];
        Batch::new(&setup, &swept, &[Outcome::Carry], &wrt)
            .unwrap_err()
            .to_string()
    };
    let density = refusal(&["air.temperature"], "air.density");
    assert!(
        density.contains("it follows from air.temperature"),
        "{density}"
    );
    let wind = refusal(&["wind.speed", "wind.from"], "wind.downrange");
    assert!(wind.contains("it follows from wind.speed"), "{wind}");
}

#[test]
fn same_order_and_bits_for_any_threads_and_from_any_chunk() {
    let whole = blocks(&Run {
        threads: 1,
        ..Run::default()
    });
    assert_eq!(
        whole.iter().map(Block::rows).collect::<Vec<_>>(),
        [CHUNK, CHUNK, CHUNK, CHUNK, 4]
    );
    assert_eq!(
        whole.iter().map(Block::first_row).collect::<Vec<_>>(),
        [0, 1024, 2048, 3072, 4096]
    );
    assert_eq!(
        bits(&blocks(&Run {
            threads: 3,
            ..Run::default()
        })),
        bits(&whole)
    );
    assert_eq!(
        bits(&blocks(&Run {
            first_row: 2048,
            threads: 2,
            ..Run::default()
        })),
        bits(&whole[2..])
    );
    let mut status_counts = StatusCounts::default();
    whole.iter().for_each(|block| status_counts.add(block));
    assert_eq!(
        status_counts.counts().map(|(_, count)| count).sum::<u64>(),
        4100
    );
    assert!(
        status_counts.counts().take(2).all(|(_, count)| count > 100),
        "{status_counts:?}"
    );
}

#[test]
fn a_batch_stops_on_request_and_at_an_error_of_the_sink() {
    let setup = quick();
    let stop = AtomicBool::new(false);
    let mut points = grid(&setup, &["club.loft=5deg..20deg:1000000"]);
    let run = Run {
        threads: 2,
        stop: Some(&stop),
        ..Run::default()
    };
    let mut rows = 0;
    let done = Batch::new(&setup, points.parameters(), &[Outcome::BallSpeed], &[])
        .unwrap()
        .run(
            &mut points,
            &run,
            |block| block,
            |block| {
                rows += block.rows() as u64;
                stop.store(true, Ordering::Relaxed);
                Ok(())
            },
        );
    // only chunks that were being computed at the stop are delivered
    assert_eq!(done.unwrap(), rows);
    assert!(rows >= CHUNK as u64 && rows <= 10 * CHUNK as u64, "{rows}");

    let full = || Error::Output(std::io::ErrorKind::StorageFull.into());
    let run = Run::default();
    let refused = Batch::new(&setup, points.parameters(), &[Outcome::BallSpeed], &[])
        .unwrap()
        .run(&mut points, &run, |block| block, |_| Err(full()));
    assert!(matches!(refused, Err(Error::Output(_))));
}

#[test]
fn same_sequence_from_any_row() {
    let setup = Setup::modern_driver();
    let over = ["club.loft=5..15deg", "swing.speed=80..120mph"]
        .map(|text| Vary::read(&setup, text).unwrap());
    let mut points = Sequence::new(over.to_vec(), 70_000, 0).unwrap();
    let values = all(&mut points);
    let mut other = Sequence::new(over.to_vec(), 70_000, 1).unwrap();
    assert_ne!(all(&mut other), values);
    assert_ne!(other.identity(), points.identity());
    assert_eq!(values.len(), 140_000);
    let mut again = vec![];
    points.seek(69_990).unwrap();
    assert_eq!(points.read(100, &mut again).unwrap(), 10);
    assert_eq!(again, values[139_980..]);
    for (i, vary) in over.iter().enumerate() {
        let of = || values.iter().skip(i).step_by(2);
        assert!(of().all(|x| *x >= vary.low && *x < vary.high));
        let mean = of().sum::<f64>() / 70_000.0;
        close(
            mean,
            0.5 * (vary.low + vary.high),
            vary.high - vary.low,
            1e-4,
            "the mean of an even spread",
        );
    }
}

#[test]
fn bad_axes_are_refused_with_advice() {
    let setup = Setup::modern_driver();
    for (text, says) in [
        ("club.loft=5deg..15deg", "the number of values is missing"),
        (
            "club.loft=5deg..15deg:0",
            "the number of values must be at least 1",
        ),
        ("club.loft=5deg..15deg:-3", "'-3' is not a number of values"),
        (
            "club.loft=5deg..15deg:1e3",
            "'1e3' is not a number of values",
        ),
        ("club.loft=15deg..5deg:3", "the range is reversed"),
        ("club.lofft=5deg..15deg:3", "did you mean 'club.loft'?"),
        ("club.loft=5kg..15kg:3", "not an angle"),
        ("club.loft=5deg..95deg:3", "outside its range"),
        ("club.loft:3", "write NAME=LOW..HIGH"),
        ("flight.step=1ms..5ms:3", "setting of the computation"),
    ] {
        let message = GridAxis::read(&setup, text).unwrap_err().to_string();
        assert!(message.contains(says), "{text}: {message}");
    }
    let axis = |text| GridAxis::read(&setup, text).unwrap();
    let twice = Grid::new(vec![
        axis("club.loft=5deg..15deg:3"),
        axis("club.loft=5deg..15deg:3"),
    ])
    .unwrap_err();
    assert!(twice.to_string().contains("given twice"), "{twice}");
    assert!(matches!(Grid::new(vec![]), Err(Error::Nothing { .. })));
    let huge = vec![
        axis("club.loft=5deg..15deg:10000000000"),
        axis("swing.path=-1deg..1deg:10000000000"),
    ];
    let message = Grid::new(huge).unwrap_err().to_string();
    assert!(
        message.contains("1.0e20 drives would take 2.4e12 GB, more than any disk"),
        "{message}"
    );
}

pub fn table(name: &str, text: impl AsRef<[u8]>) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    (folder, path)
}

#[test]
fn csv_tables_have_units_in_their_heads() {
    let setup = Setup::modern_driver();
    let text = "\u{feff}club.loft [deg], swing.speed [mph],air.density [kg/m^3]\n10.5,110,1.2\n\n \
                -3 , 9.5e1,\"0\"\n";
    let (_folder, path) = table("points.csv", text);
    let mut points = open_table(&setup, &path).unwrap();
    assert_eq!(points.rows(), 2);
    let expected = [
        10.5_f64.to_radians(),
        49.1744,
        1.2,
        -(3.0_f64.to_radians()),
        95.0 * 0.44704,
        0.0,
    ];
    assert_eq!(all(points.as_mut()), expected);
    points.seek(1).unwrap();
    let mut last = vec![];
    assert_eq!(
        (points.read(5, &mut last).unwrap(), last),
        (1, expected[3..].to_vec())
    );
}

#[test]
fn same_csv_table_in_utf_16_and_utf_8() {
    let setup = Setup::modern_driver();
    let text = "\u{feff}club.loft [deg]\tswing.speed [mph]\r\n10.5\t110\r\n11\t95\r\n";
    let (folder, path) = table("points.csv", text);
    let wide = folder.path().join("wide.csv");
    std::fs::write(
        &wide,
        text.encode_utf16()
            .flat_map(u16::to_le_bytes)
            .collect::<Vec<u8>>(),
    )
    .unwrap();
    let [plain, wide] = [path, wide].map(|path| all(open_table(&setup, &path).unwrap().as_mut()));
    assert!(plain == wide && plain.len() == 4, "{wide:?}");
}

#[test]
fn bad_tables_are_refused_by_row_and_column_before_any_work() {
    let setup = Setup::modern_driver();
    for (name, text, says) in [
        (
            "a.csv",
            "club.loft [rad]\n0.1\nten\n",
            "a.csv, row 2, column club.loft: 'ten' is not a number",
        ),
        (
            "a.csv",
            "club.loft [rad]\n0.1\n1e400\n",
            "row 2, column club.loft: '1e400' is not finite",
        ),
        (
            "a.csv",
            "gravity [m/s^2]\ninf\n",
            "row 1, column gravity: 'inf' is not finite",
        ),
        (
            "a.csv",
            "club.loft [rad],air.density [kg/m^3]\n0.1\n",
            "row 1",
        ),
        (
            "a.csv",
            "club.loft [rad]\n10 deg\n",
            "a unit is written in the head, as in 'club.loft [rad]'",
        ),
        (
            "a.csv",
            "club.lofft\n0.1\n",
            "column 1: unknown column 'club.lofft'; did you mean 'club.loft'?",
        ),
        (
            "a.csv",
            "swing.sped [mph],club.lft [deg],qqqq\n100,10,1\n",
            "a.csv, columns 1, 2, 3: unknown columns 'swing.sped' (did you mean 'swing.speed'?), \
             'club.lft' (did you mean 'club.loft'?), 'qqqq'; give \
             each a name that is known, or take it out: a column is a parameter",
        ),
        (
            "a.csv",
            "Ball Sped (mph),Lanch Angle (deg),Backspin (rpm)\n150,12,2600\n",
            "near a known head: 'Ball Sped' (did you mean 'ball speed'?), 'Lanch Angle' (did you \
             mean 'launch angle'?)",
        ),
        (
            "a.csv",
            "club.loft [kg]\n0.1\n",
            "column 1: the column 'club.loft': [kg] is not the unit of an angle",
        ),
        (
            "a.csv",
            "club.loft [deg],club.loft [rad]\n0.1,0.1\n",
            "club.loft has two columns",
        ),
        (
            "a.csv",
            "club.loft\n0.1\n",
            "column 1: the column 'club.loft': it has no unit; write it into the head, as in \
             'club.loft [deg]'",
        ),
        ("a.csv", "", "it is empty; give a head"),
        (
            "a.txt",
            "club.loft [rad]\n0.1\n",
            "a table's name must end in .csv",
        ),
    ] {
        let (_folder, path) = table(name, text);
        let message = open_table(&setup, &path).err().expect(text).to_string();
        assert!(message.contains(says), "{text}: {message}");
    }
    let none = open_table(&setup, std::path::Path::new("/nowhere/a.csv"))
        .err()
        .unwrap()
        .to_string();
    assert!(none.contains("/nowhere/a.csv: it cannot be read"), "{none}");
}

#[test]
fn rows_out_of_range_are_rows_of_their_own() {
    let setup = quick();
    let (_folder, path) = table("points.csv", "club.loft [deg]\n10\n120\n-30\n");
    let mut points = open_table(&setup, &path).unwrap();
    let mut found = vec![];
    let batch = Batch::new(&setup, points.parameters(), &[Outcome::Carry], &[]).unwrap();
    for block in all_blocks(&batch, points.as_mut()) {
        found.extend(
            (0..block.rows()).map(|row| (block.status(row), block.outcome(row, 0).is_some())),
        );
    }
    assert_eq!(
        found,
        [
            (Status::Landed, true),
            (Status::OutOfRange, false),
            (Status::NoFlight, false)
        ]
    );
}

/// A batch of one landed and one failed drive, with derivatives.
fn small() -> (Batch, Block) {
    let setup = Setup::modern_driver();
    let loft: &'static Parameter = setup.variable("club.loft").unwrap();
    let batch = Batch::new(
        &setup,
        &[loft],
        &[Outcome::Carry, Outcome::BallSpeed],
        &[loft],
    )
    .unwrap();
    let block = batch.evaluate(0, vec![0.2, -0.3]);
    (batch, block)
}

#[test]
fn same_rows_after_reading_csv_and_json_lines() {
    let (batch, block) = small();
    let values: Vec<Vec<_>> = (0..2)
        .map(|row| block.outcomes(row).chain(block.derivatives(row)).collect())
        .collect();
    assert!(
        values[0].iter().all(Option::is_some) && values[1][0].is_none() && values[1][1].is_some()
    );

    let table = SweepCsv::new(&batch, TableUnits::Si);
    let text = String::from_utf8([table.head(), table.rows(&block)].concat()).unwrap();
    let lines: Vec<_> = text.lines().collect();
    assert_eq!(
        lines[0],
        "club.loft [rad],status,carry [m],ball_speed [m/s],d_carry/d_club.loft \
         [m/rad],d_ball_speed/d_club.loft [m/s/rad]"
    );
    let cells: Vec<Vec<_>> = lines[1..]
        .iter()
        .map(|line| line.split(',').collect())
        .collect();
    assert_eq!(
        (cells[0][0], cells[0][1], cells[1][1], cells[1][2]),
        ("0.2", "landed", "no-flight", "")
    );
    for (cells, values) in cells.iter().zip(&values) {
        let read: Vec<Option<f64>> = cells[2..].iter().map(|cell| cell.parse().ok()).collect();
        assert_eq!(read, *values, "to the last bit");
    }

    let text = String::from_utf8(SweepJsonLines::new(&batch).rows(&block)).unwrap();
    for ((line, values), status) in text.lines().zip(&values).zip(["landed", "no-flight"]) {
        let object: serde_json::Map<String, serde_json::Value> =
            serde_json::from_str(line).unwrap();
        let names: Vec<_> = object.keys().map(String::as_str).collect();
        assert_eq!(
            names.join(","),
            "club.loft,status,carry,ball_speed,d_carry/d_club.loft,d_ball_speed/d_club.loft"
        );
        assert_eq!(object["status"], status);
        let read: Vec<_> = object
            .values()
            .skip(2)
            .map(serde_json::Value::as_f64)
            .collect();
        assert_eq!(read, *values);
    }
}

#[cfg(feature = "full")]
mod in_parquet {
    use super::{Setup, all, blocks, open_table, small};
    use longdrive::batch::{Batch, Run};
    use longdrive::report::{PARQUET_MAGIC, RowGroups, SweepParquet};
    use longdrive::{Error, Outcome};
    use parquet::data_type::{DoubleType, FloatType, Int32Type};
    use parquet::file::properties::WriterProperties;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::file::writer::SerializedFileWriter;
    use parquet::record::RowAccessor;
    use parquet::schema::parser::parse_message_type;
    use std::fs::File;
    use std::path::Path;
    use std::sync::Arc;

    #[test]
    fn text_named_as_parquet_is_refused() {
        let (_folder, path) = super::table("a.parquet", "club.loft [rad]\n0.1\n");
        let message = open_table(&Setup::modern_driver(), &path).err().unwrap();
        let message = message.to_string();
        assert!(message.contains("it is not a Parquet file"), "{message}");
    }

    #[test]
    fn same_rows_from_row_groups_written_separately() {
        let setup = super::quick();
        let whole = blocks(&Run::default());
        let parameters =
            ["club.loft", "swing.attack_angle"].map(|name| setup.variable(name).unwrap());
        let batch = Batch::new(
            &setup,
            &parameters,
            &[Outcome::Carry, Outcome::LaunchAngle],
            &[],
        )
        .unwrap();
        let table = SweepParquet::new(&batch, "why").unwrap();
        let mut bytes = PARQUET_MAGIC.to_vec();
        let mut groups = RowGroups::default();
        for part in whole.chunks(2) {
            let group = table.group(part).unwrap();
            groups.add(&group.metadata).unwrap();
            bytes.extend(group.bytes);
        }
        bytes.extend(table.footer(&groups, &[]).unwrap());
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.parquet");
        std::fs::write(&path, bytes).unwrap();

        let file = SerializedFileReader::new(File::open(path).unwrap()).unwrap();
        assert_eq!(
            (
                file.num_row_groups(),
                file.metadata().file_metadata().num_rows()
            ),
            (3, 4100)
        );
        let notes = file
            .metadata()
            .file_metadata()
            .key_value_metadata()
            .unwrap();
        assert_eq!(
            (notes[0].key.as_str(), notes[0].value.as_deref()),
            ("longdrive", Some("why"))
        );
        let mut rows = file.get_row_iter(None).unwrap();
        for block in &whole {
            for row in 0..block.rows() {
                let read = rows.next().unwrap().unwrap();
                assert_eq!(
                    [read.get_double(0).unwrap(), read.get_double(1).unwrap()],
                    block.point(row)
                );
                assert_eq!(read.get_string(2).unwrap(), block.status(row).name());
                assert_eq!(
                    [read.get_double(3).ok(), read.get_double(4).ok()],
                    [block.outcome(row, 0), block.outcome(row, 1)]
                );
            }
        }
        assert!(rows.next().is_none());
        let error = groups.add(b"no metadata").err().unwrap();
        let message = error.to_string();
        assert!(
            matches!(error, Error::Output(_)) && !message.contains("overwrite"),
            "{message}"
        );
    }

    /// A journal may be damaged: metadata with any one bit changed is read or refused.
    #[test]
    fn damaged_metadata_of_a_row_group_does_not_panic() {
        let (batch, _) = small();
        let table = SweepParquet::new(&batch, "").unwrap();
        let block = batch.evaluate(0, vec![0.2, 0.01]);
        let metadata = table.group(&[block]).unwrap().metadata;
        let mut refused = 0;
        for bit in 0..8 * metadata.len() {
            let mut damaged = metadata.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            let mut groups = RowGroups::default();
            refused += usize::from(groups.add(&damaged).is_err());
            groups.add(&metadata).unwrap();
        }
        assert!(refused > 0);
    }

    #[test]
    fn exact_null_for_a_missing_swept_parameter() {
        let (batch, _) = small();
        let block = batch.evaluate(0, vec![0.2, f64::NAN]);
        let table = SweepParquet::new(&batch, "").unwrap();
        let mut bytes = PARQUET_MAGIC.to_vec();
        let group = table.group(&[block]).unwrap();
        let mut groups = RowGroups::default();
        groups.add(&group.metadata).unwrap();
        bytes.extend(group.bytes);
        bytes.extend(table.footer(&groups, &[]).unwrap());
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.parquet");
        std::fs::write(&path, bytes).unwrap();
        let file = SerializedFileReader::new(File::open(path).unwrap()).unwrap();
        let rows = file.get_row_iter(None).unwrap();
        let lofts: Vec<Option<f64>> = rows.map(|row| row.unwrap().get_double(0).ok()).collect();
        assert_eq!(lofts, [Some(0.2), None]);
    }

    #[test]
    fn a_file_of_no_rows_is_a_file() {
        let table = SweepParquet::new(&small().0, "").unwrap();
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.parquet");
        let footer = table.footer(&RowGroups::default(), &[]).unwrap();
        std::fs::write(&path, [PARQUET_MAGIC.to_vec(), footer].concat()).unwrap();
        let file = SerializedFileReader::new(File::open(path).unwrap()).unwrap();
        assert_eq!(file.metadata().file_metadata().num_rows(), 0);
    }

    /// A table of three columns and two row groups, with an optional missing value.
    fn write(path: &Path, is_missing: bool) {
        let schema = "message points \
                      { required double club.loft; optional float air.density; required int32 swing.speed; }";
        // the parser accepts no dots in names
        let schema = parse_message_type(&schema.replace('.', "_")).unwrap();
        let fields = schema.get_fields().iter().map(|field| {
            let kind = field.get_physical_type();
            let name = field.name().replacen('_', ".", 1);
            let field = parquet::schema::types::Type::primitive_type_builder(&name, kind)
                .with_repetition(field.get_basic_info().repetition());
            Arc::new(field.build().unwrap())
        });
        let schema = parquet::schema::types::Type::group_type_builder("points")
            .with_fields(fields.collect());
        let properties = Arc::new(WriterProperties::builder().build());
        let schema = Arc::new(schema.build().unwrap());
        let mut file =
            SerializedFileWriter::new(File::create(path).unwrap(), schema, properties).unwrap();
        for first in [0_i32, 5] {
            let mut group = file.next_row_group().unwrap();
            let mut column = group.next_column().unwrap().unwrap();
            let lofts: Vec<f64> = (first..first + 5)
                .map(|i| 0.1 + 0.01 * f64::from(i))
                .collect();
            column
                .typed::<DoubleType>()
                .write_batch(&lofts, None, None)
                .unwrap();
            column.close().unwrap();
            let mut column = group.next_column().unwrap().unwrap();
            let missing = i16::from(!is_missing);
            let present = 4 + usize::from(!is_missing);
            column
                .typed::<FloatType>()
                .write_batch(&[1.25; 5][..present], Some(&[1, 1, missing, 1, 1]), None)
                .unwrap();
            column.close().unwrap();
            let mut column = group.next_column().unwrap().unwrap();
            column
                .typed::<Int32Type>()
                .write_batch(&[40; 5], None, None)
                .unwrap();
            column.close().unwrap();
            group.close().unwrap();
        }
        file.close().unwrap();
    }

    #[test]
    fn same_points_of_a_parquet_table_across_row_groups() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("points.parquet");
        write(&path, false);
        let setup = Setup::modern_driver();
        let mut points = open_table(&setup, &path).unwrap();
        let expected: Vec<f64> = (0..10)
            .flat_map(|i| [0.1 + 0.01 * f64::from(i), 1.25, 40.0])
            .collect();
        assert_eq!(
            (points.rows(), all(points.as_mut())),
            (10, expected.clone())
        );
        points.seek(6).unwrap();
        let mut rest = vec![];
        assert_eq!(
            (points.read(100, &mut rest).unwrap(), rest),
            (4, expected[18..].to_vec())
        );

        write(&path, true);
        let mut points = open_table(&setup, &path).unwrap();
        assert!(all(points.as_mut())[7].is_nan());
        let notes: Vec<String> = points.notes().iter().map(ToString::to_string).collect();
        assert!(
            notes.concat().contains("row 3: air.density is missing"),
            "{notes:?}"
        );
    }
}

#[test]
fn histograms_and_rankings_with_values_are_refused() {
    let setup = Setup::modern_driver();
    let speed = setup.variable("swing.speed").unwrap();
    let batch = Batch::new(&setup, &[speed], &[Outcome::Carry], &[]).unwrap();
    let refused = |histogram: &Histogram, ranking: &Ranking| {
        SummarySpec::new(&batch, vec![histogram.clone()], vec![ranking.clone()])
            .err()
            .map(|error| error.to_string())
    };
    let mut histogram = Histogram::read("carry=200m..300m:4").unwrap();
    let mut ranking = Ranking::read("carry:2", true).unwrap();
    assert_eq!(refused(&histogram, &ranking), None);
    ranking.add(0, 250.0, [("swing.speed", 50.0)]);
    let message = refused(&histogram, &ranking).unwrap();
    assert!(message.contains("the rows of carry"), "{message}");
    histogram.add(250.0);
    let message = refused(&histogram, &ranking).unwrap();
    assert!(message.contains("the histogram of carry"), "{message}");
}
