"""One rule for warnings: what an answer has in ``warnings`` is warned of once, at the line that asked."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import LongdriveWarning

# faster than anything that the law was fitted to
FAST = {"preset": "tour-average", "swing.speed": "160 mph"}
POINTS = {"club.loft": np.linspace(0.1, 0.2, 50)}

CALLS: list[Callable[[], Any]] = [
    lambda: longdrive.simulate(FAST),
    lambda: longdrive.batch(FAST, POINTS),
    lambda: longdrive.sweep(FAST, {"club.loft": (0.1, 0.2, 50)}),
    lambda: longdrive.sweep(FAST, points={"club.loft [rad]": POINTS["club.loft"]}),
    lambda: longdrive.optimize(FAST),
    lambda: longdrive.chart(FAST, along={"swing.speed": ("150 mph", "160 mph")}, vary={"club.loft": (0.1, 0.3)}),
]


@pytest.mark.parametrize("call", CALLS)
def test_a_call_warns_once_of_all_that_its_answer_warns_of(call: Callable[[], Any]) -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = call()
    assert found.warnings
    assert [(str(one.message), one.category, one.filename) for one in caught] == [("\n".join(found.warnings), LongdriveWarning, __file__)]


@pytest.mark.parametrize("call", CALLS)
def test_a_warning_may_be_an_error(call: Callable[[], Any]) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(LongdriveWarning, match="fitted"):
            call()


def test_a_drive_without_warnings_warns_of_nothing() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert not longdrive.simulate("winfield-tan").warnings
        assert not longdrive.batch("winfield-tan", {"club.loft": [0.19, 0.2]}).warnings


def test_what_an_optimizer_calls_warns_of_nothing() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert longdrive.objective(FAST, "carry", "club.loft").fun([0.15]) > 0
        assert longdrive.gradient(FAST).value > 0
    assert longdrive.Setup(FAST) is not None and longdrive.simulate(FAST).warnings


def test_a_fit_without_a_minimum_warns() -> None:
    # carry does not tell drag from lift at one launch
    shots = {"ball_speed [m/s]": [70.0, 70.0, 70.0], "launch_angle [deg]": [11.0, 11.0, 11.0], "backspin [rpm]": [2600.0, 2600.0, 2600.0], "carry [m]": [230.0, 231.0, 229.0]}
    with pytest.warns(LongdriveWarning, match="the fit is undetermined: the data do not determine"):
        found = longdrive.calibrate(shots, {"preset": "modern-driver", "aero.law": "robinson"}, fit=["aero.cd0=0.1..0.5", "aero.cl_max=0.05..0.5"])
    assert found.status == "undetermined"


def test_shots_of_which_none_flies_warn_with_the_units_that_were_taken() -> None:
    shots = {"Ball Speed": [7000.0, 6800.0], "Launch Angle": [12.0, 11.0], "Spin Rate": [2600.0, 2500.0]}
    with pytest.warns(LongdriveWarning, match="none of 2 rows could be flown; line 2: .*heads without a unit are read as Ball Speed in mph"):
        found = longdrive.fly(shots)
    assert found.status == "no-answer" and [row["flight"] for row in found.shots] == ["refused", "refused"]


@pytest.mark.parametrize(("head", "value", "words"), [
    ("carry [m]", -230.0, "-251.5311 yd is no carry_distance of a drive, which is above 0; check its sign"),
    ("carry_distance [m]", -230.0, "is no carry_distance of a drive"),
    ("flight_time [s]", 0.0, "leave the cell empty where nothing was measured"),
])
def test_a_measurement_that_no_drive_has_is_refused(head: str, value: float, words: str) -> None:
    shots = {"ball_speed [m/s]": [70.0, 70.0], "launch_angle [deg]": [11.0, 12.0], "backspin [rpm]": [2600.0, 2600.0], head: [abs(value) + 1, value]}
    with pytest.raises(longdrive.InputError, match=words) as raised:
        longdrive.calibrate(shots, {"preset": "modern-driver", "aero.law": "robinson"}, fit="aero.cd0")
    assert str(raised.value).startswith(f"data, row 2, column {head.split()[0]}: ")
