//! Detects the maker of an export from its column heads.

/// Makers with column heads (in lower case) that occur together only in their exports. Sources:
/// docs/sources.md.
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

/// The maker for these column heads, in lower case without units.
pub(super) fn maker(heads: &[String]) -> Option<&'static str> {
    let has = |head: &&str| heads.iter().any(|other| other == head);
    SIGNATURES
        .iter()
        .find(|(_, all)| all.iter().all(has))
        .map(|(maker, _)| *maker)
}
