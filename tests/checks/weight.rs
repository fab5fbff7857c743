//! What the program weighs.

/// A flight loop is compiled for each number that drives are made of: it is most of what the library costs to build. Its copies are
/// counted among the names of functions in the program, which say for what numbers they are (`.cargo/config.toml`).
#[test]
#[cfg(target_os = "linux")]
fn regress_copies_of_the_flight_loop_at_most_twenty() {
    let program = std::fs::read(env!("CARGO_BIN_EXE_longdrive")).unwrap();
    let is_flight = |name: &&[u8]| {
        let has = |part: &str| name.windows(part.len()).any(|window| window == part.as_bytes());
        name.starts_with(b"_R") && has("8outlined") && has("5Ended") && has("6follow")
    };
    let copies: std::collections::HashSet<&[u8]> = program.split(|byte| *byte == 0).filter(is_flight).collect();
    assert!((3..=20).contains(&copies.len()), "{} copies of the flight loop", copies.len());
}
