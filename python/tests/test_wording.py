"""Messages in Python: arguments in place of options, and no temporary files."""

from __future__ import annotations

import json
import logging
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import InputError, parts
from longdrive._longdrive import in_python


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("`subject_to`: expected a limit", "subject_to: expected a limit"),
        (
            "it already exists; use `overwrite` to replace it",
            "it already exists; use overwrite=True to replace it",
        ),
        ("as in `vary club.loft=4deg..20deg`", 'as in vary="club.loft=4deg..20deg"'),
        ('with `subject_to "head_mass <= 205 g"`', 'with subject_to="head_mass <= 205 g"'),
        (
            "with `swings FILE` or `distribution NAME=KIND(…)`",
            'with swings=FILE or distribution="NAME=KIND(…)"',
        ),
        (
            "give two with `maximize` and `minimize`, for example `maximize carry`",
            'give two with maximize and minimize, for example maximize="carry"',
        ),
        ("write for example `width 800`", "write for example width=800"),
        (
            "name it with `set ground.turf=average`, or another",
            'name it with setup.replace({"ground.turf": "average"}), or another',
        ),
        (
            'set it, for example `set club.mass="205 g"`',
            'set it, for example setup.replace({"club.mass": "205 g"})',
        ),
        (
            "check the club (`set`) and the ranges (`vary`)",
            "check the club (setup.replace({…})) and the ranges (vary)",
        ),
        ("add it to `outcomes`", "add it to of"),
        (
            "name a file with `output`, or take `format csv`",
            'name a file with output, or take format="csv"',
        ),
        ("`parameters()` lists them all", "longdrive.parameters() lists them all"),
        ("`plot laws()` draws them", "longdrive.plot.laws() draws them"),
        # unchanged: commands for a shell, options that only the program has, and texts that are no
        # arguments
        (
            "'longdrive optimize a.toml --vary club.loft=4deg..20deg' finds",
            "'longdrive optimize a.toml --vary club.loft=4deg..20deg' finds",
        ),
        ("the summary of `json`", "the summary of --json"),
        ("the file 'a`b`.csv', expected `=`", "the file 'a`b`.csv', expected `=`"),
    ],
)
def test_mentions_are_written_as_arguments(text: str, words: str) -> None:
    assert in_python(text) == words


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: longdrive.optimize(subject_to="apex_height <= 30"), "subject_to: "),
        (
            lambda: longdrive.optimize(correlation={("swing.path", "swing.speed"): 0.5}),
            r'swings=FILE or distribution="NAME=KIND\(…\)"',
        ),
        (
            lambda: longdrive.optimize(distribution={"swing.speed": ("normal", 50.0, -1.0)}),
            "the distribution swing.speed=normal",
        ),
        (lambda: longdrive.optimize(maximize="carry", minimize="carry"), "a search has one goal"),
        (lambda: longdrive.pareto(maximize="carry"), "give them with maximize and minimize"),
        (lambda: longdrive.uncertainty(samples=-3), "samples"),
        (lambda: longdrive.plot.trajectory(width=10), "width=800"),
        (lambda: longdrive.sensitivity(maximize="carry"), "add at_optimum=True"),
        (
            lambda: longdrive.chart(along="club.loft=5deg..9deg", vary={"club.loft": (0.1, 0.2)}),
            "take it out of",
        ),
        (lambda: longdrive.design("tour-average"), 'rules="none"'),
        (lambda: longdrive.Setup({"club.lofft": 1}), r"longdrive\.parameters\(\) lists them all"),
        (
            lambda: longdrive.batch(None, {"club.lofft": [1.0]}),
            r"longdrive\.parameters\(\) lists them all",
        ),
    ],
)
def test_no_message_of_a_command_names_an_option_of_the_command_line(
    call: Callable[[], Any], words: str
) -> None:
    with pytest.raises(InputError, match=words) as raised:
        call()
    assert not re.search(r"(?<![\w-])--[a-z]", str(raised.value)), raised.value


