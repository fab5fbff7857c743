"""Warnings: each entry of ``warnings`` of an answer is issued once, at the line of the call."""

from __future__ import annotations

import pickle
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import LongdriveWarning

# faster than the fitted range of a law whose drag depends on the Reynolds number
FAST = {"preset": "tour-average", "swing.speed": "160 mph", "aero.law": "smits-smith"}
# a setup, not a dict: a call states no speed with it, so swings may replace the speed
SWUNG = longdrive.Setup(FAST)
POINTS = {"club.loft": np.linspace(0.1, 0.2, 50)}
# a large angle without a unit
BARE = {**FAST, "swing.path": 0.6}
BALL = {"ball_speed": 90.0, "launch_angle": 0.2, "backspin": 250.0}
# the drive does not use the club of this setup
LAUNCHED = longdrive.Setup({"aero.law": "smits-smith", "club.loft": "20 deg", "launch": BALL})

CALLS: list[Callable[[], Any]] = [
    lambda: longdrive.simulate(FAST),
    lambda: longdrive.batch(FAST, POINTS),
    lambda: longdrive.sweep(FAST, {"club.loft": (0.1, 0.2, 50)}),
    lambda: longdrive.sweep(FAST, points={"club.loft [rad]": POINTS["club.loft"]}),
    lambda: longdrive.optimize(FAST),
    lambda: longdrive.simulate(BARE),
    lambda: longdrive.batch(BARE, POINTS),
    lambda: longdrive.sweep(BARE, {"club.loft": (0.1, 0.2, 50)}),
    lambda: longdrive.optimize(BARE),
    lambda: longdrive.simulate(LAUNCHED),
    lambda: longdrive.batch(LAUNCHED, {"air.density": [1.1]}),
    lambda: longdrive.chart(
        SWUNG, along={"swing.speed": ("150 mph", "160 mph")}, vary={"club.loft": (0.1, 0.3)}
    ),
]


@pytest.mark.parametrize("call", CALLS)
def test_a_call_warns_once_of_each_warning_of_its_answer(call: Callable[[], Any]) -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = call()
    assert found.warnings
    assert [(str(one.message), one.category, one.filename) for one in caught] == [
        ("\n".join(found.warnings), LongdriveWarning, __file__)
    ]


@pytest.mark.parametrize(
    "call",
    [
        longdrive.simulate,
        lambda setup: longdrive.batch(setup, {"air.density": [1.1]}),
        lambda setup: longdrive.sweep(setup, {"air.density": (1.1, 1.2, 2)}),
    ],
)
def test_warnings_about_the_setup_come_first(call: Callable[[Any], Any]) -> None:
    (of_club,) = (text for text in LAUNCHED.warnings() if "not used" in text)
    assert of_club == "not used, since the drive is given by its launch: club.loft"
    assert call(LAUNCHED).warnings[0] == of_club
    assert call(BARE).warnings[0].startswith("swing.path = 0.6 is 0.6 rad: ")


@pytest.mark.parametrize("call", CALLS)
def test_a_warning_may_be_an_error_and_has_the_answer(call: Callable[[], Any]) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(LongdriveWarning, match="fitted") as raised:
            call()
        warnings.simplefilter("ignore")
        answer = raised.value.answer
        # the exception has the same result as a call without an exception, also when it is pickled,
        # as from a pool of processes
        assert (
            type(answer) is type(call())
            and answer.warnings
            and "\n".join(answer.warnings) == str(raised.value)
        )
        other = pickle.loads(pickle.dumps(raised.value))
    assert (
        str(other) == str(raised.value)
        and type(other.answer) is type(answer)
        and other.answer.warnings == answer.warnings
    )


def test_a_warning_raised_as_an_error_has_the_optimum() -> None:
    with warnings.catch_warnings(record=True):
        warnings.simplefilter("always")
        found = longdrive.optimize(FAST)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(LongdriveWarning) as raised:
            longdrive.optimize(FAST)
    assert raised.value.answer.success and (raised.value.answer.x == found.x).all()
    assert LongdriveWarning("alone").answer is None


def test_degrees_in_place_of_radians_have_a_warning() -> None:
    degrees = {"club.loft": [8.0, 10.0, 12.0], "swing.attack_angle": np.radians([1.0, 2.0, 3.0])}
    with pytest.warns(
        LongdriveWarning,
        match=r"points: out of range: 3 of 3 values of club.loft \(8 to 12; .*look like degrees: if they are, give numpy.radians\(…\) of them$",
    ) as caught:
        table = longdrive.batch("tour-average", degrees)
    assert (
        table.counts() == {"out-of-range": 3} and "swing.attack_angle" not in str(caught[0].message)
    )
    with pytest.warns(LongdriveWarning, match=r"2 of 2 values of swing.path \(2; "):
        longdrive.batch("tour-average", {"club.loft": [0.1, 0.2], "swing.path": 2.0})
    quiet: list[dict[str, Any]] = [
        {"club.loft": [0.14, 0.17, np.nan]},  # radians
        {"club.loft": [1000.0, 2000.0]},  # no degrees either
        {"club.loft": [np.nan]},
        {"swing.speed": [5000.0]},  # no angle
    ]
    for points in quiet:
        assert not any(
            "degrees" in text for text in longdrive.batch("winfield-tan", points).warnings
        ), points


def test_swings_that_leave_the_law_warn() -> None:
    fast = "swing.speed=truncated(150mph,3mph,140mph,160mph)"
    with pytest.warns(
        LongdriveWarning, match="100 % of the swings: the flight leaves the ranges"
    ):
        longdrive.optimize(SWUNG, vary="club.loft=4deg..20deg", distribution=fast)


