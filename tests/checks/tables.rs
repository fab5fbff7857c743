//! Tables of points in Arrow IPC files and streams written by pyarrow
//! (`tests/data/tables/make.py`), compared with CSV and Parquet; Parquet of DuckDB; refused, truncated and damaged
//! files.

use crate::sweep::{all, table};
use arrow_array::{ArrayRef, Float32Array, Float64Array, Int16Array, RecordBatch};
use arrow_ipc::writer::{FileWriter, StreamWriter};
use longdrive::Setup;
use longdrive::batch::Points;
use longdrive::table::open_table;
use std::fs::{File, OpenOptions};
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock};

const ROWS: usize = 11;

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("data/tables")
        .join(name)
}

fn open(path: &Path) -> longdrive::Result<Box<dyn Points + Send>> {
    static SETUP: LazyLock<Setup<f64>> = LazyLock::new(Setup::modern_driver);
    open_table(&SETUP, path)
}

fn refusal(path: &Path) -> String {
    open(path)
        .err()
        .unwrap_or_else(|| panic!("{} was not refused", path.display()))
        .to_string()
}

#[test]
fn independent_rows_are_those_of_csv_and_parquet() {
    let expected: Vec<f64> = (0..ROWS)
        .map(|row| row as f64)
        .flat_map(|row| [0.1 + 0.017 * row, 40.0 + 1.3 * row, -0.05 + 0.01 * row])
        .collect();
    let csv = open(&file("points.csv")).unwrap().identity();
    for name in [
        "points.csv",
        "points.parquet",
        "points.arrow",
        "points.arrows",
        "legacy.arrows",
        "version4.arrow",
        "zstd.feather",
        "lz4.feather",
        "gaps.arrows",
    ] {
        let mut points = open(&file(name)).unwrap();
        let names: Vec<_> = points
            .parameters()
            .iter()
            .map(|parameter| parameter.name)
            .collect();
        assert_eq!(
            names,
            ["club.loft", "swing.speed", "swing.attack_angle"],
            "{name}"
        );
        assert_eq!(
            (points.rows(), all(points.as_mut())),
            (ROWS as u64, expected.clone()),
            "{name}"
        );
        assert_eq!(points.identity(), csv, "{name}");
        for from in (0..=ROWS).rev() {
            let mut rest = vec![];
            points.seek(from as u64).unwrap();
            let read = points.read(100, &mut rest).unwrap();
            assert_eq!(
                (read, &rest[..]),
                (ROWS - from, &expected[3 * from..]),
                "{name} from row {from}"
            );
            assert_eq!(points.read(100, &mut rest).unwrap(), 0, "{name}");
        }
    }
}

#[test]
fn independent_files_and_streams_are_recognised_by_their_bytes() {
    for name in ["points.arrow", "points.arrows"] {
        let bytes = std::fs::read(file(name)).unwrap();
        for other in ["a.arrow", "b.arrows", "c.FEATHER"] {
            let (_folder, path) = table(other, &bytes);
            assert_eq!(
                open(&path).unwrap().rows(),
                ROWS as u64,
                "{name} as {other}"
            );
        }
    }
}

#[test]
fn independent_ends_of_every_kind_of_number() {
    let mut points = open(&file("kinds.arrow")).unwrap();
    let names: Vec<_> = points
        .parameters()
        .iter()
        .map(|parameter| parameter.name)
        .collect();
    let values = all(points.as_mut());
    let expected = [
        ("swing.speed", 0.1, -1e300),
        ("air.density", 0.100_000_001_490_116_12, -1.5),
        ("swing.path", -128.0, 127.0),
        ("swing.face_angle", -32_768.0, 32_767.0),
        ("swing.shaft_lean", -2_147_483_648.0, 2_147_483_647.0),
        // a 64-bit integer becomes the nearest f64, as in CSV
        (
            "swing.attack_angle",
            -9_223_372_036_854_775_808.0,
            9_223_372_036_854_775_807.0,
        ),
        ("club.loft", 0.0, 255.0),
        ("club.mass", 0.0, 65_535.0),
        ("strike.high", 0.0, 4_294_967_295.0),
        ("strike.toe", 0.0, 18_446_744_073_709_551_615.0),
    ];
    assert_eq!((names.len(), values.len()), (10, 20));
    for (name, first, second) in expected {
        let at = names.iter().position(|found| *found == name).unwrap();
        assert_eq!([values[at], values[10 + at]], [first, second], "{name}");
    }
}

