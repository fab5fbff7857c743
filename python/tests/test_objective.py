"""Outcomes as functions for optimizers."""

from __future__ import annotations

import copy
import math
import pickle
import signal
import threading
import warnings
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import InputError, NoAnswerError, Setup

WRT = ["club.loft", "swing.attack_angle"]


def test_same_value_gradient_and_hessian_as_the_drive_in_any_order() -> None:
    value, gradient, hessian = longdrive.hessian("mae494", "carry", WRT)
    for order in [["fun", "jac", "hess"], ["hess", "jac", "fun"], ["jac", "fun"], ["fun", "hess"]]:
        carry = longdrive.objective("mae494", "carry", WRT)
        for _ in range(3):
            for name in order:
                found = getattr(carry, name)(carry.x0)
                expected = {"fun": value, "jac": gradient, "hess": hessian}[name]
                np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-9)
            # another point in between
            carry.fun([0.2, 0.0])


def test_same_values_from_lists_strides_and_types_of_x() -> None:
    carry = longdrive.objective("mae494", "carry", WRT)
    x = np.array([0.2, 0.01])
    wide = np.zeros(4)
    wide[::2] = x
    read_only = x.copy()
    read_only.flags.writeable = False
    expected = carry.fun(x)
    for same in (
        x.tolist(),
        tuple(x),
        wide[::2],
        x[::-1].copy()[::-1],
        read_only,
        x.astype(np.float64, order="F"),
        x.astype(">f8"),
    ):
        assert carry.fun(same) == expected
        assert carry.jac(same).tolist() == carry.jac(x).tolist()
    assert carry(x) == expected


def test_exact_opposite_signs_with_the_sense_max() -> None:
    up, down = longdrive.objective("mae494", "carry", WRT), longdrive.objective(
        "mae494", "carry", WRT, "max"
    )
    assert down.fun(up.x0) == -up.fun(up.x0)
    assert down.jac(up.x0).tolist() == (-up.jac(up.x0)).tolist()
    assert down.hess(up.x0).tolist() == (-up.hess(up.x0)).tolist()
    assert down.fun_and_jac(up.x0)[0] == down.fun(up.x0)


def test_an_objective_has_its_outcome_variables_and_physical_bounds() -> None:
    carry = longdrive.objective(Setup(), "carry", ["club.loft", "swing.speed"])
    assert (carry.names, carry.of, carry.setup) == (["club.loft", "swing.speed"], "carry", Setup())
    assert carry.x0.tolist() == [Setup()["club.loft"], Setup()["swing.speed"]]
    ranges = {row["parameter"]: row["range"] for row in longdrive.parameters()["parameters"]}
    for (low, high), name in zip(carry.bounds, carry.names):
        known = ranges[name]
        assert low == known["low"] if known["low_included"] else low > known["low"]
        assert (
            high == known["high"] if known["high_included"]
            or math.isinf(high) else high < known["high"]
        )
    # both ends of a range are valid: an optimizer may evaluate there
    longdrive.Setup({"club.loft": carry.bounds[0][0]})
    longdrive.Setup({"club.loft": carry.bounds[0][1]})


def test_a_point_without_a_drive_raises_or_is_nan() -> None:
    down = [0.1, math.radians(-40)]
    with pytest.raises(NoAnswerError, match="no flight"):
        longdrive.objective(Setup(), "carry", WRT).fun(down)
    with pytest.raises(InputError, match=r"club.loft = 114.5916 deg \(2 rad\)"):
        longdrive.objective(Setup(), "carry", WRT).fun([2.0, 0.0])
    carry = longdrive.objective(Setup(), "carry", WRT, invalid="nan")
    for x in (down, [2.0, 0.0], [math.nan, 0.0]):
        assert (
            math.isnan(carry.fun(x))
            and np.isnan(carry.jac(x)).all()
            and np.isnan(carry.hess(x)).all()
        )
    assert math.isfinite(carry.fun(carry.x0))


