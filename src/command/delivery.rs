use crate::command::args::{DeliveryArgs, Question};
use crate::command::files::{Destination, Rule};
use crate::command::interrupt::{self, BEST_SO_FAR};
use crate::command::output::{Answer, command_line, system, tell, warn};
use crate::parameters::Vary;
use crate::report::{
    bound_warnings, delivered_text, deliveries_text, delivery_reply, delivery_toml, parameter_text,
    population_warnings, recovered_csv, recovered_toml,
};
use crate::study::Sigma;
use crate::study::calibrate::ShotTable;
use crate::study::delivery::{
    Delivery, Population, Unknown, deliveries, delivery, launches, unknowns,
};
use crate::units::{Message, counted};
use crate::{Error, Result, Setup};
use std::ffi::OsString;
use std::path::Path;

pub fn run(args: &DeliveryArgs) -> Result<Answer> {
    refuse_step(&args.question)?;
    let inputs = args.question.inputs().chain(args.shots.clone());
    let rule = Rule::new(inputs, args.overwrite);
    let output = args
        .output
        .as_ref()
        .map(|file| rule.setup_file(file))
        .transpose()?;
    let of_swings = rule.and_not(args.output.as_deref());
    let swings = args
        .swings
        .as_ref()
        .map(|file| Ok((of_swings.file(file)?, is_table(file)?)))
        .transpose()?;
    let (setup, launched) = setups(args)?;
    let mut warnings = setup.warnings();
    warn(&warnings);
    let vary = args
        .vary
        .iter()
        .map(|text| Vary::read(&setup, text))
        .collect::<Result<Vec<_>>>()?;
    let sigmas = args
        .sigma
        .iter()
        .map(|text| Sigma::read(&setup, text))
        .collect::<Result<Vec<_>>>()?;
    let unknowns = unknowns(&setup, &vary, &sigmas)?;
    let (all, population, from, left_out) = match &args.shots {
        None => {
            tell_assumed(&unknowns);
            let found = delivery(&setup, &launches(&launched), &unknowns)?;
            (
                vec![Delivery {
                    row: 1,
                    found: Ok(found),
                }],
                None,
                "a measured launch".to_owned(),
                0,
            )
        }
        Some(file) => {
            let table = ShotTable::open_launches(&setup, file)?;
            let given: Vec<_> = setup
                .parameters()
                .into_iter()
                .filter(|parameter| table.gives(parameter))
                .collect();
            args.question.refuse_twice(
                &setup,
                &given,
                &format!("every row of {} has a value of its own", table.file),
            )?;
            warn(&table.warnings);
            warnings.extend(table.warnings.clone());
            let remarks = table
                .remarks
                .iter()
                .filter(|remark| !table.warnings.contains(remark));
            remarks.for_each(|remark| tell(&remark.in_units(system())));
            tell(&format!(
                "{}: of each row the launch is used, and not the flight",
                table.file
            ));
            let (measured, assumed): (Vec<_>, Vec<_>) = unknowns
                .iter()
                .partition(|unknown| table.gives(unknown.parameter));
            tell_assumed(&assumed);
            tell_measured(&setup, &measured);
            let all = deliveries(&setup, &table, &unknowns, &interrupt::stops(BEST_SO_FAR));
            let left_out = table.shots.len() - all.len();
            let population =
                Population::of(&setup, &all, &unknowns, |parameter| table.gives(parameter));
            (all, Some(population), table.file, left_out)
        }
    };
    if left_out > 0 {
        let unreached = [format!(
            "interrupted: {} were not looked at",
            counted(left_out as u64, "row")
        )
        .into()];
        warn(&unreached);
        warnings.extend(unreached);
    }
    let found = all.iter().filter_map(Delivery::explained).count();
    let at_bounds = bound_warnings(&all, system());
    warn(&at_bounds);
    warnings.extend(at_bounds);
    let of_population: Vec<_> = population
        .iter()
        .flatten()
        .flat_map(|population| population_warnings(population, system()))
        .collect();
    warn(&of_population);
    warnings.extend(of_population);
    let is_setup_written = output.is_some() && found > 0 && left_out == 0;
    if let Some(output) = &output {
        let file = output.path().display();
        if is_setup_written {
            let setup_file = delivery_toml(&setup, &all, args.question.preset()?, &from)?;
            output.write(args.question.as_stated(setup_file)?.as_bytes())?;
            tell(&format!(
                "wrote the setup with this delivery into {file}; 'longdrive optimize {file} --vary \
                 club.loft=4deg..20deg' finds \
                 the loft of the longest carry for it"
            ));
        } else {
            let why = if found == 0 {
                "no delivery was found"
            } else {
                "the work was interrupted"
            };
            let unwritten = [Message::from(format!("{file} is not written: {why}"))];
            warn(&unwritten);
            warnings.extend(unwritten);
        }
    }
    let mut is_written = true;
    if let (Some((swings, is_table)), Some(population)) = (&swings, &population) {
        // swings are of one club, ball and air
        let setup = match &output {
            Some(output) if is_setup_written => vec![output.path().display().to_string()],
            _ => args.question.as_arguments(
                &unknowns
                    .iter()
                    .map(|unknown| unknown.parameter)
                    .collect::<Vec<_>>(),
            ),
        };
        let unwritten = write_swings(
            (swings, *is_table),
            &all,
            population,
            left_out == 0,
            (&from, setup),
        )?;
        is_written = unwritten.is_none();
        let unwritten: Vec<Message> = unwritten.into_iter().collect();
        warn(&unwritten);
        warnings.extend(unwritten);
    }
    let population = population.and_then(Result::ok);
    let answer = if args.question.json {
        Answer::json(&delivery_reply(
            &all,
            population.as_ref(),
            left_out,
            warnings,
        ))
    } else {
        Answer::text(
            match (
                &args.shots,
                all.first()
                    .and_then(|delivery| delivery.found.as_ref().ok()),
            ) {
                (None, Some(delivered)) => delivered_text(delivered, system()),
                _ => deliveries_text(&all, population.as_ref(), system()),
            },
        )
    };
    Ok(answer.found(found == all.len() && left_out == 0 && is_written))
}

