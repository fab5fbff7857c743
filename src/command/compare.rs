use crate::command::args::{Compare, Pair, Question};
use crate::command::names::outcomes;
use crate::command::output::{Answer, spinner, system, tell, tell_error, warn};
use crate::command::question::given_once;
use crate::report::{ComparisonReport, comparison_text, difference_text};
use crate::study::Comparison;
use crate::units::Message;
use crate::{Error, Outcome, Result};

pub fn run(args: &Compare) -> Result<Answer> {
    let of = outcomes(&args.of)?;
    let comparison = args.pair.comparison()?;
    let warnings = warnings(&comparison);
    warn(&warnings);
    let spinner = spinner("splitting the difference");
    let found = comparison.of_each(&of);
    spinner.finish_and_clear();
    let (mut each, mut is_complete) = (vec![], true);
    for (of, difference) in of.into_iter().zip(found) {
        match difference {
            // what one outcome lacks (a landing, a direction) is no reason to keep back the others
            Err(error) if error.is_an_outcome() => {
                is_complete = false;
                tell_error(&error);
                each.push((of, Err(error)));
            }
            difference => each.push((of, Ok(difference?))),
        }
    }
    let answer = if args.pair.question.json {
        Answer::json(&ComparisonReport::reply(&comparison, &each, warnings))
    } else {
        let differences = each
            .iter()
            .filter_map(|(_, difference)| difference.as_ref().ok());
        let texts = differences.map(|difference| difference_text(difference, system()));
        let heads = std::iter::once(comparison_text(&comparison, args.pair.titles(), system()));
        Answer::text(
            heads
                .chain(texts.filter(|_| comparison.differs()))
                .collect::<Vec<_>>()
                .join("\n"),
        )
    };
    Ok(answer.found(is_complete))
}

/// What the reader should know about each of the two drives.
pub fn warnings(comparison: &Comparison) -> Vec<Message> {
    let of = |(name, side): (&str, usize)| {
        let warnings =
            comparison.drives[side].warnings_about(&comparison.setups[side], Outcome::ALL);
        warnings
            .into_iter()
            .map(|warning| Message::from(format!("drive {name}: ")).message(warning))
            .collect::<Vec<_>>()
    };
    [("a", 0), ("b", 1)].into_iter().flat_map(of).collect()
}

impl Pair {
    /// The two drives, side by side.
    pub fn comparison(&self) -> Result<Comparison> {
        let own = [&self.set_a, &self.set_b, &self.launch_a, &self.launch_b];
        if self.other.is_none() && own.iter().all(|options| options.is_empty()) {
            let source = "there is one drive; name a second setup, or say in what drive b differs, \
                          for example --set-b \
                          club.loft=10.5deg";
            return Err(Error::Unreadable {
                name: "compare".into(),
                source: source.into(),
            });
        }
        // told by their own names: the question about each drive has them among those of both
        for (option, own) in [("--set-a", &self.set_a), ("--set-b", &self.set_b)] {
            given_once(&[("--set", &self.question.set), (option, own)])?;
        }
        for (option, own) in [
            ("--launch-a", &self.launch_a),
            ("--launch-b", &self.launch_b),
        ] {
            given_once(&[("--launch", &self.question.launch), (option, own)])?;
        }
        let setup = |(question, drive): (Question, &'static str)| {
            let setup = question
                .setup()
                .and_then(|setup| question.within_tolerance(setup));
            setup.map_err(|error| error.of_drive(drive))
        };
        let [a, b] = self.questions();
        let comparison = Comparison::new(&setup((a, "drive a"))?, &setup((b, "drive b"))?)?;
        if comparison.is_refined {
            let setup = &comparison.setups[0];
            tell(&format!(
                "note: both drives are flown with flight.method = {} and flight.step = {} s: the \
                 higher order and the shorter step \
                 of the two setups",
                setup.method.name(),
                setup.flight.step
            ));
        }
        Ok(comparison)
    }

    /// The question about each drive alone.
    pub fn questions(&self) -> [Question; 2] {
        let Question {
            setup,
            set,
            launch,
            tolerance,
            own_step,
            json,
        } = &self.question;
        let one = |setup: &String, own: &[String], own_launch: &[String]| Question {
            setup: setup.clone(),
            set: [set, own].concat(),
            launch: [launch, own_launch].concat(),
            tolerance: tolerance.clone(),
            own_step: *own_step,
            json: *json,
        };
        [
            one(setup, &self.set_a, &self.launch_a),
            one(
                self.other.as_ref().unwrap_or(setup),
                &self.set_b,
                &self.launch_b,
            ),
        ]
    }

    /// What each drive is, as it was asked for: "modern-driver, club.loft=11deg".
    pub fn titles(&self) -> [String; 2] {
        let b = self.other.as_ref().unwrap_or(&self.question.setup);
        [
            (&self.question.setup, &self.set_a, &self.launch_a),
            (b, &self.set_b, &self.launch_b),
        ]
        .map(|(setup, set, launch)| {
            [std::slice::from_ref(setup), set, launch]
                .concat()
                .join(", ")
        })
    }
}
