"""The package as a library: equal setups, mappings, round trips of tables, types, metadata."""

from __future__ import annotations

import importlib.metadata
import io
import pickle
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import InputError, Setup

PACKAGE = Path(__file__).parents[1]
POINTS = {"club.loft": np.radians([8.0, 10.0, 12.0]), "swing.speed": np.array([45.0, 50.0, 48.0])}


@pytest.mark.parametrize("preset", ["tour-average", "mae494", "modern-driver"])
def test_same_answers_of_a_setup_after_a_round_trip(preset: str) -> None:
    setup = Setup(preset).replace({"swing.speed": "47 m/s"})
    rows = longdrive.batch(setup, POINTS, ["carry", "lateral"])
    copies = [
        Setup(setup.to_dict()),
        Setup({**setup}),
        Setup.from_toml(setup.to_toml()),
        pickle.loads(pickle.dumps(setup)),
    ]
    for copy in copies:
        assert copy == setup and hash(copy) == hash(setup) and repr(copy) == repr(setup)
        assert longdrive.batch(copy, POINTS, ["carry", "lateral"]) == rows


def test_a_stated_step_makes_another_setup() -> None:
    setup = Setup()
    stated = setup.replace({"flight.step": setup["flight.step"]})
    assert stated != setup and repr(stated) != repr(setup)
    assert "flight.step" in stated.to_dict() and "flight.step" not in setup.to_dict()
    assert "step" in stated.to_toml() and Setup.from_toml(stated.to_toml()) == stated


def test_a_setup_is_a_mapping() -> None:
    setup = Setup()
    assert isinstance(setup, Mapping)
    assert dict(setup.items()) == setup.to_dict() == dict(zip(setup.keys(), setup.values()))
    assert setup.get("club.loft") == setup["club.loft"] and setup.get("nonsense", 3) == 3
    assert setup | {"club.loft": "11 deg"} == setup.replace({"club.loft": "11 deg"})
    with pytest.raises(TypeError):
        setup | 3  # type: ignore[operator]


def test_exact_public_names() -> None:
    assert dir(longdrive) == sorted(longdrive.__all__)
    assert "__getattr__" not in vars(longdrive) and not hasattr(longdrive, "nonsense")
    for name in ("dask", "jax", "parts", "ray", "spark", "torch"):
        assert getattr(longdrive, name).__name__ == f"longdrive.{name}"
    for name in longdrive.__all__:
        assert hasattr(longdrive, name)


def test_names_may_be_an_array() -> None:
    names = np.array(["club.loft", "swing.speed"])
    listed = list(map(str, names))
    assert longdrive.gradient(wrt=names).gradient.shape == (2,)
    assert longdrive.batch(None, POINTS, np.array(["carry", "spin"]), names).wrt == tuple(listed)
    assert longdrive.objective(None, "carry", names).names == listed
    with pytest.raises(InputError, match=r"wrt\[0\] is a float"):
        longdrive.gradient(wrt=np.array([1.0]))


def test_a_table_is_not_equal_to_an_array() -> None:
    table = longdrive.batch(None, POINTS)
    assert (table == table["carry"]) is False
    assert (table["carry"] == table) is False


def test_same_rows_of_tables_after_a_round_trip() -> None:
    polars, pyarrow = pytest.importorskip("polars"), pytest.importorskip("pyarrow")
    pandas = pytest.importorskip("pandas")
    table = longdrive.batch("tour-average", POINTS, ["carry", "spin"], "points")
    frames = [table.to_pandas(), table.to_polars(), pyarrow.table(table), table]
    assert isinstance(frames[0], pandas.DataFrame) and isinstance(frames[1], polars.DataFrame)
    for frame in frames:
        again = longdrive.batch("tour-average", frame, ["carry", "spin"], "points")
        assert again == table
    assert frames[0].attrs["units"]["club.loft"] == "rad"
    for frame in (table, pyarrow.table(table), frames[0], frames[0].iloc[:]):
        swept = longdrive.sweep("tour-average", points=frame, of=["carry", "spin"], wrt="points")
        assert swept == table
    with_units = {"club.loft [rad]": POINTS["club.loft"], "swing.speed [m/s]": POINTS["swing.speed"]}
    for points in (pandas.DataFrame(with_units), polars.DataFrame(with_units), with_units):
        swept = longdrive.sweep("tour-average", points=points, of=["carry", "spin"], wrt="points")
        assert swept == table