/// DuckDB stores decimals and small integers as integers of 32 or 64 bits. The expected values are
/// the literals of `make.py`.
#[test]
fn independent_decimals_and_unsigned_integers_of_parquet() {
    let mut points = open(&file("duckdb.parquet")).unwrap();
    let parameters = points.parameters().iter();
    let names: Vec<_> = parameters.map(|parameter| parameter.name).collect();
    assert_eq!(
        names,
        [
            "swing.speed",
            "club.loft",
            "air.density",
            "club.mass",
            "strike.high"
        ]
    );
    let values = all(points.as_mut());
    assert_eq!(
        values[..5],
        [51.4, 0.175, 1.184_123_456_789, 255.0, 4_294_967_295.0]
    );
    assert_eq!(values[5..7], [-2.5, 0.5]);
    assert!(values[7].is_nan());
    assert_eq!(values[8..], [0.0, 7.0]);
}

/// The sign of a degree in Windows-1252, in the head, and in a row behind the part of the file that
/// is read for the head.
#[test]
fn a_table_of_points_in_windows_1252_says_so() {
    let of_head = b"swing.speed [mph],swing.attack_angle [\xb0]\n100,1\n".to_vec();
    let mut of_row = b"swing.speed [mph],note\n".to_vec();
    of_row.extend("100,\n".repeat(20_000).bytes());
    of_row.extend(b"100,\xb0\n");
    for text in [of_head, of_row] {
        let (_folder, path) = table("a.csv", text);
        let notes = open(&path).unwrap().notes();
        let notes: Vec<String> = notes.iter().map(ToString::to_string).collect();
        let says = "its text is not in UTF-8, and is read as Windows-1252";
        assert!(notes.iter().any(|note| note == says), "{notes:?}");
    }
}

#[test]
fn dates_times_and_long_decimals_of_parquet_are_refused_by_name() {
    for (name, kind) in [
        ("date.parquet", "DATE"),
        ("nanoseconds.parquet", "TIMESTAMP"),
        (
            "long_decimal.parquet",
            "DECIMAL of 38 digits stored as FIXED_LEN_BYTE_ARRAY",
        ),
    ] {
        let message = refusal(&file(name));
        let says = format!("column swing.speed: its type is {kind}; a column must hold numbers");
        assert!(message.contains(&says), "{message}");
    }
}

#[test]
fn independent_compressed_batches() {
    let path = file("long_zstd.arrows");
    assert!(
        std::fs::metadata(&path).unwrap().len() < 8 * 4000 / 10,
        "the fixture is compressed"
    );
    assert_eq!(all(open(&path).unwrap().as_mut()), [0.2; 4000]);
}

#[test]
fn independent_tables_without_rows_are_read() {
    for name in ["no_rows.arrow", "no_rows.arrows"] {
        let mut points = open(&file(name)).unwrap();
        assert_eq!(
            (
                points.rows(),
                all(points.as_mut()),
                points.parameters().len()
            ),
            (0, vec![], 3),
            "{name}"
        );
    }
}