/// Whether swings are to be written as a table; else they are written as distributions.
fn is_table(file: &Path) -> Result<bool> {
    let ending = file
        .extension()
        .map(|ending| ending.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        Some("csv") => Ok(true),
        Some("toml") => Ok(false),
        _ => {
            let source = format!(
                "{} ends in neither; write .csv for a row of each shot, or .toml for distributions",
                file.display()
            );
            Err(Error::Unreadable {
                name: "--swings".into(),
                source: source.into(),
            })
        }
    }
}

/// Writes the swings behind the shots, or says why not.
fn write_swings(
    (output, is_table): (&Destination, bool),
    all: &[Delivery],
    population: &Result<Population>,
    is_whole: bool,
    (from, setup): (&str, Vec<String>),
) -> Result<Option<Message>> {
    let file = output.path().display();
    let unwritten = |why: &str| Ok(Some(Message::from(format!("{file} is not written: {why}"))));
    let found = all.iter().filter_map(Delivery::explained).count();
    let swings = counted(found as u64, "swing");
    let (text, told) = match population {
        _ if !is_whole => return unwritten("the work was interrupted"),
        _ if is_table && found == 0 => return unwritten("no delivery was found"),
        _ if is_table => {
            let told = format!(
                "wrote {swings} into {file}: what a shot does not tell of a swing is drawn towards \
                 what was known before, so that these scatter \
                 less than the golfer; a name that ends in .toml gives the distribution"
            );
            (recovered_csv(all)?, told)
        }
        Ok(population) => (
            recovered_toml(population, from, system()),
            format!("wrote the distribution of {swings} into {file}"),
        ),
        Err(Error::Delivery { reason }) => return unwritten(reason),
        Err(error) => return unwritten(&error.to_string()),
    };
    output.write(text.as_bytes())?;
    tell(&told);
    if all.len() > found {
        tell(&format!(
            "left out of it: {} whose delivery was not found",
            counted((all.len() - found) as u64, "row")
        ));
    }
    tell(&format!(
        "the design that is best over them: {}",
        optimize_over(output.path(), setup)
    ));
    Ok(None)
}

