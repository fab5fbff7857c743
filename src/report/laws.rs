use super::lines::{item, note};
use super::{Reply, json};
use crate::aerodynamics::{AerodynamicLaw, Fitted, Published};
use crate::parameters::Law;
use crate::units::{Message, System};
use serde_json::{Value, json};

/// Every law with its published coefficients and the user's own, where it comes from, and what it
/// was fitted to.
fn all(own: Option<Law<f64>>) -> impl Iterator<Item = (Law<f64>, Published, Fitted)> {
    let laws = Law::NAMES
        .iter()
        .filter_map(|name| Law::named(name))
        .chain(own);
    laws.map(|law| (law, law.published(), law.fitted()))
}

/// The answer of `laws`.
pub fn laws_reply(own: Option<Law<f64>>) -> Reply<Value> {
    let range = |range: Option<[f64; 2]>| {
        range.map(|[low, high]| json!({ "low": json::number(Some(low)), "high": json::number(Some(high)) }))
    };
    let one = |(law, published, fitted): (Law<f64>, Published, Fitted)| {
        json!({
            "name": law.name(),
            "is_default": law.name() == Law::default().name(),
            "authors": published.authors,
            "year": published.year,
            "ball": published.ball,
            "source": published.source,
            "formula": law.formula(),
            "fitted": {
                "to": Some(fitted.to).filter(|to| !to.is_empty()),
                "spin_ratio": range(fitted.spin_ratio),
                "spin": range(fitted.spin),
                "reynolds": range(fitted.reynolds),
                "speed": range(fitted.speed),
            },
        })
    };
    Reply::done(
        "laws",
        vec![],
        json!({ "laws": all(own).map(one).collect::<Vec<_>>() }),
    )
}

/// The laws as text: who published each, its formula, and below it the range, the ball and the
/// source.
pub fn laws_text(own: Option<Law<f64>>, system: System) -> String {
    let one = |(law, published, fitted): (Law<f64>, Published, Fitted)| {
        let year = published
            .year
            .map_or(String::new(), |year| format!(" {year}"));
        let default = if law.name() == Law::default().name() {
            " (default)"
        } else {
            ""
        };
        let range = if fitted == Fitted::UNKNOWN {
            "fitted to: not known".into()
        } else {
            fitted
                .in_words(Message::from(format!("fitted to {}: ", fitted.to)))
                .in_units(system)
        };
        item(&format!(
            "{}{default}: {}{year}",
            law.name(),
            published.authors
        )) + &note(law.formula().trim_end_matches('.'))
            + &note(&range)
            + &note(&format!("ball: {}", published.ball.unwrap_or("not stated")))
            + &note(&format!("source: {}", published.source))
    };
    let laws: Vec<String> = all(own).map(one).collect();
    laws.join("\n")
        + "\n  choose one with `set aero.law=NAME`; `parameters()` lists the \
           coefficients\n  \
           or your own table with `set aero.table=mine.csv`; `plot laws()` \
           draws them\n"
}
