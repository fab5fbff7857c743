"""Arguments that users of NumPy, SciPy and pandas are used to: they work as in these libraries, or
the message names the accepted arguments."""

from __future__ import annotations

import copy
import math
import os
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import InputError, LongdriveWarning

YARD = 0.9144
SPREAD = "swing.path=normal(0deg,2deg)"
LOFT = "club.loft=6deg..16deg"


@pytest.fixture(scope="module")
def picture() -> Any:
    return longdrive.plot.trajectory("mae494")


@pytest.mark.parametrize(
    ("path", "words"),
    [
        (None, "^path is a NoneType; expected the name of a file$"),
        (3, "^path is an int; expected the name of a file$"),
        ("drive", "^path = 'drive': this plot is SVG; name a file that ends in .svg$"),
        (
            "drive.png",
            "name a file that ends in .svg, or make the plot with output='drive.png' to have it in that format$",
        ),
        (
            "no/such/drive.svg",
            "^the file 'no/such/drive.svg': it cannot be written: there is no folder 'no/such'$",
        ),
    ],
)
def test_a_picture_that_cannot_be_saved_says_why(picture: Any, path: Any, words: str) -> None:
    with pytest.raises(InputError, match=words):
        picture.save(path)


def test_a_picture_replaces_a_file_with_overwrite(picture: Any, tmp_path: Path) -> None:
    kept = tmp_path / "drive.SVG"
    kept.write_text("mine")
    with pytest.raises(InputError, match="it already exists; use overwrite=True to replace it"):
        picture.save(kept)
    assert kept.read_text() == "mine"
    assert picture.save(os.fspath(kept), overwrite=True).read_text(encoding="utf-8") == picture.svg
    (tmp_path / "folder.svg").mkdir()
    with pytest.raises(InputError, match="folder.svg': it cannot be written"):
        picture.save(tmp_path / "folder.svg", overwrite=True)


def test_a_loss_without_a_unit_is_si() -> None:
    for goal, text, number in [
        ({}, "2 yd", 2 * YARD),
        (
            {"maximize": "descent_angle", "vary": "swing.attack_angle=-5deg..5deg"},
            "2 deg",
            math.radians(2.0),
        ),
        ({"minimize": "spin", "vary": "swing.attack_angle=-5deg..0deg"}, "60 rpm", 2 * math.pi),
    ]:
        found = longdrive.optimum_sensitivity("mae494", **goal, loss=number)
        assert found.reply["window_loss"] == pytest.approx(number, rel=1e-15)
        for name, row in longdrive.optimum_sensitivity("mae494", **goal, loss=text).reply[
            "window"
        ].items():
            assert [found.reply["window"][name][end] for end in ("low", "high")] == pytest.approx(
                [row["low"], row["high"]], rel=1e-9
            )


@pytest.mark.parametrize(
    ("goal", "within"),
    [
        ({}, 1.5),
        ({"minimize": "landing_speed", "vary": "club.loft=10deg..25deg"}, 0.5),
        ({"maximize": "mean(carry) - 0.5*std(lateral)", "vary": LOFT, "distribution": SPREAD}, 1.5),
        # a share is a plain number, whatever the unit of its outcome
        ({"maximize": "within(lateral, 20yd)", "vary": LOFT, "distribution": SPREAD}, 0.1),
    ],
)
def test_a_within_value_without_a_unit_is_si(goal: dict[str, Any], within: float) -> None:
    found = longdrive.robust("mae494", model="aero.law=ferguson", **goal, within=within)
    assert found.reply["within"] == within


@pytest.mark.parametrize(
    "goal", [{}, {"minimize": "landing_speed", "vary": "club.loft=10deg..25deg"}]
)
def test_same_goal_at_a_robust_design_and_in_its_setup(goal: dict[str, Any]) -> None:
    found = longdrive.robust("mae494", model="aero.law=ferguson", **goal)
    outcome = goal.get("minimize", "carry")
    # within the tolerance of a search
    assert found.fun == pytest.approx(longdrive.simulate(found.setup)[outcome], abs=2e-6)
    assert found.jac is None


def test_same_goal_at_a_robust_design_over_swings_and_in_optimize() -> None:
    goal = "mean(carry) - 0.5*std(lateral)"
    found = longdrive.robust(
        "mae494", model="aero.law=ferguson", maximize=goal, vary=LOFT, distribution=SPREAD
    )
    alone = longdrive.objective("mae494", goal, ["club.loft"], distribution=SPREAD)
    assert found.fun == pytest.approx(alone.fun(found.x), abs=2e-6)