/// The command that finds the best design over these swings, of the setup that these arguments
/// give.
fn optimize_over(swings: &Path, setup: Vec<String>) -> String {
    let setup = setup.into_iter().map(OsString::from);
    let arguments = std::iter::once("optimize".into())
        .chain(setup)
        .chain(["--swings".into(), swings.into()]);
    command_line(&arguments.collect::<Vec<_>>())
}

/// What is taken for the uncertainty of each parameter before the shot, where none was given.
fn tell_assumed(unknowns: &[Unknown]) {
    for unknown in unknowns {
        if let Some(source) = unknown.source {
            let shown = |value: f64| parameter_text(unknown.parameter, value, system());
            let (name, value, sigma) = (
                unknown.parameter.name,
                shown(unknown.before),
                shown(unknown.sigma),
            );
            tell(&format!(
                "known before: {name} = {value} ± {sigma} (one standard deviation); {source}"
            ));
        }
    }
}

/// How well the columns of the club are known, where these are sought.
fn tell_measured(setup: &Setup<f64>, unknowns: &[Unknown]) {
    for unknown in unknowns {
        let name = unknown.parameter.name;
        let measured = unknown.measured_as(setup.value(unknown.parameter).unwrap_or_default());
        let sigma = parameter_text(unknown.parameter, measured.sigma, system());
        let source = measured.source.unwrap_or("as given");
        tell(&format!(
            "known before: {name} as each row has it ± {sigma} (one standard deviation); {source}"
        ));
    }
}

/// The setup of the club, and the same with the launch that was measured.
fn setups(args: &DeliveryArgs) -> Result<(Setup<f64>, Setup<f64>)> {
    let options = [
        ("ball_speed", &args.ball_speed),
        ("launch_angle", &args.launch_angle),
        ("launch_direction", &args.launch_direction),
        ("backspin", &args.backspin),
        ("sidespin", &args.sidespin),
        ("spin", &args.spin),
        ("spin_axis", &args.spin_axis),
    ];
    let options = options
        .into_iter()
        .filter_map(|(name, text)| Some(format!("{name}={}", text.as_ref()?)));
    let launch: Vec<String> = args
        .question
        .launch
        .iter()
        .cloned()
        .chain(options)
        .collect();
    let is_launch = |text: &&String| text.trim_start().starts_with("launch.");
    let (of_launch, of_club): (Vec<_>, Vec<_>) = args.question.set.iter().partition(is_launch);
    let part = |set: Vec<&String>, launch: Vec<String>| Question {
        set: set.into_iter().cloned().collect(),
        launch,
        ..args.question.clone()
    };
    let (club, own) = (part(of_club, vec![]), part(of_launch, launch));
    let mut setup = club.setup()?;
    if args.shots.is_some() && !own.launch.is_empty() {
        let source = "the shots have launches of their own; give one of the two".into();
        return Err(Error::Unreadable {
            name: format!("--shots with the launch {}", own.launch.join(", ")),
            source,
        });
    }
    let launched = own.setup()?;
    for condition in setup.given_launch_conditions() {
        setup.set_value(condition, None)?;
    }
    if args.shots.is_none() && !launched.launch.is_given() {
        let source =
            "no launch is given; add --ball-speed, --launch-angle and --spin (or --backspin), or \
             --shots FILE"
                .into();
        return Err(Error::Unreadable {
            name: "delivery".into(),
            source,
        });
    }
    Ok((setup, launched))
}

/// Nothing is flown: an accuracy of the flight has no effect.
fn refuse_step(question: &Question) -> Result<()> {
    let given = if question.tolerance.is_some() {
        "--tolerance"
    } else {
        "--own-step"
    };
    if question.tolerance.is_none() && !question.own_step {
        return Ok(());
    }
    let source =
        "delivery looks at the impact alone and flies nothing, so that this has no effect; leave \
         it out"
            .into();
    Err(Error::Unreadable {
        name: given.into(),
        source,
    })
}