def test_a_usual_drive_has_no_warnings() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert not longdrive.simulate("winfield-tan").warnings
        assert not longdrive.batch("winfield-tan", {"club.loft": [0.19, 0.2]}).warnings


def test_calls_of_an_optimizer_have_no_warnings_of_drives() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert longdrive.objective(FAST, "carry", "club.loft").fun([0.15]) > 0
        assert longdrive.gradient(FAST).value > 0
    assert longdrive.Setup(FAST) is not None and longdrive.simulate(FAST).warnings


def outcome_of_jax(setup: Any) -> Any:
    pytest.importorskip("jax")
    import longdrive.jax

    return longdrive.jax.outcome(setup, wrt="air.density")


def outcome_of_torch(setup: Any) -> Any:
    pytest.importorskip("torch")
    import longdrive.torch

    return longdrive.torch.outcome(setup, wrt="air.density")


@pytest.mark.parametrize(
    ("call", "kind"),
    [
        (lambda setup: longdrive.gradient(setup, wrt="air.density"), "Gradient"),
        (lambda setup: longdrive.jacobian(setup, wrt="air.density"), "Jacobian"),
        (lambda setup: longdrive.hessian(setup, wrt="air.density"), "Hessian"),
        (lambda setup: longdrive.objective(setup, wrt="air.density"), "Objective"),
        (outcome_of_jax, "OutcomeFunction"),
        (outcome_of_torch, "OutcomeFunction"),
    ],
)
def test_calls_of_an_optimizer_warn_of_their_setup(call: Callable[[Any], Any], kind: str) -> None:
    of_club = "not used, since the drive is given by its launch: club.loft"
    with pytest.warns(LongdriveWarning) as caught:
        function = call(LAUNCHED)
    assert [(str(one.message), one.filename) for one in caught] == [(of_club, __file__)]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(LongdriveWarning, match="^swing.path = 0.6 is 0.6 rad: ") as raised:
            call(BARE)
        assert type(raised.value.answer).__name__ == kind
        if kind == "OutcomeFunction":
            # the call that made the function has warned
            assert callable(pickle.loads(pickle.dumps(raised.value.answer)))
            pickle.loads(pickle.dumps(function))


def test_an_attribute_of_an_optimum_does_not_warn() -> None:
    best = longdrive.optimize(LAUNCHED, vary={"launch.launch_angle": ("5 deg", "20 deg")})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert best.hess is not None and best.hess.shape == (1, 1)


def test_a_fit_without_a_minimum_warns() -> None:
    # carry does not distinguish drag from lift at one launch
    shots = {
        "ball_speed [m/s]": [70.0, 70.0, 70.0],
        "launch_angle [deg]": [11.0, 11.0, 11.0],
        "backspin [rpm]": [2600.0, 2600.0, 2600.0],
        "carry [m]": [230.0, 231.0, 229.0],
    }
    with pytest.warns(
        LongdriveWarning, match="the fit ended as 'undetermined': the data do not determine"
    ):
        found = longdrive.calibrate(
            shots,
            {"preset": "modern-driver", "aero.law": "robinson"},
            fit=["aero.cd0=0.1..0.5", "aero.cl_max=0.05..0.5"],
        )
    assert found.status == "undetermined"


def test_shots_without_a_flight_warn_with_the_assumed_units() -> None:
    shots = {
        "Ball Speed": [7000.0, 6800.0], "Launch Angle": [12.0, 11.0], "Spin Rate": [2600.0, 2500.0]
    }
    with pytest.warns(
        LongdriveWarning,
        match="none of 2 rows could be flown; line 2: .*heads without a unit are read as Ball Speed in mph",
    ):
        found = longdrive.fly(shots)
    assert (
        found.status == "no-answer"
        and [row["flight"] for row in found.shots] == ["refused", "refused"]
    )


@pytest.mark.parametrize(
    ("head", "value", "words"),
    [
        (
            "carry [m]",
            -230.0,
            "-251.5311 yd cannot be the carry_distance of a drive, because this is always above 0; check its sign",
        ),
        ("carry_distance [m]", -230.0, "cannot be the carry_distance of a drive"),
        ("flight_time [s]", 0.0, "leave the cell empty where nothing was measured"),
    ],
)
def test_a_measurement_that_no_drive_has_is_refused(head: str, value: float, words: str) -> None:
    shots = {
        "ball_speed [m/s]": [70.0, 70.0],
        "launch_angle [deg]": [11.0, 12.0],
        "backspin [rpm]": [2600.0, 2600.0],
        head: [abs(value) + 1, value],
    }
    with pytest.raises(longdrive.InputError, match=words) as raised:
        longdrive.calibrate(
            shots, {"preset": "modern-driver", "aero.law": "robinson"}, fit="aero.cd0"
        )
    assert str(raised.value).startswith(f"data, row 2, column {head.split()[0]}: ")


def test_a_fit_names_the_impossible_value_and_the_swing_of_all_rows() -> None:
    launch = {
        "ball_speed [mph]": [150.0, 160.0],
        "launch_angle [deg]": [12.0, 12.0],
        "spin [rpm]": [2500.0, 2500.0],
    }
    with pytest.raises(
        longdrive.InputError,
        match="^data, row 2, column carry: 825 yd is outside of the range of drives, above 0 to 600 yd; check",
    ):
        longdrive.calibrate({**launch, "carry [yd]": [240.0, 825.0]}, fit="aero.cd0")
    with pytest.warns(
        LongdriveWarning,
        match="^data has neither a whole launch .* all 2 rows are compared with one drive, .* swing.speed 115 mph",
    ):
        longdrive.calibrate({"carry [yd]": [270.0, 275.0]}, fit="aero.cd0")
