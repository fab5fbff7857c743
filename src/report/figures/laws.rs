use crate::aerodynamics::{AerodynamicLaw, Coefficients, Fitted, Stream};
use crate::atmosphere::AirState;
use crate::parameters::{Law, Setup};
use crate::report::plot::{Axis, Figure, Hue, Layer, LineNames, NamedQuantity, Shape};
use crate::units::{System, significant};

/// The variable on the horizontal axis of a plot of laws. Spin ratio and Reynolds number are the
/// two variables; a plot keeps one of them constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "commands", derive(clap::ValueEnum))]
pub enum Over {
    /// Over the spin ratio.
    SpinRatio,
    /// Over the Reynolds number.
    Reynolds,
}

/// The coefficient to draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "commands", derive(clap::ValueEnum))]
pub enum Coefficient {
    /// The drag coefficient.
    #[cfg_attr(feature = "commands", value(name = "cd"))]
    Drag,
    /// The lift coefficient.
    #[cfg_attr(feature = "commands", value(name = "cl"))]
    Lift,
}

/// Range of the spin ratio in a plot. It is about twice as wide as the range in a drive.
const SPIN_RATIOS: [f64; 2] = [0.0, 0.4];
/// Range of the Reynolds number in a plot. It is about twice as wide as the range in a drive.
const REYNOLDS: [f64; 2] = [4e4, 2.4e5];

/// Number of segments of a curve.
const STEPS: usize = 240;

/// A plot keeps a variable constant. A measured point is drawn if its value of this variable is
/// unknown, or differs from the constant by at most this fraction.
const CONSTANT_TOLERANCE: f64 = 0.1;

/// A measured point in the plot.
struct DrawnPoint {
    /// The variable on the horizontal axis, and the coefficient.
    at: [f64; 2],
    /// True if the source states the variable that the plot keeps constant.
    is_stated: bool,
}

/// Minimum range of the vertical axis. The values of the setup's law extend the range. Values of
/// other laws outside of the extended range are not drawn.
const COEFFICIENTS: [f64; 2] = [0.0, 0.5];

/// Laws of drag and lift as curves with measured points. The law of the setup has a colour; the
/// others are grey. A curve is solid in the fitted range of the law and dashed elsewhere. It is
/// dashed everywhere if the range is unknown. A law that also depends on the speed or the spin is
/// drawn for the ball and the air of `setup`. `constant` is the Reynolds number if `over` is the
/// spin ratio, and the spin ratio otherwise.
pub fn laws_figure(
    laws: &[Law<f64>],
    setup: &Setup<f64>,
    over: Over,
    constant: f64,
    of: Coefficient,
    system: System,
) -> Figure {
    let plot = LawPlot::new(setup, over, constant, of);
    let mut figure = plot.without_layers(system);
    figure.line_names = LineNames::AtEnds;
    let is_used = |law: &&Law<f64>| law.name() == setup.law.name();
    let (used, others): (Vec<_>, Vec<_>) = laws.iter().partition(is_used);
    // the law in use is drawn on top
    for law in others {
        figure.layers.extend(plot.layers(law, Hue::Faint));
    }
    let own: Vec<Layer> = used
        .iter()
        .flat_map(|law| plot.layers(law, Hue::SET_UP))
        .collect();
    let [low, high] = values(&own).fold(COEFFICIENTS, |[low, high], value| {
        [low.min(value), high.max(value)]
    });
    figure.y = figure.y.exactly(low, high);
    figure.layers.extend(own);
    let used = used.first().map(|law| law.name());
    let mut notes = vec![];
    notes.extend(used.map(|name| format!("In colour: {name}, the law of the setup.")));
    notes.push(
        "Solid within the range of a law's fit, dashed outside of it or if the range is unknown."
            .into(),
    );
    notes.extend(plot.points_note(laws));
    notes.extend(omitted_note(&figure));
    notes.push(
        "Laws that depend on the speed or the spin, not only on Reynolds number and spin ratio, are \
         drawn for the setup's ball and air."
            .into(),
    );
    figure.noted(notes.join(" "))
}

