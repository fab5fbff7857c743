"""Very many drives: arrays in and out, statuses, threads, processes, interruptions."""

from __future__ import annotations

import copy
import csv
import io
import math
import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import InputError, Interrupted, Setup, Status, Table

VARY = ["club.loft", "swing.speed"]
# time limit of a hanging test, s
WAIT = 1200


def points(rows: int, seed: int = 1) -> dict[str, np.ndarray[Any, np.dtype[np.float64]]]:
    draw = np.random.default_rng(seed)
    return {
        "club.loft": np.radians(draw.uniform(6, 16, rows)),
        "swing.speed": draw.uniform(36, 55, rows),
    }


def bits(table: Table) -> tuple[bytes, ...]:
    return tuple(np.ascontiguousarray(table[name]).tobytes() for name in table.keys())


@pytest.fixture(scope="module")
def table() -> Table:
    return longdrive.batch("tour-average", points(3000), ["carry", "lateral", "spin"], "points")


def test_same_rows_as_the_program(program: Callable[..., Any]) -> None:
    done = program(
        "sweep",
        "--over",
        "club.loft=5deg..25deg:13",
        "--over",
        "swing.attack_angle=-30deg..5deg:11",
        "--outcomes",
        "carry,spin,apex_height",
        "--gradient",
        "-o",
        "-",
        "--quiet",
    )
    rows = list(csv.DictReader(io.StringIO(done.stdout)))
    assert len(rows) == 13 * 11, done.stderr
    names = {head: head.split(" [")[0] for head in rows[0]}
    given = {
        name: np.array(
            [float(row[head]) for row in rows]
        ) for head, name in names.items() if "." in name and "/" not in name
    }
    ours = longdrive.batch("tour-average", given, ["carry", "spin", "apex_height"], "points")
    assert list(names.values()) == ours.keys()
    assert ours.counts().keys() >= {"landed", "no-flight"}
    for k, row in enumerate(rows):
        assert row["status"] == Status(ours.status[k]).label
        for head, name in names.items():
            if name != "status":
                theirs = float(row[head]) if row[head] else math.nan
                assert (
                    ours[name][k] == theirs or (math.isnan(ours[name][k]) and math.isnan(theirs))
                ), (name, k)
                assert head == f"{name} [{ours.units[name]}]"


def test_exact_parabola_in_a_vacuum() -> None:
    vacuum = Setup({"preset": "mae494", "air.density": 0})
    speed = np.linspace(30, 60, 500)
    table = longdrive.batch(
        vacuum,
        {"swing.speed": speed},
        ["carry", "ball_speed", "launch_angle"],
        ["gravity", "swing.speed"],
        hessians=True,
    )
    g = vacuum["gravity"]
    np.testing.assert_allclose(
        table["carry"], table["ball_speed"] ** 2 * np.sin(2 * table["launch_angle"]) / g, rtol=1e-11
    )
    np.testing.assert_allclose(
        table.derivative("carry", "gravity"), -table["carry"] / g, rtol=1e-11
    )
    # carry is proportional to the square of the club's speed, the ball's speed to the club's speed
    np.testing.assert_allclose(
        table.derivative("carry", "swing.speed"), 2 * table["carry"] / speed, rtol=1e-10
    )
    assert table.hessians is not None and table.hessians.shape == (500, 3, 2, 2)
    np.testing.assert_allclose(table.hessians[:, 0, 0, 0], 2 * table["carry"] / g**2, rtol=1e-10)
    np.testing.assert_allclose(table.hessians[:, 0, 1, 1], 2 * table["carry"] / speed**2, rtol=1e-9)
    np.testing.assert_allclose(table.hessians[:, 1], 0, atol=1e-9)


def test_same_rows_as_single_drives_at_one_step_size() -> None:
    setup, given = Setup("modern-driver"), points(50)
    table = longdrive.batch(setup, given, ["carry", "spin"], "points", own_step=True, hessians=True)
    assert table.hessians is not None
    for row in range(50):
        one = setup.replace({name: given[name][row] for name in VARY})
        values, jacobian = longdrive.jacobian(one, ["carry", "spin"], VARY, own_step=True)
        np.testing.assert_allclose(table.values[row], values, rtol=1e-12)
        np.testing.assert_allclose(table.gradients[row], jacobian, rtol=1e-10, atol=1e-9)
        np.testing.assert_allclose(
            table.hessians[row, 0],
            longdrive.hessian(one, "carry", VARY, own_step=True).hessian,
            rtol=1e-9,
            atol=1e-7,
        )


