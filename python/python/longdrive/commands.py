"""The studies: a function for each command.

Written by make_commands.py; change it there.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from .optimum import Optimum, optimum
from .replies import (
    CalibrateReply,
    ChartReply,
    CompareReply,
    DeliveryReply,
    FlyReply,
    LawsReply,
    ParetoReply,
    ReportReply,
    ReproduceReply,
    SensitivityReply,
    UncertaintyReply,
    ValidateReply,
    VerifyReply,
)
from .reply import as_reply, with_rows
from .run_command import run_command

if TYPE_CHECKING:
    from .progress import Progress
    from .types import Amount, AngleUnit, Given, Goals, Names, PathLike, SetupLike, TableLike

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
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> CompareReply:
    """Compare two drives, with the cause of each difference.

    The outcomes of both, and the share of each parameter and launch condition in the difference.

    Parameters
    ----------
    setup : SetupLike
        The first drive, a in messages: a setup, the name of a preset, a dict, or None for the
        preset tour-average.
    other : SetupLike
        The second drive, b: a setup, the name of a preset, or a dict like {"club.loft": "11 deg"},
        which changes the first setup unless it names a preset. Without it launch_a or launch_b
        gives the difference.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    tolerance : Amount
        The largest error of a length, m or a text; without it 1 um where many drives are flown,
        unless the setup states flight.method or flight.step.
    own_step : bool
        Keep flight.method and flight.step of the setup.
    launch_a : Given
        The launch conditions of drive a, as in launch.
    launch_b : Given
        The launch conditions of drive b, as in launch.
    of : Names
        The outcomes whose difference is split, one or several; "all" for every outcome of a drive
        [default: carry].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    CompareReply
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> reply = longdrive.compare("tour-average", {"club.loft": "11 deg"}, of="carry")
    >>> reply.status
    'done'
    """
    return run_command("compare", locals(), as_reply(CompareReply))


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
    starts: int | None = None,
    checkpoint: PathLike | None = None,
    output: PathLike | None = None,
    overwrite: bool = False,
    swings: TableLike | None = None,
    distribution: Given | None = None,
    correlation: Given | None = None,
    scenarios: int | None = None,
    seed: int | None = None,
    strokes: TableLike | None = None,
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> Optimum:
    """Find the drive that carries farthest, or any best outcome.

    Finds the parameters that maximize or minimize an outcome: by default, the loft and attack angle
    of the longest carry.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset tour-average.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    tolerance : Amount
        The largest error of a length, m or a text; without it 1 um where many drives are flown,
        unless the setup states flight.method or flight.step.
    own_step : bool
        Keep flight.method and flight.step of the setup.
    maximize : str
        The outcome to maximize [default: carry, unless minimize is given].
    minimize : str
        The outcome to minimize.
    vary : Given
        A parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to 20 deg
        and attack angle -5 to 5 deg; a parameter that you set, e.g. with loft, stays fixed].
    subject_to : Names
        A constraint on an outcome, e.g. "descent_angle >= 38 deg", "20 yd <= apex_height <= 35 yd"
        or "lateral == 0 m". Every limit needs its unit. A search over many swings also takes a
        named linear relation of parameters, e.g. "budget: club.weight_1.mass + club.weight_2.mass
        <= 20 g".
    max_iterations : int
        The largest number of iterations of a search [default: 500].
    starts : int
        Search from this many starts, spread evenly over the ranges (the first is the setup's own),
        and list the local optima [default: 1].
    checkpoint : PathLike
        Save the search to this file after every iteration; if the file exists, continue from it.
    output : PathLike
        Write the setup at the optimum into this setup file.
    overwrite : bool
        Replace the file if it exists.
    swings : TableLike
        Search for the best over many swings: a TOML file with [distributions] and [[correlations]],
        or a table (CSV, Parquet, Arrow) of recorded swings, a column for each parameter. Goals are
        then written like "mean(carry)", "std(lateral)", "lowest(carry, 10%)", "within(lateral,
        15yd)" or "mean(carry) - 0.5*std(lateral)", and by default only the loft is varied.
    distribution : Given
        The distribution of a parameter from swing to swing: NAME=normal(MEAN,DEVIATION),
        NAME=uniform(LOW,HIGH), NAME=triangular(LOW,MODE,HIGH) or
        NAME=truncated(MEAN,DEVIATION,LOW,HIGH).
    correlation : Given
        The correlation of two parameters with distributions, e.g. swing.path,swing.face_angle=0.6.
    scenarios : int
        Take this many swings of the distributions, by a quasi-random sequence [default: quadrature
        for up to 3 distributions, else 512 swings; also 512 for lowest, highest and within].
    seed : int
        The seed of the swings; the same seed gives the same swings [default: 0].
    strokes : TableLike
        A CSV table with the columns "distance [yd]" (to the hole) and "strokes" (expected number to
        hole out). The goal "strokes(400yd)" is the expected number of strokes after the drive, on a
        hole of 400 yd, from the landing point (without run).
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Optimum
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> best = longdrive.optimize("tour-average", vary={"club.loft": ("4 deg", "20 deg")})
    >>> best.success, best.names
    (True, ['club.loft'])
    """
    return run_command("optimize", locals(), optimum)


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
    starts: int | None = None,
    checkpoint: PathLike | None = None,
    output: PathLike | None = None,
    overwrite: bool = False,
    wrt: Names | None = None,
    change: Given | None = None,
    loss: Amount | None = None,
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> Optimum:
    """Sensitivity of the optimum, and how flat it is.

    How the optimum depends on every other parameter, and the price of its bounds and constraints.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset tour-average.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    tolerance : Amount
        The largest error of a length, m or a text; without it 1 um where many drives are flown,
        unless the setup states flight.method or flight.step.
    own_step : bool
        Keep flight.method and flight.step of the setup.
    maximize : str
        The outcome to maximize [default: carry, unless minimize is given].
    minimize : str
        The outcome to minimize.
    vary : Given
        A parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to 20 deg
        and attack angle -5 to 5 deg; a parameter that you set, e.g. with loft, stays fixed].
    subject_to : Names
        A constraint on an outcome, e.g. "descent_angle >= 38 deg", "20 yd <= apex_height <= 35 yd"
        or "lateral == 0 m". Every limit needs its unit. A search over many swings also takes a
        named linear relation of parameters, e.g. "budget: club.weight_1.mass + club.weight_2.mass
        <= 20 g".
    max_iterations : int
        The largest number of iterations of a search [default: 500].
    starts : int
        Search from this many starts, spread evenly over the ranges (the first is the setup's own),
        and list the local optima [default: 1].
    checkpoint : PathLike
        Save the search to this file after every iteration; if the file exists, continue from it.
    output : PathLike
        Write the setup at the optimum into this setup file.
    overwrite : bool
        Replace the file if it exists.
    wrt : Names
        The parameters that the optimum depends on, one or several; "all" for every one that has a
        value in this setup and is not varied [default: all].
    change : Given
        A change of a parameter, e.g. swing.speed=+5mph or air.density=-20% of its value: its effect
        on the optimum is predicted, and compared with a new search.
    loss : Amount
        The allowed loss of the outcome, for the range in which each varied parameter may move
        [default: 1 yd for a distance, or 1 % of the carry if the carry is below 10 yd; 1 % of the
        outcome otherwise].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Optimum
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> vary = {"club.loft": ("4 deg", "20 deg")}
    >>> best = longdrive.optimum_sensitivity("mae494", vary=vary, wrt="swing.speed")
    >>> best.success
    True
    """
    return run_command("optimum-sensitivity", locals(), optimum)


def design(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    max_iterations: int | None = None,
    starts: int | None = None,
    checkpoint: PathLike | None = None,
    overwrite: bool = False,
    distribution: Given | None = None,
    correlation: Given | None = None,
    scenarios: int | None = None,
    seed: int | None = None,
    strokes: TableLike | None = None,
    rules: Literal["golf", "none"] | None = None,
    maximize: str | None = None,
    minimize: str | None = None,
    vary: Given | None = None,
    subject_to: Names | None = None,
    swings: TableLike | None = None,
    output: PathLike | None = None,
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> Optimum:
    """Design head and face under the Rules of Golf.

    For swings that vary: the best bulge, roll, loft, inertia or movable weights, with the price of
    each rule.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset modern-driver.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    tolerance : Amount
        The largest error of a length, m or a text; without it 1 um where many drives are flown,
        unless the setup states flight.method or flight.step.
    own_step : bool
        Keep flight.method and flight.step of the setup.
    max_iterations : int
        The largest number of iterations of a search [default: 500].
    starts : int
        Search from this many starts, spread evenly over the ranges (the first is the setup's own),
        and list the local optima [default: 1].
    checkpoint : PathLike
        Save the search to this file after every iteration; if the file exists, continue from it.
    overwrite : bool
        Replace the file if it exists.
    distribution : Given
        The distribution of a parameter from swing to swing: NAME=normal(MEAN,DEVIATION),
        NAME=uniform(LOW,HIGH), NAME=triangular(LOW,MODE,HIGH) or
        NAME=truncated(MEAN,DEVIATION,LOW,HIGH).
    correlation : Given
        The correlation of two parameters with distributions, e.g. swing.path,swing.face_angle=0.6.
    scenarios : int
        Take this many swings of the distributions, by a quasi-random sequence [default: quadrature
        for up to 3 distributions, else 512 swings; also 512 for lowest, highest and within].
    seed : int
        The seed of the swings; the same seed gives the same swings [default: 0].
    strokes : TableLike
        A CSV table with the columns "distance [yd]" (to the hole) and "strokes" (expected number to
        hole out). The goal "strokes(400yd)" is the expected number of strokes after the drive, on a
        hole of 400 yd, from the landing point (without run).
    rules : Literal["golf", "none"]
        The rules for the design: golf (moment of inertia, volume, spring effect, ball) or none
        [default: golf].
    maximize : str
        The goal to maximize, e.g. "mean(carry)" [default: "mean(carry) - 0.5*rms(lateral)", unless
        minimize is given].
    minimize : str
        The goal to minimize, e.g. "rms(lateral)".
    vary : Given
        A parameter of the head to vary, with its range, e.g. club.bulge_radius=200mm..600mm or
        club.weight_1.toe=-50mm..50mm. [default: bulge and roll 150 to 1000 mm, loft 6 to 16 deg; a
        parameter that you set stays fixed].
    subject_to : Names
        A limit of a goal or of the head, e.g. "std(lateral) <= 20yd" or "head_mass <= 205 g"; or a
        relation with a name, linear in parameters, e.g. "volume: 120 cm^3 + 80 cm^2*club.cg_depth
        <= 460 cm^3".
    swings : TableLike
        The swings to design for: a TOML file with [distributions] and [[correlations]], or a table
        (CSV, Parquet, Arrow) of recorded swings [default: a golfer whose drives were measured,
        about the setup's own swing].
    output : PathLike
        Write the setup with the best design into this setup file.
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Optimum
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> club = {"preset": "modern-driver"}
    >>> best = longdrive.design(
    ...     club, vary={"club.bulge_radius": ("250 mm", "400 mm")}, scenarios=8,
    ...     distribution={"strike.toe": ("normal", 0.0, 0.01)}, maximize="mean(carry)")
    >>> best.names
    ['club.bulge_radius']
    """
    return run_command("design", locals(), optimum)


def calibrate(
    data: TableLike,
    setup: SetupLike = None,
    *,
    fit: Given,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    only: Given | None = None,
    huber: bool = False,
    starts: int | None = None,
    folds: int | None = None,
    compare: Names | None = None,
    max_iterations: int | None = None,
    output: PathLike | None = None,
    plot: PathLike | None = None,
    overwrite: bool = False,
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> CalibrateReply:
    """Fit parameters to measured shots.

    Also finds their uncertainties, and the combinations of parameters that the data do not
    determine.

    Parameters
    ----------
    data : TableLike
        Measured shots as CSV, one row per shot; the head of each column names a parameter or an
        outcome and its unit, as in "carry [yd]"; see docs/calibration.md.
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset tour-average.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    tolerance : Amount
        The largest error of a length, m or a text; without it 1 um where many drives are flown,
        unless the setup states flight.method or flight.step.
    own_step : bool
        Keep flight.method and flight.step of the setup.
    only : Given
        Read only the rows with this text in a column, e.g. Club=Driver, in upper or lower case;
        several texts of one column are alternatives.
    fit : Given
        A parameter to fit, e.g. aero.cd0 or aero.cd0=0.1..0.4.
    huber : bool
        Use Huber's loss: an outlier has no more influence than a residual of 1.345 σ.
    starts : int
        Search from this many starts: the setup's own values, then points spread evenly over the
        fitted ranges. State these ranges: the default is the whole allowed range, in which few
        drives fly [default: 1].
    folds : int
        Cross-validate: fit K times, each time without a K-th of the rows, and show the prediction
        errors of the omitted rows [default: 0].
    compare : Names
        Show the cross-validation errors of another aerodynamic law too: with its published
        coefficients, and with all its coefficients fitted.
    max_iterations : int
        The largest number of iterations of a search [default: 200].
    output : PathLike
        Write the fitted setup into this file.
    plot : PathLike
        Write the report into this folder too: a page (index.html), Markdown, and plots of the
        residuals with their data.
    overwrite : bool
        Replace files that exist.
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    CalibrateReply
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> shots = {
    ...     "ball_speed [mph]": [165.0, 168.1, 162.0, 166.2],
    ...     "launch_angle [deg]": [11.2, 10.4, 11.5, 10.9],
    ...     "spin [rpm]": [2500.0, 2380.0, 2450.0, 2600.0],
    ...     "carry [yd]": [275.0, 281.0, 270.5, 277.0],
    ... }

    >>> fit = longdrive.calibrate(shots, "modern-driver", fit="aero.cd0")
    >>> list(fit.estimates)
    ['aero.cd0']
    """
    return run_command("calibrate", locals(), as_reply(CalibrateReply))


def delivery(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    ball_speed: Amount | None = None,
    launch_angle: Amount | None = None,
    launch_direction: Amount | None = None,
    spin: Amount | None = None,
    spin_axis: Amount | None = None,
    backspin: Amount | None = None,
    sidespin: Amount | None = None,
    shots: TableLike | None = None,
    only: Given | None = None,
    vary: Given | None = None,
    sigma: Given | None = None,
    output: PathLike | None = None,
    swings: PathLike | None = None,
    overwrite: bool = False,
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> DeliveryReply:
    """Find the swing and strike behind a measured launch.

    Also finds the combinations of parameters that the launch does not determine.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset tour-average.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    ball_speed : Amount
        The measured speed of the ball, e.g. 167mph.
    launch_angle : Amount
        The measured angle of the launch above horizontal, e.g. 10.9deg.
    launch_direction : Amount
        The measured direction of the launch, + right of the target line [default: not measured].
    spin : Amount
        The measured total spin, e.g. 2686rpm; spin_axis may be added.
    spin_axis : Amount
        The measured tilt of the spin axis, + for a ball that curves to the right [default: not
        measured].
    backspin : Amount
        The measured backspin, in place of spin; sidespin may be added.
    sidespin : Amount
        The measured sidespin, + for a ball that curves to the right [default: not measured].
    shots : TableLike
        Measured shots as CSV, one row per shot, as a launch monitor exports them or as calibrate
        reads them. Club values in a row count as measured too.
    only : Given
        Read only the rows with this text in a column, e.g. Club=Driver, in upper or lower case;
        several texts of one column are alternatives.
    vary : Given
        A parameter to find and its range, e.g. club.loft=4deg..20deg. [default: the speed, attack
        angle, shaft lean, path and face angle of the swing, and the impact point on the face].
    sigma : Given
        The prior standard uncertainty of a parameter about its value in the setup, e.g.
        swing.attack_angle=1deg. [default: for a club value that an option or a row gives, the error
        of a launch monitor; for others, the spread among golfers].
    output : PathLike
        Write the setup with the delivery into this file; for several shots, with the mean of the
        deliveries that explain their launches. If there is none, no file is written.
    swings : PathLike
        Write the swings that explain the shots into this file, for "longdrive optimize swings": a
        table with a row for each shot (.csv), or distributions with correlations, without the
        errors of the launch monitor (.toml).
    overwrite : bool
        Replace files that exist.
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    DeliveryReply
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> found = longdrive.delivery(ball_speed="150 mph", launch_angle="12 deg", spin="2600 rpm")
    >>> found.status
    'done'
    """
    return run_command("delivery", locals(), as_reply(DeliveryReply))


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
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> ChartReply:
    """The optimum along a parameter, such as club speed.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset tour-average.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    tolerance : Amount
        The largest error of a length, m or a text; without it 1 um where many drives are flown,
        unless the setup states flight.method or flight.step.
    own_step : bool
        Keep flight.method and flight.step of the setup.
    maximize : str
        The outcome to maximize [default: carry, unless minimize is given].
    minimize : str
        The outcome to minimize.
    vary : Given
        A parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to 20 deg
        and attack angle -5 to 5 deg; a parameter that you set, e.g. with loft, stays fixed].
    subject_to : Names
        A constraint on an outcome, e.g. "descent_angle >= 38 deg", "20 yd <= apex_height <= 35 yd"
        or "lateral == 0 m". Every limit needs its unit. A search over many swings also takes a
        named linear relation of parameters, e.g. "budget: club.weight_1.mass + club.weight_2.mass
        <= 20 g".
    max_iterations : int
        The largest number of iterations of a search [default: 500].
    along : Given
        The parameter along which optima are computed, with its range, e.g.
        swing.speed=80mph..130mph.
    at : Names
        The values of the parameter of along at which the optimum is computed, one or several, e.g.
        90mph,100mph,110mph; along then needs only the name [default: as many values as the curve
        needs].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    ChartReply
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> along = {"swing.speed": ("90 mph", "110 mph")}
    >>> chart = longdrive.chart(along=along, vary={"club.loft": ("4 deg", "20 deg")})
    >>> len(chart.points) > 2
    True
    """
    return run_command("chart", locals(), as_reply(ChartReply))


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
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> ParetoReply:
    """The best compromises between two goals.

    For example between carry and dispersion. Also computes their rate of exchange.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset tour-average.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    tolerance : Amount
        The largest error of a length, m or a text; without it 1 um where many drives are flown,
        unless the setup states flight.method or flight.step.
    own_step : bool
        Keep flight.method and flight.step of the setup.
    maximize : Goals
        A goal to maximize: an outcome, or over many swings a statistic of it, e.g. "mean(carry)".
        Give two goals in total, with maximize and minimize.
    minimize : Goals
        A goal to minimize, e.g. "std(lateral)".
    vary : Given
        A parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to 20 deg;
        for one drive also attack angle -5 to 5 deg; a parameter that you set, e.g. with loft, stays
        fixed].
    subject_to : Names
        A constraint on a goal, e.g. "apex_height <= 35 yd", or over many swings "mean(carry) >= 240
        yd". Every limit needs its unit.
    points : int
        The number of points, spread evenly along the front, with its ends. Points at the knee, and
        where a bound or constraint becomes active or inactive, are added [default: 15].
    max_iterations : int
        The largest number of iterations of a search [default: 500].
    swings : TableLike
        Search for the best over many swings: a TOML file with [distributions] and [[correlations]],
        or a table (CSV, Parquet, Arrow) of recorded swings, a column for each parameter. Goals are
        then written like "mean(carry)", "std(lateral)", "lowest(carry, 10%)", "within(lateral,
        15yd)" or "mean(carry) - 0.5*std(lateral)", and by default only the loft is varied.
    distribution : Given
        The distribution of a parameter from swing to swing: NAME=normal(MEAN,DEVIATION),
        NAME=uniform(LOW,HIGH), NAME=triangular(LOW,MODE,HIGH) or
        NAME=truncated(MEAN,DEVIATION,LOW,HIGH).
    correlation : Given
        The correlation of two parameters with distributions, e.g. swing.path,swing.face_angle=0.6.
    scenarios : int
        Take this many swings of the distributions, by a quasi-random sequence [default: quadrature
        for up to 3 distributions, else 512 swings; also 512 for lowest, highest and within].
    seed : int
        The seed of the swings; the same seed gives the same swings [default: 0].
    strokes : TableLike
        A CSV table with the columns "distance [yd]" (to the hole) and "strokes" (expected number to
        hole out). The goal "strokes(400yd)" is the expected number of strokes after the drive, on a
        hole of 400 yd, from the landing point (without run).
    output : PathLike
        Write all points into a .csv file (each column head names its unit), or the setup of one
        point, which at chooses, into a .toml file.
    at : Amount
        The point whose setup is written: its number in the table, or "knee", the point farthest
        from the straight line between the ends [default: knee].
    overwrite : bool
        Replace the file if it exists.
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    ParetoReply
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> front = longdrive.pareto(
    ...     "mae494", maximize="carry", minimize="spin", points=3,
    ...     vary={"club.loft": ("8 deg", "14 deg")})
    >>> len(front.points) >= 3
    True
    """
    return run_command("pareto", locals(), as_reply(ParetoReply))


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
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> Optimum:
    """The design that loses least, whichever model is true.

    Several models of impact and flight are compared. The loss of a design under a model is its
    difference from the best design for this model.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset tour-average.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    tolerance : Amount
        The largest error of a length, m or a text; without it 1 um where many drives are flown,
        unless the setup states flight.method or flight.step.
    own_step : bool
        Keep flight.method and flight.step of the setup.
    maximize : str
        The outcome to maximize [default: carry, unless minimize is given].
    minimize : str
        The outcome to minimize.
    vary : Given
        A parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to 20 deg
        and attack angle -5 to 5 deg; a parameter that you set, e.g. with loft, stays fixed].
    subject_to : Names
        A constraint on an outcome, e.g. "descent_angle >= 38 deg", "20 yd <= apex_height <= 35 yd"
        or "lateral == 0 m". Every limit needs its unit. A search over many swings also takes a
        named linear relation of parameters, e.g. "budget: club.weight_1.mass + club.weight_2.mass
        <= 20 g".
    max_iterations : int
        The largest number of iterations of a search [default: 500].
    swings : TableLike
        Search for the best over many swings: a TOML file with [distributions] and [[correlations]],
        or a table (CSV, Parquet, Arrow) of recorded swings, a column for each parameter. Goals are
        then written like "mean(carry)", "std(lateral)", "lowest(carry, 10%)", "within(lateral,
        15yd)" or "mean(carry) - 0.5*std(lateral)", and by default only the loft is varied.
    distribution : Given
        The distribution of a parameter from swing to swing: NAME=normal(MEAN,DEVIATION),
        NAME=uniform(LOW,HIGH), NAME=triangular(LOW,MODE,HIGH) or
        NAME=truncated(MEAN,DEVIATION,LOW,HIGH).
    correlation : Given
        The correlation of two parameters with distributions, e.g. swing.path,swing.face_angle=0.6.
    scenarios : int
        Take this many swings of the distributions, by a quasi-random sequence [default: quadrature
        for up to 3 distributions, else 512 swings; also 512 for lowest, highest and within].
    seed : int
        The seed of the swings; the same seed gives the same swings [default: 0].
    strokes : TableLike
        A CSV table with the columns "distance [yd]" (to the hole) and "strokes" (expected number to
        hole out). The goal "strokes(400yd)" is the expected number of strokes after the drive, on a
        hole of 400 yd, from the landing point (without run).
    starts : int
        Make each search from this many starts, spread evenly over the ranges (the first is the
        setup's own) [default: 1].
    model : Given
        A model in addition to the setup itself: changes of the setup, e.g. "aero.law=ferguson" or
        "impact.friction=0.3,impact.gear_scale=0.5". [default: the laws launch-monitor and ferguson,
        and gear effects of 0.5 and 1, each as its own model].
    within : Amount
        Report whether the robust design is within this amount of the best design of every model
        [default: 1 yd for a distance].
    output : PathLike
        Write the setup with the robust design into this setup file.
    overwrite : bool
        Replace the file if it exists.
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Optimum
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> best = longdrive.robust(
    ...     model=["aero.law=smits-smith"], vary={"club.loft": ("4 deg", "20 deg")})
    >>> best.names
    ['club.loft']
    """
    return run_command("robust", locals(), optimum)


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
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> ReportReply:
    """Write a page: drive, optimum, map, sensitivities.

    An HTML page of the drive, the optimum, a map around it, sensitivities and uncertainties, with
    plots and data.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset tour-average.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    tolerance : Amount
        The largest error of a length, m or a text; without it 1 um where many drives are flown,
        unless the setup states flight.method or flight.step.
    own_step : bool
        Keep flight.method and flight.step of the setup.
    maximize : str
        The outcome to maximize [default: carry, unless minimize is given].
    minimize : str
        The outcome to minimize.
    vary : Given
        A parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to 20 deg
        and attack angle -5 to 5 deg; a parameter that you set, e.g. with loft, stays fixed].
    subject_to : Names
        A constraint on an outcome, e.g. "descent_angle >= 38 deg", "20 yd <= apex_height <= 35 yd"
        or "lateral == 0 m". Every limit needs its unit. A search over many swings also takes a
        named linear relation of parameters, e.g. "budget: club.weight_1.mass + club.weight_2.mass
        <= 20 g".
    max_iterations : int
        The largest number of iterations of a search [default: 500].
    output : PathLike
        The folder to write: index.html, the best drive as setup.toml, and each plot as
        NAME-metric.svg, NAME-us.svg and NAME.csv. The folder is created if it does not exist; other
        files in it are not touched.
    overwrite : bool
        Replace files that exist.
    sigma : Given
        The standard uncertainty of a parameter, e.g. swing.speed=1mph or air.density=0.5%.
        Repeatable; other parameters have the default uncertainties of "longdrive sensitivity".
    along : Given
        The parameter along which optima are computed, with its range [default:
        swing.speed=80mph..130mph; with launch, launch.ball_speed=120mph..190mph; around the drive's
        own speed if that is outside of these ranges].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    ReportReply
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     longdrive.report("mae494", output=folder).status
    'done'
    """
    return run_command("report", locals(), as_reply(ReportReply))


def fly(
    shots: TableLike,
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    only: Given | None = None,
    of: Names | None = None,
    output: PathLike | None = None,
    format: Literal["csv", "launch-monitor", "jsonl", "open-connect", "parquet"] | None = None,
    overwrite: bool = False,
    threads: int | None = None,
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> FlyReply:
    """Fly the shots of a launch monitor.

    Reads a CSV export or messages of GSPro Open Connect, and compares predicted with measured
    flights.

    Parameters
    ----------
    shots : TableLike
        Shots, one per row: the CSV export of a launch monitor, any CSV with columns such as
        "ball_speed [mph]", "launch_angle [deg]" and "backspin [rpm]", or messages of GSPro Open
        Connect as JSON (one per line, or an array); "-" is standard input. See
        docs/launch-monitors.md.
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset tour-average.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    tolerance : Amount
        The largest error of a length, m or a text; without it 1 um where many drives are flown,
        unless the setup states flight.method or flight.step.
    own_step : bool
        Keep flight.method and flight.step of the setup.
    only : Given
        Read only the rows with this text in a column, e.g. Club=Driver, in upper or lower case;
        several texts of one column are alternatives.
    of : Names
        The outcomes of the flight to predict, one or several; "all" for every one [default:
        carry_distance,lateral,apex_height,flight_time,descent_angle,total].
    output : PathLike
        The file for the rows; its extension selects the format (.csv, .jsonl, .parquet; .json for
        Open Connect). "-" is standard output. With json and without a file only the summary is
        printed.
    format : Literal["csv", "launch-monitor", "jsonl", "open-connect", "parquet"]
        The format, whatever the extension of the file [default for standard output: csv].
    overwrite : bool
        Replace the file if it exists.
    threads : int
        The number of threads (0: one per processor). The results do not depend on it [default: 0].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    FlyReply
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> shots = {
    ...     "ball_speed [mph]": [165.0, 168.1, 162.0, 166.2],
    ...     "launch_angle [deg]": [11.2, 10.4, 11.5, 10.9],
    ...     "spin [rpm]": [2500.0, 2380.0, 2450.0, 2600.0],
    ...     "carry [yd]": [275.0, 281.0, 270.5, 277.0],
    ... }

    >>> flown = longdrive.fly(shots)
    >>> len(flown.shots)
    4
    """
    return run_command("fly", locals(), with_rows(FlyReply))


def reproduce(
    study: Literal["mae494", "winfield-tan"],
    *,
    output: PathLike | None = None,
    overwrite: bool = False,
    progress: Progress = False,
) -> ReproduceReply:
    """Reproduce a published study, number by number.

    Parameters
    ----------
    study : Literal["mae494", "winfield-tan"]
        The study.
    output : PathLike
        Write the study into this folder too: a page (index.html), Markdown, and every plot as SVG
        with its data as CSV.
    overwrite : bool
        Replace files that exist.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    ReproduceReply
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> longdrive.reproduce("mae494").status  # doctest: +SKIP
    'done'
    """
    return run_command("reproduce", locals(), as_reply(ReproduceReply))


def validate(
    *,
    output: PathLike | None = None,
    overwrite: bool = False,
    progress: Progress = False,
) -> ValidateReply:
    """Compare every law of flight with published drives.

    Bias and mean absolute error of carry, apex and descent.

    Parameters
    ----------
    output : PathLike
        Write the comparison to this folder: a page (index.html), and Markdown with pictures and
        their data. With a name that ends in .csv, write a table with a row for every law and drive.
    overwrite : bool
        Replace files that exist.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    ValidateReply
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> longdrive.validate().status  # doctest: +SKIP
    'done'
    """
    return run_command("validate", locals(), as_reply(ValidateReply))


def verify(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    of: Names | None = None,
    wrt: Names | None = None,
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> VerifyReply:
    """Check every derivative against finite differences.

    Also checks smoothness, convergence and the landing; exit status 1 if a check fails.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset tour-average.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    tolerance : Amount
        The largest error of a length, m or a text; without it 1 um where many drives are flown,
        unless the setup states flight.method or flight.step.
    own_step : bool
        Keep flight.method and flight.step of the setup.
    of : Names
        The outcomes, one or several; "all" for every one [default: carry,lateral].
    wrt : Names
        The parameters, one or several; "all" for every one that has a value in this setup [default:
        all].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    VerifyReply
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> longdrive.verify("tour-average", of="carry", wrt="club.loft").status
    'passed'
    """
    return run_command("verify", locals(), as_reply(VerifyReply))


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
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> SensitivityReply:
    """Effect of each parameter on the outcomes.

    Slopes, elasticities, and the effect of the uncertainty of each parameter.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset tour-average.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    tolerance : Amount
        The largest error of a length, m or a text; without it 1 um where many drives are flown,
        unless the setup states flight.method or flight.step.
    own_step : bool
        Keep flight.method and flight.step of the setup.
    of : Names
        The outcomes, one or several; "all" for every one [default: carry].
    sigma : Given
        The standard uncertainty of a parameter, as an amount (swing.speed=1mph) or as a percentage
        of its value (air.density=0.5%).
    no_defaults : bool
        Use no default uncertainties: only parameters with a sigma are uncertain.
    at_optimum : bool
        Compute the slopes and effects at the optimum of a search, and show the total derivatives of
        the optimum too.
    maximize : str
        The outcome to maximize [default: carry, unless minimize is given].
    minimize : str
        The outcome to minimize.
    vary : Given
        A parameter to vary, with its range, e.g. club.loft=4deg..20deg. [default: loft 4 to 20 deg
        and attack angle -5 to 5 deg; a parameter that you set, e.g. with loft, stays fixed].
    subject_to : Names
        A constraint on an outcome, e.g. "descent_angle >= 38 deg", "20 yd <= apex_height <= 35 yd"
        or "lateral == 0 m". Every limit needs its unit. A search over many swings also takes a
        named linear relation of parameters, e.g. "budget: club.weight_1.mass + club.weight_2.mass
        <= 20 g".
    max_iterations : int
        The largest number of iterations of a search [default: 500].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    SensitivityReply
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> reply = longdrive.sensitivity("tour-average", of="carry")
    >>> reply.outcomes[0]["of"]
    'carry'
    """
    return run_command("sensitivity", locals(), as_reply(SensitivityReply))


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
    angles: AngleUnit = "rad",
    progress: Progress = False,
) -> UncertaintyReply:
    """Spread of the outcomes from uncertain parameters.

    By exact derivatives, and by a sample of drives.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset tour-average.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    tolerance : Amount
        The largest error of a length, m or a text; without it 1 um where many drives are flown,
        unless the setup states flight.method or flight.step.
    own_step : bool
        Keep flight.method and flight.step of the setup.
    of : Names
        The outcomes, one or several; "all" for every one. For carry and lateral together, landing
        ellipses are computed [default: carry,lateral].
    sigma : Given
        The standard deviation of a parameter that is normally distributed about its value, e.g.
        swing.speed=1mph or air.density=0.5% of its value. Unlike in "sensitivity", only the
        parameters of sigma and distribution are then uncertain [default, without both: the
        uncertainties that "sensitivity" uses].
    distribution : Given
        The distribution of a parameter: NAME=normal(MEAN,DEVIATION), NAME=uniform(LOW,HIGH),
        NAME=triangular(LOW,MODE,HIGH) or NAME=truncated(MEAN,DEVIATION,LOW,HIGH).
    samples : int
        The number of points N of the sample; with k uncertain parameters, N (k + 2) drives are
        computed [default: 4096].
    seed : int
        The seed of the sample; the same seed gives the same sample [default: 0].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    UncertaintyReply
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> sigma = {"swing.speed": "1 mph"}
    >>> reply = longdrive.uncertainty("tour-average", of="carry", sigma=sigma, samples=64)
    >>> reply.status
    'done'
    """
    return run_command("uncertainty", locals(), as_reply(UncertaintyReply))


def laws(
    *,
    progress: Progress = False,
) -> LawsReply:
    """List the laws of drag and lift.

    Authors, formula, ball, source, and fitted range of each law.

    Parameters
    ----------
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    LawsReply
        The answer.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.

    Examples
    --------
    >>> import longdrive
    >>> any(law["name"] == "smits-smith" for law in longdrive.laws().laws)
    True
    """
    return run_command("laws", locals(), as_reply(LawsReply))
