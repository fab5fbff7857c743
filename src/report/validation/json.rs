use crate::report::{Reply, json};
use crate::study::validation::{Compared, Score, SetScores};
use serde_json::{Map, Value, json};

/// Every law on every set, as JSON: SI and radians.
pub fn validation_reply(found: &[SetScores]) -> Reply<Value> {
    let sets: Vec<Value> = found.iter().map(set).collect();
    Reply::done("validate", vec![], json!({ "sets": sets }))
}

fn set(of: &SetScores) -> Value {
    let published = |case: &crate::study::validation::Case| {
        let known = Compared::ALL
            .iter()
            .filter_map(|of| Some((of.name(), Some(case.published(*of)?))));
        json!({ "name": case.name, "source": case.source, "published": json::named(known) })
    };
    let laws = of.laws.iter().map(|law| {
        let scores: Map<String, Value> = law.scores.iter().map(|one| (one.of.name().to_owned(), score(one))).collect();
        let swept =
            law.swept.map(|[cold, warm]| json!({ "at_15_degC": json::number(cold), "at_35_degC": json::number(warm) }));
        json!({ "law": law.law, "scores": scores, "bias_in_other_air": swept, "bias_averaged": json::number(law.averaged) })
    });
    json!({
        "name": of.set.name,
        "title": of.set.title,
        "about": of.set.about,
        "air": of.set.air,
        "misses": of.set.misses,
        "cases": of.cases.iter().map(published).collect::<Vec<_>>(),
        "laws": laws.collect::<Vec<_>>(),
    })
}

fn score(of: &Score) -> Value {
    let residual = |one: &crate::study::validation::Residual| json!({ "case": one.case, "predicted": one.predicted, "published": one.published, "difference": one.difference() });
    json!({
        "count": of.residuals.len(),
        "bias": json::number(of.bias()),
        "mean_absolute_error": json::number(of.mean_absolute()),
        "residuals": of.residuals.iter().map(residual).collect::<Vec<_>>(),
    })
}