/// NaN from NumPy counts as a missing value, like an empty cell and null. The row reports the
/// missing value; the other rows are flown.
#[test]
fn rows_with_a_nan_value_have_no_drive() {
    let (_folder, path) = table(
        "nan.csv",
        b"club.loft [deg],swing.speed [mph]\n10,100\nnan,100\n,100\n11,NaN\n11,-nan\n11,100\n",
    );
    let mut points = open(&path).unwrap();
    let missing: Vec<_> = all(points.as_mut())
        .chunks(2)
        .map(|row| row.iter().any(|value| value.is_nan()))
        .collect();
    assert_eq!(missing, [false, true, true, true, true, false]);
    let output = crate::command_line::longdrive(&["sweep", "--points", path.to_str().unwrap()]);
    let ended: Vec<_> = output
        .out
        .lines()
        .skip(1)
        .map(|row| row.split(',').nth(2).unwrap().to_owned())
        .collect();
    let without = "out-of-range";
    assert_eq!(
        ended,
        ["landed", without, without, without, without, "landed"],
        "{}",
        output.err
    );
    assert!(!output.out.to_lowercase().contains("nan"), "{}", output.out);
    let values = all(open(&file("nan.arrow")).unwrap().as_mut());
    assert_eq!(
        values.iter().filter(|value| value.is_nan()).count(),
        1,
        "{values:?}"
    );
}

#[test]
fn bad_columns_and_values_are_refused_by_row_and_column() {
    for (name, says) in [
        (
            "text.arrow",
            "column air.density: its type is Utf8; a column must hold numbers",
        ),
        (
            "dictionary.arrow",
            "column air.density: its type is Dictionary(Int32, Float64); a column must hold \
             numbers",
        ),
        ("nested.arrow", "column club.loft: its type is List"),
        ("time.arrow", "column club.loft: its type is Timestamp"),
        ("only_null.arrow", "column club.loft: its type is Null"),
        (
            "unknown.arrow",
            "column 2: unknown column 'club.lofft'; did you mean 'club.loft'?",
        ),
        (
            "unit.arrow",
            "column 1: the column 'club.loft': 'club.loft [deg]' has a unit in its name, but the \
             columns of Parquet and Arrow tables are in SI; name it 'club.loft', with numbers in \
             rad",
        ),
        (
            "twice.arrow",
            "the parameter club.loft has two columns; keep one",
        ),
        ("no_columns.arrow", "it has no columns"),
    ] {
        let message = refusal(&file(name));
        assert!(message.contains(says), "{name}: {message}");
    }
}

#[test]
fn bad_files_are_refused_with_the_reason() {
    let stream = std::fs::read(file("points.arrows")).unwrap();
    let whole = std::fs::read(file("points.arrow")).unwrap();
    let parquet = std::fs::read(file("points.parquet")).unwrap();
    let without_end = &stream[..stream.len() - 8];
    for (bytes, says) in [
        (&b""[..], "it is empty"),
        (
            b"club.loft\n0.1\n",
            "it is neither an Arrow IPC file nor a stream",
        ),
        (b"club", "it is neither an Arrow IPC file nor a stream"),
        (&parquet, "it is neither an Arrow IPC file nor a stream"),
        (b"FEA1\0\0\0\0", "a Feather file of version 1"),
        (b"ARROW1", "it has no footer"),
        (
            &whole[..whole.len() - 1],
            "it has no footer: it was cut short",
        ),
        (
            without_end,
            "after row 11: it ends too early: it was cut short",
        ),
        (
            &[&stream[..], &stream].concat(),
            "it has 1232 bytes after its end; put each stream into a file of its own",
        ),
    ] {
        let (_folder, path) = table("a.arrow", bytes);
        let message = refusal(&path);
        assert!(
            message.contains("a.arrow") && message.contains(says),
            "{says}: {message}"
        );
    }
    let none = refusal(Path::new("/nowhere/a.arrow"));
    assert!(
        none.contains("/nowhere/a.arrow: it cannot be read"),
        "{none}"
    );
}

