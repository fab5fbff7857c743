//! Movable weights of the head: point masses in addition to the body of the head.

use super::table::{Club, Setup};
use crate::number::Numbers;

/// A movable weight.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weight<T> {
    /// Mass, kg.
    pub mass: T,
    /// Distance behind the face centre, along the normal at the face centre, m.
    pub depth: T,
    /// Distance from the face centre towards the toe, m.
    pub toe: T,
    /// Distance from the face centre up the face, m.
    pub high: T,
}

impl<T: Numbers> Club<T> {
    /// The two movable weights; `None` for a weight without a mass.
    #[inline(always)]
    pub(crate) fn weights(&self) -> [Option<Weight<T>>; 2] {
        let one = [
            self.weight_1_mass,
            self.weight_1_depth,
            self.weight_1_toe,
            self.weight_1_high,
        ];
        let other = [
            self.weight_2_mass,
            self.weight_2_depth,
            self.weight_2_toe,
            self.weight_2_high,
        ];
        [weight(one), weight(other)]
    }
}

#[inline(always)]
fn weight<T: Numbers>([mass, depth, toe, high]: [Option<T>; 4]) -> Option<Weight<T>> {
    let mass = mass?;
    Some(Weight {
        mass,
        depth: depth.unwrap_or_else(T::zero),
        toe: toe.unwrap_or_else(T::zero),
        high: high.unwrap_or_else(T::zero),
    })
}

/// Suffix of the name of a weight's mass.
const MASS: &str = "mass";

impl Setup<f64> {
    /// Warnings about weights with a position and no mass, or a mass of 0.
    pub(super) fn massless_weight_warnings(&self) -> Vec<String> {
        let set: Vec<_> = self
            .parameters()
            .into_iter()
            .filter(|row| self.value(row).is_some())
            .collect();
        let weights = ["club.weight_1.", "club.weight_2."].into_iter();
        let warnings = weights.filter_map(|weight| {
            let of_it: Vec<_> = set
                .iter()
                .filter_map(|row| row.name.strip_prefix(weight))
                .collect();
            let places: Vec<_> = of_it
                .iter()
                .filter(|name| **name != MASS)
                .map(|name| format!("{weight}{name}"))
                .collect();
            let mass = format!("{weight}{MASS}");
            let is_zero = self
                .parameter(&mass)
                .ok()
                .and_then(|row| self.value(row))
                .map(|mass| mass == 0.0);
            let (why, advice) = match is_zero {
                None => ("the weight has no mass", "set"),
                Some(true) => ("the mass of the weight is 0 g", "raise"),
                Some(false) => return None,
            };
            let change = if places.len() == 1 {
                "changes"
            } else {
                "change"
            };
            (!places.is_empty()).then(|| {
                format!(
                    "{} {change} nothing: {why}; {advice} {mass}",
                    places.join(", ")
                )
            })
        });
        warnings.collect()
    }
}
