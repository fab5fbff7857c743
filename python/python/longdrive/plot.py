"""Plots, as pictures: a function for each kind.

Written by make_commands.py; change it there.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

from .picture import Picture, picture
from .run_command import run_command

if TYPE_CHECKING:
    from .progress import Progress
    from .types import Amount, AngleUnit, Given, Goals, Names, PathLike, SetupLike, TableLike

__all__ = [
    "chart",
    "compare",
    "contour",
    "face",
    "fairway",
    "launch",
    "laws",
    "pareto",
    "strike",
    "tornado",
    "trajectory",
    "vcurve",
]


def trajectory(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    output: PathLike | None = None,
    overwrite: bool = False,
    dark: bool = False,
    width: int | None = None,
    view: Literal["side", "top"] | None = None,
    angles: AngleUnit = "rad",
    ax: Any = None,
    progress: Progress = False,
) -> Picture:
    """The path of the ball.

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
    output : PathLike
        The file to write: .svg or .png for a picture, .csv for its data (each column head names its
        unit).
    overwrite : bool
        Replace files that exist.
    dark : bool
        Draw for a dark background.
    width : int
        The width of the picture in pixels; a PNG has twice the resolution. The size of the text
        does not change [default: 480].
    view : Literal["side", "top"]
        The side from which the trajectory is shown [default: side].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    ax : matplotlib.axes.Axes
        Axes in which the plot is drawn, in SI units and radians; the answer then has its data.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Picture
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
    >>> longdrive.plot.trajectory("tour-average", width=640).form
    '.svg'
    """
    return run_command("plot trajectory", locals(), picture)


def contour(
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
    output: PathLike | None = None,
    overwrite: bool = False,
    dark: bool = False,
    width: int | None = None,
    angles: AngleUnit = "rad",
    ax: Any = None,
    progress: Progress = False,
) -> Picture:
    """An outcome over two parameters, with its gradients and the optimum.

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
        The file to write: .svg or .png for a picture, .csv for its data (each column head names its
        unit).
    overwrite : bool
        Replace files that exist.
    dark : bool
        Draw for a dark background.
    width : int
        The width of the picture in pixels; a PNG has twice the resolution. The size of the text
        does not change [default: 480].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    ax : matplotlib.axes.Axes
        Axes in which the plot is drawn, in SI units and radians; the answer then has its data.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Picture
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
    >>> longdrive.plot.contour("mae494").title
    'Carry over club loft and attack angle'
    """
    return run_command("plot contour", locals(), picture)


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
    output: PathLike | None = None,
    overwrite: bool = False,
    dark: bool = False,
    width: int | None = None,
    show: str | None = None,
    angles: AngleUnit = "rad",
    ax: Any = None,
    progress: Progress = False,
) -> Picture:
    """The optimum as a function of a parameter.

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
        The file to write: .svg or .png for a picture, .csv for its data (each column head names its
        unit).
    overwrite : bool
        Replace files that exist.
    dark : bool
        Draw for a dark background.
    width : int
        The width of the picture in pixels; a PNG has twice the resolution. The size of the text
        does not change [default: 480].
    along : Given
        The parameter along which optima are computed, with its range, e.g.
        swing.speed=80mph..130mph.
    show : str
        The curve to draw: the outcome, or one of the parameters varied.
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    ax : matplotlib.axes.Axes
        Axes in which the plot is drawn, in SI units and radians; the answer then has its data.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Picture
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
    >>> along = {"swing.speed": ("90 mph", "100 mph")}
    >>> longdrive.plot.chart("mae494", along=along).form
    '.svg'
    """
    return run_command("plot chart", locals(), picture)


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
    overwrite: bool = False,
    dark: bool = False,
    width: int | None = None,
    angles: AngleUnit = "rad",
    ax: Any = None,
    progress: Progress = False,
) -> Picture:
    """The Pareto front of two goals, with its ends, its knee and the slope at the knee.

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
        The file to write: .svg or .png for a picture, .csv for its data (each column head names its
        unit).
    overwrite : bool
        Replace files that exist.
    dark : bool
        Draw for a dark background.
    width : int
        The width of the picture in pixels; a PNG has twice the resolution. The size of the text
        does not change [default: 480].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    ax : matplotlib.axes.Axes
        Axes in which the plot is drawn, in SI units and radians; the answer then has its data.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Picture
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
    >>> longdrive.plot.pareto("mae494", maximize="carry", minimize="spin", points=3).form
    '.svg'
    """
    return run_command("plot pareto", locals(), picture)


def tornado(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    output: PathLike | None = None,
    overwrite: bool = False,
    dark: bool = False,
    width: int | None = None,
    of: str | None = None,
    sigma: Given | None = None,
    show: Literal["control", "model", "all"] | None = None,
    angles: AngleUnit = "rad",
    ax: Any = None,
    progress: Progress = False,
) -> Picture:
    """The effects of the uncertainties of parameters on an outcome.

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
    output : PathLike
        The file to write: .svg or .png for a picture, .csv for its data (each column head names its
        unit).
    overwrite : bool
        Replace files that exist.
    dark : bool
        Draw for a dark background.
    width : int
        The width of the picture in pixels; a PNG has twice the resolution. The size of the text
        does not change [default: 480].
    of : str
        The outcome [default: carry].
    sigma : Given
        The standard uncertainty of a parameter, e.g. swing.speed=1mph or air.density=0.5%.
        Repeatable; other parameters have the default uncertainties of "longdrive sensitivity".
    show : Literal["control", "model", "all"]
        The uncertainties to draw [default: control].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    ax : matplotlib.axes.Axes
        Axes in which the plot is drawn, in SI units and radians; the answer then has its data.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Picture
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
    >>> longdrive.plot.tornado("tour-average", of="carry").form
    '.svg'
    """
    return run_command("plot tornado", locals(), picture)


def compare(
    setup: SetupLike = None,
    other: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    launch_a: Given | None = None,
    launch_b: Given | None = None,
    output: PathLike | None = None,
    overwrite: bool = False,
    dark: bool = False,
    width: int | None = None,
    of: str | None = None,
    angles: AngleUnit = "rad",
    ax: Any = None,
    progress: Progress = False,
) -> Picture:
    """The difference between two drives, split into the parameters and launch conditions that
    differ.

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
    output : PathLike
        The file to write: .svg or .png for a picture, .csv for its data (each column head names its
        unit).
    overwrite : bool
        Replace files that exist.
    dark : bool
        Draw for a dark background.
    width : int
        The width of the picture in pixels; a PNG has twice the resolution. The size of the text
        does not change [default: 480].
    of : str
        The outcome [default: carry].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    ax : matplotlib.axes.Axes
        Axes in which the plot is drawn, in SI units and radians; the answer then has its data.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Picture
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
    >>> longdrive.plot.compare("tour-average", other={"club.loft": "11 deg"}).form
    '.svg'
    """
    return run_command("plot compare", locals(), picture)


def vcurve(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    output: PathLike | None = None,
    overwrite: bool = False,
    dark: bool = False,
    width: int | None = None,
    of: Names | None = None,
    wrt: Names | None = None,
    angles: AngleUnit = "rad",
    ax: Any = None,
    progress: Progress = False,
) -> Picture:
    """The error of central differences against exact derivatives, by step.

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
    output : PathLike
        The file to write: .svg or .png for a picture, .csv for its data (each column head names its
        unit).
    overwrite : bool
        Replace files that exist.
    dark : bool
        Draw for a dark background.
    width : int
        The width of the picture in pixels; a PNG has twice the resolution. The size of the text
        does not change [default: 480].
    of : Names
        The outcomes, one or several [default: carry].
    wrt : Names
        The parameters, one or several; "all" for every one that has a value in this setup. By
        default: loft and attack angle, or the launch conditions if they are given.
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    ax : matplotlib.axes.Axes
        Axes in which the plot is drawn, in SI units and radians; the answer then has its data.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Picture
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
    >>> longdrive.plot.vcurve("tour-average", of="carry").form
    '.svg'
    """
    return run_command("plot vcurve", locals(), picture)


def laws(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    output: PathLike | None = None,
    overwrite: bool = False,
    dark: bool = False,
    width: int | None = None,
    laws: Names | None = None,
    show: Literal["cd", "cl"] | None = None,
    over: Literal["spin-ratio", "reynolds"] | None = None,
    reynolds: Amount | None = None,
    spin_ratio: Amount | None = None,
    angles: AngleUnit = "rad",
    ax: Any = None,
    progress: Progress = False,
) -> Picture:
    """Laws of drag and lift over the spin ratio or the Reynolds number, with measured points.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset tour-average.
    launch : Given
        Compute the flight of a ball with these launch conditions, as a launch monitor reports them:
        ball_speed, launch_angle, launch_direction, and backspin with sidespin or spin with
        spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They replace those
        of the setup file.
    output : PathLike
        The file to write: .svg or .png for a picture, .csv for its data (each column head names its
        unit).
    overwrite : bool
        Replace files that exist.
    dark : bool
        Draw for a dark background.
    width : int
        The width of the picture in pixels; a PNG has twice the resolution. The size of the text
        does not change [default: 480].
    laws : Names
        The laws, one or several; "table" for your own table of set aero.table [default: all laws].
    show : Literal["cd", "cl"]
        The coefficient to draw [default: cd].
    over : Literal["spin-ratio", "reynolds"]
        The horizontal axis [default: spin-ratio].
    reynolds : Amount
        The constant Reynolds number of a plot over the spin ratio [default: 1.5e5].
    spin_ratio : Amount
        The constant spin ratio of a plot over the Reynolds number [default: 0.1].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    ax : matplotlib.axes.Axes
        Axes in which the plot is drawn, in SI units and radians; the answer then has its data.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Picture
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
    >>> longdrive.plot.laws().form
    '.svg'
    """
    return run_command("plot laws", locals(), picture)


def fairway(
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
    output: PathLike | None = None,
    overwrite: bool = False,
    dark: bool = False,
    width: int | None = None,
    sigma: Given | None = None,
    angles: AngleUnit = "rad",
    ax: Any = None,
    progress: Progress = False,
) -> Picture:
    """The landings of the drive and of the optimum from above, at true scale, with the ellipses of
    half and of 95 % of the landings.

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
        The file to write: .svg or .png for a picture, .csv for its data (each column head names its
        unit).
    overwrite : bool
        Replace files that exist.
    dark : bool
        Draw for a dark background.
    width : int
        The width of the picture in pixels; a PNG has twice the resolution. The size of the text
        does not change [default: 480].
    sigma : Given
        The standard deviation of a parameter of the golfer from drive to drive, e.g.
        swing.face_angle=2deg. Repeatable; other parameters of swing, strike and club have the
        default uncertainties of "longdrive sensitivity".
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    ax : matplotlib.axes.Axes
        Axes in which the plot is drawn, in SI units and radians; the answer then has its data.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Picture
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
    >>> longdrive.plot.fairway("tour-average", sigma={"swing.path": "1 deg"}).form
    '.svg'
    """
    return run_command("plot fairway", locals(), picture)


def face(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    output: PathLike | None = None,
    overwrite: bool = False,
    dark: bool = False,
    width: int | None = None,
    angles: AngleUnit = "rad",
    ax: Any = None,
    progress: Progress = False,
) -> Picture:
    """The club face from the front: the strike, the sweet spot, contours of lost carry, and the
    side to which the spin axis tilts.

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
    output : PathLike
        The file to write: .svg or .png for a picture, .csv for its data (each column head names its
        unit).
    overwrite : bool
        Replace files that exist.
    dark : bool
        Draw for a dark background.
    width : int
        The width of the picture in pixels; a PNG has twice the resolution. The size of the text
        does not change [default: 480].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    ax : matplotlib.axes.Axes
        Axes in which the plot is drawn, in SI units and radians; the answer then has its data.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Picture
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
    >>> longdrive.plot.face("tour-average").form
    '.svg'
    """
    return run_command("plot face", locals(), picture)


def strike(
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
    after: SetupLike | None = None,
    output: PathLike | None = None,
    overwrite: bool = False,
    dark: bool = False,
    width: int | None = None,
    angles: AngleUnit = "rad",
    ax: Any = None,
    progress: Progress = False,
) -> Picture:
    """Carry, lateral, ball speed and spin axis over the club face, for the drive as set up and for
    the optimum, or for two designs.

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
    after : SetupLike
        A preset or setup file of another design to draw in place of the optimum, e.g. best.toml of
        "longdrive optimize -o".
    output : PathLike
        The file to write: .svg or .png for a picture, .csv for its data (each column head names its
        unit).
    overwrite : bool
        Replace files that exist.
    dark : bool
        Draw for a dark background.
    width : int
        The width of the picture in pixels; a PNG has twice the resolution. The size of the text
        does not change [default: 480].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    ax : matplotlib.axes.Axes
        Axes in which the plot is drawn, in SI units and radians; the answer then has its data.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Picture
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
    >>> longdrive.plot.strike("tour-average").form
    '.svg'
    """
    return run_command("plot strike", locals(), picture)


def launch(
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
    output: PathLike | None = None,
    overwrite: bool = False,
    dark: bool = False,
    width: int | None = None,
    angles: AngleUnit = "rad",
    ax: Any = None,
    progress: Progress = False,
) -> Picture:
    """Carry over launch angle and backspin at the drive's ball speed, with the launches of the
    drive and of the optimum.

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
        The file to write: .svg or .png for a picture, .csv for its data (each column head names its
        unit).
    overwrite : bool
        Replace files that exist.
    dark : bool
        Draw for a dark background.
    width : int
        The width of the picture in pixels; a PNG has twice the resolution. The size of the text
        does not change [default: 480].
    angles : {"rad", "deg"}
        The unit of angles without a unit.
    ax : matplotlib.axes.Axes
        Axes in which the plot is drawn, in SI units and radians; the answer then has its data.
    progress : bool or callable
        True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot be
        counted.

    Returns
    -------
    Picture
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
    >>> longdrive.plot.launch("tour-average").form
    '.svg'
    """
    return run_command("plot launch", locals(), picture)