@pytest.mark.parametrize(("x", "message"), [
    ([0.1], r"x has shape \(1,\); expected shape \(2,\): club.loft, swing.attack_angle"),
    ([[0.1, 0.2]], r"x has shape \(1, 2\)"),
    (0.1, r"x has shape \(\)"),
    (["a", "b"], "x has dtype <U1; expected shape"),
    (np.zeros((2, 1)), r"x has shape \(2, 1\)"),
])
def test_an_x_of_the_wrong_shape_is_refused(x: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        longdrive.objective(Setup(), "carry", WRT).fun(x)


def test_one_variable_may_be_a_number() -> None:
    carry = longdrive.objective(Setup(), "carry", "club.loft", sense="max")
    values = [
        carry.fun(x) for x in (0.16, np.float64(0.16), np.array(0.16), [0.16], np.array([0.16]))
    ]
    assert (
        set(values) == {values[0]}
        and carry.jac(0.16).shape == (1,)
        and carry.hess(0.16).shape == (1, 1)
    )
    with pytest.raises(InputError, match=r"x has shape \(1, 1\)"):
        carry.fun([[0.16]])
    optimize = pytest.importorskip("scipy.optimize")
    found = optimize.minimize_scalar(
        carry.fun, bounds=(0.05, 0.4), method="bounded", options={"xatol": 1e-10}
    )
    # its gradient vanishes, which proves the optimum
    assert abs(carry.jac(found.x)[0]) < 1e-4 and 0.06 < found.x < 0.39


def test_ctrl_c_ends_the_evaluation_of_a_goal_over_many_swings() -> None:
    swings: dict[str, Any] = {
        "distribution": {"swing.speed": ("normal", 50.0, 1.5), "swing.path": ("normal", 0.0, 0.04)}
    }
    mean = longdrive.objective("mae494", "mean(carry)", "club.loft", scenarios=20_000, **swings)
    heard, is_over = [], threading.Event()

    def on_signal(*_: object) -> None:
        heard.append(True)
        # raise at the third signal within one call. Without checks during the call, Python would
        # see only one signal, at the end of the call
        if len(heard) == 3:
            raise KeyboardInterrupt

    def press() -> None:
        while not is_over.wait(0.005):
            signal.raise_signal(signal.SIGINT)

    before = signal.signal(signal.SIGINT, on_signal)
    presser = threading.Thread(target=press)
    try:
        presser.start()
        with pytest.raises(KeyboardInterrupt):
            mean.hess([0.2])
    finally:
        is_over.set()
        presser.join()
        signal.signal(signal.SIGINT, before)
    # and later calls are correct
    alone = longdrive.objective("mae494", "mean(carry)", "club.loft", **swings)
    assert mean.fun([0.19]) == pytest.approx(alone.fun([0.19]), rel=1e-3)


def test_wrong_names_are_refused() -> None:
    with pytest.raises(InputError, match="sense = 'up'; expected 'max', 'min' or None"):
        longdrive.objective(Setup(), "carry", WRT, "up")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="invalid = 'zero'; expected 'raise' or 'nan'"):
        longdrive.objective(Setup(), "carry", WRT, invalid="zero")  # type: ignore[arg-type]


def test_an_objective_pickles_and_copies() -> None:
    carry = longdrive.objective({"club.loft": 0.19}, "carry", WRT, "max", invalid="nan")
    for other in (pickle.loads(pickle.dumps(carry)), copy.copy(carry), copy.deepcopy(carry)):
        assert repr(other) == repr(carry) == "<longdrive.Objective carry of club.loft, swing.attack_angle, max>"
        assert other.fun(carry.x0) == carry.fun(carry.x0) and math.isnan(other.fun([2.0, 0.0]))


SWINGS: dict[str, Any] = {"distribution": ["swing.attack_angle=uniform(-2deg, 6deg)"]}


def test_independent_a_mean_over_uniform_swings_is_that_of_gauss_legendre() -> None:
    nodes, weights = np.polynomial.legendre.leggauss(32)
    attack = np.radians(2 + 4 * nodes)
    mean = longdrive.objective("mae494", "mean(carry)", ["club.loft", "club.mass"], **SWINGS)
    x = [0.2, 0.195]
    rows = [
        longdrive.hessian(
            {"preset": "mae494", "swing.attack_angle": angle, "club.loft": x[0], "club.mass": x[1]},
            "carry",
            mean.names,
        )
        for angle in attack
    ]
    for found, expected in [
        (mean.fun(x), [row.value for row in rows]),
        (mean.jac(x), [row.gradient for row in rows]),
        (mean.hess(x), [row.hessian for row in rows]),
    ]:
        np.testing.assert_allclose(
            found, np.tensordot(weights / 2, np.asarray(expected), 1), rtol=1e-9
        )
    deviation = longdrive.objective(
        "mae494", "std(carry)", ["club.loft", "club.mass"], "max", **SWINGS
    )
    carry = np.asarray([row.value for row in rows])
    scatter = np.sqrt(weights / 2 @ (carry - weights / 2 @ carry) ** 2)
    assert deviation.fun(x) == pytest.approx(-scatter, rel=1e-9)
    assert repr(
        deviation
    ) == "<longdrive.Objective std(carry) over swings of club.loft, club.mass, max>"


