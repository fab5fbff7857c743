"""Angles without a unit: radians, degrees by ``angles="deg"``, and a warning for likely degrees."""

from __future__ import annotations

import math
import re
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import longdrive
import longdrive.parts
from longdrive import InputError, LongdriveWarning, Setup

SMALL = {"swing.path": 1, "swing.face_angle": 1}

SUSPICIOUS: list[Callable[[], Any]] = [
    lambda: Setup(SMALL),
    lambda: Setup().replace({"swing.path": 0.6}),
    lambda: Setup() | SMALL,
    lambda: longdrive.simulate(SMALL),
    lambda: longdrive.batch(None, {"swing.path": [0.0, 1.0, -1.0]}),
    lambda: longdrive.batch(None, {"swing.path": 1}),
    lambda: longdrive.sweep(None, {"swing.attack_angle": (0.0, 1.0, 3)}),
    lambda: longdrive.optimize("mae494", vary={"swing.attack_angle": (-1, 1)}),
    lambda: longdrive.optimize({"preset": "mae494", "swing.path": 0.7}),
    lambda: longdrive.delivery(ball_speed=67.0, launch_angle=0.8, spin=260.0),
]


@pytest.mark.parametrize("call", SUSPICIOUS)
def test_a_large_bare_angle_warns_at_the_line_that_gave_it(call: Callable[[], Any]) -> None:
    with pytest.warns(LongdriveWarning) as caught:
        try:
            call()
        except longdrive.Error:
            pass
    warning = next(one for one in caught if "1 rad is 57.3°; write '" in str(one.message))
    assert warning.filename == __file__
    assert " deg'" in str(warning.message) and "angles='deg'" in str(warning.message)


def test_exact_message_names_parameter_value_and_text_to_write() -> None:
    with pytest.warns(LongdriveWarning) as caught:
        setup = Setup(SMALL)
    message = (
        "swing.path = 1 is 1 rad: 1 rad is 57.3°; write '1 deg', or angles='deg', if degrees are "
        "meant"
    )
    assert str(caught[0].message).split("\n")[0] == message
    assert isinstance(caught[0].message, LongdriveWarning) and caught[0].message.answer == setup


SOUND: list[Callable[[], Any]] = [
    lambda: Setup({"club.loft": 0.2, "swing.attack_angle": -0.05}),
    lambda: Setup({"club.loft": math.radians(40)}),
    lambda: Setup(Setup({"club.loft": "40 deg", "wind.from": "200.5 deg", "wind.speed": 3}).to_dict()),
    lambda: Setup({"swing.speed": 50, "club.loft": "40 deg"}),
    lambda: longdrive.batch(None, {"club.loft": np.radians(np.linspace(5, 40, 36))}, of="spin"),
    lambda: longdrive.sweep(None, {"club.loft": ("8 deg", "40 deg", 3)}, of="spin"),
]


@pytest.mark.parametrize("call", SOUND)
def test_a_sound_angle_does_not_warn(call: Callable[[], Any]) -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        call()
    assert not [one for one in caught if "57.3°" in str(one.message)]


def test_same_results_in_degrees_and_radians() -> None:
    degrees = Setup({"club.loft": 10.5, "swing": {"path": -2}}, angles="deg")
    texts = Setup({"club.loft": "10.5 deg", "swing.path": "-2 deg"})
    assert degrees == texts
    assert texts.replace({"club.loft": 11}, angles="deg") == texts.replace({"club.loft": "11 deg"})
    loft = [8.0, 10.0, 12.0]
    table = longdrive.batch(None, {"club.loft": loft, "swing.speed": 50.0}, angles="deg")
    same = longdrive.batch(None, {"club.loft": np.radians(loft), "swing.speed": 50.0})
    assert np.array_equal(table["carry"], same["carry"])
    swept = longdrive.sweep(None, {"club.loft": (8, 12, 3)}, angles="deg")
    np.testing.assert_allclose(swept["club.loft"], np.radians(loft), rtol=1e-15)
    best = longdrive.optimize("mae494", vary={"club.loft": (4, 20)}, angles="deg")
    same_best = longdrive.optimize("mae494", vary={"club.loft": ("4 deg", "20 deg")})
    assert best.fun == pytest.approx(same_best.fun, abs=1e-9)
    with pytest.raises(InputError, match="angles = 'grad'; expected 'rad' or 'deg'"):
        Setup({}, angles="grad")  # type: ignore[arg-type]


def sweep_of_points(setup: Any, points: Any, **more: Any) -> longdrive.Table:
    return longdrive.sweep(setup, points=points, **more)


def test_same_results_of_a_table_for_each_unit_of_angles() -> None:
    pandas = pytest.importorskip("pandas")
    table = longdrive.batch("mae494", {"club.loft": np.radians([8.0, 10.0, 12.0])})
    for points in (table, table.to_pandas()):
        assert longdrive.batch("mae494", points) == table
        for angles_in_degrees in (longdrive.batch, sweep_of_points):
            with pytest.raises(InputError, match="^angles = 'deg': each column of points has"):
                angles_in_degrees("mae494", points, angles="deg")
    # a frame without units has angles in the unit of the argument `angles`
    frame = pandas.DataFrame({"club.loft": [8.0, 10.0, 12.0]})
    assert longdrive.batch("mae494", frame, angles="deg") == table
    for points in (table, frame):
        with pytest.raises(InputError, match="angles = 'grad'; expected 'rad' or 'deg'"):
            longdrive.batch(Setup(), points, angles="grad")  # type: ignore[arg-type]


