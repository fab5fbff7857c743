"""One drive and its derivatives, compared with independent drives and closed forms."""

from __future__ import annotations

import json
import math
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import InputError, NoAnswerError, Setup

CHECKED = [
    "carry",
    "lateral",
    "flight_time",
    "apex_height",
    "descent_angle",
    "landing_speed",
    "ball_speed",
    "launch_angle",
    "spin",
]


def test_independent_outcomes_of_every_drive(independent_drives: list[dict[str, Any]]) -> None:
    for drive in independent_drives:
        ours = longdrive.simulate(drive["setup"])
        assert ours.status == drive["outcomes"]["status"]
        for name in CHECKED:
            theirs = drive["outcomes"][name]
            assert ours[name] == pytest.approx(theirs, rel=1e-9, abs=1e-12), (drive["name"], name)


def test_independent_gradients_of_carry_and_lateral(
    independent_drives: list[dict[str, Any]]
) -> None:
    for drive in independent_drives:
        for of in ["carry", "lateral"]:
            theirs = drive["gradient"][of]
            value, gradient = longdrive.gradient(drive["setup"], of=of, wrt=list(theirs))
            size = np.abs(list(theirs.values())).max()
            assert value == pytest.approx(drive["outcomes"][of], rel=1e-9, abs=1e-9)
            np.testing.assert_allclose(
                gradient, list(theirs.values()), rtol=1e-8, atol=1e-8 * size, err_msg=drive["name"]
            )


def test_independent_hessians_of_carry(independent_drives: list[dict[str, Any]]) -> None:
    checked = 0
    for drive in independent_drives:
        theirs = drive.get("hessian_carry_loft_attack")
        if theirs is None:
            continue
        _, gradient, hessian = longdrive.hessian(
            drive["setup"], of="carry", wrt=["club.loft", "swing.attack_angle"]
        )
        np.testing.assert_allclose(
            hessian, theirs, rtol=1e-7, atol=1e-7 * np.abs(theirs).max(), err_msg=drive["name"]
        )
        assert gradient.shape == (2,)
        checked += 1
    assert checked > 0


def test_exact_parabola_in_a_vacuum() -> None:
    vacuum = Setup({"preset": "mae494", "air.density": 0})
    drive = longdrive.simulate(vacuum)
    speed, angle, carry = drive["ball_speed"], drive["launch_angle"], drive["carry"]
    assert speed is not None and angle is not None and carry is not None
    g = vacuum["gravity"]
    assert carry == pytest.approx(speed**2 * math.sin(2 * angle) / g, rel=1e-12)
    value, gradient, hessian = longdrive.hessian(vacuum, wrt="gravity")
    assert gradient[0] == pytest.approx(-value / g, rel=1e-12)
    assert hessian[0, 0] == pytest.approx(2 * value / g**2, rel=1e-12)


def test_a_jacobian_has_a_row_for_each_outcome() -> None:
    wrt = ["club.loft", "swing.speed", "strike.toe"]
    values, rows = longdrive.jacobian(Setup(), of=["carry", "lateral"], wrt=wrt)
    for k, of in enumerate(["carry", "lateral"]):
        value, gradient = longdrive.gradient(Setup(), of=of, wrt=wrt)
        assert values[k] == pytest.approx(value, rel=1e-14)
        np.testing.assert_allclose(rows[k], gradient, rtol=1e-12)
    everything = longdrive.jacobian(Setup(), of="all", wrt="all")
    assert everything.jacobian.shape == (
        sum(row["part"] != "head" for row in longdrive.outcomes()), everything.jacobian.shape[1]
    )
    assert np.isfinite(everything.jacobian).all()


def test_all_parameters_leave_those_of_the_run_out_for_a_carry() -> None:
    carry, total = (longdrive.gradient(Setup(), of=of, wrt="all") for of in ("carry", "total"))
    of_run = [
        row
        for row in longdrive.parameters()["parameters"]
        if row["parameter"].startswith("ground.") and row["parameter"] != "ground.height"
    ]
    with_value = [row for row in of_run if row["value"] is not None]
    assert len(with_value) > 0
    assert len(total.gradient) - len(carry.gradient) == len(with_value)


def test_same_numbers_as_the_program(program: Callable[..., Any]) -> None:
    stated = ("modern-driver", "--set", "club.loft=11deg", "--json")
    report = json.loads(program("simulate", *stated).stdout)
    setup = {"preset": "modern-driver", "club.loft": "11 deg"}
    drive = longdrive.simulate(setup, own_step=True)
    # the program also names the setup as it was stated
    assert report.pop("from") == "modern-driver, club.loft=11deg"
    assert drive.report == report
    assert drive["carry"] == report["flight"]["carry"]
    theirs = json.loads(program("gradient", *stated, "--hessian").stdout)["outcomes"][0]
    value, gradient, hessian = longdrive.hessian(setup, own_step=True)
    assert value == theirs["value"] and gradient.tolist() == list(theirs["gradient"].values())
    assert hessian.tolist() == theirs["hessian"]["values"]


def test_a_drive_is_a_mapping_that_pickles_and_shows_itself() -> None:
    drive = longdrive.simulate("mae494", of=["carry", "apex_height"])
    assert pickle.loads(pickle.dumps(drive)) == drive
    assert dict(drive).keys() == {"carry", "apex_height"}
    assert "<td>apex height</td>" in drive._repr_html_()
    down = longdrive.simulate({"swing.attack_angle": "-40 deg"})
    assert (down.status, down["carry"]) == ("no-flight", None) and down["ball_speed"] is not None
    assert down.message is not None and "no flight" in down.message
    with pytest.raises(InputError, match="unknown outcome 'carri'; did you mean 'carry'"):
        longdrive.simulate(of="carri")


@pytest.mark.parametrize(("of", "wrt", "message"), [
    ("carri", "club.loft", "unknown outcome 'carri'; did you mean 'carry'"),
    ("carry", "club.lofft", "unknown parameter 'club.lofft'; did you mean 'club.loft'"),
    ("carry", ["club.loft", "club.loft"], "wrt names 'club.loft' twice"),
    ("carry", [], "nothing to differentiate by"),
    ("carry", 3, "wrt is an int; expected a name or a list of names"),
    ("carry", "aero.law", "it is a choice, not a number"),
    ("all", "club.loft", "name one"),
])
def test_wrong_arguments_have_a_message(of: str, wrt: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        longdrive.gradient(Setup(), of=of, wrt=wrt)


def test_a_missing_derivative_raises() -> None:
    launch = {"launch": {"ball_speed": "150 mph", "launch_angle": "12 deg", "backspin": 0}}
    with pytest.raises(NoAnswerError) as caught:
        longdrive.gradient(launch, of="spin_axis", wrt="launch.launch_angle")
    assert caught.value.status == "undefined"


def test_several_outcomes_of_a_gradient_are_refused_with_the_function_to_use() -> None:
    for derivative in (longdrive.gradient, longdrive.hessian):
        with pytest.raises(longdrive.InputError, match="of is a list; expected one name"):
            derivative("tour-average", of=["carry", "spin"])  # type: ignore[arg-type]