def test_same_goals_over_swings_as_the_search() -> None:
    best = longdrive.optimize(
        "mae494", maximize="mean(carry) - 0.5*std(carry)", vary="club.loft=4deg..20deg", **SWINGS
    )
    chosen = {name: best.reply["setup"][name] for name in ("flight.method", "flight.step")}
    goal = longdrive.objective(
        {"preset": "mae494", **chosen}, "mean(carry) - 0.5*std(carry)", "club.loft", "max", **SWINGS
    )
    assert goal.fun(best.x) == pytest.approx(-best.fun, abs=1e-9)
    np.testing.assert_allclose(goal.jac(best.x), -best.jac, rtol=1e-12)
    again = pickle.loads(pickle.dumps(goal))
    assert again.fun(best.x) == goal.fun(best.x) and repr(again) == repr(goal)


def test_wrong_swings_are_refused() -> None:
    cases: list[tuple[dict[str, Any], str]] = [
        ({"distribution": "swing.speed=normal(100mph)"}, "normal"),
        ({"scenarios": 64}, "scenarios: it is about many swings"),
        ({"swings": "nowhere.toml"}, "nowhere.toml"),
        (
            {"swings": "nowhere.toml", "distribution": "swing.speed=normal(100mph,2mph)"},
            "^distribution: nowhere.toml gives the swings",
        ),
        ({"distribution": "club.loft=normal(10deg,1deg)"}, "the swings have values of it"),
        (
            {"distribution": "launch.ball_speed=normal(70m/s,1m/s)"},
            "launch.ball_speed: it is a quantity of the ball",
        ),
    ]
    for words, message in cases:
        with pytest.raises(InputError, match=message):
            longdrive.objective("mae494", "mean(carry)", "club.loft", **words)
    with pytest.raises(InputError, match="mean\\(carry\\)"):
        longdrive.objective("mae494", "carry", "club.loft", **SWINGS)


def test_swings_are_written_as_for_optimize_and_counts_are_named() -> None:
    text = longdrive.objective(
        "mae494", "mean(carry)", "club.loft", distribution="swing.attack_angle=uniform(0deg, 10deg)"
    )
    named = longdrive.objective(
        "mae494",
        "mean(carry)",
        "club.loft",
        distribution={"swing.attack_angle": ("uniform", "0 deg", "10 deg")},
    )
    assert text.fun([0.19]) == named.fun([0.19])
    cases: list[tuple[dict[str, Any], str]] = [
        ({"scenarios": -3}, "scenarios = -3; expected a whole number of 2 or more"),
        ({"scenarios": 0}, "scenarios = 0; expected a whole number of 2 or more"),
        ({"scenarios": 1}, "scenarios = 1; expected a whole number of 2 or more"),
        ({"seed": 2.5}, "seed = 2.5; expected a whole number"),
        ({"swings": {}}, "swings is a dict; expected the name of a file"),
    ]
    for words, message in cases:
        with pytest.raises(InputError, match=message):
            longdrive.objective("mae494", "mean(carry)", "club.loft", **{**SWINGS, **words})


def test_other_threads_of_python_run_while_an_objective_flies_swings(
    at_work: threading.Event
) -> None:
    # seconds of work
    goal = longdrive.objective(
        "tour-average", "mean(carry)", "club.loft", **{**SWINGS, "scenarios": 20_000}
    )
    at_work.set()
    with pytest.raises(KeyboardInterrupt):
        goal.hess(goal.x0)


def test_scipy_reaches_the_optimum_that_the_gradient_proves() -> None:
    optimize = pytest.importorskip("scipy.optimize")
    # at a fixed attack angle, the best loft is inside the bounds, where the derivative is 0
    carry = longdrive.objective("mae494", "carry", ["club.loft"], "max")
    found = optimize.minimize(
        carry.fun,
        carry.x0,
        jac=carry.jac,
        hess=carry.hess,
        method="trust-constr",
        bounds=[(0.0, 0.5)],
        options={"gtol": 1e-11, "xtol": 1e-14},
    )
    # distance to the optimum: one step of Newton's method
    assert (
        abs(carry.jac(found.x)[0] / carry.hess(found.x)[0, 0]) < 1e-7
        and carry.hess(found.x)[0, 0] > 0
    )
    other = optimize.minimize(
        carry.fun_and_jac, carry.x0, jac=True, method="L-BFGS-B", bounds=[(0.0, 0.5)]
    )
    assert other.x[0] == pytest.approx(found.x[0], abs=1e-5)