def test_a_table_in_memory_is_swept_into_a_file(tmp_path: Path) -> None:
    table = longdrive.batch("tour-average", POINTS, ["carry"])
    file = tmp_path / "rows.csv"
    reply = longdrive.sweep("tour-average", points=table, output=file)
    assert reply.status == "done"
    carry = np.loadtxt(io.StringIO(file.read_text()), delimiter=",", skiprows=1, usecols=3)
    assert np.array_equal(carry, table["carry"])


def test_no_temporary_file_is_made(monkeypatch: pytest.MonkeyPatch) -> None:
    import tempfile

    def refuse(*_: Any, **__: Any) -> None:
        raise AssertionError("a temporary file")

    monkeypatch.setattr(tempfile, "TemporaryDirectory", refuse)
    monkeypatch.setattr(tempfile, "NamedTemporaryFile", refuse)
    shots = {
        "ball_speed [mph]": [165.0, 168.1, 162.0],
        "launch_angle [deg]": [11.2, 10.4, 11.5],
        "spin [rpm]": [2500.0, 2380.0, 2450.0],
        "carry [yd]": [275.0, 281.0, 270.5],
    }
    assert len(longdrive.fly(shots).shots) == 3
    over = {"club.loft": "5deg..15deg:2000"}
    longdrive.parts.SweepPlan.of(over=over, output="nowhere", parts=1).validate()
    over = {"club.loft": "15deg..5deg:2000"}
    wrong = longdrive.parts.SweepPlan.of(over=over, output="nowhere", parts=1)
    with pytest.raises(InputError, match="club.loft"):
        wrong.validate()
    assert not Path("nowhere").exists()
    assert longdrive.calibrate(shots, "modern-driver", fit="aero.cd0").status == "converged"
    assert longdrive.plot.trajectory().svg.startswith("<svg")
    assert longdrive.compare("mae494", {"preset": "mae494", "club.loft": "11 deg"}).status == "done"
    table = {"club.loft [deg]": [8.0, 10.0]}
    assert longdrive.sweep(points=table).counts() == {"landed": 2}


def test_exact_carry_of_a_trajectory() -> None:
    drive = longdrive.simulate("tour-average", trajectory=True)
    path = drive.trajectory
    assert path is not None
    assert path.position[-1, 2] == drive["carry"] and path.position[-1, 1] == drive["lateral"]
    speed = np.linalg.norm(path.velocity[0])
    assert speed == pytest.approx(drive["ball_speed"], rel=1e-14)
    spin = np.linalg.norm(path.spin, axis=1)
    assert spin[0] == pytest.approx(drive["spin"], rel=1e-14) and np.all(np.diff(spin) <= 0)
    assert longdrive.simulate("tour-average").trajectory is None
    no_flight = longdrive.simulate({"swing.attack_angle": "-40 deg"}, trajectory=True)
    assert no_flight.trajectory is None
    polars = pytest.importorskip("polars")
    frame = polars.DataFrame(path)
    assert frame.columns[:2] == ["time", "position.x"] and frame.height == len(path)


KINDS = [
    "compare", "contour", "face", "launch", "laws", "pareto", "tornado", "trajectory", "vcurve"
]  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
def test_a_plot_is_drawn_into_axes(kind: str) -> None:
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pyplot.switch_backend("agg")
    arguments = {
        "compare": {"other": {"club.loft": "11 deg"}},
        "pareto": {"maximize": "carry", "minimize": "spin", "points": 3},
    }
    figure, ax = pyplot.subplots()
    picture = getattr(longdrive.plot, kind)("mae494", ax=ax, **arguments.get(kind, {}))
    lines = [picture.title, picture.subtitle] if picture.subtitle else [picture.title]
    assert picture.form == ".csv" and ax.get_title().split("\n") == lines
    assert (kind in ("contour", "launch", "pareto")) == (len(lines) == 2)
    labels = [text.get_text() for text in ax.texts]
    assert (kind in ("contour", "launch")) == bool(labels)
    assert all(label.endswith(" m") for label in labels), labels
    assert ax.lines or ax.collections or ax.patches
    scale = "log" if kind == "vcurve" else "linear"
    assert (ax.get_xscale(), ax.get_yscale()) == (scale, scale)
    pyplot.close(figure)