@pytest.mark.parametrize(
    "call",
    [
        lambda: longdrive.gradient(wrt="swing.shaft_droop"),
        lambda: longdrive.objective(wrt="swing.shaft_droop"),
        lambda: longdrive.batch(None, {"club.loft": [0.2]}, wrt="swing.shaft_droop"),
        lambda: longdrive.verify(wrt="swing.shaft_droop"),
    ],
)
def test_the_message_on_a_missing_value_names_replace(call: Callable[[], Any]) -> None:
    with pytest.raises(
        InputError, match=r"swing.shaft_droop.*; give it a value with setup\.replace\(\{…\}\)"
    ):
        call()


SHOTS = {
    "ball_speed [m/s]": [60.0, 65.0, 70.0],
    "launch_angle [deg]": [10.0, 11.0, 12.0],
    "backspin [rpm]": [2500.0, 2600.0, 2700.0],
}


def test_no_answer_names_a_missing_file(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    caplog.set_level(logging.INFO)
    carry = {**SHOTS, "carry [m]": [180.0, 200.0, 221.0]}
    mine = {"preset": "modern-driver", "club.loft": 0.17}
    answers = [
        longdrive.fly(SHOTS),
        longdrive.calibrate(
            carry, {"preset": "modern-driver", "aero.law": "robinson"}, fit="aero.cd0"
        ),
        longdrive.delivery(shots={name: values for name, values in SHOTS.items()}),
        longdrive.compare("tour-average", mine),
        longdrive.plot.trajectory(mine),
        longdrive.optimize(
            longdrive.Setup(mine),
            swings={
                "swing.speed [m/s]": list(np.linspace(48, 52, 12)),
                "swing.path [rad]": list(np.linspace(-0.02, 0.02, 12)),
            },
        ),
    ]
    for answer in answers:
        message = json.dumps(
            {
                name: value for name, value in answer.items() if isinstance(
                    value, (str, dict, list, type(None))
                )
            },
            default=str,
        )
        assert "longdrive-" not in message, message
    assert answers[0].file is None and answers[4].file is None
    assert answers[1].data["file"] == "data"
    assert not [
        record.getMessage() for record in caplog.records if "/longdrive-" in record.getMessage()
    ]


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (
            lambda: longdrive.fly(
                {**SHOTS, "nonsense [kg]": [1.0, 2.0, 3.0], "backspin [deg]": [1.0, 2.0, 3.0]}
            ),
            "^shots",
        ),
        (
            lambda: longdrive.calibrate({**SHOTS, "carry [kg]": [1.0, 2.0, 3.0]}, fit="aero.cd0"),
            "^data",
        ),
        (lambda: longdrive.sweep(points={"club.loft [kg]": [0.1]}), "^points"),
        (lambda: longdrive.sweep(points={"club.lofft [rad]": [0.1]}, output="never.csv"), "^points"),
    ],
)
def test_messages_name_a_table_by_its_argument(
    call: Callable[[], Any], words: str
) -> None:
    with pytest.raises(InputError, match=words) as raised:
        call()
    assert "longdrive-" not in str(raised.value)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (
            lambda: longdrive.calibrate(None, fit="aero.cd0"),
            "data is None, and calibrate needs it: Measured shots",
        ),
        (
            lambda: longdrive.calibrate(SHOTS, fit=None),
            "fit is None, and calibrate needs it: .*parameter",
        ),
        (lambda: longdrive.chart(along=None), "along is None, and chart needs it: .*range"),
        (lambda: longdrive.report(output=None), "output is None, and report needs it"),
        (lambda: longdrive.reproduce(None), "study is None, and reproduce needs it"),
        (lambda: longdrive.fly(None), "shots is None, and fly needs it"),
        (
            lambda: longdrive.Setup({"club.loft": None}),
            "'club.loft' is None, and cannot be unset; expected a number in rad, or a text with its unit like \"9.8 deg\"",
        ),
        (
            lambda: longdrive.Setup({"impact.restitution": None}),
            "'impact.restitution' is None, and cannot be unset; expected a number, or",
        ),
        (
            lambda: longdrive.Setup({"aero.table": None}),
            "'aero.table' is None, .*expected the name of a CSV file with a table of drag and lift",
        ),
        (lambda: longdrive.objective(None, None), "of is a NoneType; expected one name"),
        (lambda: longdrive.objective(None, 3), "of is an int; expected one name"),
        (lambda: longdrive.Setup.read(None), "path is a NoneType; expected the name of a file"),
        (
            lambda: longdrive.Setup.from_toml(None),
            "text is a NoneType; expected the text of a setup file",
        ),
        (
            lambda: longdrive.optimize(vary={"club.loft": (None, 0.2)}),
            "club.loft has None where a value is needed",
        ),
        (
            lambda: longdrive.Table.concatenate([longdrive.batch(None, {"club.loft": [0.2]}), None]),
            "table 2 is a NoneType; expected a Table",
        ),
        (
            lambda: longdrive.Setup().replace({"aero.law": None}),
            "'aero.law' is None, .*a name in quotes",
        ),
    ],
)
def test_the_message_on_none_names_the_argument_and_the_expected_value(
    call: Callable[[], Any], words: str
) -> None:
    with pytest.raises(InputError, match=words):
        call()