REFUSED: list[tuple[Callable[[], Any], str]] = [
    (
        lambda: longdrive.chart(
            "mae494", along={"swing.speed": (40.0, 50.0), "club.loft": (0.1, 0.2)}
        ),
        r"^along has 2 parameters \(swing.speed, club.loft\); expected one, as in along={'swing.speed': \(40.0, 50.0\)}",
    ),
    (
        lambda: longdrive.chart("mae494", along=["swing.speed=40m/s..50m/s", "air.density=1..1.2"]),
        r"^along has 2 parameters \(swing.speed, air.density\)",
    ),
    (
        lambda: longdrive.chart("mae494", along="swing.speed=40m/s..50m/s, air.density=1..1.2"),
        r"^along has 2 parameters \(swing.speed, air.density\)",
    ),
    (lambda: longdrive.plot.chart("mae494", along={}), "^along is empty"),
    (
        lambda: longdrive.sweep("mae494", {"club.loft": (0.1, 0.2, 3)}, sample=4),
        "^the range club.loft=0.1 rad..0.2 rad:3: sample says how many points there are; write .*, without a count$",
    ),
    (
        lambda: longdrive.sweep("mae494", {"club.loft": "4deg..20deg:3"}, sample=4),
        "write club.loft=4deg..20deg, or",
    ),
    (
        lambda: longdrive.objective("mae494", "mean(carry)", swings={"swing.speed [m/s]": [48.0]}),
        r"^swings is a dict; .*to_csv\('swings.csv', index=False\), and give that name; distribution takes dicts",
    ),
    (
        lambda: longdrive.optimize("mae494", maximize=["carry"]),
        "^maximize is a list; expected one outcome or goal, as in maximize='carry'$",
    ),
    (
        lambda: longdrive.optimize("mae494", minimize={"spin"}),
        "^minimize is a set; expected one outcome or goal",
    ),
    (
        lambda: longdrive.optimize("mae494", max_iterations=[3]),
        "^max_iterations is a list; expected a whole number$",
    ),
    (
        lambda: longdrive.optimize("mae494", output=3),
        "^output is an int; expected the name of a file$",
    ),
    (
        lambda: longdrive.optimize("mae494", checkpoint={}),
        "^checkpoint is a dict; expected the name of a file$",
    ),
    (
        lambda: longdrive.report("mae494", output=3),
        "^output is an int; expected the name of a folder$",
    ),
    (
        lambda: longdrive.optimize("mae494", tolerance=True),
        "^tolerance: True is a bool; expected a number",
    ),
    (
        lambda: longdrive.optimum_sensitivity("mae494", loss=[1.0]),
        r"^loss: \[1.0\] is a list; expected a number",
    ),
    (
        lambda: longdrive.optimize("mae494", vary=[("club.loft", 0.1, 0.3)]),
        r"^vary has a tuple in its list: \('club.loft', 0.1, 0.3\); expected texts, or one dict for all, as in vary={'club.loft': …}$",
    ),
    (
        lambda: longdrive.optimize("mae494", subject_to={"descent_angle": 0.6}),
        r"^subject_to is a dict; expected a text or a list of texts, as in subject_to=\['descent_angle >= 38 deg'\]$",
    ),
    (lambda: longdrive.reproduce("other"), "^invalid value 'other' for 'study'"),
    *[
        (lambda off=off: longdrive.optimize("mae494", progress=off), "^progress = .*; expected True or False, or a function of parts done and parts in all$")  # type: ignore[misc]
        for off in (0, 1, "yes")
    ],
    (
        lambda: longdrive.batch("mae494", {"club.loft": [0.2]}, progress=0),
        "^progress = 0; expected True or False, or a function",
    ),
    (
        lambda: longdrive.sweep("mae494", {"club.loft": (0.1, 0.2, 3)}, progress=0),
        "^progress = 0; expected True or False, or a function",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("call", "words"), REFUSED)
def test_messages_on_refused_arguments_list_the_accepted_ones(
    call: Callable[[], Any], words: str
) -> None:
    with pytest.raises(InputError, match=words):
        call()


def test_one_parameter_in_a_list_is_one() -> None:
    def points(along: Any, at: Any) -> Any:
        return longdrive.chart("mae494", along=along, at=at).points

    wanted = points("swing.speed", ["45 m/s", "50 m/s"])
    assert points(["swing.speed"], [45.0, 50.0]) == wanted
    assert points("swing.speed", np.array([45.0, 50.0])) == wanted


@pytest.mark.parametrize("off", [None, False, np.False_])
def test_progress_none_prints_nothing(off: Any) -> None:
    assert longdrive.optimize("mae494", progress=off).success


def test_a_quantity_of_pint_is_a_loss(unit: Any) -> None:
    found = longdrive.optimum_sensitivity("mae494", loss=2 * unit.yard)
    assert found.reply["window_loss"] == pytest.approx(2 * YARD, rel=1e-15)
    with pytest.raises(InputError, match="^loss: .*gram"):
        longdrive.optimum_sensitivity("mae494", loss=2 * unit.gram)


def test_a_launch_of_a_dict_and_of_the_arguments_is_refused() -> None:
    launch = {"ball_speed": "150 mph", "launch_angle": "12 deg", "backspin": "2600 rpm"}
    setup = {"launch": launch}
    assert longdrive.delivery(setup).status == "done"
    with pytest.raises(
        InputError,
        match=r"^launch\.ball_speed, .* of the setup: ball_speed give the measured launch",
    ):
        longdrive.delivery(setup, ball_speed="160 mph")


def test_a_club_value_of_a_dict_counts_as_measured() -> None:
    found = longdrive.delivery(
        {"swing.speed": "95 mph"}, ball_speed="140 mph", launch_angle="12 deg", backspin="2600 rpm"
    )
    known = {row["parameter"]: row for row in found["rows"][0]["known"]}
    assert "the error of a launch monitor's club values" in known["swing.speed"]["source"]
    assert "how golfers differ" in known["swing.attack_angle"]["source"]


def test_a_coefficient_of_a_dict_that_another_law_lacks_is_named() -> None:
    lost = "aero.cd0 as given has no effect in the model 'aero.law=ferguson'"
    with pytest.warns(LongdriveWarning, match=lost):
        longdrive.robust({"aero.cd0": 0.2})


DEGREES: list[Callable[[], Any]] = [
    lambda: longdrive.optimize("mae494", vary={"club.loft": (4, 20)}),
    lambda: longdrive.sweep("mae494", {"club.loft": (4.0, 20.0, 5)}),
    lambda: longdrive.chart(
        "mae494", along="club.loft", at=[0.1, 20], vary="swing.attack_angle=-5deg..5deg"
    ),
    lambda: longdrive.delivery(ball_speed=67.0, launch_angle=20, spin=260.0),
    lambda: longdrive.optimize("mae494", distribution={"swing.attack_angle": ("uniform", 0, 20)}),
]


@pytest.mark.parametrize("call", DEGREES)
def test_a_large_angle_without_a_unit_suggests_degrees(call: Callable[[], Any]) -> None:
    with pytest.raises(
        InputError,
        match=r' = 1145.916 deg \(20(\.0)? rad\) is outside its range .*; a number without a unit is SI; did you mean "20 deg"\?$',
    ):
        call()


def test_an_angle_with_a_unit_has_no_warning() -> None:
    for low in (0.1, "4 deg"):
        with pytest.raises(InputError, match="outside its range") as raised:
            longdrive.optimize("mae494", vary={"club.loft": (low, "95 deg")})
        assert "did you mean" not in str(raised.value)


def test_a_missing_attribute_names_where_it_is() -> None:
    drive, table = longdrive.simulate("mae494", of="spin"), longdrive.batch(
        "mae494", {"club.loft": [0.2]}
    )
    for call, words in [
        (
            lambda: drive.spin,
            r"^a Drive has no attribute 'spin'; read an outcome by its name, as in drive\['spin'\]$",
        ),
        (
            lambda: table.carry,
            r"^a Table has no attribute 'carry'; read a column by its name, as in table\['carry'\]; pandas",
        ),
        (
            lambda: table.to_numpy(),
            r"no attribute 'to_numpy'; .*; pandas.DataFrame.from_arrow\(table\)",
        ),
    ]:
        with pytest.raises(AttributeError, match=words):
            call()
    assert not hasattr(drive, "spin") and getattr(table, "carry", None) is None
    assert pickle.loads(pickle.dumps(drive)) == copy.deepcopy(drive) == drive
    assert copy.copy(table) == pickle.loads(pickle.dumps(table)) == table


def test_quantities_of_pint_are_points_of_a_batch(unit: Any) -> None:
    speeds = np.array([100.0, 110.0])
    table = longdrive.batch(
        "mae494",
        {"swing.speed": speeds * unit.mph, "club.loft": 12 * unit.deg},
        tolerance=1 * unit.mm,
    )
    # a mile is 1609.344 m
    wanted = longdrive.batch(
        "mae494",
        {"swing.speed": speeds * (1609.344 / 3600), "club.loft": np.full(2, math.radians(12.0))},
        tolerance=1e-3,
    )
    assert table["swing.speed"] == pytest.approx(wanted["swing.speed"], rel=1e-15)
    assert table["carry"] == pytest.approx(wanted["carry"], rel=1e-12)
    with pytest.raises(InputError, match="^points: swing.speed: .*gram"):
        longdrive.batch("mae494", {"swing.speed": speeds * unit.gram})
    with pytest.raises(InputError, match="did you mean 'swing.speed'"):
        longdrive.batch("mae494", {"swing.sped": speeds * unit.mph})
    with pytest.raises(InputError, match="^tolerance = True; expected a length"):
        longdrive.batch("mae494", {"swing.speed": speeds}, tolerance=True)


def test_a_pint_column_of_a_table_is_refused_with_the_way_to_name_its_unit(unit: Any) -> None:
    speeds = np.array([70.0]) * unit.meter
    with pytest.raises(
        InputError,
        match=r"^shots: the column 'ball_speed \[mph\]' is a Quantity; the head of a column names the unit, so give the numbers",
    ):
        longdrive.fly(
            {"ball_speed [mph]": speeds, "launch_angle [deg]": [11.0], "spin [rpm]": [2500.0]}
        )


def test_tables_of_a_generator_are_joined() -> None:
    tables = [longdrive.batch("mae494", {"club.loft": [loft]}) for loft in (0.1, 0.2)]
    assert longdrive.Table.concatenate(
        table for table in tables
    ) == longdrive.Table.concatenate(tables)
    with pytest.raises(InputError, match="^tables is an int; expected several tables"):
        longdrive.Table.concatenate(3)  # type: ignore[arg-type]