/// True if a message has only this program's own words.
fn is_in_own_words(message: &str) -> bool {
    let words = [
        "Parquet error",
        "EOF",
        "External",
        "NYI",
        "Ipc error",
        "Io error",
        "thrift",
        "orrupt",
        "flatbuffer",
        "error @",
        "Unexpected",
    ];
    !message.contains('\n') && !words.iter().any(|word| message.contains(word))
}

#[test]
fn bad_parquet_files_are_refused_in_plain_words() {
    let whole = std::fs::read(file("points.parquet")).unwrap();
    let mut end = whole.clone();
    let at = end.len() - 60;
    end[at..at + 20].fill(0xff);
    let mut middle = whole.clone();
    middle[4..40].fill(0xff);
    for (bytes, says) in [
        (&b""[..], "it is empty"),
        (b"club.loft [rad]\n0.1\n", "it is not a Parquet file"),
        (b"PARE", "it is encrypted"),
        (b"PAR1", "it has no footer"),
        (
            &whole[..whole.len() / 2],
            "it has no footer: it was cut short",
        ),
        (&end, "it is damaged"),
        (&middle, "rows 1 to 4, column club.loft: it is damaged"),
    ] {
        let (_folder, path) = table("a.parquet", bytes);
        let message = refusal(&path);
        assert!(
            message.contains("a.parquet") && message.contains(says),
            "{says}: {message}"
        );
        assert!(is_in_own_words(&message), "{message}");
    }
    let folder = tempfile::tempdir().unwrap();
    let directory = folder.path().join("a.parquet");
    std::fs::create_dir(&directory).unwrap();
    let message = refusal(&directory);
    assert!(
        message.contains("a.parquet: it cannot be read (") && is_in_own_words(&message),
        "{message}"
    );
}

/// Changes the metadata of the file so that they state GZIP compression, which this program cannot
/// read.
#[test]
fn an_unsupported_compression_is_named_with_the_supported_ones() {
    use parquet::basic::Compression;
    use parquet::file::metadata::{ParquetMetaData, ParquetMetaDataReader, ParquetMetaDataWriter};
    let metadata = ParquetMetaDataReader::new()
        .parse_and_finish(&File::open(file("points.parquet")).unwrap())
        .unwrap();
    let groups = metadata.row_groups().iter().map(|group| {
        let columns = group.columns().iter().cloned();
        let by_gzip = |column: parquet::file::metadata::ColumnChunkMetaData| {
            column
                .into_builder()
                .set_compression(Compression::GZIP(Default::default()))
                .build()
                .unwrap()
        };
        group
            .clone()
            .into_builder()
            .set_column_metadata(columns.map(by_gzip).collect())
            .build()
            .unwrap()
    });
    let changed = ParquetMetaData::new(metadata.file_metadata().clone(), groups.collect());
    let mut bytes = std::fs::read(file("points.parquet")).unwrap();
    let tail = bytes.len() - 8;
    let length = u32::from_le_bytes(bytes[tail..tail + 4].try_into().unwrap()) as usize;
    bytes.truncate(tail - length);
    ParquetMetaDataWriter::new(&mut bytes, &changed)
        .finish()
        .unwrap();
    let (_folder, path) = table("a.parquet", &bytes);
    let message = refusal(&path);
    let says = "column club.loft: it is compressed by GZIP, which is not read here; write it \
                uncompressed, or with Snappy or ZSTD";
    assert!(message.contains(says), "{message}");
}

/// Changes one byte of a file in place: rewriting the file thousands of times would keep the disk
/// busy.
fn put(path: &Path, at: usize, byte: u8) {
    let mut file = OpenOptions::new().write(true).open(path).unwrap();
    file.seek(SeekFrom::Start(at as u64)).unwrap();
    file.write_all(&[byte]).unwrap();
}