def test_views_share_the_columns(table: Table) -> None:
    assert (
        table.values.shape == (3000, 3)
        and table.gradients.shape == (3000, 3, 2)
        and len(table) == 3000
    )
    for i, of in enumerate(table.of):
        assert np.array_equal(table[of], table.values[:, i])
        for j, by in enumerate(table.wrt):
            assert np.array_equal(table.derivative(of, by), table.gradients[:, i, j])
            assert np.array_equal(table.derivative(of, by), table[f"d_{of}/d_{by}"])
    assert (
        np.shares_memory(table.values, table["carry"])
        and np.shares_memory(table.gradients, table.derivative("spin", "club.loft"))
    )
    assert table["carry"].flags.c_contiguous and not table["carry"].flags.writeable
    part = table[1000:2000]
    assert (
        (len(part), part.first_row) == (1000, 1000)
        and np.shares_memory(part["carry"], table["carry"])
    )
    assert np.array_equal(part["carry"], table["carry"][1000:2000])
    rows = np.arange(len(table))
    for some in (slice(2, 10, 3), slice(None, None, -1), slice(-5, None)):
        assert table[some].first_row == rows[some][0]
    assert part[5:].first_row == 1005
    assert table[::-1][2:].first_row == rows[::-1][2:][0]
    assert table[::3][2:].first_row == rows[::3][2:][0]
    assert Table.concatenate([table[:1000], part, table[2000:]]) == table
    assert Table.concatenate([part, table[2000:]]).first_row == 1000
    for parts in ([part, table[:1000]], [part, part], [table[:4:2], table[4:]]):
        assert Table.concatenate(parts).first_row is None
        assert Table.concatenate([*parts, table])[1:].first_row is None
    with pytest.raises(
        KeyError,
        match="unknown column 'cary'; did you mean 'carry'. the columns are club.loft, swing.speed, status, carry",
    ):
        table["cary"]
    with pytest.raises(InputError, match="columns by name and rows by slice"):
        table[3]  # type: ignore[index]


def test_same_rows_from_strides_types_and_read_only_arrays(table: Table) -> None:
    given = points(3000)
    wide = np.zeros((3000, 4))
    wide[:, 1], wide[:, 3] = given["club.loft"], given["swing.speed"]
    read_only = given["club.loft"].copy()
    read_only.flags.writeable = False
    same = [
        {"club.loft": wide[:, 1], "swing.speed": wide[:, 3]},
        {
            "club.loft": given["club.loft"][::-1].copy()[::-1],
            "swing.speed": given["swing.speed"].astype(">f8"),
        },
        {"club.loft": read_only, "swing.speed": given["swing.speed"].tolist()},
    ]
    for other in same:
        before = {name: np.array(value) for name, value in other.items()}
        assert bits(
            longdrive.batch("tour-average", other, ["carry", "lateral", "spin"], "points")
        ) == bits(table)
        assert all(np.array_equal(value, other[name]) for name, value in before.items())
    single = given["swing.speed"].astype(np.float32)
    narrow = longdrive.batch("tour-average", {"swing.speed": single})
    assert np.array_equal(narrow["swing.speed"], single.astype(np.float64))
    assert np.array_equal(
        narrow["carry"],
        longdrive.batch("tour-average", {"swing.speed": single.astype(np.float64)})["carry"],
    )
    whole = longdrive.batch("tour-average", {"swing.speed": np.array([40, 50])})
    assert np.array_equal(
        whole["carry"], longdrive.batch("tour-average", {"swing.speed": [40.0, 50.0]})["carry"]
    )


def test_numbers_and_texts_apply_to_every_row() -> None:
    loft = np.radians([8.0, 10.0, 12.0])
    each = longdrive.batch(Setup(), {"club.loft": loft, "swing.speed": np.full(3, 110 * 0.44704)})
    for speed in ("110 mph", 110 * 0.44704, np.float64(110 * 0.44704), np.array(110 * 0.44704)):
        assert longdrive.batch(Setup(), {"club.loft": loft, "swing.speed": speed}) == each
    assert len(longdrive.batch(Setup(), {"club.loft": "10 deg"})) == 1
    assert len(longdrive.batch(Setup(), {"club.loft": np.array([])})) == 0


