//! Makers of launch monitors, known from the column heads of their exports.

use super::launch_monitor::{split_unit, words};

/// Each maker, with column heads (in lower case) that occur together only in exports of this maker.
/// Sources: docs/sources.md.
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

/// The maker of an export, if its column heads identify it.
pub(super) fn maker(heads: &[String]) -> Option<&'static str> {
    let plain: Vec<String> = heads.iter().map(|head| words(split_unit(head).0)).collect();
    let has = |head: &&str| plain.iter().any(|other| other == head);
    let signature = SIGNATURES.iter().find(|(_, all)| all.iter().all(has));
    signature.map(|(maker, _)| *maker)
}