#[test]
fn a_truncated_table_is_refused() {
    for name in [
        "points.arrow",
        "points.arrows",
        "zstd.feather",
        "lz4.feather",
    ] {
        let bytes = std::fs::read(file(name)).unwrap();
        let (_folder, path) = table("a.arrow", &bytes);
        for length in (0..bytes.len()).rev() {
            OpenOptions::new()
                .write(true)
                .open(&path)
                .unwrap()
                .set_len(length as u64)
                .unwrap();
            assert!(open(&path).is_err(), "the first {length} bytes of {name}");
        }
    }
}

#[test]
fn a_damaged_table_is_refused_or_read_whole_but_nothing_panics() {
    let mut refused = 0;
    for name in [
        "points.arrow",
        "points.arrows",
        "legacy.arrows",
        "long_zstd.arrows",
        "null.arrow",
    ] {
        let bytes = std::fs::read(file(name)).unwrap();
        let (_folder, path) = table("a.arrow", &bytes);
        for at in 0..bytes.len() {
            if at > 0 {
                put(&path, at - 1, bytes[at - 1]);
            }
            for mask in [0x01, 0x80, 0xff] {
                put(&path, at, bytes[at] ^ mask);
                let mut points = match open(&path) {
                    Ok(points) => points,
                    Err(error) => {
                        assert!(
                            is_in_own_words(&error.to_string()),
                            "{name}, byte {at}: {error}"
                        );
                        refused += 1;
                        continue;
                    }
                };
                let values = all(points.as_mut());
                let count = points.rows() as usize * points.parameters().len();
                // NaN is a missing value
                assert_eq!(values.len(), count, "{name}, byte {at}");
            }
        }
    }
    assert!(refused > 1000, "{refused}");
}

/// Record batches of 1 to 997 rows, and the expected values of all rows.
fn long(rows: usize) -> (Vec<RecordBatch>, Vec<f64>) {
    let expected: Vec<f64> = (0..rows)
        .flat_map(|i| {
            [
                0.05 + i as f64 * 1e-6,
                f64::from(i as f32 * 0.25),
                (i % 45) as f64,
            ]
        })
        .collect();
    let (mut batches, mut first, mut length) = (vec![], 0, 1);
    while first < rows {
        let batch = first..rows.min(first + length);
        let lofts: Float64Array = batch.clone().map(|i| 0.05 + i as f64 * 1e-6).collect();
        let speeds: Float32Array = batch.clone().map(|i| i as f32 * 0.25).collect();
        let angles: Int16Array = batch.map(|i| (i % 45) as i16).collect();
        let columns: [(&str, ArrayRef, bool); 3] = [
            ("club.loft", Arc::new(lofts), true),
            ("swing.speed", Arc::new(speeds), true),
            ("strike.toe", Arc::new(angles), true),
        ];
        batches.push(RecordBatch::try_from_iter_with_nullable(columns).unwrap());
        (first, length) = (first + length, (length + 331) % 997 + 1);
    }
    (batches, expected)
}

#[test]
fn same_points_of_many_record_batches_across_chunks() {
    let (batches, expected) = long(30_011);
    let (_folder, path) = table("long.arrow", "");
    for is_stream in [false, true] {
        let target = std::fs::File::create(&path).unwrap();
        if is_stream {
            let mut writer = StreamWriter::try_new(target, &batches[0].schema()).unwrap();
            batches
                .iter()
                .for_each(|batch| writer.write(batch).unwrap());
            writer.finish().unwrap();
        } else {
            let mut writer = FileWriter::try_new(target, &batches[0].schema()).unwrap();
            batches
                .iter()
                .for_each(|batch| writer.write(batch).unwrap());
            writer.finish().unwrap();
        }
        let mut points = open(&path).unwrap();
        assert_eq!(points.rows(), 30_011);
        assert!(all(points.as_mut()) == expected);
        for from in [30_010, 29_000, 1, 0, 12_345, 333] {
            let mut values = vec![];
            points.seek(from).unwrap();
            while points.read(4096, &mut values).unwrap() > 0 {}
            assert!(values == expected[3 * from as usize..], "from row {from}");
        }
    }
}