def test_same_bits_for_any_number_of_threads(table: Table) -> None:
    for threads in (1, 2, 5):
        assert bits(
            longdrive.batch(
                "tour-average",
                points(3000),
                ["carry", "lateral", "spin"],
                "points",
                threads=threads,
            )
        ) == bits(table)


def test_only_rows_that_do_not_fly_have_a_failed_status_and_nan() -> None:
    nan, inf = math.nan, math.inf
    given = {
        "club.loft": [0.2, nan, inf, 2.0, 0.2, 0.2, 0.2],
        "swing.attack_angle": [0, 0, 0, 0, math.radians(-40), 0, nan],
        "strike.toe": [0, 0, 0, 0, 0, 0.14, 0],
        "club.bulge_radius": 0.05,
    }
    table = longdrive.batch("tour-average", given, ["carry", "ball_speed"], "points", hessians=True)
    out, landed = Status.OUT_OF_RANGE, Status.LANDED
    assert table.status.tolist() == [landed, out, out, out, Status.NO_FLIGHT, Status.NO_STRIKE, out]
    assert table.status.dtype == np.int8
    is_landed = table.status == landed
    assert np.isnan(table["carry"]).tolist() == (~is_landed).tolist()
    # a ball that does not fly still has a launch
    assert np.isnan(table["ball_speed"]).tolist() == [False, True, True, True, False, True, True]
    assert (
        table.hessians is not None
        and np.isfinite(table.hessians[0]).all()
        and np.isnan(table.hessians[1]).all()
    )
    assert table.counts() == {"landed": 1, "no-flight": 1, "no-strike": 1, "out-of-range": 4}


