use super::document::{Detail, Document, DocumentTable, Line};
use super::json::JsonNumber;
use super::reply::Report;
use crate::atmosphere::in_effect;
use crate::parameters::{
    GOLFER, Golfer, Kind, LAW, Law, METHOD, Method, PRESETS, Parameter, Range, SPEED_OF, Setup,
    SpeedOf, TABLE, TABLE_LAW, TURF, TURFS, UNSET,
};
use crate::units::System;
use crate::{Error, Result};
use serde::Serialize;

/// Every parameter with its value in a setup.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ParametersReport {
    /// The law of drag and lift of the setup.
    pub law: &'static str,
    /// All laws.
    pub laws: &'static [&'static str],
    /// The parameters of the setup, then the parameters of the other laws.
    pub parameters: Vec<ParameterReport>,
    /// The settings whose values are names, except the law.
    pub choices: Vec<ChoiceReport>,
    /// True if the setup states `flight.method` or `flight.step`. Otherwise a command that computes
    /// many drives chooses method and step.
    pub states_step: bool,
    /// The word that selects by name or, if no name has it, by meaning; `None` lists all.
    #[serde(skip)]
    word: Option<String>,
}

/// A parameter with its value in a setup.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ParameterReport {
    #[serde(skip)]
    row: &'static Parameter,
    /// The dotted name.
    pub parameter: &'static str,
    /// The symbol in docs/model.md.
    pub symbol: &'static str,
    /// The SI unit.
    pub unit: &'static str,
    /// The unit in texts.
    pub shown_in: &'static str,
    /// The value in the setup, SI; `null` if it is unset.
    pub value: JsonNumber,
    /// The default value, SI.
    pub default: JsonNumber,
    /// The source of the default.
    pub source: &'static str,
    /// The allowed values.
    pub range: Range,
    /// The kind.
    pub kind: Kind,
    /// The law that has this parameter as a coefficient; `null` for other parameters.
    pub law: Option<&'static str>,
    /// The meaning.
    pub doc: &'static str,
}

/// A setting whose value is a name.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ChoiceReport {
    /// The dotted name.
    pub choice: &'static str,
    /// The name in the setup; `null` if the ground of the setup differs from every named turf.
    pub value: Option<&'static str>,
    /// The name by default.
    pub default: Option<&'static str>,
    /// All names.
    pub names: Vec<&'static str>,
    /// The meaning.
    pub doc: String,
}

impl ParametersReport {
    /// The report of a setup: its parameters with their values in the drive, then the parameters of
    /// the other laws.
    pub fn new(setup: &Setup<f64>) -> Self {
        let effective = &in_effect(setup);
        let own = effective
            .parameters()
            .into_iter()
            .map(|row| ParameterReport::new(row, effective.value(row)));
        let others = Law::all_rows()
            .filter(|row| row.law != Some(effective.law.name()))
            .map(|row| ParameterReport::new(row, row.default_value()));
        Self {
            law: setup.law.name(),
            laws: Law::NAMES,
            parameters: own.chain(others).collect(),
            choices: choices(setup).into(),
            states_step: setup.states_step,
            word: None,
        }
    }

    /// Selects the parameters and choices whose names contain a word; if none does, the parameters
    /// whose meanings contain it.
    ///
    /// # Errors
    /// [`Error::Unknown`] if no name and no meaning contains the word. The error suggests the most
    /// similar name, group or preset.
    pub fn with_word(mut self, word: &str) -> Result<Self> {
        let names = || self.parameters.iter().map(|one| one.parameter);
        let choices = self.choices.iter().map(|one| one.choice).chain([LAW]);
        if names().chain(choices).any(|name| has_word(name, word)) {
            self.parameters.retain(|one| has_word(one.parameter, word));
            self.choices.retain(|one| has_word(one.choice, word));
        } else if self.parameters.iter().any(|one| has_word(one.doc, word)) {
            self.parameters.retain(|one| has_word(one.doc, word));
            self.choices.clear();
        } else {
            let parts = names().flat_map(|name| name.split('.'));
            let presets = PRESETS.iter().map(|preset| preset.name);
            return Err(Error::unknown(
                "parameter or group",
                word,
                parts.chain(names()).chain(presets),
                "`parameters()` lists them all",
            ));
        }
        self.word = Some(word.into());
        Ok(self)
    }
}

/// True if the text contains the word, in upper or lower case.
fn has_word(text: &str, word: &str) -> bool {
    text.to_lowercase().contains(&word.to_lowercase())
}

impl ParameterReport {
    fn new(row: &'static Parameter, value: Option<f64>) -> Self {
        Self {
            row,
            parameter: row.name,
            symbol: row.symbol,
            unit: row.quantity.si,
            shown_in: row.unit,
            value: value.into(),
            default: row.default_value().into(),
            source: row.source,
            range: row.range,
            kind: row.kind,
            law: row.law,
            doc: row.doc,
        }
    }
}

impl Report for ParametersReport {
    const COMMAND: &'static str = "parameters";

    /// The values by group; the listing follows with the option `all`. With a word, the listing
    /// alone.
    fn document(&self, system: System) -> Document {
        if self.word.is_some() {
            return self.listings(system);
        }
        let mut document = Document::default();
        document.add(self.values(system));
        document.append_detail(self.listings(system), Detail::WithAll);
        document
    }
}

