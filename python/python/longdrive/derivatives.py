"""Exact derivatives of the outcomes of one drive."""

from __future__ import annotations

from os import PathLike
from typing import TYPE_CHECKING, Literal, NamedTuple

from . import _longdrive
from .arguments import (
    MOST_SCENARIOS,
    MOST_SEED,
    count_of,
    kind_of,
    one_name,
    switch_of,
    whole_characters,
)
from .errors import InputError, warn_of
from .quantities import tolerance_of
from .setups import CallSetup

if TYPE_CHECKING:
    from .types import Amount, Floats, Given, Names, Sense, SetupLike

__all__ = ["Gradient", "Hessian", "Jacobian", "gradient", "hessian", "jacobian", "objective"]


class Gradient(NamedTuple):
    """Value and gradient of an outcome, SI."""

    value: float
    gradient: Floats
    """Shape (parameters,)."""


class Jacobian(NamedTuple):
    """Values of outcomes and their derivatives, SI."""

    values: Floats
    """Shape (outcomes,)."""
    jacobian: Floats
    """Shape (outcomes, parameters)."""


class Hessian(NamedTuple):
    """Value, gradient and Hessian of an outcome, SI."""

    value: float
    gradient: Floats
    """Shape (parameters,)."""
    hessian: Floats
    """Shape (parameters, parameters), symmetric."""


def gradient(
    setup: SetupLike = None,
    of: str = "carry",
    wrt: Names | None = None,
    *,
    tolerance: Amount | None = None,
    own_step: bool = False,
) -> Gradient:
    """Value and exact gradient of an outcome.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset ``tour-average``.
    of : str
        The outcome.
    wrt : Names | None
        Parameters to differentiate by, a name or several; ``"all"`` for every one that can be
        varied in this setup, for an outcome of the flight without those of the roll-out. Without it
        loft and attack angle, or the ball speed, launch angle and backspin of a given launch.
    tolerance : Amount | None
        The largest error of a length, m or a text; without it 1 µm, unless the setup states its
        method or step.
    own_step : bool
        Keep ``flight.method`` and ``flight.step`` of the setup.

    Returns
    -------
    Gradient
        The value and the gradient.

    Raises
    ------
    InputError
        For an unknown name, or a value outside its range.
    NoAnswerError
        If the ball does not fly, or the derivative does not exist.

    Warns
    -----
    LongdriveWarning
        Of the setup, not of its drive: of its angles without a unit, and of values of the club that
        a given launch replaces.

    Examples
    --------
    In a vacuum the ball flies along a parabola, and carry is inversely proportional to gravity:

    >>> import longdrive
    >>> vacuum = longdrive.Setup({"preset": "mae494", "air.density": 0})
    >>> carry, slope = longdrive.gradient(vacuum, of="carry", wrt="gravity")
    >>> bool(abs(slope[0] + carry / vacuum["gravity"]) < 1e-11)
    True
    """
    of = one_name("of", of, "jacobian takes several")
    tolerance, own_step = tolerance_of(tolerance), switch_of("own_step", own_step)
    call = CallSetup.of(setup)
    call.refuse_idle()
    answer = Gradient(*_longdrive.gradient(call.setup, of, wrt, tolerance, own_step))
    warn_of(call.warnings_of_drive, answer)
    return answer


