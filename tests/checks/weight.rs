//! What the program weighs.

use crate::program;
use std::path::PathBuf;

/// A flight loop is compiled for each number that drives are made of: it is most of what the
/// library costs to build. Its copies are counted among the names of functions in the program,
/// which say for what numbers they are (`.cargo/config.toml`).
#[test]
#[cfg(target_os = "linux")]
fn regress_copies_of_the_flight_loop_at_most_twenty() {
    let program = std::fs::read(program::path()).unwrap();
    let is_flight = |name: &&[u8]| {
        let has = |part: &str| {
            name.windows(part.len())
                .any(|window| window == part.as_bytes())
        };
        name.starts_with(b"_R") && has("8outlined") && has("5Ended") && has("6follow")
    };
    let copies: std::collections::HashSet<&[u8]> =
        program.split(|byte| *byte == 0).filter(is_flight).collect();
    assert!(
        (3..=20).contains(&copies.len()),
        "{} copies of the flight loop",
        copies.len()
    );
    let over_num_dual = copies
        .iter()
        .filter(|name| name.windows(8).any(|window| window == b"num_dual"));
    assert_eq!(over_num_dual.count(), 1, "verify flies num-dual's numbers");
}

/// A release of the program does not unwind, but a panic in a wheel of the Python package must
/// become an exception.
#[test]
fn a_wheel_of_the_python_package_unwinds() {
    // the lines below a head, up to the next one
    let table = |path: &str, head: &str| -> Vec<String> {
        let text = std::fs::read_to_string(
            PathBuf::from(env!("CARGO_MANIFEST_DIR"))
                .join("..")
                .join(path),
        )
        .unwrap();
        let lines = text.lines().skip_while(|line| *line != head).skip(1);
        lines
            .take_while(|line| !line.starts_with('['))
            .map(str::to_owned)
            .collect()
    };
    assert!(
        table("python/pyproject.toml", "[tool.maturin]").contains(&r#"profile = "wheel""#.into())
    );
    assert!(table("Cargo.toml", "[profile.wheel]").contains(&r#"panic = "unwind""#.into()));
}
