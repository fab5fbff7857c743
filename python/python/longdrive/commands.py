"""The studies: a function for each command of the program.

Each of them raises :class:`longdrive.InputError` for bad input, with the program's message, :class:`longdrive.NoAnswerError` for a sound question
without an answer, and :class:`longdrive.Interrupted` after Ctrl-C, with what was found so far. ``progress`` is True for a bar, or a function that is
called with how many parts of how many are done: 0 of 0 while the parts cannot be counted.

Written by make_commands.py from what the program says of its commands; change it there.
"""

from __future__ import annotations

from typing import Literal

from ._ask import ask
from .optimum import Optimum, optimum
from .progress import Progress
from .reply import Reply, as_reply
from .rows import flown
from .types import Amount, Given, Goals, Names, PathLike, SetupLike, TableLike

__all__ = [
    "calibrate",
    "chart",
    "compare",
    "delivery",
    "design",
    "fly",
    "laws",
    "optimize",
    "optimum_sensitivity",
    "pareto",
    "report",
    "reproduce",
    "robust",
    "sensitivity",
    "uncertainty",
    "validate",
    "verify",
]


def compare(
    setup: SetupLike = None,
    other: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    launch_a: Given | None = None,
    launch_b: Given | None = None,
    of: Names | None = None,
    progress: Progress = False,
) -> Reply:
    """Compare two drives: their outcomes, and which part of the difference is due to which parameter
    and launch condition.

    Args:
        setup: the first drive, which messages call a: a setup, the name of a preset, a dict, or
            None for the preset tour-average.
        other: the second drive, b, as setup is given: for example setup.replace({"club.loft": "11
            deg"}). Without it launch_a or launch_b says in what it differs.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        launch_a: the launch conditions of a, as in launch.
        launch_b: the launch conditions of b, as in launch.
        of: the outcomes whose difference is split, one or several; "all" for every one [default:
            carry].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("compare", locals(), as_reply)


def optimize(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    maximize: str | None = None,
    minimize: str | None = None,
    vary: Given | None = None,
    subject_to: Names | None = None,
    max_iterations: int | None = None,
    swings: TableLike | None = None,
    distribution: Given | None = None,
    correlation: Given | None = None,
    scenarios: int | None = None,
    seed: int | None = None,
    strokes: TableLike | None = None,
    starts: int | None = None,
    checkpoint: PathLike | None = None,
    output: PathLike | None = None,
    overwrite: bool = False,
    progress: Progress = False,
) -> Optimum:
    """Find the parameters that maximize or minimize an outcome: by default, the loft and attack angle
    of the longest carry.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        maximize: the outcome to maximize [default: carry, unless minimize is given].
        minimize: the outcome to minimize.
        vary: a parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to
            20 deg and attack angle -5 to 5 deg].
        subject_to: a constraint on an outcome, e.g. "descent_angle >= 38 deg", "20 yd <=
            apex_height <= 35 yd" or "lateral == 0 m"; every limit with its unit. Over many swings
            also a relation with a name, linear in parameters, e.g. "budget: club.weight_1.mass +
            club.weight_2.mass <= 20 g".
        max_iterations: the largest number of iterations of a search [default: 500].
        swings: search for the best over many swings: a TOML file with [distributions] and
            [[correlations]], or a table (CSV, Parquet, Arrow) of recorded swings, a column for each
            parameter. Goals are then written like "mean(carry)", "std(lateral)", "lowest(carry,
            10%)", "within(lateral, 15yd)" or "mean(carry) - 0.5*std(lateral)", and vary is the loft
            alone by default.
        distribution: the distribution of a parameter from swing to swing:
            NAME=normal(MEAN,DEVIATION), NAME=uniform(LOW,HIGH), NAME=triangular(LOW,MODE,HIGH) or
            NAME=truncated(MEAN,DEVIATION,LOW,HIGH).
        correlation: the correlation of two parameters with distributions, e.g.
            swing.path,swing.face_angle=0.6.
        scenarios: take this many swings of the distributions, by a quasi-random sequence [default:
            quadrature for up to 3 parameters, else 512 swings].
        seed: the seed of the swings; the same seed gives the same swings [default: 0].
        strokes: a CSV table of the strokes that are expected from a distance, with the columns
            "distance [yd]" and "strokes", for the goal "strokes(400yd)": the expected strokes to
            hole out after this drive.
        starts: search from this many starts, spread evenly over the ranges (the first is the
            setup's own), and list the local optima [default: 1].
        checkpoint: save the search to this file after every iteration; if the file exists, continue
            from it.
        output: write the setup at the optimum into this setup file.
        overwrite: replace the file if it exists.
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("optimize", locals(), optimum)


def optimum_sensitivity(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    maximize: str | None = None,
    minimize: str | None = None,
    vary: Given | None = None,
    subject_to: Names | None = None,
    max_iterations: int | None = None,
    swings: TableLike | None = None,
    distribution: Given | None = None,
    correlation: Given | None = None,
    scenarios: int | None = None,
    seed: int | None = None,
    strokes: TableLike | None = None,
    starts: int | None = None,
    checkpoint: PathLike | None = None,
    output: PathLike | None = None,
    overwrite: bool = False,
    wrt: Names | None = None,
    change: Given | None = None,
    loss: Amount | None = None,
    progress: Progress = False,
) -> Optimum:
    """How the optimum depends on every other parameter, what its bounds and constraints cost, and how
    flat it is.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        maximize: the outcome to maximize [default: carry, unless minimize is given].
        minimize: the outcome to minimize.
        vary: a parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to
            20 deg and attack angle -5 to 5 deg].
        subject_to: a constraint on an outcome, e.g. "descent_angle >= 38 deg", "20 yd <=
            apex_height <= 35 yd" or "lateral == 0 m"; every limit with its unit. Over many swings
            also a relation with a name, linear in parameters, e.g. "budget: club.weight_1.mass +
            club.weight_2.mass <= 20 g".
        max_iterations: the largest number of iterations of a search [default: 500].
        swings: search for the best over many swings: a TOML file with [distributions] and
            [[correlations]], or a table (CSV, Parquet, Arrow) of recorded swings, a column for each
            parameter. Goals are then written like "mean(carry)", "std(lateral)", "lowest(carry,
            10%)", "within(lateral, 15yd)" or "mean(carry) - 0.5*std(lateral)", and vary is the loft
            alone by default.
        distribution: the distribution of a parameter from swing to swing:
            NAME=normal(MEAN,DEVIATION), NAME=uniform(LOW,HIGH), NAME=triangular(LOW,MODE,HIGH) or
            NAME=truncated(MEAN,DEVIATION,LOW,HIGH).
        correlation: the correlation of two parameters with distributions, e.g.
            swing.path,swing.face_angle=0.6.
        scenarios: take this many swings of the distributions, by a quasi-random sequence [default:
            quadrature for up to 3 parameters, else 512 swings].
        seed: the seed of the swings; the same seed gives the same swings [default: 0].
        strokes: a CSV table of the strokes that are expected from a distance, with the columns
            "distance [yd]" and "strokes", for the goal "strokes(400yd)": the expected strokes to
            hole out after this drive.
        starts: search from this many starts, spread evenly over the ranges (the first is the
            setup's own), and list the local optima [default: 1].
        checkpoint: save the search to this file after every iteration; if the file exists, continue
            from it.
        output: write the setup at the optimum into this setup file.
        overwrite: replace the file if it exists.
        wrt: the parameters that the optimum depends on, one or several; "all" for every one that
            has a value in this setup and is not varied [default: all].
        change: a change of a parameter, e.g. swing.speed=+5mph or air.density=-20% of its value:
            its effect on the optimum is predicted, and compared with a new search.
        loss: the loss of the outcome for which tolerances of the optimum are computed [default: 1
            yd for a distance, or 1 % of the carry where that is below 10 yd; 1 % of the outcome
            otherwise].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("optimum-sensitivity", locals(), optimum)


def design(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    max_iterations: int | None = None,
    distribution: Given | None = None,
    correlation: Given | None = None,
    scenarios: int | None = None,
    seed: int | None = None,
    strokes: TableLike | None = None,
    starts: int | None = None,
    checkpoint: PathLike | None = None,
    overwrite: bool = False,
    rules: Literal["golf", "none"] | None = None,
    maximize: str | None = None,
    minimize: str | None = None,
    vary: Given | None = None,
    subject_to: Names | None = None,
    swings: TableLike | None = None,
    output: PathLike | None = None,
    progress: Progress = False,
) -> Optimum:
    """Design head and face for swings that vary, under the Rules of Golf: the best bulge, roll, loft,
    inertia or movable weights, with what each rule costs.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset modern-driver.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        max_iterations: the largest number of iterations of a search [default: 500].
        distribution: the distribution of a parameter from swing to swing:
            NAME=normal(MEAN,DEVIATION), NAME=uniform(LOW,HIGH), NAME=triangular(LOW,MODE,HIGH) or
            NAME=truncated(MEAN,DEVIATION,LOW,HIGH).
        correlation: the correlation of two parameters with distributions, e.g.
            swing.path,swing.face_angle=0.6.
        scenarios: take this many swings of the distributions, by a quasi-random sequence [default:
            quadrature for up to 3 parameters, else 512 swings].
        seed: the seed of the swings; the same seed gives the same swings [default: 0].
        strokes: a CSV table of the strokes that are expected from a distance, with the columns
            "distance [yd]" and "strokes", for the goal "strokes(400yd)": the expected strokes to
            hole out after this drive.
        starts: search from this many starts, spread evenly over the ranges (the first is the
            setup's own), and list the local optima [default: 1].
        checkpoint: save the search to this file after every iteration; if the file exists, continue
            from it.
        overwrite: replace the file if it exists.
        rules: the rules that hold the design: those of golf (moment of inertia, volume, spring
            effect, ball), or none [default: golf].
        maximize: the goal to maximize, e.g. "mean(carry)" [default: "mean(carry) -
            0.5*rms(lateral)", unless minimize is given].
        minimize: the goal to minimize, e.g. "rms(lateral)".
        vary: a parameter of the head to vary, with its range, e.g. club.bulge_radius=200mm..600mm
            or club.weight_1.toe=-50mm..50mm. [default: bulge and roll 150 to 1000 mm, loft 6 to 16
            deg].
        subject_to: a limit of a goal or of the head, e.g. "std(lateral) <= 20yd" or "head_mass <=
            205 g"; or a relation with a name, linear in parameters, e.g. "volume: 120 cm^3 + 80
            cm^2*club.cg_depth <= 460 cm^3".
        swings: the swings to design for: a TOML file with [distributions] and [[correlations]], or
            a table (CSV, Parquet, Arrow) of recorded swings [default: a golfer whose drives were
            measured, about the setup's own swing].
        output: write the setup with the best design into this setup file.
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("design", locals(), optimum)


def calibrate(
    data: TableLike,
    setup: SetupLike = None,
    *,
    fit: Given,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    huber: bool = False,
    starts: int | None = None,
    folds: int | None = None,
    compare: Names | None = None,
    max_iterations: int | None = None,
    output: PathLike | None = None,
    plot: PathLike | None = None,
    overwrite: bool = False,
    progress: Progress = False,
) -> Reply:
    """Fit parameters to measured shots, with their uncertainties and what the data do not determine.

    Args:
        data: measured shots as CSV, one row per shot; the head of each column names a parameter or
            an outcome and its unit, as in "carry [yd]"; see docs/calibration.md.
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        fit: a parameter to fit, e.g. aero.cd0 or aero.cd0=0.1..0.4.
        huber: limit the influence of outliers to that of a residual of 1.345 σ (Huber's loss).
        starts: search from this many starts, spread evenly over the ranges of what is fitted; the
            first is the setup's own. Give the ranges: without one it is all that is allowed, where
            few drives fly [default: 1].
        folds: Cross-validate: fit K times, each time without a K-th of the rows, and show how well
            those rows are predicted [default: 0].
        compare: compare with another aerodynamic law, as published and fitted, by its
            cross-validation error.
        max_iterations: the largest number of iterations of a search [default: 200].
        output: write the fitted setup into this file.
        plot: write the report into this folder too: a page (index.html), Markdown, and plots of the
            residuals with their data.
        overwrite: replace files that exist.
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("calibrate", locals(), as_reply)


def delivery(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    ball_speed: Amount | None = None,
    launch_angle: Amount | None = None,
    launch_direction: Amount | None = None,
    spin: Amount | None = None,
    spin_axis: Amount | None = None,
    backspin: Amount | None = None,
    sidespin: Amount | None = None,
    shots: TableLike | None = None,
    vary: Given | None = None,
    sigma: Given | None = None,
    output: PathLike | None = None,
    swings: TableLike | None = None,
    overwrite: bool = False,
    progress: Progress = False,
) -> Reply:
    """Find the delivery and strike that explain a measured launch, and what the launch does not tell
    of them.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        ball_speed: the measured speed of the ball, e.g. 167mph.
        launch_angle: the measured angle of the launch above horizontal, e.g. 10.9deg.
        launch_direction: the measured direction of the launch, + right of the target line [default:
            not measured].
        spin: the measured spin in all, e.g. 2686rpm; with spin_axis.
        spin_axis: the measured tilt of the spin axis, + for a ball that curves to the right
            [default: not measured].
        backspin: the measured backspin, in place of spin; with sidespin.
        sidespin: the measured sidespin, + for a ball that curves to the right [default: not
            measured].
        shots: measured shots as CSV, one row per shot, as a launch monitor exports them or as
            calibrate reads them. What a row states of the club is taken as measured too.
        vary: a parameter to find and its range, e.g. club.loft=4deg..20deg. [default: the speed,
            attack angle, shaft lean, path and face angle of the swing, and where the face strikes
            the ball].
        sigma: how well a parameter is known before the shot: the standard uncertainty of its value
            in the setup, e.g. swing.attack_angle=1deg.
        output: write the setup with the delivery found into this file; of several shots, with their
            mean.
        swings: write the swings behind the shots into this file, for "longdrive optimize swings":
            as a table, a row for each shot (.csv), or as distributions with correlations, without
            the errors of the launch monitor (.toml).
        overwrite: replace files that exist.
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("delivery", locals(), as_reply)


def chart(
    setup: SetupLike = None,
    *,
    along: Given,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    maximize: str | None = None,
    minimize: str | None = None,
    vary: Given | None = None,
    subject_to: Names | None = None,
    max_iterations: int | None = None,
    at: Names | None = None,
    progress: Progress = False,
) -> Reply:
    """Compute the optimum as a function of a parameter.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        maximize: the outcome to maximize [default: carry, unless minimize is given].
        minimize: the outcome to minimize.
        vary: a parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to
            20 deg and attack angle -5 to 5 deg].
        subject_to: a constraint on an outcome, e.g. "descent_angle >= 38 deg", "20 yd <=
            apex_height <= 35 yd" or "lateral == 0 m"; every limit with its unit. Over many swings
            also a relation with a name, linear in parameters, e.g. "budget: club.weight_1.mass +
            club.weight_2.mass <= 20 g".
        max_iterations: the largest number of iterations of a search [default: 500].
        along: the parameter to follow the optimum along, with its range, e.g.
            swing.speed=80mph..130mph.
        at: the values of that parameter at which the optimum is computed, one or several, e.g.
            90mph,100mph,110mph; along may then be the name alone [default: as many values as the
            curve needs].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("chart", locals(), as_reply)


def pareto(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    maximize: Goals | None = None,
    minimize: Goals | None = None,
    vary: Given | None = None,
    subject_to: Names | None = None,
    points: int | None = None,
    max_iterations: int | None = None,
    swings: TableLike | None = None,
    distribution: Given | None = None,
    correlation: Given | None = None,
    scenarios: int | None = None,
    seed: int | None = None,
    strokes: TableLike | None = None,
    output: PathLike | None = None,
    at: Amount | None = None,
    overwrite: bool = False,
    progress: Progress = False,
) -> Reply:
    """Find the best compromises between two goals, such as carry and dispersion, with what one costs
    of the other.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        maximize: a goal to maximize: an outcome, or over many swings what of it, e.g.
            "mean(carry)". Give two goals in all, with maximize and minimize.
        minimize: a goal to minimize, e.g. "std(lateral)".
        vary: a parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to
            20 deg; for one drive also attack angle -5 to 5 deg].
        subject_to: a constraint on a goal, e.g. "apex_height <= 35 yd", over many swings
            "mean(carry) >= 240 yd"; every limit with its unit.
        points: the number of points, spread evenly from the best of one goal to the best of the
            other [default: 15].
        max_iterations: the largest number of iterations of a search [default: 500].
        swings: search for the best over many swings: a TOML file with [distributions] and
            [[correlations]], or a table (CSV, Parquet, Arrow) of recorded swings, a column for each
            parameter. Goals are then written like "mean(carry)", "std(lateral)", "lowest(carry,
            10%)", "within(lateral, 15yd)" or "mean(carry) - 0.5*std(lateral)", and vary is the loft
            alone by default.
        distribution: the distribution of a parameter from swing to swing:
            NAME=normal(MEAN,DEVIATION), NAME=uniform(LOW,HIGH), NAME=triangular(LOW,MODE,HIGH) or
            NAME=truncated(MEAN,DEVIATION,LOW,HIGH).
        correlation: the correlation of two parameters with distributions, e.g.
            swing.path,swing.face_angle=0.6.
        scenarios: take this many swings of the distributions, by a quasi-random sequence [default:
            quadrature for up to 3 parameters, else 512 swings].
        seed: the seed of the swings; the same seed gives the same swings [default: 0].
        strokes: a CSV table of the strokes that are expected from a distance, with the columns
            "distance [yd]" and "strokes", for the goal "strokes(400yd)": the expected strokes to
            hole out after this drive.
        output: write the points into this file: .csv for all of them (SI units and radians), .toml
            for the setup at one of them, which at chooses.
        at: the point whose setup is written: "knee", or its number in the table [default: knee].
        overwrite: replace the file if it exists.
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("pareto", locals(), as_reply)


def robust(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    maximize: str | None = None,
    minimize: str | None = None,
    vary: Given | None = None,
    subject_to: Names | None = None,
    max_iterations: int | None = None,
    swings: TableLike | None = None,
    distribution: Given | None = None,
    correlation: Given | None = None,
    scenarios: int | None = None,
    seed: int | None = None,
    strokes: TableLike | None = None,
    starts: int | None = None,
    model: Given | None = None,
    within: Amount | None = None,
    output: PathLike | None = None,
    overwrite: bool = False,
    progress: Progress = False,
) -> Optimum:
    """Find the design that loses least whichever of several models of impact and flight is true.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        maximize: the outcome to maximize [default: carry, unless minimize is given].
        minimize: the outcome to minimize.
        vary: a parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to
            20 deg and attack angle -5 to 5 deg].
        subject_to: a constraint on an outcome, e.g. "descent_angle >= 38 deg", "20 yd <=
            apex_height <= 35 yd" or "lateral == 0 m"; every limit with its unit. Over many swings
            also a relation with a name, linear in parameters, e.g. "budget: club.weight_1.mass +
            club.weight_2.mass <= 20 g".
        max_iterations: the largest number of iterations of a search [default: 500].
        swings: search for the best over many swings: a TOML file with [distributions] and
            [[correlations]], or a table (CSV, Parquet, Arrow) of recorded swings, a column for each
            parameter. Goals are then written like "mean(carry)", "std(lateral)", "lowest(carry,
            10%)", "within(lateral, 15yd)" or "mean(carry) - 0.5*std(lateral)", and vary is the loft
            alone by default.
        distribution: the distribution of a parameter from swing to swing:
            NAME=normal(MEAN,DEVIATION), NAME=uniform(LOW,HIGH), NAME=triangular(LOW,MODE,HIGH) or
            NAME=truncated(MEAN,DEVIATION,LOW,HIGH).
        correlation: the correlation of two parameters with distributions, e.g.
            swing.path,swing.face_angle=0.6.
        scenarios: take this many swings of the distributions, by a quasi-random sequence [default:
            quadrature for up to 3 parameters, else 512 swings].
        seed: the seed of the swings; the same seed gives the same swings [default: 0].
        strokes: a CSV table of the strokes that are expected from a distance, with the columns
            "distance [yd]" and "strokes", for the goal "strokes(400yd)": the expected strokes to
            hole out after this drive.
        starts: make each search from this many starts, spread evenly over the ranges (the first is
            the setup's own) [default: 1].
        model: a model beside the setup as it is: its changes, e.g. "aero.law=ferguson" or
            "impact.friction=0.3,impact.gear_scale=0.5". [default: the laws launch-monitor and
            ferguson, a friction of 0.3 and half the gear effect, each alone].
        within: the loss beside the best for each model that is allowed [default: 1 yd for a
            distance].
        output: write the setup with the robust design into this setup file.
        overwrite: replace the file if it exists.
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("robust", locals(), optimum)


def report(
    setup: SetupLike = None,
    *,
    output: PathLike,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    maximize: str | None = None,
    minimize: str | None = None,
    vary: Given | None = None,
    subject_to: Names | None = None,
    max_iterations: int | None = None,
    overwrite: bool = False,
    sigma: Given | None = None,
    along: Given | None = None,
    progress: Progress = False,
) -> Reply:
    """Write a page (HTML) of the drive, the optimum, a map around it, sensitivities and uncertainties,
    with plots and data.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        maximize: the outcome to maximize [default: carry, unless minimize is given].
        minimize: the outcome to minimize.
        vary: a parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to
            20 deg and attack angle -5 to 5 deg].
        subject_to: a constraint on an outcome, e.g. "descent_angle >= 38 deg", "20 yd <=
            apex_height <= 35 yd" or "lateral == 0 m"; every limit with its unit. Over many swings
            also a relation with a name, linear in parameters, e.g. "budget: club.weight_1.mass +
            club.weight_2.mass <= 20 g".
        max_iterations: the largest number of iterations of a search [default: 500].
        output: the folder to write: index.html, the best drive as setup.toml, and each plot as
            NAME-metric.svg, NAME-us.svg and NAME.csv. The folder is created if it does not exist;
            other files in it are not touched.
        overwrite: replace files that exist.
        sigma: the standard uncertainty of a parameter, e.g. swing.speed=1mph or air.density=0.5%.
            Repeatable; other parameters have the default uncertainties of "longdrive sensitivity".
        along: the parameter to follow the optimum along, with its range [default:
            swing.speed=80mph..130mph; with launch, launch.ball_speed=120mph..190mph; around the
            drive's own speed where that lies outside].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("report", locals(), as_reply)


def fly(
    shots: TableLike,
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    of: Names | None = None,
    output: PathLike | None = None,
    format: Literal["csv", "launch-monitor", "jsonl", "open-connect", "parquet"] | None = None,
    overwrite: bool = False,
    threads: int | None = None,
    progress: Progress = False,
) -> Reply:
    """Fly the shots of a launch monitor (a CSV export, or GSPro Open Connect): predicted flights
    beside the measured ones.

    Args:
        shots: shots, a row each: the CSV export of a launch monitor, any CSV with columns such as
            "ball_speed [mph]", "launch_angle [deg]" and "backspin [rpm]", or messages of GSPro Open
            Connect as JSON (one a line, or an array); "-" is standard input. See
            docs/launch-monitors.md.
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        of: the outcomes to predict, one or several: those of the flight; "all" for every one of
            them [default: carry_distance,lateral,apex_height,flight_time,descent_angle,total].
        output: the file to write the rows into; its ending says in which format (.csv, .jsonl,
            .parquet; .json for Open Connect). "-" is standard output. With json and without a file
            only the summary is printed.
        format: the format, whatever the name of the file ends in [default for standard output:
            csv].
        overwrite: replace the file if it exists.
        threads: the number of threads (0: as many as there are processors). The results do not
            depend on it [default: 0].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("fly", locals(), flown)


def reproduce(
    study: Literal["mae494", "winfield-tan"],
    *,
    output: PathLike | None = None,
    overwrite: bool = False,
    progress: Progress = False,
) -> Reply:
    """Reproduce a published study: each printed number beside the computed one.

    Args:
        study: the study.
        output: write the study into this folder too: a page (index.html), Markdown, and every plot
            as SVG with its data as CSV.
        overwrite: replace files that exist.
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("reproduce", locals(), as_reply)


def validate(
    *,
    output: PathLike | None = None,
    overwrite: bool = False,
    progress: Progress = False,
) -> Reply:
    """Compare every law of drag and lift with published drives: bias and mean absolute error of carry,
    apex and descent.

    Args:
        output: write the comparison too: into this folder as a page (index.html) and Markdown with
            pictures and their data, or, where the name ends in .csv, every law on every drive into
            this file.
        overwrite: replace files that exist.
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("validate", locals(), as_reply)


def verify(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    of: Names | None = None,
    wrt: Names | None = None,
    progress: Progress = False,
) -> Reply:
    """Compare every exact derivative with numerical differences, and check what both rest on; exit
    status 1 if a check fails.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        of: the outcomes, one or several; "all" for every one [default: carry,lateral].
        wrt: the parameters, one or several; "all" for every one that has a value in this setup
            [default: all].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("verify", locals(), as_reply)


def sensitivity(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    of: Names | None = None,
    sigma: Given | None = None,
    no_defaults: bool = False,
    at_optimum: bool = False,
    maximize: str | None = None,
    minimize: str | None = None,
    vary: Given | None = None,
    subject_to: Names | None = None,
    max_iterations: int | None = None,
    progress: Progress = False,
) -> Reply:
    """How outcomes depend on parameters: slopes, elasticities, and the effect of the uncertainty of
    each parameter.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        of: the outcomes, one or several; "all" for every one [default: carry].
        sigma: the standard uncertainty of a parameter, e.g. swing.speed=1mph or air.density=0.5% of
            its value.
        no_defaults: use no default uncertainties: only parameters with a sigma are uncertain.
        at_optimum: compute the slopes and effects at the optimum of a search, and show the slopes
            of the optimum beside those of the drive.
        maximize: the outcome to maximize [default: carry, unless minimize is given].
        minimize: the outcome to minimize.
        vary: a parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to
            20 deg and attack angle -5 to 5 deg].
        subject_to: a constraint on an outcome, e.g. "descent_angle >= 38 deg", "20 yd <=
            apex_height <= 35 yd" or "lateral == 0 m"; every limit with its unit. Over many swings
            also a relation with a name, linear in parameters, e.g. "budget: club.weight_1.mass +
            club.weight_2.mass <= 20 g".
        max_iterations: the largest number of iterations of a search [default: 500].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("sensitivity", locals(), as_reply)


def uncertainty(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    of: Names | None = None,
    sigma: Given | None = None,
    distribution: Given | None = None,
    samples: int | None = None,
    seed: int | None = None,
    progress: Progress = False,
) -> Reply:
    """Compute the uncertainty of outcomes from uncertain parameters: by exact derivatives, and by a
    sample of drives.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        of: the outcomes, one or several; "all" for every one. For carry and lateral together,
            landing ellipses are computed [default: carry,lateral].
        sigma: the standard deviation of a parameter that is normally distributed about its value,
            e.g. swing.speed=1mph or air.density=0.5% of its value. [default, without distribution:
            the uncertainties that "sensitivity" uses].
        distribution: the distribution of a parameter: NAME=normal(MEAN,DEVIATION),
            NAME=uniform(LOW,HIGH), NAME=triangular(LOW,MODE,HIGH) or
            NAME=truncated(MEAN,DEVIATION,LOW,HIGH).
        samples: the number of points N of the sample; with k uncertain parameters, N (k + 2) drives
            are computed [default: 4096].
        seed: the seed of the sample; the same seed gives the same sample [default: 0].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("uncertainty", locals(), as_reply)


def laws(
    *,
    progress: Progress = False,
) -> Reply:
    """List the laws of drag and lift: authors, formula, ball, source, and what each was fitted to.

    Args:
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("laws", locals(), as_reply)