def jacobian(
    setup: SetupLike = None,
    of: Names = "carry",
    wrt: Names | None = None,
    *,
    tolerance: Amount | None = None,
    own_step: bool = False,
) -> Jacobian:
    """Values of several outcomes of one drive, and their exact Jacobian.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset ``tour-average``.
    of : Names
        Outcomes, a name or several; ``"all"`` for every one.
    wrt : Names | None
        As for :func:`gradient`.
    tolerance : Amount | None
        The largest error of a length, m or a text; without it 1 µm, unless the setup states its
        method or step.
    own_step : bool
        Keep ``flight.method`` and ``flight.step`` of the setup.

    Returns
    -------
    Jacobian
        The values and the Jacobian.

    Raises
    ------
    InputError
        As :func:`gradient`.
    NoAnswerError
        As :func:`gradient`.

    Warns
    -----
    LongdriveWarning
        As :func:`gradient`.

    Examples
    --------
    >>> import longdrive
    >>> wrt = ["club.loft", "swing.speed", "strike.toe"]
    >>> values, rows = longdrive.jacobian("tour-average", of=["carry", "lateral"], wrt=wrt)
    >>> values.shape, rows.shape
    ((2,), (2, 3))
    """
    tolerance, own_step = tolerance_of(tolerance), switch_of("own_step", own_step)
    call = CallSetup.of(setup)
    call.refuse_idle()
    answer = Jacobian(*_longdrive.jacobian(call.setup, of, wrt, tolerance, own_step))
    warn_of(call.warnings_of_drive, answer)
    return answer


def hessian(
    setup: SetupLike = None,
    of: str = "carry",
    wrt: Names | None = None,
    *,
    tolerance: Amount | None = None,
    own_step: bool = False,
) -> Hessian:
    """Value, exact gradient and exact Hessian of an outcome.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset ``tour-average``.
    of : str
        The outcome.
    wrt : Names | None
        As for :func:`gradient`.
    tolerance : Amount | None
        The largest error of a length, m or a text; without it 1 µm, unless the setup states its
        method or step.
    own_step : bool
        Keep ``flight.method`` and ``flight.step`` of the setup.

    Returns
    -------
    Hessian
        The value, the gradient and the Hessian.

    Raises
    ------
    InputError
        As :func:`gradient`.
    NoAnswerError
        As :func:`gradient`.

    Warns
    -----
    LongdriveWarning
        As :func:`gradient`.

    Examples
    --------
    >>> import longdrive
    >>> wrt = ["club.loft", "swing.speed"]
    >>> carry, slope, curvature = longdrive.hessian("tour-average", wrt=wrt)
    >>> bool((curvature == curvature.T).all())
    True
    """
    of = one_name("of", of, "batch with hessians=True takes several")
    tolerance, own_step = tolerance_of(tolerance), switch_of("own_step", own_step)
    call = CallSetup.of(setup)
    call.refuse_idle()
    answer = Hessian(*_longdrive.hessian(call.setup, of, wrt, tolerance, own_step))
    warn_of(call.warnings_of_drive, answer)
    return answer