impl ParametersReport {
    /// A table with a row for each group of parameters of the setup. A row has all values of the
    /// group.
    fn values(&self, system: System) -> DocumentTable {
        let mut groups: Vec<(&str, Vec<String>)> = vec![];
        let own = self.parameters.iter();
        for one in own.filter(|one| one.law.is_none_or(|law| law == self.law)) {
            let (group, name) = one.parameter.split_once('.').unwrap_or(("", one.parameter));
            let value = one.value.0.map_or(UNSET.into(), |value| {
                one.row.quantity.show(value, system.unit(one.row.unit))
            });
            let text = format!("{name} {value}");
            match groups.iter_mut().find(|(other, _)| *other == group) {
                Some((_, texts)) => texts.push(text),
                None => groups.push((group, vec![text])),
            }
        }
        let rows = groups
            .into_iter()
            .map(|(group, texts)| vec![group.to_owned(), texts.join(", ")]);
        let mut table = DocumentTable::new(["group", "parameters and values"], rows);
        table.remark(
            "not shown here: the meaning, default and range of each parameter, and the other laws",
        );
        table
    }

    /// A row for each parameter with its value, default, range, symbol and meaning, then the
    /// choices and the coefficients of the other laws.
    fn listings(&self, system: System) -> Document {
        let (own, others): (Vec<_>, Vec<_>) = self
            .parameters
            .iter()
            .partition(|one| one.law.is_none_or(|law| law == self.law));
        let mut document = Document::default();
        if !own.is_empty() {
            document.add(listing("parameter", &own, system));
        }
        for choice in &self.choices {
            document.list([Line::item(choice.text())]);
        }
        if !others.is_empty() {
            document.list([Line::item(format!(
                "{LAW} = {} here; the coefficients of the other laws:",
                self.law
            ))]);
        } else if self.word.as_ref().is_some_and(|word| has_word(LAW, word)) {
            document.list([Line::item(format!(
                "{LAW} = {} here; the laws are {}",
                self.law,
                Law::NAMES.join(", ")
            ))]);
        }
        for law in Law::NAMES.iter().copied().chain([TABLE_LAW]) {
            let of_law: Vec<_> = others
                .iter()
                .copied()
                .filter(|one| one.law == Some(law))
                .collect();
            if of_law.is_empty() {
                continue;
            }
            if law == TABLE_LAW {
                let title = format!("{TABLE_LAW}, your own {TABLE}");
                document.add(listing(&title, &of_law, system));
            } else {
                document.add(listing(law, &of_law, system));
            }
        }
        document
    }
}

impl ChoiceReport {
    fn text(&self) -> String {
        if self.choice == TURF {
            return format!("{TURF} {}", self.doc);
        }
        format!(
            "{} = {} here; {}",
            self.choice,
            self.value.unwrap_or(UNSET),
            self.doc
        )
    }
}

/// The settings whose values are names. Each has a list of all possible names.
fn choices(setup: &Setup<f64>) -> [ChoiceReport; 4] {
    let defaults = Setup::modern_driver();
    let methods = Method::ALL
        .iter()
        .map(|method| format!("{} (order {})", method.name(), method.order()));
    let turfs = TURFS
        .iter()
        .map(|turf| format!("{} ({})", turf.name, turf.about));
    [
        ChoiceReport {
            choice: METHOD,
            value: setup.choice(METHOD),
            default: defaults.choice(METHOD),
            names: Method::NAMES.to_vec(),
            doc: format!("the methods are {}", methods.collect::<Vec<_>>().join(", ")),
        },
        ChoiceReport {
            choice: GOLFER,
            value: setup.choice(GOLFER),
            default: defaults.choice(GOLFER),
            names: Golfer::NAMES.to_vec(),
            doc: "right or left, by the hand: swing, strike and club of a left-hander are the \
                  mirror image of a right-hander's"
                .into(),
        },
        ChoiceReport {
            choice: SPEED_OF,
            value: setup.choice(SPEED_OF),
            default: defaults.choice(SPEED_OF),
            names: SpeedOf::NAMES.to_vec(),
            doc: "centre-of-mass or face-centre, the point of the head whose speed, attack angle \
                  and path the swing states (they differ where swing.closure turns the head)"
                .into(),
        },
        ChoiceReport {
            choice: TURF,
            value: setup.choice(TURF),
            default: defaults.choice(TURF),
            names: TURFS.iter().map(|turf| turf.name).collect(),
            doc: format!(
                "sets ground.restitution, ground.friction, ground.compliance and ground.rolling at \
                 once ({} here): {}",
                setup.choice(TURF).unwrap_or("none of them"),
                turfs.collect::<Vec<_>>().join("; ")
            ),
        },
    ]
}

/// A table of parameters with value, default and range. Symbol and meaning are below each row.
fn listing(title: &str, all: &[&ParameterReport], system: System) -> DocumentTable {
    let cells = |one: &&ParameterReport| {
        let (row, quantity) = (one.row, one.row.quantity);
        let unit = system.unit(row.unit);
        let show = |value: JsonNumber| {
            value
                .0
                .map_or(UNSET.into(), |value| quantity.show(value, unit))
        };
        vec![
            row.name.into(),
            show(one.value),
            show(one.default),
            row.range.show(quantity, unit),
        ]
    };
    let meaning = |one: &&ParameterReport| {
        let meaning = one.doc.trim_end_matches('.');
        format!("{}: {meaning}", one.symbol)
    };
    let head = [title, "value", "default", "range"];
    let mut table = DocumentTable::new(head, all.iter().map(cells)).right([1, 2]);
    table.row_notes = all.iter().map(meaning).collect();
    table
}
