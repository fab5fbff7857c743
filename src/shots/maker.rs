//! Whose export a table is, by its heads.

/// A maker, with heads in small letters that stand together in its exports alone. docs/sources.md
/// says where they are from.
const SIGNATURES: [(&str, &[&str]); 16] = [
    ("TrackMan", &["carry flat length"]),
    ("TrackMan", &["tmd no"]),
    ("TrackMan", &["dyn loft", "spin rate"]),
    ("TrackMan", &["dynamic loft", "landing angle", "hang time"]),
    ("Garmin", &["carry deviation distance"]),
    ("Garmin", &["carry abweichungsdistanz"]),
    ("FlightScope", &["launch v", "launch h"]),
    ("FlightScope", &["launch angle v", "height"]),
    ("Foresight", &["push pull", "peak height"]),
    ("Foresight", &["tilt angle", "total spin"]),
    ("Foresight", &["side angle", "offline", "face to target"]),
    ("Foresight", &["azimuth", "offline"]),
    ("Rapsodo", &["side carry", "club type"]),
    ("Uneekor", &["side angle", "side distance"]),
    ("Square", &["index", "offline", "dynamic loft"]),
    (
        "Awesome Golf",
        &[
            "vertical launch",
            "horizontal launch",
            "carry lateral distance",
        ],
    ),
];

/// The maker whose heads these are, in small letters and without their units.
pub(super) fn maker(heads: &[String]) -> Option<&'static str> {
    let has = |head: &&str| heads.iter().any(|other| other == head);
    SIGNATURES
        .iter()
        .find(|(_, all)| all.iter().all(has))
        .map(|(maker, _)| *maker)
}
