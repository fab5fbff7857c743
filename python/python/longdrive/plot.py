"""Plots, as pictures for notebooks and files: a function for each kind.

Each of them raises :class:`longdrive.InputError` for bad input, with the program's message, :class:`longdrive.NoAnswerError` for a sound question
without an answer, and :class:`longdrive.Interrupted` after Ctrl-C, with what was found so far. ``progress`` is True for a bar, or a function that is
called with how many parts of how many are done: 0 of 0 while the parts cannot be counted.

Written by make_commands.py from what the program says of its commands; change it there.
"""

from __future__ import annotations

from typing import Literal

from ._ask import ask
from .picture import Picture, picture
from .progress import Progress
from .types import Amount, Given, Goals, Names, PathLike, SetupLike, TableLike

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
    progress: Progress = False,
) -> Picture:
    """The path of the ball.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        output: the file to write: .svg or .png for a picture, .csv for its data (SI units and
            radians).
        overwrite: replace files that exist.
        dark: draw for a dark background.
        width: the width of the picture in pixels; a PNG has twice the resolution. The size of the
            text does not change [default: 480].
        view: the side from which the trajectory is shown [default: side].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("plot trajectory", locals(), picture)


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
    progress: Progress = False,
) -> Picture:
    """An outcome over two parameters, with its gradients and the optimum.

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
        output: the file to write: .svg or .png for a picture, .csv for its data (SI units and
            radians).
        overwrite: replace files that exist.
        dark: draw for a dark background.
        width: the width of the picture in pixels; a PNG has twice the resolution. The size of the
            text does not change [default: 480].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("plot contour", locals(), picture)


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
    progress: Progress = False,
) -> Picture:
    """The optimum as a function of a parameter.

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
        output: the file to write: .svg or .png for a picture, .csv for its data (SI units and
            radians).
        overwrite: replace files that exist.
        dark: draw for a dark background.
        width: the width of the picture in pixels; a PNG has twice the resolution. The size of the
            text does not change [default: 480].
        along: the parameter to follow the optimum along, with its range, e.g.
            swing.speed=80mph..130mph.
        show: the curve to draw: the outcome, or one of the parameters varied.
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("plot chart", locals(), picture)


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
    progress: Progress = False,
) -> Picture:
    """The best compromises between two goals, with their ends, the knee and the slope there.

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
        output: the file to write: .svg or .png for a picture, .csv for its data (SI units and
            radians).
        overwrite: replace files that exist.
        dark: draw for a dark background.
        width: the width of the picture in pixels; a PNG has twice the resolution. The size of the
            text does not change [default: 480].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("plot pareto", locals(), picture)


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
    progress: Progress = False,
) -> Picture:
    """The effects of the uncertainties of parameters on an outcome.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        output: the file to write: .svg or .png for a picture, .csv for its data (SI units and
            radians).
        overwrite: replace files that exist.
        dark: draw for a dark background.
        width: the width of the picture in pixels; a PNG has twice the resolution. The size of the
            text does not change [default: 480].
        of: the outcome [default: carry].
        sigma: the standard uncertainty of a parameter, e.g. swing.speed=1mph or air.density=0.5%.
            Repeatable; other parameters have the default uncertainties of "longdrive sensitivity".
        show: the uncertainties to draw [default: control].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("plot tornado", locals(), picture)


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
    progress: Progress = False,
) -> Picture:
    """The difference between two drives, split into the parameters and launch conditions that differ.

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
        output: the file to write: .svg or .png for a picture, .csv for its data (SI units and
            radians).
        overwrite: replace files that exist.
        dark: draw for a dark background.
        width: the width of the picture in pixels; a PNG has twice the resolution. The size of the
            text does not change [default: 480].
        of: the outcome [default: carry].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("plot compare", locals(), picture)


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
    progress: Progress = False,
) -> Picture:
    """The error of central differences against exact derivatives, by step.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        output: the file to write: .svg or .png for a picture, .csv for its data (SI units and
            radians).
        overwrite: replace files that exist.
        dark: draw for a dark background.
        width: the width of the picture in pixels; a PNG has twice the resolution. The size of the
            text does not change [default: 480].
        of: the outcomes, one or several [default: carry].
        wrt: the parameters, one or several. Without: loft and attack angle, or the launch
            conditions where these are given.
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("plot vcurve", locals(), picture)


def laws(
    setup: SetupLike = None,
    *,
    launch: Given | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
    output: PathLike | None = None,
    overwrite: bool = False,
    dark: bool = False,
    width: int | None = None,
    laws: Names | None = None,
    show: Literal["cd", "cl"] | None = None,
    over: Literal["spin-ratio", "reynolds"] | None = None,
    reynolds: Amount | None = None,
    spin_ratio: Amount | None = None,
    progress: Progress = False,
) -> Picture:
    """Laws of drag and lift over the spin ratio or the Reynolds number, with measured points.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        output: the file to write: .svg or .png for a picture, .csv for its data (SI units and
            radians).
        overwrite: replace files that exist.
        dark: draw for a dark background.
        width: the width of the picture in pixels; a PNG has twice the resolution. The size of the
            text does not change [default: 480].
        laws: the laws, one or several; "table" for your own of set aero.table. Without: all of
            them.
        show: the coefficient to draw [default: cd].
        over: what to draw it over [default: spin-ratio].
        reynolds: the Reynolds number, over the spin ratio [default: 1.5e5].
        spin_ratio: the spin ratio, over the Reynolds number [default: 0.1].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("plot laws", locals(), picture)


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
    progress: Progress = False,
) -> Picture:
    """Where the drive and the best one land, from above at true scale, with the ellipses that hold
    half and 95 % of the landings.

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
        output: the file to write: .svg or .png for a picture, .csv for its data (SI units and
            radians).
        overwrite: replace files that exist.
        dark: draw for a dark background.
        width: the width of the picture in pixels; a PNG has twice the resolution. The size of the
            text does not change [default: 480].
        sigma: how much a parameter of the golfer varies from drive to drive, one standard
            deviation, e.g. swing.face_angle=2deg. Repeatable; other parameters of swing, strike and
            club have the default uncertainties of "longdrive sensitivity".
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("plot fairway", locals(), picture)


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
    progress: Progress = False,
) -> Picture:
    """The club face from the front: the strike, the sweet spot, rings of carry lost, and the side to
    which the spin axis tilts.

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset tour-average.
        launch: compute the flight of a ball with these launch conditions, as a launch monitor
            reports them: ball_speed, launch_angle, launch_direction, and backspin with sidespin or
            spin with spin_axis; e.g. ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm. They
            replace those of the setup file.
        tolerance: every length is within this length of its exact value, m or a text; without it 1
            um where many drives are flown, unless the setup gives flight.method or flight.step.
        own_step: integrate by flight.method and flight.step of the setup in every case.
        output: the file to write: .svg or .png for a picture, .csv for its data (SI units and
            radians).
        overwrite: replace files that exist.
        dark: draw for a dark background.
        width: the width of the picture in pixels; a PNG has twice the resolution. The size of the
            text does not change [default: 480].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("plot face", locals(), picture)


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
    progress: Progress = False,
) -> Picture:
    """Carry, lateral, ball speed and spin axis over the club face, of the drive as set up and of the
    best one, or of two designs.

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
        after: a preset or setup file of another design, drawn beside this one in place of the best
            one, e.g. best.toml of "longdrive optimize -o".
        output: the file to write: .svg or .png for a picture, .csv for its data (SI units and
            radians).
        overwrite: replace files that exist.
        dark: draw for a dark background.
        width: the width of the picture in pixels; a PNG has twice the resolution. The size of the
            text does not change [default: 480].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("plot strike", locals(), picture)


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
    progress: Progress = False,
) -> Picture:
    """Carry over launch angle and backspin at the drive's ball speed, with its launch and the best
    one.

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
        output: the file to write: .svg or .png for a picture, .csv for its data (SI units and
            radians).
        overwrite: replace files that exist.
        dark: draw for a dark background.
        width: the width of the picture in pixels; a PNG has twice the resolution. The size of the
            text does not change [default: 480].
        progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they
            cannot be counted.
    """
    return ask("plot launch", locals(), picture)