@pytest.mark.parametrize(
    "method", ["CG", "BFGS", "Newton-CG", "L-BFGS-B", "TNC", "SLSQP", "trust-constr"]
)
def test_same_optimum_by_every_method_of_scipy_that_takes_derivatives(method: str) -> None:
    optimize = pytest.importorskip("scipy.optimize")
    ranges = {"club.loft": (0.05, 0.45), "strike.high": (-0.015, 0.015)}
    carry = longdrive.objective("tour-average", "carry", list(ranges), "max")
    # use the carry in km: the first step of CG and BFGS has the length of the gradient, which would
    # leave all ranges for a carry in m
    more: dict[str, Any] = {}
    if method in ("Newton-CG", "trust-constr"):
        more["hess"] = lambda x: carry.hess(x) / 1e3
    if method not in ("CG", "BFGS", "Newton-CG"):
        more["bounds"] = list(ranges.values())
    found = optimize.minimize(
        lambda x: carry.fun(x) / 1e3,
        carry.x0,
        jac=lambda x: carry.jac(x) / 1e3,
        method=method,
        tol=1e-10,
        **more,
    )
    best = longdrive.optimize("tour-average", vary=ranges)
    assert best.success and -1e3 * found.fun == pytest.approx(best.fun, abs=1e-6)
    assert found.x == pytest.approx(best.x, abs=1e-5)


@pytest.mark.parametrize(
    "method",
    [
        "SLSQP",
        "COBYLA",
        "COBYQA",
        "Nelder-Mead",
        "trust-constr",
        "TNC",
        "L-BFGS-B",
        "Powell",
        "BFGS",
        "CG",
        "Newton-CG",
    ],
)
def test_scipy_steps_back_from_a_point_without_a_drive_or_reports_it(
    method: str
) -> None:
    optimize = pytest.importorskip("scipy.optimize")
    carry = longdrive.objective("tour-average", "carry", "club.loft", "max", invalid="nan")
    values = []

    def fun(x: Any) -> float:
        values.append(carry.fun(x))
        return values[-1]

    slopes = {} if method in ("COBYLA", "COBYQA", "Nelder-Mead", "Powell") else {"jac": carry.jac}
    slopes |= {"hess": carry.hess} if method in ("trust-constr", "Newton-CG") else {}
    bounds = {} if method in ("BFGS", "CG", "Newton-CG") else {"bounds": [(-1.5, 1.5)]}
    with np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = optimize.minimize(fun, [0.4], method=method, **slopes, **bounds)
    # the optimizer of longdrive, whose answer is proven by its KKT residual
    best = longdrive.optimize("tour-average", vary="club.loft=0deg..30deg")
    is_there = abs(-found.fun - best.fun) < 1e-3
    if method in ("SLSQP", "COBYLA", "COBYQA"):
        assert any(map(math.isnan, values)) and found.success and is_there
    else:
        assert is_there or not found.success


@pytest.mark.parametrize(
    "distribution",
    [{"swing.speed": ("normal", 51.0, 1.0)}, "swing.speed = normal(51 m/s, 1 m/s)"],
)
def test_a_stated_value_is_refused_beside_its_distribution_as_by_a_search(
    distribution: Any,
) -> None:
    for setup in ({"swing.speed": 50.0}, {"swing": {"speed": 50.0}}):
        message = "^swing.speed of the setup: the swings have values of it, so this one is not used"
        with pytest.raises(InputError, match=message):
            longdrive.objective(setup, "mean(carry)", "club.loft", distribution=distribution)
        with pytest.raises(InputError, match=message):
            longdrive.optimize(
                setup,
                maximize="mean(carry)",
                vary="club.loft=8deg..12deg",
                distribution=distribution,
            )
    # the search starts from a stated value of a parameter that it varies
    mean = longdrive.objective(
        {"club.loft": 0.2}, "mean(carry)", "club.loft", distribution=distribution
    )
    assert mean.x0.tolist() == [0.2]
