"""Exact derivatives of the outcomes of one drive."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from typing import Literal, NamedTuple

from . import _longdrive
from ._question import Question
from .arguments import MOST_SCENARIOS, MOST_SEED, count_of, kind_of, one_name, whole_characters
from .errors import InputError
from .types import Floats, Given, Names, Sense, SetupLike

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


def gradient(setup: SetupLike = None, of: str = "carry", wrt: Names | None = None) -> Gradient:
    """Value and exact gradient of an outcome.

    In a vacuum the ball flies along a parabola, and carry is in inverse proportion to gravity:

    >>> import longdrive
    >>> vacuum = longdrive.Setup({"preset": "mae494", "air.density": 0})
    >>> carry, slope = longdrive.gradient(vacuum, of="carry", wrt="gravity")
    >>> bool(abs(slope[0] + carry / vacuum["gravity"]) < 1e-11)
    True

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset ``tour-average``.
        of: the outcome.
        wrt: parameters to differentiate by, a name or several; ``"all"`` for every one that can be varied in this setup. Without it
            loft and attack angle.

    Raises:
        InputError: for a name that nothing bears, or a value outside its range.
        NoAnswerError: where the ball does not fly, or the derivative does not exist.
    """
    return Gradient(*_longdrive.gradient(setup, one_name("of", of, "jacobian takes several"), wrt))


def jacobian(setup: SetupLike = None, of: Names = "carry", wrt: Names | None = None) -> Jacobian:
    """Values of several outcomes of one drive, and their exact Jacobian.

    >>> import longdrive
    >>> values, rows = longdrive.jacobian("tour-average", of=["carry", "lateral"], wrt=["club.loft", "swing.speed", "strike.toe"])
    >>> values.shape, rows.shape
    ((2,), (2, 3))

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset ``tour-average``.
        of: outcomes, a name or several; ``"all"`` for every one.
        wrt: as for :func:`gradient`.

    Raises:
        InputError: as :func:`gradient`.
        NoAnswerError: as :func:`gradient`.
    """
    return Jacobian(*_longdrive.jacobian(setup, of, wrt))


def hessian(setup: SetupLike = None, of: str = "carry", wrt: Names | None = None) -> Hessian:
    """Value, exact gradient and exact Hessian of an outcome.

    >>> import longdrive
    >>> carry, slope, curvature = longdrive.hessian("tour-average", wrt=["club.loft", "swing.speed"])
    >>> bool((curvature == curvature.T).all())
    True

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset ``tour-average``.
        of: the outcome.
        wrt: as for :func:`gradient`.

    Raises:
        InputError: as :func:`gradient`.
        NoAnswerError: as :func:`gradient`.
    """
    return Hessian(
        *_longdrive.hessian(
            setup, one_name("of", of, "batch with hessians=True takes several"), wrt
        )
    )


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
) -> _longdrive.Objective:
    """An outcome as a function of some parameters, for optimizers that take functions; with ``swings`` or ``distribution`` a goal over swings.

    It has ``fun(x)``, ``jac(x)``, ``hess(x)`` and ``fun_and_jac(x)``, ``x0``, ``bounds`` and ``names``; x has a value for each parameter, numbers in SI or
    quantities of pint. What is asked of one point in turn is computed once. A value that is computed together with derivatives may differ in its
    last bit from one that is computed alone.

    >>> import longdrive
    >>> carry = longdrive.objective("tour-average", "carry", ["club.loft", "swing.attack_angle"], sense="max")
    >>> abs(carry.fun(carry.x0) + longdrive.simulate("tour-average")["carry"]) < 1e-9
    True
    >>> carry.jac([0.18, 0.0]).shape
    (2,)

    Goals over swings are those of :func:`optimize`, over the same swings, with exact gradients and Hessians:

    >>> attack = "swing.attack_angle=uniform(0deg, 10deg)"
    >>> mean = longdrive.objective("mae494", "mean(carry)", "club.loft", distribution=attack)
    >>> alone = longdrive.objective("mae494", "mean(carry)", "club.loft", distribution=attack, scenarios=64)
    >>> abs(mean.fun([0.19]) - alone.fun([0.19])) < 0.1
    True

    Args:
        setup: a setup, the name of a preset, a dict, or None for the preset ``tour-average``.
        of: the outcome; over swings the goal, as ``"mean(carry) - 0.5*std(lateral)"``.
        wrt: as for :func:`gradient`; over swings without it the loft alone, as :func:`optimize` varies it: the attack angle is the golfer's.
        sense: ``"max"`` changes the sign of everything, since optimizers look for the least; ``"min"`` and None leave it.
        invalid: what becomes of a point without an answer (no flight, a value outside its range): ``"raise"`` an exception, or ``"nan"``, from which
            SLSQP, COBYLA and COBYQA of SciPy step back; give other methods bounds within which every drive flies.
        swings: a file of swings, as for :func:`optimize`: TOML with distributions and correlations, or a table of recorded swings.
        distribution: distributions of parameters from swing to swing, as for :func:`optimize`: texts as ``"swing.speed=normal(107mph,3mph)"``, or a dict.
        correlation: correlations of these, one or several, as ``"swing.path,swing.face_angle=0.6"``.
        scenarios: how many swings of the distributions are taken, as for :func:`optimize`.
        seed: the seed of the swings.
        strokes: a file with the table of expected strokes, as for :func:`optimize`, for a goal of ``strokes(400yd)``.

    Raises:
        InputError: as :func:`gradient`; for swings that cannot be read, and for a parameter that they have values of.
    """
    from pathlib import Path

    over = Question("optimize", Path())
    over.take_setup(setup)
    for name, file in (("swings", swings), ("strokes", strokes)):
        if not (file is None or isinstance(file, (str, PathLike))):
            instead = "" if name == "strokes" else "; distribution takes dicts of distributions"
            raise InputError(
                f"{name} is {kind_of(file)}; expected the name of a file, which an objective reads again where it is unpickled: write a table with " f"pandas.DataFrame(…).to_csv('{name}.csv', index=False), and give that name{instead}"
            )
    for name, text in (("sense", sense), ("invalid", invalid)):
        with whole_characters(name):
            str(text).encode()
    return _longdrive.Objective(
        setup,
        one_name("of", of, "jacobian takes several"),
        _listed(wrt),
        sense,
        invalid,
        swings,
        over.texts("distribution", distribution),
        over.texts("correlation", correlation),
        None if scenarios is None else count_of("scenarios", scenarios, 1, MOST_SCENARIOS),
        None if seed is None else count_of("seed", seed, most=MOST_SEED),
        strokes,
    )


def _listed(names: Names | None) -> Sequence[str] | None:
    return [names] if isinstance(names, str) else names