@pytest.mark.parametrize(
    ("kind", "fault"), [("strike", r"8 panels \(carry, as set up; "), ("fairway", "lines without")]
)
def test_a_plot_that_axes_cannot_show_is_refused(kind: str, fault: str) -> None:
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pyplot.switch_backend("agg")
    figure, ax = pyplot.subplots()
    with pytest.raises(InputError, match=f"^ax: this plot has {fault}.*output='plot.csv' for its"):
        getattr(longdrive.plot, kind)("mae494", ax=ax)
    assert not ax.has_data()
    pyplot.close(figure)


def test_axes_and_output_exclude_each_other(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="ax = 3; expected axes of matplotlib"):
        longdrive.plot.trajectory(ax=3)
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pyplot.switch_backend("agg")
    _, ax = pyplot.subplots()
    with pytest.raises(InputError, match="ax and output both say where the plot goes"):
        longdrive.plot.trajectory(ax=ax, output=tmp_path / "drive.svg")


@pytest.mark.parametrize("stated", [{"width": 900}, {"dark": True}])
def test_axes_refuse_size_and_colours_of_a_picture(stated: dict[str, Any]) -> None:
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pyplot.switch_backend("agg")
    figure, ax = pyplot.subplots()
    ((name, value),) = stated.items()
    message = f"^{name} = {value} is about a picture, and ax has its own size and colours; leave"
    with pytest.raises(InputError, match=message):
        longdrive.plot.trajectory("mae494", ax=ax, **stated)
    assert not ax.has_data()
    pyplot.close(figure)


def test_metadata_of_the_package() -> None:
    metadata = importlib.metadata.metadata("longdrive")
    assert set(metadata.get_all("License-File") or []) == {"LICENSE-MIT", "LICENSE-APACHE"}
    assert {"jax", "torch", "plot", "dask"} <= set(metadata.get_all("Provides-Extra") or [])
    classifiers = metadata.get_all("Classifier") or []
    assert "Programming Language :: Python :: 3.12" in classifiers
    assert "Operating System :: OS Independent" not in classifiers
    # the page of a package index has no files of the repository
    assert "](../" not in str(metadata) and "](examples" not in str(metadata)
    for name in ("LICENSE-MIT", "LICENSE-APACHE"):
        assert (PACKAGE / name).read_text() == (PACKAGE.parent / name).read_text()


# lines 3 to 8 have attributes that do not exist
TYPED = """
import longdrive
longdrive.nonsense
longdrive.optimize().nonsense
longdrive.simulate().nonsense
longdrive.batch(None, {}).nonsense
longdrive.calibrate({}, fit="aero.cd0").nonsense
longdrive.batch(None, {})["carry"].nonsense

longdrive.parts
longdrive.jax
x: float = longdrive.optimize().x[0]
fun: float = longdrive.optimize().fun
carry: float = longdrive.batch(None, {})["carry"].max()
rows: int = len(longdrive.batch(None, {})[1:3])
loft: float = longdrive.Setup().get("club.loft", 0.0)
estimates: dict[str, dict[str, object]] = longdrive.calibrate({}, fit="aero.cd0").estimates
"""


@pytest.mark.parametrize("checker", ["mypy", "pyright"])
def test_type_checkers_refuse_wrong_attributes_only(checker: str, tmp_path: Path) -> None:
    pytest.importorskip(checker)
    file = tmp_path / "typed.py"
    file.write_text(TYPED)
    options = ["--strict"] if checker == "mypy" else ["--pythonpath", sys.executable]
    done = subprocess.run(
        [sys.executable, "-m", checker, *options, str(file)],
        capture_output=True,
        text=True,
        check=False,
        cwd=PACKAGE,
    )
    lines = [line for line in done.stdout.splitlines() if "error" in line and "typed.py:" in line]
    found = {int(line.split("typed.py:")[1].split(":")[0]) for line in lines}
    assert found == {3, 4, 5, 6, 7, 8}, done.stdout