/// The finite coefficients in the points of `layers`.
fn values(layers: &[Layer]) -> impl Iterator<Item = f64> {
    let points = layers.iter().flat_map(Layer::points);
    points
        .map(|[_, value]| value)
        .filter(|value| value.is_finite())
}

/// The note about values outside of the vertical axis. `None` if there are none.
fn omitted_note(figure: &Figure) -> Option<String> {
    let [low, high] = figure.y.range.unwrap_or(COEFFICIENTS);
    let is_omitted = values(&figure.layers).any(|value| !(low..=high).contains(&value));
    is_omitted.then(|| {
        format!(
            "Values below {} and above {} are not drawn.",
            significant(low, 3),
            significant(high, 3)
        )
    })
}

/// The axes of a plot of laws, with the ball and the air.
struct LawPlot {
    over: Over,
    /// The name of the variable on the horizontal axis.
    label: &'static str,
    /// The name of the other variable.
    constant_name: &'static str,
    /// The value of the other variable.
    constant: f64,
    of: Coefficient,
    /// Radius of the ball, m.
    radius: f64,
    /// Reynolds number divided by speed, s/m.
    per_speed: f64,
    /// Range of the horizontal axis.
    range: [f64; 2],
}

impl LawPlot {
    fn new(setup: &Setup<f64>, over: Over, constant: f64, of: Coefficient) -> Self {
        let radius = setup.ball.radius;
        let [label, constant_name] = match over {
            Over::SpinRatio => ["spin ratio", "Reynolds number"],
            Over::Reynolds => ["Reynolds number", "spin ratio"],
        };
        Self {
            over,
            label,
            constant_name,
            constant,
            of,
            radius,
            per_speed: AirState::of(&setup.air).reynolds_per_speed(radius),
            range: match over {
                Over::SpinRatio => SPIN_RATIOS,
                Over::Reynolds => REYNOLDS,
            },
        }
    }

    /// The constant variable with its value, as text.
    fn constant_text(&self) -> String {
        let value = significant(self.constant, 4);
        format!("a {} of {value}", self.constant_name)
    }

    fn without_layers(&self, system: System) -> Figure {
        let (symbol, words) = match self.of {
            Coefficient::Drag => ("C_D", "Drag"),
            Coefficient::Lift => ("C_L", "Lift"),
        };
        let label = self.label;
        let name = format!(
            "laws-{}-{}",
            words.to_lowercase(),
            label.replace(' ', "-").to_lowercase()
        );
        let constant = self.constant_text();
        Figure::new(
            system,
            name,
            format!("{words} coefficient over the {label}, at {constant}"),
            Axis::linear(NamedQuantity::plain(label)),
            Axis::linear(NamedQuantity::plain(symbol)),
        )
    }

    /// The flow of air past the ball; `at` is a value on the horizontal axis.
    fn stream(&self, at: f64) -> Stream<f64> {
        let (spin_ratio, reynolds) = match self.over {
            Over::SpinRatio => (at, self.constant),
            Over::Reynolds => (self.constant, at),
        };
        let speed = reynolds / self.per_speed;
        let spin = spin_ratio * speed / self.radius;
        Stream::new(spin, speed, self.radius, self.per_speed)
    }

    /// The curve of a law with its measured points.
    fn layers(&self, law: &Law<f64>, hue: Hue) -> Vec<Layer> {
        let mut layers = self.curve(law, hue);
        let points: Vec<_> = self
            .drawn_points(law)
            .iter()
            .map(|point| point.at)
            .collect();
        if !points.is_empty() {
            layers.push(Layer::new(law.name(), hue, Shape::Dots(points)).remarked("measured"));
        }
        layers
    }

    /// The measured points of a law near the value that the plot keeps constant (see
    /// [`CONSTANT_TOLERANCE`]).
    fn drawn_points(&self, law: &Law<f64>) -> Vec<DrawnPoint> {
        let [low, high] = self.range;
        let which = self.of as usize;
        law.measured_points(self.per_speed, self.radius)
            .into_iter()
            .filter_map(|point| {
                let (x, other) = match self.over {
                    Over::SpinRatio => (point.spin_ratio?, point.reynolds),
                    Over::Reynolds => (point.reynolds?, point.spin_ratio),
                };
                let is_near = other.is_none_or(|other| {
                    (other - self.constant).abs() <= CONSTANT_TOLERANCE * self.constant
                });
                let point = DrawnPoint {
                    at: [x, point.values[which]?],
                    is_stated: other.is_some(),
                };
                (is_near && (low..=high).contains(&x)).then_some(point)
            })
            .collect()
    }