def test_a_landed_drive_without_a_direction_has_the_status_undefined() -> None:
    launch = {"launch": {"ball_speed": "150 mph", "launch_angle": "12 deg", "backspin": "2600 rpm"}}
    table = longdrive.batch(launch, {"launch.backspin": [250.0, 0.0]}, ["carry", "spin_axis"])
    assert table.status.tolist() == [Status.LANDED, Status.UNDEFINED]
    assert (
        np.isfinite(table["carry"]).all() and np.isnan(table["spin_axis"]).tolist() == [False, True]
    )


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (
            {"club.loft": np.zeros((2, 2))},
            r"points: club.loft has shape \(2, 2\); expected a number or a one-dimensional array of numbers in rad",
        ),
        (
            {"club.loft": np.zeros(3), "swing.speed": np.zeros(4)},
            r"points: swing.speed has shape \(4,\), and club.loft has \(3,\)",
        ),
        ({"club.loft": np.array(["a"])}, "points: club.loft has dtype <U1"),
        ({"club.loft": np.array([True])}, "points: club.loft has dtype bool"),
        ({"club.loft": np.array([1j])}, "points: club.loft has dtype complex128"),
        ({"club.loft": np.array([1], "m8[s]")}, "points: club.loft has dtype timedelta64"),
        (
            {"club.loft": np.array([1], np.longdouble)},
            "points: club.loft has dtype float128, which 64-bit floats do not hold",
        ),
        ({"club.loft": np.ma.masked_array([1.0], [True])}, "points: club.loft is a masked array"),
        ({"club.loft": object()}, "points: club.loft has dtype object"),
        ({"club.loft": "10 kg"}, 'club.loft: "10 kg" is not an angle'),
        ({"club.lofft": [0.1]}, "unknown parameter 'club.lofft'; did you mean 'club.loft'"),
        ({"flight.step": [0.1]}, "flight.step cannot be varied"),
        ({1: [0.1]}, "points: the key 1 is no text"),
        ({}, "points is empty"),
        ([1.0], "points is a list; expected a dict of parameters with arrays"),
    ],
)
def test_wrong_points_have_a_message(given: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        longdrive.batch(Setup(), given)


def test_wrong_arguments_have_a_message() -> None:
    given = {"club.loft": [0.2]}
    for requested, message in [
        (dict(of="carri"), "did you mean 'carry'"),
        (dict(of=["carry", "carry"]), "of names 'carry' twice"),
        (dict(wrt=["club.loft", "club.loft"]), "wrt names 'club.loft' twice"),
        (dict(wrt="club.lofft"), "did you mean 'club.loft'"),
        (dict(tolerance="1 kg"), "tolerance"),
        (dict(tolerance=-1.0), "tolerance"),
        (dict(tolerance="1 mm", own_step=True), "tolerance and own_step are both given"),
        (dict(first_row=7), r"first_row = 7; expected a multiple of 1024 up to the 1 rows"),
        (dict(first_row=1024), "first_row = 1024"),
    ]:
        with pytest.raises(InputError, match=message):
            longdrive.batch(Setup(), given, **requested)  # type: ignore[arg-type]


def test_the_step_of_the_setup_is_used_on_request() -> None:
    given = {"club.loft": np.radians([8.0, 12.0])}
    own = longdrive.batch("tour-average", given, own_step=True)
    assert own == longdrive.batch(Setup().replace({"flight.step": Setup()["flight.step"]}), given)
    exact = longdrive.batch("tour-average", given, tolerance=1e-9)
    assert np.abs(longdrive.batch("tour-average", given)["carry"] - exact["carry"]).max() < 1e-6
    assert np.abs(
        longdrive.batch("tour-average", given, tolerance=1e-3)["carry"] - exact["carry"]
    ).max() < 1e-3


def test_a_table_pickles_copies_and_prints(table: Table) -> None:
    for other in (pickle.loads(pickle.dumps(table)), copy.copy(table), copy.deepcopy(table)):
        assert other == table and bits(other) == bits(table)
        assert (other.first_row, other.warnings, other.units) == (
            table.first_row, table.warnings, table.units
        )
    assert table != table[:10] and table != "a"
    assert repr(table).startswith(
        "<longdrive.Table of 3000 drives (3000 landed): carry, lateral, spin, d_carry/d_club.loft"
    )
    assert table._repr_html_().count("<tr>") == 11
    assert table.units["d_carry/d_club.loft"] == "m/rad"


def test_arrow_shares_the_columns(table: Table) -> None:
    pyarrow = pytest.importorskip("pyarrow")
    lent = pyarrow.table(table)
    assert lent.column_names == table.keys()
    for name in table.keys():
        if name == "status":
            continue
        chunk = lent.column(name).chunk(0)
        assert chunk.buffers()[1].address == table[name].ctypes.data
        assert lent.schema.field(name).metadata[b"unit"].decode() == table.units[name]
    assert lent.column("status").chunk(0).dictionary.to_pylist() == [
        status.label for status in Status
    ]
    # the memory of the table stays valid as long as Arrow uses it
    other = pyarrow.table(longdrive.batch(Setup(), {"club.loft": [0.1, math.nan, 0.2]}))
    assert (
        other.column("carry").null_count == 1
        and other.column("status").to_pylist() == ["landed", "out-of-range", "landed"]
    )
    assert pyarrow.table(table[::7]).column("carry").to_pylist() == table["carry"][::7].tolist()


def test_polars_and_pandas_read_a_table(table: Table) -> None:
    polars = pytest.importorskip("polars")
    pandas = pytest.importorskip("pandas")
    assert polars.DataFrame(table)["carry"].to_list() == table["carry"].tolist()
    assert pandas.DataFrame.from_arrow(table)["carry"].tolist() == table["carry"].tolist()


@pytest.mark.parametrize("kind", ["dict", "pandas", "polars", "pyarrow"])
def test_a_missing_value_in_the_only_column_keeps_its_row(kind: str) -> None:
    module = None if kind == "dict" else pytest.importorskip(kind)

    def made(columns: dict[str, Any]) -> Any:
        if module is None:
            return columns
        return module.table(columns) if kind == "pyarrow" else module.DataFrame(columns)

    table = longdrive.sweep("mae494", points=made({"club.loft [deg]": [9.0, None, 11.0]}))
    assert [Status(code).label for code in table.status] == ["landed", "out-of-range", "landed"]
    with pytest.raises(InputError, match="swing 2: swing.path is missing"):
        longdrive.optimize(
            "mae494",
            maximize="mean(carry)",
            vary="club.loft=8deg..12deg",
            swings=made({"swing.path [deg]": [1.0, None, 2.0]}),
        )


@pytest.mark.parametrize("kind", ["pandas", "polars", "pyarrow"])
def test_exact_numbers_of_32_bits_and_other_columns_of_a_frame(kind: str) -> None:
    module = pytest.importorskip(kind)
    loft = np.array([0.1, 0.2], np.float32)
    columns = {"club.loft [rad]": loft, "note": ["a, b", None]}
    frame = module.table(columns) if kind == "pyarrow" else module.DataFrame(columns)
    table = longdrive.sweep("mae494", points=frame)
    assert table["club.loft"].tolist() == loft.astype(float).tolist()
    assert table.warnings[0].startswith("points: columns not read, since they are results or remarks")
    assert table.warnings[0].endswith(": note")


def test_a_row_of_a_frame_is_not_a_table() -> None:
    pandas = pytest.importorskip("pandas")
    row = pandas.DataFrame({"club.loft": [0.15, 0.2], "swing.path": [0.0, 0.0]}).iloc[0]
    with pytest.raises(InputError, match="^points is a Series; expected a dict of parameters"):
        longdrive.batch("mae494", row)
    with pytest.raises(InputError, match="^points is a Series; expected a file, a dict of columns"):
        longdrive.sweep("mae494", points=row)


def test_results_among_the_columns_of_a_frame_are_named() -> None:
    pandas = pytest.importorskip("pandas")
    columns = {"swing.speed": [45.0, 50.0], "ball_speed": [60.0, 80.0], "launch_angle": [0.2, 0.3]}
    kinds = [pandas.DataFrame(columns)]
    for kind in ("polars", "pyarrow"):
        module = pytest.importorskip(kind)
        kinds.append(module.table(columns) if kind == "pyarrow" else module.DataFrame(columns))
    warning = "columns not read, since they are results and not parameters: ball_speed, launch_angle"
    for frame in kinds:
        assert longdrive.batch("mae494", frame).warnings == [f"points: {warning}"]
    heads = {"swing.speed [m/s]": [45.0, 50.0], "ball_speed [m/s]": [60.0, 80.0]}
    swept = longdrive.sweep("mae494", points=heads)
    assert "since they are results or remarks" in swept.warnings[0]
    assert swept.warnings[0].endswith(": ball_speed")
    # a frame made from a Table knows the units of its result columns, so they are ignored without a
    # warning
    table = longdrive.batch("mae494", {"club.loft": [0.15, 0.18]}, wrt="club.loft")
    for frame in (table.to_pandas(), pytest.importorskip("pyarrow").table(table)):
        assert longdrive.batch("mae494", frame, wrt="club.loft").warnings == []
        assert longdrive.sweep("mae494", points=frame, wrt="club.loft") == table
    with pytest.raises(InputError, match="unknown parameter 'd_loft'"):
        longdrive.batch("mae494", pandas.DataFrame({"club.loft": [0.15], "d_loft": [1.0]}))
    twice = pandas.DataFrame([[0.1, 0.2]], columns=["club.loft", "club.loft"])
    with pytest.raises(InputError, match="two columns have the name 'club.loft'"):
        longdrive.batch("mae494", twice)


def test_a_column_in_another_unit_than_si_is_refused() -> None:
    pandas, pyarrow = pytest.importorskip("pandas"), pytest.importorskip("pyarrow")
    frame = pandas.DataFrame({"swing.speed": [100.0, 110.0]})
    frame.attrs["units"] = {"swing.speed": "mph"}
    field = pyarrow.field("swing.speed", pyarrow.float64(), metadata={"unit": "mph"})
    lent = pyarrow.table({"swing.speed": [100.0, 110.0]}, schema=pyarrow.schema([field]))
    for points in (frame, lent):
        for call in (longdrive.batch, lambda setup, points: longdrive.sweep(setup, points=points)):
            with pytest.raises(
                InputError, match="'swing.speed' has the unit 'mph'; expected 'm/s', as SI"
            ):
                call("mae494", points)


def test_a_lazy_frame_is_refused_with_advice() -> None:
    polars = pytest.importorskip("polars")
    lazy = polars.DataFrame({"club.loft": [0.15]}).lazy()
    for call in (longdrive.batch, lambda setup, points: longdrive.sweep(setup, points=points)):
        with pytest.raises(InputError, match="LazyFrame has no values .*give frame.collect()"):
            call("mae494", lazy)


def test_progress_begins_at_zero_and_ends_at_all_rows() -> None:
    seen: list[tuple[int, int]] = []
    table = longdrive.batch(
        "tour-average", points(200_000), progress=lambda done, total: seen.append((done, total))
    )
    assert seen[-1] == (200_000, 200_000) and len(table) == 200_000
    assert [done for done, _ in seen] == sorted(done for done, _ in seen)

    def refuse(done: int, total: int) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        longdrive.batch("tour-average", points(200_000), progress=refuse)


def test_the_progress_line_ends_with_a_line_break(capsys: pytest.CaptureFixture[str]) -> None:
    longdrive.batch("tour-average", points(10), progress=True)
    assert capsys.readouterr().err.endswith("drives: 10 of 10   \n")


@pytest.mark.skipif(os.name != "posix", reason="sends a signal to itself")
def test_same_bits_after_ctrl_c_and_another_batch() -> None:
    # in steps of 4 ms, a minute of work
    setup, given, of = Setup({"flight.step": 4e-3}), points(400_000), ["carry", "spin"]
    some_are_done = threading.Event()

    def press() -> None:
        some_are_done.wait()
        os.kill(os.getpid(), signal.SIGINT)

    presser = threading.Thread(target=press, daemon=True)
    presser.start()
    with pytest.raises(KeyboardInterrupt) as caught:
        longdrive.batch(
            setup, given, of, progress=lambda done, _: some_are_done.set() if done else None
        )
    presser.join()
    assert isinstance(caught.value, Interrupted)
    done = caught.value.table
    assert 0 < len(done) < 400_000 and len(done) % 1024 == 0
    assert f"first_row={len(done)}" in str(caught.value)
    other = pickle.loads(pickle.dumps(caught.value))
    assert other.table == done and str(other) == str(caught.value)

    few = {name: values[: len(done) + 2048] for name, values in given.items()}
    rest = longdrive.batch(setup, few, of, first_row=len(done))
    assert (rest.first_row, len(rest)) == (len(done), 2048)
    one = longdrive.batch(setup, {name: values[-1024:] for name, values in few.items()}, of)
    assert np.array_equal(Table.concatenate([done, rest])["carry"][-1024:], one["carry"])


def test_other_threads_of_python_run_during_a_batch(at_work: threading.Event) -> None:
    # in steps of 4 ms, a minute of work
    with pytest.raises(Interrupted):
        longdrive.batch(
            Setup({"flight.step": 4e-3}),
            points(400_000),
            own_step=True,
            progress=lambda *_: at_work.set(),
        )


def test_same_rows_in_several_threads_at_once(table: Table) -> None:
    found: list[Table] = []

    def ask() -> None:
        found.append(
            longdrive.batch("tour-average", points(3000), ["carry", "lateral", "spin"], "points")
        )

    threads = [threading.Thread(target=ask) for _ in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(WAIT)
    assert len(found) == 6 and all(bits(other) == bits(table) for other in found)


# starts child processes while a thread of the parent computes batches
PROCESSES = """
import multiprocessing, pickle, sys, threading
import numpy as np
import longdrive

def rows(_=None):
    draw = np.random.default_rng(1)
    points = {
        "club.loft": np.radians(draw.uniform(6, 16, 3000)),
        "swing.speed": draw.uniform(36, 55, 3000),
    }
    table = longdrive.batch("tour-average", points, ["carry", "lateral", "spin"], "points")
    return tuple(np.ascontiguousarray(table[name]).tobytes() for name in table.keys())

if __name__ == "__main__":
    # finish the first call, which imports modules: a child forked meanwhile could inherit the lock
    # of an import
    rows()
    stop = threading.Event()

    def busy():
        while not stop.is_set():
            rows()

    thread = threading.Thread(target=busy)
    thread.start()
    try:
        pool = multiprocessing.get_context(sys.argv[1]).Pool(2)
    finally:
        stop.set()
        thread.join()
    with pool:
        found = pool.map_async(rows, range(4)).get(float(sys.argv[2]))
    pickle.dump(found, sys.stdout.buffer)
"""


@pytest.mark.parametrize("method", multiprocessing.get_all_start_methods())
def test_same_rows_in_processes_of_every_kind(method: str, table: Table, tmp_path: Path) -> None:
    # in an interpreter of its own: a library that another test imported may warn of a fork
    script = tmp_path / "processes.py"
    script.write_text(PROCESSES)
    found = subprocess.run(
        [sys.executable, "-W", "ignore::DeprecationWarning", str(script), method, str(WAIT)],
        capture_output=True,
        check=False,
    )
    assert found.returncode == 0, found.stderr.decode()
    assert all(other == bits(table) for other in pickle.loads(found.stdout))


@pytest.mark.skipif(not hasattr(os, "sched_setaffinity"), reason="asks Linux for one processor")
def test_no_more_threads_than_allowed_processors() -> None:
    code = """
import os
os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
import longdrive, numpy as np
longdrive.batch("modern-driver", {"club.loft": np.full(5000, 0.2)})
names = [open(f"/proc/self/task/{task}/comm").read() for task in os.listdir("/proc/self/task")]
print(*sorted({name.strip() for name in names if name.startswith("longdrive")}), sep=",")
"""
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "longdrive 0"
