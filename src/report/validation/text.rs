use super::figures::{ALTERNATIVE, best};
use crate::parameters::{Law, TABLE_LAW};
use crate::report::document::{Document, DocumentTable};
use crate::report::shown;
use crate::statistics::extent;
use crate::study::validation::{Case, Compared, LawScores, OTHER_TEMPERATURES, SetScores};
use crate::units::{System, counted, fixed};

/// The first quantity of most sets is the carry. If it is another quantity, the table names it.
const CARRY: &str = "carry";

/// The mean absolute error of the first quantity of every set, for the best law, the default law,
/// the law `ALTERNATIVE`, and the user's table if there is one.
pub(super) fn summary(document: &mut Document, found: &[SetScores], system: System) {
    let default = Law::default().name();
    let own = found
        .iter()
        .flat_map(|set| &set.laws)
        .find(|law| law.law == TABLE_LAW)
        .map(|law| law.law);
    document.heading("Which law is the default");
    let rows = found.iter().map(|set| {
        let of = |law: &LawScores| law.scores.first()?.mean_absolute_error;
        let best = best(set);
        let number = |mean: Option<f64>| shown::number_or_dash(first(set).unit(), mean, system);
        let named = |name: &str| number(set.laws.iter().find(|law| law.law == name).and_then(of));
        let set_name = match first(set).words() {
            CARRY => set.set.name.to_owned(),
            other => format!("{}, {other}", set.set.name),
        };
        let mut cells = vec![
            set.cases.len().to_string(),
            named(default),
            named(ALTERNATIVE),
        ];
        cells.extend(own.map(named));
        cells.extend([
            number(best.map(|(mean, _)| mean)),
            best.map_or(shown::NONE, |(_, law)| law).to_owned(),
            set_name,
        ]);
        cells
    });
    let mut head = vec!["drives", default, ALTERNATIVE];
    head.extend(own.map(|_| "your table"));
    head.extend(["best", "law", "set"]);
    let numbers = 0..head.len() - 2;
    let mut table = DocumentTable::new(head, rows).right(numbers);
    table.caption = format!(
        "Mean absolute error of carry [{}], or of the quantity that the set names",
        system.unit("yd")
    );
    document.add(table);
    document.paragraph(reasons(found, default, system));
}

/// The reasons for the default law, with numbers of the scores.
fn reasons(found: &[SetScores], default: &str, system: System) -> String {
    let unit = system.unit("yd");
    let of_law = |set: &SetScores, law: &str| -> Option<[f64; 2]> {
        let scores = set.laws.iter().find(|each| each.law == law)?;
        let bias = scores.scores.first()?.bias?;
        Some([bias, bias - scores.averaged?])
    };
    // range of a law's bias (k = 0) or loss by scatter (k = 1) over the sets of averages
    let over_averages = |law: &str, k: usize| {
        let values = found.iter().filter_map(|set| Some(of_law(set, law)?[k]));
        let carry = Compared::Carry.unit();
        let [least, most] = extent(values).map(|value| carry.read_off_number(value, system));
        format!("{least} to {most} {unit}")
    };
    let averages = found.iter().filter(|set| set.set.is_averaged);
    let best: Vec<String> = averages
        .filter_map(|set| Some(format!("{} on {}", best(set)?.1, set.set.name)))
        .collect();
    format!(
        "No law has the smallest error on every set. On averages of drives, other laws have the \
         smallest error of carry: {}. But drives scatter: their mean carry is shorter than that of \
         the average launch, by {} with {default} (bias less \"averaged\" in their tables). An exact \
         law predicts so much more than the averages; {default} predicts {} more, {ALTERNATIVE} {}. \
         The default is {default} because it was fitted to a launch monitor's predictions of single \
         drives, and because the mean absolute error of its descent angle over the other clubs is \
         {}, that of {ALTERNATIVE} {}. {ALTERNATIVE} is the alternative, fitted to radar flights of \
         one ball: for drivers its apex has a smaller error, its descent angle a larger one. Their \
         difference hints at the model's error.",
        best.join(", "),
        over_averages(default, 1),
        over_averages(default, 0),
        over_averages(ALTERNATIVE, 0),
        descent_of_clubs(found, default, system),
        descent_of_clubs(found, ALTERNATIVE, system)
    )
}

/// The sets of all clubs but the driver.
const CLUBS: [&str; 2] = ["pga-clubs", "lpga-clubs"];

/// The mean absolute error of a law's descent in each of the sets [`CLUBS`]: "2.6° (pga-clubs) and
/// 2.4° (lpga-clubs)".
fn descent_of_clubs(found: &[SetScores], law: &str, system: System) -> String {
    let of_set = |name: &&str| {
        let set = found.iter().find(|set| set.set.name == *name)?;
        let scores = &set.laws.iter().find(|each| each.law == law)?.scores;
        let descent = scores.iter().find(|score| score.of == Compared::Descent)?;
        let mean = descent.of.unit();
        let mean = mean.read_off_number(descent.mean_absolute_error?, system);
        Some(format!("{mean}° ({name})"))
    };
    let of_sets: Vec<String> = CLUBS.iter().filter_map(of_set).collect();
    of_sets.join(" and ")
}

/// A set with a row for each law.
pub(super) fn one(document: &mut Document, set: &SetScores, system: System) {
    let about = set.set;
    document.heading(&format!("{} ({})", about.title, about.name));
    document.paragraph(format!(
        "{} {}. Air: {}. {}",
        about.about,
        counted(set.cases.len() as u64, "drive"),
        about.air,
        about.misses
    ));
    let compared: Vec<Compared> = set.laws.first().map_or(vec![], |law| {
        law.scores.iter().map(|score| score.of).collect()
    });
    let errors = compared.iter().flat_map(|of| [of.words(), "MAE"]);
    let mut head: Vec<&str> = std::iter::once("law").chain(errors).collect();
    let is_swept = set.laws.iter().any(|law| law.bias_in_other_air.is_some());
    let [cold, warm] =
        OTHER_TEMPERATURES.map(|temperature| format!("{} °C", fixed(temperature - 273.15, 0)));
    let is_averaged = set.laws.iter().any(|law| law.averaged.is_some());
    if is_averaged {
        head.push("averaged");
    }
    if is_swept {
        head.extend([cold.as_str(), &warm]);
    }
    let rows = set.laws.iter().map(|law| {
        let mut cells = vec![law_with_count(set, law)];
        for score in &law.scores {
            let of = score.of.unit();
            cells.push(shown::signed_or_dash(of, score.bias, system));
            cells.push(shown::number_or_dash(of, score.mean_absolute_error, system));
        }
        let bias_text = |bias: Option<f64>| shown::signed_or_dash(first(set).unit(), bias, system);
        if is_averaged {
            cells.push(bias_text(law.averaged));
        }
        if let Some(other) = &law.bias_in_other_air {
            cells.extend([other.cold, other.warm].map(bias_text));
        }
        cells
    });
    let numbers = 1..head.len();
    document.add(DocumentTable::new(head, rows).right(numbers));
}

/// The name of a law. If the law cannot compute every drive of the set, the numbers of drives
/// follow: "NAME (3 of 5 drives)".
fn law_with_count(set: &SetScores, law: &LawScores) -> String {
    let computed = law.scores.first().map_or(0, |score| score.residuals.len());
    let is_published = |case: &&Case| case.published(first(set)).is_some();
    let of = set.cases.iter().filter(is_published).count();
    if computed < of {
        format!("{} ({computed} of {of} drives)", law.law)
    } else {
        law.law.into()
    }
}

fn first(set: &SetScores) -> Compared {
    set.set.computation.compared()[0]
}
