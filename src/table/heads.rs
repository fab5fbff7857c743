//! Column heads of launch monitors with their meanings.

use crate::drive::Outcome;

/// Meaning of a column head.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Meaning {
    /// An outcome.
    Outcome(Outcome),
    /// A parameter of the delivery, by its dotted name.
    Input(&'static str),
}

/// Column heads of the delivery, in lower case, without punctuation.
const OF_DELIVERY: &[(&str, &str)] = &[
    ("club speed", "swing.speed"),
    ("club head speed", "swing.speed"),
    ("clubhead speed", "swing.speed"),
    ("swing speed", "swing.speed"),
    ("attack angle", "swing.attack_angle"),
    ("angle of attack", "swing.attack_angle"),
    ("aoa", "swing.attack_angle"),
    ("club path", "swing.path"),
    ("swing path", "swing.path"),
    ("face angle", "swing.face_angle"),
    ("club face", "swing.face_angle"),
    ("face to target", "swing.face_angle"),
    ("attack ang", "swing.attack_angle"),
    ("face ang", "swing.face_angle"),
    ("vert path", "swing.attack_angle"),
    ("horiz path", "swing.path"),
    // Garmin in German
    ("schl gsch", "swing.speed"),
    ("anstellwinkel", "swing.attack_angle"),
    ("schwungbahn", "swing.path"),
    ("schlagfläche", "swing.face_angle"),
];

/// Known column heads of the delivery and of outcomes, with their meanings. Outcomes of the rest
/// position depend on the ground and are omitted; [`rest_of_head`] finds their heads.
pub(super) fn heads() -> impl Iterator<Item = (&'static str, Meaning)> {
    let of_delivery = OF_DELIVERY
        .iter()
        .map(|(head, parameter)| (*head, Meaning::Input(parameter)));
    let of_outcomes = Outcome::OF_DRIVES
        .iter()
        .filter(|of| !of.needs_run())
        .flat_map(|of| {
            of.column_heads()
                .iter()
                .map(|head| (*head, Meaning::Outcome(*of)))
        });
    of_delivery.chain(of_outcomes)
}

/// The outcome of the rest position whose column head is `words`, in lower case without
/// punctuation.
pub(super) fn rest_of_head(words: &str) -> Option<Outcome> {
    let mut of_rest = Outcome::OF_DRIVES
        .iter()
        .copied()
        .filter(|of| of.needs_run());
    of_rest.find(|of| of.column_heads().contains(&words))
}

/// Name of the parameter for an air density that a launch monitor states.
pub(super) const AIR: &str = "air.density";

/// True for the head of a column with conditions, such as the weather to which the values of a row
/// are normalized. `words` is the head in lower case without punctuation.
pub(crate) fn is_condition_head(words: &str) -> bool {
    ["condition", "conditions"].contains(&words)
}

/// Column heads of launch monitors that are not used. They are listed so that they do not count as
/// misspelt heads of used columns.
pub(super) const NOT_USED: &[&str] = &[
    "ball type",
    "club brand",
    "club lie",
    "club model",
    "club name",
    "club type",
    "clubspeed",
    "dyn loft",
    "dynamic lie",
    "dynamic loft",
    "face to path",
    "flight",
    "impacthorizontal",
    "impactvertical",
    "lie angle",
    "loft angle",
    "low point",
    "side distance",
    "side total",
    "smashfactor",
    "spin loft",
    "swing direction",
    "swing plane",
    "total distance",
    "total side",
];
