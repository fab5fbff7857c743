//! Formats the numbers of a published study. Computed numbers are in the requested units. Numbers
//! from the paper are in the units of the paper, followed by the requested units in parentheses.

use super::plot::{Axis, NamedQuantity};
use crate::units::{DisplayUnit, Quantity, System, fixed, signed, typed};

pub(super) const LENGTH: DisplayUnit = DisplayUnit {
    quantity: Quantity::LENGTH,
    unit: "m",
};
pub(super) const SPEED: DisplayUnit = DisplayUnit {
    quantity: Quantity::SPEED,
    unit: "m/s",
};
pub(super) const ANGLE: DisplayUnit = DisplayUnit {
    quantity: Quantity::ANGLE,
    unit: "deg",
};

/// The units in which a study is displayed.
#[derive(Clone, Copy)]
pub(super) struct PaperUnits {
    /// The units of the paper.
    pub paper: System,
    /// The number of decimals of an angle in degrees.
    pub angle_decimals: usize,
    /// The units requested.
    pub system: System,
}

impl PaperUnits {
    /// The unit of a length.
    pub fn length_unit(self) -> &'static str {
        self.system.unit("m")
    }

    /// The number of a length, without its unit.
    pub fn length_number(self, length: f64) -> f64 {
        length / LENGTH.size_in(self.system)
    }

    /// A computed length: "153.33 m".
    pub fn length(self, length: f64) -> String {
        self.computed(LENGTH, length)
    }

    /// A computed carry, or "does not fly".
    pub fn carry_if_flown(self, carry: Option<f64>) -> String {
        carry.map_or("does not fly".into(), |carry| self.length(carry))
    }

    /// An angle in degrees: "11.71°".
    pub fn degrees(self, radians: f64) -> String {
        format!("{}°", fixed(radians.to_degrees(), self.angle_decimals))
    }

    /// A computed number with two decimals, like the numbers in the papers. A zero has no sign.
    pub fn computed(self, of: DisplayUnit, value: f64) -> String {
        let number = value / of.size_in(self.system);
        typed(&fixed(number, 2), self.system.unit(of.unit))
    }

    /// A difference (computed − printed) with its sign.
    pub fn difference(self, of: DisplayUnit, difference: f64) -> String {
        signed(difference, self.computed(of, difference))
    }

    /// A derivative of a length by an angle in radians, with its sign: "-65.4 m/rad".
    pub fn per_radian(self, slope: f64) -> String {
        signed(
            slope,
            format!(
                "{} {}/rad",
                fixed(self.length_number(slope), 1),
                self.length_unit()
            ),
        )
    }

    /// A number from the paper in its units, followed by the requested units if they differ:
    /// "248.48 m (271.74 yd)".
    pub fn printed(self, of: DisplayUnit, value: f64) -> String {
        let [printed, requested] =
            [self.paper, self.system].map(|system| Self { system, ..self }.computed(of, value));
        if printed == requested {
            printed
        } else {
            format!("{printed} ({requested})")
        }
    }
}

/// An axis for angles in degrees.
pub(super) fn angles(label: &str) -> Axis {
    Axis::linear(NamedQuantity::new(label, Quantity::ANGLE, "deg"))
}

#[cfg(test)]
mod tests {
    use super::{ANGLE, LENGTH, PaperUnits, SPEED, System};

    #[test]
    fn published_numbers_keep_their_units_beside_the_chosen_ones() {
        let [alone, beside] = System::ALL.map(|system| PaperUnits {
            paper: System::Metric,
            angle_decimals: 4,
            system,
        });
        // 248.48 m is the longest distance of the report; 1 yd is 0.9144 m
        assert_eq!(alone.printed(LENGTH, 248.48), "248.48 m");
        assert_eq!(beside.printed(LENGTH, 248.48), "248.48 m (271.74 yd)");
        assert_eq!(
            (alone.length(248.48), beside.length(248.48)),
            ("248.48 m".into(), "271.74 yd".into())
        );
        assert_eq!(
            (
                alone.computed(SPEED, 44.704),
                beside.computed(SPEED, 44.704)
            ),
            ("44.70 m/s".into(), "100.00 mph".into())
        );
        assert_eq!(beside.printed(ANGLE, 0.2), "11.46 deg");
        let differences = [0.01, -0.01, 1e-6, -1e-6].map(|by| alone.difference(LENGTH, by));
        assert_eq!(differences, ["+0.01 m", "-0.01 m", "0.00 m", "0.00 m"]);
    }
}