@pytest.mark.parametrize(
    ("look", "words"),
    [
        (
            lambda: longdrive.Setup()["club.lofft"],
            "unknown parameter 'club.lofft'; did you mean 'club.loft'",
        ),
        (lambda: longdrive.Setup()[3], "3 is no name of a setup"),
        (lambda: longdrive.Setup()["ground.turf"], "only chooses the other numbers of the ground"),
        (lambda: longdrive.simulate()["cary"], "unknown outcome 'cary'; did you mean 'carry'"),
        (
            lambda: longdrive.simulate(of="spin")["carry"],
            "'carry' was not requested; this drive has spin; add 'carry' to of",
        ),
        (
            lambda: longdrive.batch(None, {"club.loft": [0.2]})["cary"],
            "unknown column 'cary'; did you mean 'carry'",
        ),
        (
            lambda: longdrive.batch(None, {"club.loft": [0.2]}).derivative("carry", "club.loft"),
            "no derivatives by 'club.loft'; it has none; ask for others with wrt, as in wrt='club.loft'",
        ),
        (
            lambda: longdrive.batch(None, {"club.loft": [0.2]}, wrt="points").derivative(
                "carry", "club.lofft"
            ),
            "unknown parameter 'club.lofft'; did you mean 'club.loft'",
        ),
        (lambda: longdrive.simulate()["head_mass"], "'head_mass' was not requested"),
        (
            lambda: longdrive.batch(None, {"club.loft": [0.2]}, wrt="points").derivative(
                "carry", "gravity"
            ),
            "it has those by club.loft; ask for others with wrt",
        ),
        (
            lambda: longdrive.batch(None, {"club.loft": [0.2]}, wrt="points").derivative(
                "cary", "club.loft"
            ),
            "unknown outcome 'cary'; did you mean 'carry'",
        ),
        (
            lambda: longdrive.batch(None, {"club.loft": [0.2]}, wrt="points").derivative(
                "spin", "club.loft"
            ),
            "the table has carry; ask for others with of",
        ),
    ],
)
def test_an_unknown_key_is_a_key_error_with_the_nearest_name(
    look: Callable[[], Any], words: str
) -> None:
    with pytest.raises(KeyError, match=words) as raised:
        look()
    # it is also a KeyError, which Python expects of a mapping
    assert (
        isinstance(raised.value, longdrive.UnknownKeyError) and isinstance(raised.value, InputError)
    )
    assert not str(raised.value).startswith(("'unknown", '"'))


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (
            lambda: longdrive.gradient(wrt=["club.loft", None]),
            r"^wrt\[1\] is a NoneType; expected a name$",
        ),
        (
            lambda: longdrive.objective(wrt=("club.loft", 3)),
            r"^wrt\[1\] is an int; expected a name$",
        ),
        (
            lambda: longdrive.simulate(of=[["carry"], "spin"]),
            r"^of\[0\] is a list; expected a name$",
        ),
        (
            lambda: longdrive.batch(None, {"club.loft": [0.2]}, wrt=["club.loft", None]),
            r"^wrt\[1\] is a NoneType",
        ),
        (
            lambda: longdrive.gradient(wrt={"club.loft"}),
            "^wrt is a set; expected a name or a list of names$",
        ),
        (
            lambda: parts.SweepPlan.of(output="never", parts=1, of=["carry", None]),
            r"^of\[1\] is a NoneType; expected a name$",
        ),
    ],
)
def test_the_message_on_a_wrong_element_has_its_index(
    call: Callable[[], Any], words: str
) -> None:
    with pytest.raises(InputError, match=words):
        call()


