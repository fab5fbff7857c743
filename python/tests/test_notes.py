"""Messages about tables, batches and searches: used and omitted rows, and likely mistakes."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import InputError, LongdriveWarning

BALL = {"preset": "modern-driver", "aero.law": "robinson"}
LAUNCHES: dict[str, Any] = {
    "ball_speed [m/s]": np.array([66.0, 70.0, 73.0, 75.0, 68.0]),
    "launch_angle [deg]": np.array([11.0, 13.0, 9.5, 12.0, 15.0]),
    "backspin [rpm]": np.array([2600.0, 2300.0, 3100.0, 2500.0, 2000.0]),
}
ALL = 5


def carries(cd0: float) -> Any:
    """Carries of a ball with this drag for these launches, m."""
    speed, angle, spin = LAUNCHES.values()
    points = {
        "launch.ball_speed": speed,
        "launch.launch_angle": np.radians(angle),
        "launch.backspin": spin * 2 * np.pi / 60,
    }
    launch = {"launch.launch_direction": 0.0, "launch.sidespin": 0.0}
    return longdrive.batch({**BALL, "aero.cd0": cd0}, {**points, **launch}, of="carry_distance")[
        "carry_distance"
    ]


@pytest.fixture(scope="module")
def shots() -> dict[str, Any]:
    """Shots of a ball whose drag is 0.27."""
    return {**LAUNCHES, "carry [m]": carries(0.27)}


def fitted(table: Any, fit: str = "aero.cd0") -> tuple[Any, list[str]]:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = longdrive.calibrate(table, BALL, fit=[fit])
    return found, found.warnings


def test_exact_drag_recovered_without_warnings(shots: dict[str, Any]) -> None:
    found, warned = fitted(shots)
    assert warned == [] and found.estimates["aero.cd0"]["value"] == pytest.approx(0.27, abs=1e-6)


def test_club_values_that_change_a_fit_of_launches_have_a_warning(shots: dict[str, Any]) -> None:
    _, warned = fitted({**shots, "swing.speed [m/s]": np.full(ALL, 47.0)})
    assert (
        "ball_speed, launch_angle, backspin are measured values that it is compared with" in warned[0]
        and "leave swing.speed out" in warned[0]
    )


def test_values_far_from_the_fit_have_a_warning(shots: dict[str, Any]) -> None:
    found, warned = fitted(
        {
            **shots,
            "carry [m]": shots["carry [m]"] * np.array([0.5, 1.0, 1.5, 0.7, 1.2]),
            "sigma carry [m]": np.ones(ALL),
        }
    )
    # the warning has the numbers of the answer
    off = math.sqrt(found.chi_square / found.degrees_of_freedom)
    assert (
        off > 3
        and f"the values miss the fit by {off:.1f} of their standard uncertainties" in warned[0]
    )
    with pytest.warns(LongdriveWarning, match="the fitted model does not describe them"):
        longdrive.calibrate(
            {
                **shots,
                "carry [m]": shots["carry [m]"] + np.array([-60.0, 0, 50, 0, 40]),
                "sigma carry [m]": np.ones(ALL),
            },
            BALL,
            fit=["aero.cd0"],
        )


def test_a_value_at_its_bound_has_a_warning(shots: dict[str, Any]) -> None:
    assert any(
        "aero.cd0 ended at 0.3, the end of its range" in one
        for one in fitted(shots, "aero.cd0=0.3..0.6")[1]
    )
    assert any(
        "aero.cd0 ended at 0, the end of its allowed values" in one
        for one in fitted({**shots, "carry [m]": carries(0.0) + 20})[1]
    )


def test_an_interval_with_negative_drag_has_a_warning(shots: dict[str, Any]) -> None:
    found, warned = fitted(
        {**shots, "carry [m]": carries(0.01), "sigma carry [m]": np.full(ALL, 150.0)}
    )
    low, _ = found.estimates["aero.cd0"]["interval_95"]
    assert low < 0
    assert any(
        "the 95 % interval of aero.cd0" in one and "reaches beyond its allowed range (0 ≤ … ≤ 100)" in one
        for one in warned
    )


def test_an_unused_spin_has_a_warning(shots: dict[str, Any]) -> None:
    _, warned = fitted({**shots, "spin [rpm]": shots["backspin [rpm]"] * 1.2})
    assert "the backspin (2600 rpm) is not used" in warned[0] and "(also in 4 other rows)" in warned[0]
    assert fitted({**shots, "spin [rpm]": shots["backspin [rpm]"]})[1] == []


@pytest.mark.parametrize("column", ["carry [m]", "ball_speed [m/s]"])
def test_rows_without_a_value_are_omitted_and_named(
    shots: dict[str, Any], column: str, tmp_path: Path
) -> None:
    holed = {**shots, column: np.where(np.arange(ALL) == 2, np.nan, shots[column])}
    found, warned = fitted(holed)
    assert len(warned) == 1 and "rows left out" in warned[0] and "row 3 (" in warned[0]
    without = fitted({name: np.delete(values, 2) for name, values in shots.items()})[0]
    assert found.estimates == without.estimates
    # a file is read as a dict with its values
    lines = [
        ",".join(holed),
        *(
            ",".join("" if np.isnan(value) else repr(float(value)) for value in row)
            for row in zip(*holed.values())
        ),
    ]
    (tmp_path / "shots.csv").write_text("\n".join(lines))
    assert fitted(tmp_path / "shots.csv")[0].estimates == found.estimates


def test_a_blank_last_row_is_omitted(shots: dict[str, Any]) -> None:
    found, warned = fitted({name: np.append(values, np.nan) for name, values in shots.items()})
    assert len(warned) == 1 and "row 6" in warned[0] and found.estimates == fitted(shots)[0].estimates


def test_the_message_on_a_refused_trial_point_does_not_name_the_step(shots: dict[str, Any]) -> None:
    found, warned = fitted({**shots, "carry [m]": np.full(ALL, 27.0)})
    assert found.refused["count"] > 0 and "drag or lift is far too large" in found.refused["last"]
    assert "flight.step" not in found.refused["last"] + " ".join(warned)


@pytest.mark.parametrize(
    ("column", "values", "found"),
    [
        ("carry [m]", 230.0, "a float"),
        ("carry [m]", np.zeros((5, 2)), "of shape (5, 2)"),
        ("note", "dry", "a str"),
    ],
)
def test_a_column_without_a_value_for_each_row_is_named(
    shots: dict[str, Any], column: str, values: Any, found: str
) -> None:
    with pytest.raises(ValueError, match="expected a value for each row") as raised:
        longdrive.calibrate({**shots, column: values}, BALL, fit=["aero.cd0"])
    assert str(
        raised.value
    ) == f"data: the column '{column}' is {found}; expected a value for each row, shape (rows,)"


@pytest.mark.parametrize(
    ("points", "words"),
    [
        ({"club.loft": [0.2, 8.0, 10.5, 12.0]}, "3 of 4 values of club.loft (8 to 12; it may be"),
        (
            {"swing.attack_angle": np.array([-1.0, 0.0, 1.0, 2.0])},
            "1 of 4 values of swing.attack_angle (2; it may be",
        ),
    ],
)
def test_some_degrees_among_radians_have_a_warning(points: Any, words: str) -> None:
    with pytest.warns(LongdriveWarning, match="these look like degrees") as caught:
        longdrive.batch("tour-average", points)
    assert words in str(caught[0].message)


def test_angles_with_a_unit_have_no_warning_about_degrees() -> None:
    with pytest.warns(LongdriveWarning) as caught:
        longdrive.sweep("tour-average", points={"club.loft [deg]": [10.0, 100.0, 120.0]})
        longdrive.sweep("tour-average", points={"club.loft [deg]": [100.0, 120.0]})
    messages = " ".join(str(one.message) for one in caught)
    assert (
        "radians" not in messages and "club.loft = 100 deg (1.745329 rad) is outside its range" in messages
    )


def test_a_batch_without_a_flight_names_the_reason_of_its_first_row() -> None:
    with pytest.warns(
        LongdriveWarning,
        match="no drive has the requested outcome: 2 no-flight; row 0: no flight: the ball leaves at",
    ) as caught:
        longdrive.batch("tour-average", {"swing.attack_angle": np.radians([-75.0, -69.0])})
    assert len(caught) == 1
    with pytest.warns(LongdriveWarning, match="2 out-of-range; row 0: club.loft is NaN"):
        longdrive.batch("tour-average", {"club.loft": [np.nan, np.nan]})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        # no warning: the balls do not fly, but the requested ball speed has a value
        longdrive.batch(
            "tour-average",
            {"swing.attack_angle": np.radians([-75.0, -69.0])},
            of=["carry", "ball_speed"],
        )
        longdrive.batch("tour-average", {"club.loft": np.array([])})


TABLE = longdrive.batch("mae494", {"club.loft": [0.15, 0.2]})

REFUSED: list[tuple[Callable[[], Any], str]] = [
    (
        lambda: longdrive.batch("tour-average", {}),
        "points is empty; give at least one parameter with its values",
    ),
    (
        lambda: longdrive.sweep("tour-average", {"club.loft": np.array([0.1, 0.2, 3])}),
        "club.loft in over is an ndarray of 3; expected a tuple (low, high, count)",
    ),
    (
        lambda: longdrive.sweep("tour-average", {"club.loft": [0.1, 0.15, 0.2]}),
        "your own values, with one drive for each, go into points={'club.loft [rad]': …}",
    ),
    (
        lambda: longdrive.sweep("tour-average", {"club.loft": [0.1, 0.15, 0.2]}, output="never.csv"),
        "expected a tuple (low, high, count)",
    ),
    (
        lambda: longdrive.optimize(vary={"club.loft": (0.1, 0.2, 5)}),
        "club.loft in vary is a tuple of 3; expected (low, high)",
    ),
    (
        lambda: longdrive.chart(along={"swing.speed": [40.0, 45.0, 50.0]}),
        "expected (low, high); your own values go into at=…",
    ),
    (
        lambda: longdrive.optimize(distribution={}),
        "distribution is empty; give one or more, or leave it out",
    ),
    (
        lambda: longdrive.objective("mae494", "mean(carry)", distribution={}),
        "distribution is empty; give one or more, or leave it out",
    ),
    (lambda: longdrive.sensitivity(sigma={}), "sigma is empty; give one or more, or leave it out"),
    (
        lambda: longdrive.optimize(
            distribution="swing.speed=normal(50m/s,1m/s), swing.path=normal(0rad,0.03rad)"
        ),
        "it has a second distribution, swing.path=normal(0rad,0.03rad)",
    ),
    (
        lambda: longdrive.optimize(distribution={"swing.speed": np.array([49.0, 50.0, 51.0])}),
        "swing.speed in distribution is an ndarray of 3; expected a kind with its numbers",
    ),
    (
        lambda: longdrive.optimize(
            distribution={"swing.speed": ("normal", np.array([49.0, 50.0]), 1.0)}
        ),
        "swing.speed: array([49., 50.]) is an ndarray; expected a number",
    ),
    (
        lambda: longdrive.sensitivity(sigma={"swing.speed": np.array([1.0, 2.0])}),
        "swing.speed in sigma is an ndarray of 2; expected one number",
    ),
    (
        lambda: longdrive.optimize(maximize="mean(carry)"),
        "mean(carry) is a goal over many swings; give the swings too, with swings=FILE or",
    ),
    (lambda: longdrive.robust(minimize="std(lateral)"), "std(lateral) is a goal over many swings"),
    (
        lambda: longdrive.objective("mae494", "mean(carry)"),
        "of: mean(carry) is a goal over many swings; give the swings too, with swings or distribution",
    ),
    (lambda: np.asarray(TABLE), "a table is not a single array: use a column"),
    (
        lambda: TABLE[TABLE["carry"] > 0],
        "an ndarray is neither: index its columns, as in table['carry'][…]",
    ),
    (lambda: TABLE[["carry"]], "a list is neither: index its columns"),
    (
        lambda: longdrive.batch("mae494", {"club.loft": [0.1, None]}),
        "has dtype object (a NaN, not None, makes a row without a drive)",
    ),
    (
        lambda: longdrive.batch("mae494", [0.1]),
        "sweep(points=…) takes tables, with their units in the heads",
    ),
    (lambda: longdrive.Setup({"aero.cdo": 0.3}), "did you mean 'aero.cd0'?"),
    (
        lambda: longdrive.fly(LAUNCHES, overwrite=True),
        "overwrite is about a file, and no file is written; name one with output, or leave overwrite out",
    ),
    (lambda: longdrive.fly(LAUNCHES, overwrite="no"), "overwrite = 'no'; expected True or False"),  # type: ignore[arg-type]
    (
        lambda: longdrive.plot.trajectory("mae494", overwrite=True),
        "overwrite is about a file, and no file is written",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("call", "words"), REFUSED)
def test_likely_mistakes_are_refused_with_the_expected_value(
    call: Callable[[], Any], words: str
) -> None:
    with pytest.raises(InputError) as raised:
        call()
    assert words in str(raised.value)


def test_an_empty_list_of_constraints_is_no_constraint() -> None:
    assert longdrive.optimize("mae494", subject_to=[]).fun == longdrive.optimize("mae494").fun


def test_the_message_on_a_table_of_swings_lists_the_known_columns(tmp_path: Path) -> None:
    (tmp_path / "swings.csv").write_text("swing.speed [mph],tempo\n110,3\n")
    with pytest.raises(InputError, match="unknown column 'tempo'") as raised:
        longdrive.optimize(swings=tmp_path / "swings.csv")
    assert (
        "a column is a parameter, with its unit as in 'swing.speed [mph]'" in str(raised.value)
        and "sigma" not in str(raised.value)
    )


@pytest.mark.parametrize("swings", [{}, {"distribution": {"swing.path": ("normal", 0.0, 0.02)}}])
def test_a_search_without_a_result_has_arrays_of_the_right_shape(swings: dict[str, Any]) -> None:
    found = longdrive.optimize(
        {"swing.attack_angle": -1.2},
        vary={"club.loft": (0.1, 0.3), "swing.face_angle": (-0.1, 0.1)},
        **swings,
    )
    assert (
        (found.success, found.ended, found.optimum) == (False, "no-flight", None)
        and math.isnan(found.fun)
    )
    # x is the start: the setup's own values
    setup = longdrive.Setup({})
    assert (
        found.names == ["club.loft", "swing.face_angle"]
        and found.x.tolist() == [setup["club.loft"], setup["swing.face_angle"]]
    )
    assert (
        found.jac.shape == (2,)
        and np.isnan(found.jac).all()
        and found.setup["club.loft"] == setup["club.loft"]
    )


def test_a_data_frame_of_a_table_has_its_columns() -> None:
    pandas = pytest.importorskip("pandas")
    # NumPy would make one column of the names of a table's columns
    with pytest.raises(InputError, match=r"pandas.DataFrame\(dict\(table\)\)"):
        pandas.DataFrame(TABLE)
    frame = pandas.DataFrame(dict(TABLE))
    assert list(frame) == TABLE.keys() and (frame["carry"].to_numpy() == TABLE["carry"]).all()


def test_rows_without_a_value_are_omitted_from_deliveries_and_named() -> None:
    shots = {
        "ball_speed [mph]": [150.0, np.nan, 155.0],
        "launch_angle [deg]": [12.0, np.nan, 12.5],
        "spin [rpm]": [2600.0, np.nan, 2550.0],
    }
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = longdrive.delivery("modern-driver", shots=shots)
    assert any(
        "rows left out" in text and "row 2 (nothing is measured)" in text for text in found.warnings
    )
    assert len(caught) == 1 and found.warnings[0] in str(caught[0].message)


@pytest.mark.parametrize("off", [0, "no", np.float64(0)])
def test_switches_take_only_true_and_false(off: Any, tmp_path: Path) -> None:
    kept = tmp_path / "kept.toml"
    kept.write_text("mine")
    with pytest.raises(InputError, match="overwrite = .*; expected True or False"):
        longdrive.optimize(output=kept, overwrite=off)
    for call in (longdrive.batch, longdrive.sweep):
        points = {"club.loft": [0.2]} if call is longdrive.batch else {"club.loft": (0.1, 0.2, 3)}
        with pytest.raises(InputError, match="own_step = .*; expected True or False"):
            call("tour-average", points, own_step=off)
    assert kept.read_text() == "mine"


def test_switches_take_booleans_of_numpy(tmp_path: Path) -> None:
    kept = tmp_path / "kept.toml"
    kept.write_text("mine")
    with pytest.raises(InputError, match="exists"):
        longdrive.optimize(output=kept, overwrite=np.False_)
    assert kept.read_text() == "mine"
    longdrive.optimize(output=kept, overwrite=np.True_)
    assert kept.read_text() != "mine"


def test_values_that_are_missing_in_a_dict_of_columns_are_missing_rows() -> None:
    class NAType:
        """Like pandas.NA, which cannot be compared."""

        def __ne__(self, other: object) -> Any:
            return self

        def __bool__(self) -> bool:
            raise TypeError("boolean value of NA is ambiguous")

    shots = {"launch_angle [deg]": [11.0, 10.0], "spin [rpm]": [2500, 2400]}
    for missing in (NAType(), None, float("nan"), np.ma.masked):
        found = longdrive.fly({**shots, "ball_speed [mph]": [165, missing]})
        assert [row["flight"] for row in found["shots"]] == ["landed", "refused"]
    with pytest.raises(InputError, match="format = 'csv' is the format of a file"):
        longdrive.fly({**shots, "ball_speed [mph]": [165, 160]}, format="csv")


def test_a_masked_array_is_no_point_of_an_objective() -> None:
    with pytest.raises(InputError, match="masked"):
        longdrive.objective("tour-average", "carry", "club.loft").fun(np.ma.array([0.2], mask=[1]))


def test_messages_of_parts_name_the_argument(tmp_path: Path) -> None:
    import longdrive.parts

    good: dict[str, Any] = {
        "output": tmp_path / "parts", "parts": 2, "over": {"club.loft": (0.1, 0.3, 3000)}
    }
    for change, expected in [
        ({"parts": 0}, "parts = 0; expected a whole number of 1 or more"),
        ({"parts": "2"}, "parts = '2'"),
        ({"output": None}, "output is a NoneType; expected the name of a folder"),
        ({"points": {"club.loft": [0.2]}}, "points is a dict; expected the name of a file"),
        ({"retries": -1}, "retries = -1"),
        ({"processes": 1.5}, "processes = 1.5"),
    ]:
        with pytest.raises(InputError, match=expected):
            longdrive.parts.sweep("tour-average", **{**good, **change})
    with pytest.raises(InputError, match="needs output and parts"):
        longdrive.parts.sweep("tour-average", over=good["over"])
    with pytest.raises(InputError, match="manifests is a str"):
        longdrive.parts.merge("folder")
    assert longdrive.parts.SweepPlan.of(**good, highest="carry:3").words[-1] == "--highest=carry:3"
    assert not (tmp_path / "parts").exists()