    /// The note about the measured points of `laws`. `None` if there are no points.
    fn points_note(&self, laws: &[Law<f64>]) -> Option<String> {
        let has = |law: &&Law<f64>, is_stated: bool| {
            let points = self.drawn_points(law);
            points.iter().any(|point| point.is_stated == is_stated)
        };
        let is_any_near = laws.iter().any(|law| has(&law, true));
        let unstated = laws.iter().filter(|law| has(law, false));
        let unstated: Vec<&str> = unstated.map(Law::name).collect();
        let near = format!(
            ", within {:.0} % of {}",
            100.0 * CONSTANT_TOLERANCE,
            self.constant_text()
        );
        let at_any = format!(
            "; those of {} are drawn at any {}, because their sources state no single one",
            unstated.join(", "),
            self.constant_name
        );
        match (is_any_near, unstated.is_empty()) {
            (false, true) => None,
            (true, true) => Some(format!("Points are measured values{near}.")),
            (true, false) => Some(format!("Points are measured values{near}{at_any}.")),
            (false, false) => Some(format!("Points are measured values{at_any}.")),
        }
    }

    /// The curve of a law: a solid line in the fitted range, and a dashed line elsewhere. The whole
    /// curve is dashed if the range is unknown. A line without points is omitted.
    fn curve(&self, law: &Law<f64>, hue: Hue) -> Vec<Layer> {
        let fitted = law.properties().fitted;
        let points = self.points(law, &fitted);
        let (within, beyond) = (pieces(&points, true), pieces(&points, false));
        let range = |variable| self.range.map(|at| self.stream(at).value(variable));
        // without a solid line, the dashed line is not the continuation of another
        let remark = if within.is_empty() {
            String::new()
        } else {
            fitted.continuation_of_all(range).to_string()
        };
        let line = |is_dashed: bool, points: Vec<[f64; 2]>| {
            Layer::new(law.name(), hue, Shape::Line { is_dashed, points })
        };
        let mut lines = vec![line(false, within), line(true, beyond).remarked(remark)];
        lines.retain(|line| !line.points().is_empty());
        lines
    }

    /// The points of a law's curve, each with a flag that is true within the fitted range.
    fn points(&self, law: &Law<f64>, fitted: &Fitted) -> Vec<([f64; 2], bool)> {
        let [low, high] = self.range;
        let point = |k: usize| {
            let at = low + (high - low) * k as f64 / STEPS as f64;
            let stream = self.stream(at);
            let Coefficients { drag, lift } = law.coefficients(stream);
            let is_within = !fitted.is_unknown() && fitted.contains(stream.variables());
            ([at, [drag, lift][self.of as usize]], is_within)
        };
        (0..=STEPS).map(point).collect()
    }
}

/// The parts of a curve within the law's range if `within`, otherwise the parts outside of it. NaN
/// points separate the parts.
fn pieces(curve: &[([f64; 2], bool)], within: bool) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = vec![];
    for (k, (at, is_in)) in curve.iter().enumerate() {
        // a part outside of the range includes the adjacent points of the range, so that the parts
        // meet
        let is_next_to = |k: Option<usize>| {
            k.and_then(|k| curve.get(k))
                .is_some_and(|(_, is_in)| !is_in)
        };
        if *is_in == within
            || (!within && (is_next_to(k.checked_sub(1)) || is_next_to(Some(k + 1))))
        {
            points.push(*at);
        } else if points.last().is_some_and(|last| last[1].is_finite()) {
            points.push([at[0], f64::NAN]);
        }
    }
    while points.last().is_some_and(|last| !last[1].is_finite()) {
        points.pop();
    }
    points
}