def test_degrees_are_refused_for_a_table_with_an_added_column() -> None:
    pytest.importorskip("pandas")
    frame = longdrive.batch("mae494", {"club.loft": [0.15, 0.2]}).to_pandas()
    frame["swing.path"] = [0.0, 0.7]
    with pytest.raises(InputError, match="^angles = 'deg': each column of points has"):
        longdrive.batch("mae494", frame, angles="deg")
    with pytest.warns(longdrive.LongdriveWarning) as warned:
        table = longdrive.batch("mae494", frame)
    assert table["club.loft"].tolist() == [0.15, 0.2]
    assert "swing.path = 0.7 is 0.7 rad" in str(warned[0].message)


def test_no_warning_about_an_angle_whose_column_has_a_unit() -> None:
    pytest.importorskip("pandas")
    frame = longdrive.batch("mae494", {"swing.path": [0.0, 0.1]}).to_pandas()
    frame["swing.path"] = [0.0, 0.7]
    frame["club.loft"] = [0.15, 0.2]
    assert not longdrive.batch("mae494", frame).warnings


def test_degrees_are_refused_for_a_file_of_points_whose_columns_have_units(tmp_path: Path) -> None:
    file = tmp_path / "points.csv"
    file.write_text("club.loft [rad]\n1\n", encoding="utf-8")
    plan = longdrive.parts.SweepPlan
    for call in (
        lambda: longdrive.sweep("mae494", points=file, angles="deg"),
        lambda: longdrive.sweep("mae494", points=file, angles="deg", output=tmp_path / "rows.csv"),
        lambda: plan.of("mae494", points=file, angles="deg", output=tmp_path / "parts", parts=1),
    ):
        with pytest.raises(InputError, match="leave angles out: degrees need such a head"):
            call()


def test_same_points_from_the_advice_about_own_values() -> None:
    loft = np.radians([8.0, 9.0])
    with pytest.raises(InputError) as refused:
        longdrive.sweep("mae494", over={"club.loft": [8.0, 9.0, 10.0]})
    (head,) = re.findall(r"points=\{'(.*?)': …\}", str(refused.value))
    table = longdrive.sweep("mae494", points={head: loft})
    assert table == longdrive.batch("mae494", {"club.loft": loft})


def test_same_radians_for_degrees_beside_quantities(unit: Any) -> None:
    mixed = longdrive.batch("mae494", {"club.loft": [8 * unit.deg, 9]}, angles="deg")
    assert mixed["club.loft"].tolist() == np.radians([8.0, 9.0]).tolist()
    assert not mixed.warnings
    # without angles="deg", the number is in radians, with the warning of a list of numbers
    warned = longdrive.batch("mae494", {"club.loft": [8 * unit.deg, 1]})
    assert any("club.loft = 1 is 1 rad" in text for text in warned.warnings)


@pytest.mark.parametrize(
    "dtype",
    ["int8", "uint8", "int16", "uint16", "int32", "int64", "float16", "float32", ">f8", "float64"],
)
def test_same_radians_of_every_number_type(dtype: str) -> None:
    degrees = [8, 10, 13]
    for given in (np.array(degrees, dtype), np.array(8, dtype)):
        table = longdrive.batch("mae494", {"club.loft": given}, angles="deg")
        wanted = np.radians(np.array(given, float)).reshape(-1)
        assert table["club.loft"].tolist() == wanted.tolist()


@pytest.mark.parametrize(
    "values",
    [
        [True, 8.0],
        np.array([True]),
        np.array([8], np.longdouble),
        np.ma.masked_array([8.0], [True]),
        [[8.0], [8.0, 9.0]],
        [None, 8.0],
        np.array([1j]),
    ],
)
def test_same_refusals_in_degrees_and_radians(values: Any) -> None:
    messages = []
    units: list[Any] = ["rad", "deg"]
    for angles in units:
        with pytest.raises(InputError) as refused:
            longdrive.batch("mae494", {"club.loft": values}, angles=angles)
        messages.append(str(refused.value))
    assert messages[0] == messages[1] and messages[0].startswith("points: club.loft ")


@pytest.mark.parametrize("kind", ["pandas", "polars", "pyarrow"])
def test_a_frame_warns_of_a_large_bare_angle_as_a_dict_does(kind: str) -> None:
    module = pytest.importorskip(kind)
    columns = {"swing.attack_angle": [0.0, 1.0]}
    frame = module.table(columns) if kind == "pyarrow" else module.DataFrame(columns)
    table = longdrive.batch("tour-average", columns)
    assert any("1 rad is 57.3°" in text for text in table.warnings)
    assert longdrive.batch("tour-average", frame).warnings == table.warnings
    # a table has known units, so its angles are not bare
    known = longdrive.batch("tour-average", table)
    assert not any("57.3°" in text for text in known.warnings)


@pytest.mark.parametrize("truth", [True, np.True_])
def test_a_boolean_is_refused_as_an_angle(truth: Any) -> None:
    with pytest.raises(InputError, match="club.loft"):
        Setup({"club.loft": truth})
    with pytest.raises(InputError, match="club.loft"):
        longdrive.batch(None, {"club.loft": truth})
    with pytest.raises(InputError, match="club.loft"):
        longdrive.optimize(vary={"club.loft": (truth, 0.2)})