def test_the_message_on_an_unknown_outcome_lists_all_outcomes() -> None:
    rows = {row["name"]: row for row in longdrive.outcomes()}
    assert {row["part"] for row in rows.values()} == {"launch", "flight", "head"}
    drive = longdrive.simulate("modern-driver", of=list(rows))
    assert (
        list(drive) == list(rows)
        and drive["head_mass"] == longdrive.Setup("modern-driver")["club.mass"]
    )
    # outcomes that no swing changes must be named
    assert list(longdrive.simulate("modern-driver")) == [
        name for name, row in rows.items() if row["part"] != "head"
    ]


def test_get_of_a_mapping_has_its_default() -> None:
    drive = longdrive.simulate(of="carry")
    assert drive.get("cary") is None and drive.get("cary", 3.0) == 3.0 and "cary" not in drive


def test_the_message_on_a_file_as_preset_names_the_function_that_reads_it() -> None:
    with pytest.raises(
        InputError,
        match=r'"mine.toml" is a file, not a preset; Setup.read\("mine.toml"\) reads it',
    ):
        longdrive.Setup("mine.toml")
    with pytest.raises(InputError, match="Setup.read"):
        longdrive.simulate("mine.toml")


def test_outcomes_of_a_drive_cannot_be_changed() -> None:
    drive = longdrive.simulate(of=["carry", "spin"])
    kept = (hash(drive), drive["carry"])
    with pytest.raises(TypeError):
        drive.outcomes["carry"] = 1.0  # type: ignore[index]
    assert (hash(drive), drive["carry"]) == kept


def test_tables_with_different_columns_are_not_joined() -> None:
    points = {"club.loft": [0.15, 0.16]}
    table = longdrive.batch("tour-average", points)
    others = {
        "differ in outcomes: carry and spin": longdrive.batch("tour-average", points, of="spin"),
        "differ in derivatives by: none and club.loft": longdrive.batch(
            "tour-average", points, wrt="club.loft"
        ),
        "differ in parameters of the points: club.loft and swing.speed": longdrive.batch(
            "tour-average", {"swing.speed": [45.0]}
        ),
        "are of different setups: swing.speed = .* and 45.0": longdrive.batch(
            {"preset": "tour-average", "swing.speed": 45.0}, points
        ),
    }
    for words, other in others.items():
        with pytest.raises(InputError, match=words):
            longdrive.Table.concatenate([table, other])
    assert len(
        longdrive.Table.concatenate([table, longdrive.batch("tour-average", {"club.loft": [0.17]})])
    ) == 3


def test_design_begins_with_the_programs_preset() -> None:
    found = longdrive.design(max_iterations=1)
    assert found.setup.preset == "modern-driver"


RECORDED = {"swing.speed [m/s]": [48.0, 49.0, 50.0, 51.0]}
ATTACK = "swing.attack_angle=truncated(-1deg,2deg,-5deg,3deg)"


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (
            lambda: longdrive.optimize(vary={}),
            "^vary is empty; give one or more, or leave it out: A parameter to vary, with its range, .*default: loft 4 to 20 deg",
        ),
        (lambda: longdrive.optimize(vary=[]), "^vary is empty"),
        (lambda: longdrive.robust(model=[]), "^model is empty"),
        (
            lambda: longdrive.calibrate(SHOTS, fit=[]),
            "^fit is empty; give one or more: A parameter to fit",
        ),
        (lambda: longdrive.compare("mae494", "tour-average", of=[]), "^of is empty"),
        (
            lambda: longdrive.sweep("mae494", {"club.loft": (0.1, 0.2, 3)}, seed=4),
            "^seed = 4 chooses the points of a sample, and nothing is sampled",
        ),
        (
            lambda: longdrive.sweep("mae494", {"club.loft": (0.1, 0.2, 3)}, seed=-4),
            "^seed = -4; expected a whole number of 0 or more",
        ),
        (
            lambda: parts.SweepPlan.of(
                "mae494", output="a", parts=1, over={"club.loft": (0.1, 0.2, 3)}, seed=4
            ),
            "^seed = 4 chooses the points",
        ),
        (
            lambda: longdrive.optimize(distribution=ATTACK, vary="club.loft=4deg..20deg", seed=4),
            "^seed: smooth goals over up to 3 distributed parameters are integrated.*give scenarios",
        ),
        (
            lambda: longdrive.objective("mae494", "mean(carry)", distribution=ATTACK, seed=4),
            "^seed: smooth goals over up to 3 distributed parameters are integrated",
        ),
        (
            lambda: longdrive.robust(swings=RECORDED, vary="club.loft=4deg..20deg", seed=4),
            "^seed: recorded swings are the scenarios themselves",
        ),
    ],
)
def test_arguments_without_effect_are_refused_by_a_search(call: Callable[[], Any], words: str) -> None:
    with pytest.raises(InputError, match=words):
        call()


