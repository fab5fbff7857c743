"""Sweeps from Python: the rows of the program."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

import longdrive

OVER = {"club.loft": ("6 deg", 0.3, 41), "swing.attack_angle": (-0.1, 0.1, 50)}


def rows_of(file: Path) -> dict[str, list[str]]:
    with file.open(newline="", encoding="utf-8") as text:
        rows = list(csv.DictReader(text))
    return {head: [row[head] for row in rows] for head in rows[0]}


@pytest.mark.parametrize(
    "question",
    [
        {"over": OVER},
        {"over": {name: ends[:2] for name, ends in OVER.items()}, "sample": 3000, "seed": 7},
    ],
)
def test_same_rows_in_memory_and_in_a_file(question, tmp_path):
    table = longdrive.sweep("mae494", **question, of=["carry", "lateral"], wrt="points")
    answer = longdrive.sweep(
        "mae494", **question, of=["carry", "lateral"], wrt="points", output=tmp_path / "rows.csv"
    )
    rows = rows_of(tmp_path / "rows.csv")
    assert answer.rows == len(table) == len(rows["status"])
    assert rows["status"] == [longdrive.Status(code).label for code in table.status]
    columns = [head for head in rows if head != "status"]
    names = [name for name in table.keys() if name != "status"]
    assert len(columns) == len(names)
    for head, name in zip(columns, names):
        read = np.array([float(cell) if cell else np.nan for cell in rows[head]])
        np.testing.assert_array_equal(read, table[name], err_msg=name)


@pytest.mark.parametrize("wrt", ["points", ["points"], ("points",), np.array(["points"])])
def test_derivatives_by_the_swept_parameters_in_a_file(wrt, tmp_path):
    over = {"club.loft": ("6 deg", "12 deg", 3)}
    longdrive.sweep("mae494", over, wrt=wrt, output=tmp_path / "rows.csv")
    heads = ["club.loft [rad]", "status", "carry [m]", "d_carry/d_club.loft [m/rad]"]
    assert list(rows_of(tmp_path / "rows.csv")) == heads
    plan = longdrive.parts.SweepPlan.of("mae494", over=over, wrt=wrt, output=tmp_path, parts=1)
    assert "--gradient" in plan.words and "--wrt" not in plan.words


def test_a_table_of_points_is_flown():
    loft = np.radians([8.0, 9.0, 10.0])
    table = longdrive.sweep("tour-average", points={"club.loft [rad]": loft}, wrt="club.loft")
    np.testing.assert_array_equal(table["club.loft"], loft)
    assert table.gradients.shape == (3, 1, 1)


def test_bad_ranges_get_the_programs_message(tmp_path):
    for output in (None, tmp_path / "rows.csv"):
        with pytest.raises(longdrive.InputError, match=r"did you mean 'club\.loft'\?"):
            longdrive.sweep(over={"club.lofft": ("1 deg", "2 deg", 3)}, output=output)
        with pytest.raises(longdrive.InputError):
            longdrive.sweep(over={"club.loft": ("1 deg", "2 deg")}, output=output)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"over": OVER, "points": {"club.loft [rad]": [0.2]}}, "keep one of the two"),
        ({"points": {"club.loft [rad]": [0.2]}, "sample": 9}, "keep one of the two"),
        ({"over": OVER, "resume": True}, "about a file"),
        ({"over": OVER, "overwrite": True}, "about a file"),
        (
            {"over": {"club.loft": (0.1, 0.2)}, "sample": 0},
            "sample = 0; expected a whole number of 1 or more",
        ),
        (
            {"over": {"club.loft": (0.1, 0.2)}, "sample": 3, "seed": -1},
            "seed = -1; expected a whole number of 0 or more",
        ),
        ({"over": OVER, "threads": -2}, "threads = -2; expected"),
        ({"over": OVER, "threads": 1.5}, "threads = 1.5; expected"),
        ({}, "nothing to sweep"),
    ],
)
def test_arguments_without_effect_are_refused(given, words):
    with pytest.raises(longdrive.InputError, match=words):
        longdrive.sweep("tour-average", **given)


def test_a_file_that_exists_is_kept(tmp_path):
    file = tmp_path / "rows.csv"
    file.write_text("mine", encoding="utf-8")
    with pytest.raises(longdrive.InputError, match="overwrite"):
        longdrive.sweep(over=OVER, output=file)
    assert file.read_text(encoding="utf-8") == "mine"