def objective(
    setup: SetupLike = None,
    of: str = "carry",
    wrt: Names | None = None,
    sense: Sense | None = None,
    *,
    invalid: Literal["raise", "nan"] = "raise",
    swings: str | PathLike[str] | None = None,
    distribution: Given | None = None,
    correlation: Given | None = None,
    scenarios: int | None = None,
    seed: int | None = None,
    strokes: str | PathLike[str] | None = None,
    tolerance: Amount | None = None,
    own_step: bool = False,
) -> _longdrive.Objective:
    """An outcome, or a goal over swings, as a function for other optimizers.

    It has ``fun(x)``, ``jac(x)``, ``hess(x)``, ``fun_and_jac(x)``, ``x0``, ``bounds`` and
    ``names``. x has a value for each parameter, numbers in SI or quantities of pint. Results at one
    point are computed once. The last bit of a value may depend on whether derivatives are computed
    with it. Method and step are chosen once, for values around the values of the setup.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, a dict, or None for the preset ``tour-average``.
    of : str
        The outcome; over swings the goal, such as ``"mean(carry) - 0.5*std(lateral)"``.
    wrt : Names | None
        As for :func:`gradient`. Over swings the default is only the loft, as in :func:`optimize`,
        because the attack angle belongs to the golfer.
    sense : Sense | None
        ``"max"`` changes the sign of all results, because optimizers minimize; ``"min"`` and None
        keep it.
    invalid : Literal['raise', 'nan']
        The result at a point without a drive (no flight, a value outside its range): ``"raise"`` an
        exception, or ``"nan"``. SLSQP, COBYLA and COBYQA of SciPy step back from NaN; give other
        methods bounds within which every drive flies.
    swings : str | PathLike[str] | None
        A file of swings, as for :func:`optimize`: TOML with distributions and correlations, or a
        table of recorded swings.
    distribution : Given | None
        Distributions of parameters from swing to swing, as for :func:`optimize`: texts such as
        ``"swing.speed=normal(107mph,3mph)"``, or a dict.
    correlation : Given | None
        Correlations of these parameters, such as ``"swing.path,swing.face_angle=0.6"``.
    scenarios : int | None
        The number of swings of the distributions, as for :func:`optimize`.
    seed : int | None
        The seed of the swings.
    strokes : str | PathLike[str] | None
        A file with a table of expected strokes, as for :func:`optimize`, for a goal such as
        ``strokes(400yd)``.
    tolerance : Amount | None
        The largest error of a length, m or a text; without it 1 µm, unless the setup states its
        method or step.
    own_step : bool
        Keep ``flight.method`` and ``flight.step`` of the setup.

    Returns
    -------
    _longdrive.Objective
        The function.

    Raises
    ------
    InputError
        As :func:`gradient`, for unreadable swings, and for a parameter that the swings already
        give, also if a dict in place of a setup states it.

    Warns
    -----
    LongdriveWarning
        As :func:`gradient`.

    Examples
    --------
    >>> import longdrive
    >>> wrt = ["club.loft", "swing.attack_angle"]
    >>> carry = longdrive.objective("tour-average", "carry", wrt, sense="max")
    >>> abs(carry.fun(carry.x0) + longdrive.simulate("tour-average")["carry"]) < 1e-6
    True
    >>> carry.jac([0.18, 0.0]).shape
    (2,)

    Goals over swings are those of :func:`optimize`, over the same swings, with exact gradients and
    Hessians:

    >>> attack = "swing.attack_angle=uniform(0deg, 10deg)"
    >>> over = dict(wrt="club.loft", distribution=attack)
    >>> mean = longdrive.objective("mae494", "mean(carry)", **over)
    >>> of_sample = longdrive.objective("mae494", "mean(carry)", **over, scenarios=64)
    >>> abs(mean.fun([0.19]) - of_sample.fun([0.19])) < 0.1
    True
    """
    # imported here: `import longdrive` does not need it
    from .request import Request

    for name, file in (("swings", swings), ("strokes", strokes)):
        if not (file is None or isinstance(file, (str, PathLike))):
            advice = "" if name == "strokes" else "; distribution takes dicts of distributions"
            raise InputError(
                f"{name} is {kind_of(file)}; expected the name of a file, which an objective reads "
                "again where it is unpickled: write a table with "
                f"pandas.DataFrame(…).to_csv('{name}.csv', index=False), and give that name{advice}"
            )
    for name, text in (("sense", sense), ("invalid", invalid)):
        with whole_characters(name):
            str(text).encode()
    call = CallSetup.of(setup)
    request = Request("optimize", {"distribution": distribution, "correlation": correlation})
    found = _longdrive.Objective(
        call.setup,
        one_name("of", of, "jacobian takes several"),
        [wrt] if isinstance(wrt, str) else wrt,
        sense,
        invalid,
        swings,
        request.texts("distribution"),
        request.texts("correlation"),
        None if scenarios is None else count_of("scenarios", scenarios, 2, MOST_SCENARIOS),
        None if seed is None else count_of("seed", seed, most=MOST_SEED),
        strokes,
        tolerance_of(tolerance),
        switch_of("own_step", own_step),
        call.stated,
    )
    warn_of([*call.warnings_of_drive, *request.warnings], found)
    return found
