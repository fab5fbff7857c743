"""Method and step of single drives and functions: the choice, long flights and Ctrl-C."""

from __future__ import annotations

import copy
import pickle
import threading
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import InputError, Setup

WRT = ["club.loft", "swing.speed"]
MICROMETRE = 1e-6


def carries(setup: Any, **step: Any) -> dict[str, float]:
    """Carry at the setup's own values by every function of one drive."""
    setup = Setup(setup)
    x = np.array([setup[name] for name in WRT])
    objective = longdrive.objective(setup, "carry", WRT, **step)
    found = {
        "simulate": longdrive.simulate(setup, of="carry", **step)["carry"],
        "gradient": longdrive.gradient(setup, "carry", WRT, **step).value,
        "jacobian": longdrive.jacobian(setup, "carry", WRT, **step).values[0],
        "hessian": longdrive.hessian(setup, "carry", WRT, **step).value,
        "objective": objective.fun(x),
        "pickled objective": pickle.loads(pickle.dumps(objective)).fun(x),
    }
    return {name: float(value) for name, value in found.items() if value is not None}


@pytest.mark.parametrize("step", [{}, {"tolerance": "1 mm"}, {"own_step": True}])
def test_same_carry_of_every_function(step: dict[str, Any]) -> None:
    found = carries("tour-average", **step)
    functions = {name: found.pop(name) for name in ("objective", "pickled objective")}
    of_function = functions["objective"]
    assert max(found.values()) - min(found.values()) < 1e-11, found
    assert functions["pickled objective"] == of_function
    most = 1e-11 if "own_step" in step else 1e-3 if step else MICROMETRE
    assert abs(of_function - found["simulate"]) < most


def test_same_carry_within_a_micrometre_by_default() -> None:
    usual = carries("tour-average")["simulate"]
    own = carries("tour-average", own_step=True)["simulate"]
    exact = carries("tour-average", tolerance=1e-10)["simulate"]
    assert usual not in (own, exact)
    assert abs(usual - exact) < MICROMETRE
    flown = longdrive.simulate("tour-average").report["setup"]
    assert flown["flight.method"] == "dp8" and flown["flight.step"] > 0.3
    flown = longdrive.simulate("tour-average", own_step=True).report["setup"]
    assert (flown["flight.method"], flown["flight.step"]) == ("rk4", 0.01)


def test_a_stated_step_is_kept() -> None:
    stated = {"flight.step": 0.01}
    assert carries(stated) == carries(stated, own_step=True) == carries({}, own_step=True)
    assert carries("mae494") == carries("mae494", own_step=True)
    assert carries(stated, tolerance="1 um") == carries({}, tolerance="1 um") == carries({})


def test_points_far_from_the_setup_are_within_a_micrometre() -> None:
    fast = longdrive.objective("tour-average", "carry", WRT)
    exact = longdrive.objective("tour-average", "carry", WRT, tolerance=1e-9)
    draw = np.random.default_rng(1)
    for _ in range(200):
        x = fast.x0 * draw.uniform(0.5, 1.5, 2)
        assert abs(fast.fun(x) - exact.fun(x)) < MICROMETRE


def test_same_choice_of_functions_of_jax_and_pytorch_as_of_an_objective() -> None:
    steps: list[dict[str, Any]] = [{}, {"tolerance": 1e-3}, {"own_step": True}]
    x = [Setup()[name] for name in WRT]
    for step in steps:
        carry = carries("tour-average", **step)["objective"]
        jax = pytest.importorskip("jax")
        jax.config.update("jax_enable_x64", True)
        function = longdrive.jax.outcome("tour-average", "carry", WRT, **step)
        both = (function, pickle.loads(pickle.dumps(function)))
        assert all(abs(float(one(jax.numpy.array(x))) - carry) < 1e-11 for one in both)
        torch = pytest.importorskip("torch")
        function = longdrive.torch.outcome("tour-average", "carry", WRT, **step)
        at = torch.tensor(x, dtype=torch.float64)
        assert abs(float(function(at)) - carry) < 1e-11


@pytest.mark.parametrize(
    "function", [longdrive.simulate, longdrive.gradient, longdrive.hessian, longdrive.objective]
)
def test_a_tolerance_is_checked_as_in_batch(function: Callable[..., Any]) -> None:
    for bad in (True, "1 kg", "10", [1.0], -1.0):
        with pytest.raises(InputError, match="tolerance"):
            function("tour-average", tolerance=bad)
    with pytest.raises(InputError, match="tolerance and own_step are both given"):
        function("tour-average", tolerance=1e-3, own_step=True)
    with pytest.raises(InputError, match="own_step = 1; expected True or False"):
        function("tour-average", own_step=1)


def test_the_report_of_a_drive_is_made_at_the_first_access() -> None:
    drive = longdrive.simulate("tour-average", of="carry")
    assert drive.report is drive.report
    assert drive.report["flight"]["carry"] == drive["carry"]
    assert drive.status == "landed" and drive.message is None
    for twin in (pickle.loads(pickle.dumps(drive)), copy.deepcopy(drive)):
        assert twin == drive and twin.report == drive.report
    assert drive != longdrive.simulate("mae494", of="carry")
    with pytest.raises(AttributeError):
        drive.outcomes = {}  # type: ignore[misc, assignment]


ENDLESS = Setup({"gravity": 0.001, "flight.step": 6e-5})
"""Ten million steps up to the time limit, which take more than ten seconds."""


@pytest.mark.parametrize(
    "work",
    [
        lambda: longdrive.simulate(ENDLESS),
        lambda: longdrive.simulate(ENDLESS, trajectory=True),
        lambda: longdrive.gradient(ENDLESS),
        lambda: longdrive.hessian(ENDLESS),
        lambda: longdrive.objective(ENDLESS).fun([0.2, 0.0]),
        lambda: longdrive.batch(ENDLESS, {"club.loft": [0.2]}),
        lambda: longdrive.batch(ENDLESS, {"club.loft": [0.2]}, own_step=True, hessians=True),
    ],
)
def test_ctrl_c_ends_a_flight_of_millions_of_steps(
    work: Callable[[], object], at_work: threading.Event
) -> None:
    at_work.set()
    with pytest.raises(KeyboardInterrupt):
        work()


def test_no_thread_flies_on_after_ctrl_c(at_work: threading.Event) -> None:
    at_work.set()
    with pytest.raises(KeyboardInterrupt):
        longdrive.simulate(ENDLESS)
    latest = time.monotonic() + 8.0
    is_at_rest = False
    while not is_at_rest:
        assert time.monotonic() < latest
        before = time.process_time()
        time.sleep(0.05)
        is_at_rest = time.process_time() - before < 0.005