def test_empty_lists_are_accepted_where_they_have_a_meaning() -> None:
    # no constraints, no correlations
    assert longdrive.optimize("mae494", subject_to=[], correlation=[]).success
    assert len(longdrive.sweep("mae494", {"club.loft": (0.1, 0.2)}, sample=4, seed=4)) == 4


@pytest.mark.parametrize("shape", [tuple, list, np.array])
def test_a_range_is_any_sequence_of_two_numbers(shape: Callable[[Any], Any]) -> None:
    ends = np.radians([4.0, 20.0])
    wanted = longdrive.optimize(
        "mae494", vary=f"club.loft={float(ends[0])!r} rad..{float(ends[1])!r} rad"
    )
    assert (longdrive.optimize("mae494", vary={"club.loft": shape(ends)}).x == wanted.x).all()
    sample = longdrive.sweep("mae494", {"club.loft": shape([0.1, 0.2])}, sample=4)
    assert (
        sample["carry"] == longdrive.sweep("mae494", {"club.loft": (0.1, 0.2)}, sample=4)["carry"]
    ).all()
    chart = longdrive.chart(
        "mae494",
        along="swing.speed",
        at=shape([45.0, 47.0, 50.0]),
        vary={"club.loft": shape(ends)},
    )
    assert [point["at"] for point in chart.points] == [45.0, 47.0, 50.0]


@pytest.mark.parametrize(
    "given", [{4.0, 20.0}, 3, [0.1], [0.1, 0.2, 0.3, 0.4], [0.1, None], [0.1, 0.2, 2.5]]
)
def test_wrong_ranges_are_refused(given: Any) -> None:
    with pytest.raises(InputError, match="club.loft|expected"):
        longdrive.sweep("mae494", {"club.loft": given})


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (
            lambda: longdrive.objective(None, "carry >= 3 yd", distribution=ATTACK),
            "^of: 'carry >= 3 yd' is no measure",
        ),
        (
            lambda: longdrive.objective(None, "mean(cary)", distribution=ATTACK),
            "^of: unknown outcome 'cary'; did you mean 'carry'",
        ),
        (
            lambda: longdrive.objective(None, "strokes(400yd)", distribution=ATTACK),
            "^of: expected strokes need a table; give its file with strokes=FILE",
        ),
        (
            lambda: longdrive.objective(None, "mean(carry)", distribution=ATTACK, strokes={}),
            r"^strokes is a dict; expected the name of a file, which an objective reads again .*to_csv\('strokes.csv', index=False\)",
        ),
        (
            lambda: longdrive.objective(None, "carry", strokes="a.csv"),
            "^strokes: it is about many swings",
        ),
        (lambda: longdrive.optimize(vary=3), "^vary is an int; expected"),
        (lambda: longdrive.batch("mae494", 3), "^points is an int; expected"),
        (lambda: longdrive.Setup(3), "a setup cannot be made of an int;"),
        (lambda: longdrive.gradient(wrt=3), "^wrt is an int; expected"),
    ],
)
def test_a_message_names_arguments_that_the_function_has(
    call: Callable[[], Any], words: str
) -> None:
    with pytest.raises(InputError, match=words) as raised:
        call()
    assert "subject_to" not in str(raised.value)
