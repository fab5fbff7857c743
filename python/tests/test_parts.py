"""Sweeps in parts: equal files from processes and from the program; missing parts, and merged
statistics."""

from __future__ import annotations

import hashlib
import math
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import longdrive
from longdrive import InputError, parts
from longdrive.parts import PartError, SweepPlan

ARGUMENTS: dict[str, Any] = {
    "setup": {"preset": "tour-average", "flight.step": 0.5},
    "over": {
        "club.loft": "-4deg..15deg:41",
        "swing.attack_angle": (math.radians(-5.0), math.radians(5.0), 200),
    },
    "of": ["carry", "launch_angle"],
    "wrt": "club.loft",
    "histogram": {"carry": "150m..290m:7"},
    "highest": {"carry": 5},
    "parts": 4,
}


def sha256_of_the_set(folder: Path) -> str:
    """Output of ``sha256sum part-*.parquet | sha256sum``."""
    files = sorted(folder.glob("part-*.parquet"))
    lines = [f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n" for file in files]
    return hashlib.sha256("".join(lines).encode()).hexdigest()


@pytest.fixture(scope="session")
def one_worker(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[dict[str, Any]]]:
    """All parts, in order and in this process."""
    folder = tmp_path_factory.mktemp("parts")
    requested = SweepPlan.of(**ARGUMENTS, output=folder)
    return folder, [requested.write(part) for part in range(1, requested.parts + 1)]


def test_same_set_from_processes_and_from_one_worker(
    one_worker: tuple[Path, list[dict[str, Any]]], tmp_path: Path
) -> None:
    folder, rows = one_worker
    found = parts.sweep(**ARGUMENTS, output=tmp_path, processes=2)
    assert found.manifests == rows
    assert (
        found.rows == 8200
        and found.summary["moments"]["carry"]["count"] == found.summary["statuses"]["landed"]
    )
    assert sha256_of_the_set(tmp_path) == sha256_of_the_set(folder)
    # once more: all parts exist, and nothing is written
    before = [file.stat().st_mtime_ns for file in sorted(tmp_path.iterdir())]
    assert parts.sweep(**ARGUMENTS, output=tmp_path, processes=1).manifests == rows
    assert [file.stat().st_mtime_ns for file in sorted(tmp_path.iterdir())] == before


def test_same_set_from_the_program_and_from_python(
    one_worker: tuple[Path, list[dict[str, Any]]], tmp_path: Path, program: Callable[..., Any]
) -> None:
    folder, _ = one_worker
    requested = SweepPlan.of(**ARGUMENTS, output=tmp_path / "drives")
    setup = tmp_path / "setup.toml"
    setup.write_text(requested.setup)
    for part in (3, 1, 4, 2):
        words = [str(setup) if word == "-" else word for word in requested.words]
        done = program(*words, f"--output={requested.output}", f"--part={part}/{requested.parts}")
        assert done.returncode == 0, done.stderr
    assert sha256_of_the_set(Path(requested.output)) == sha256_of_the_set(folder)


def test_independent_hash_and_summary_of_a_check(
    one_worker: tuple[Path, list[dict[str, Any]]]
) -> None:
    folder, rows = one_worker
    found = parts.check(folder, contents=True)
    assert (found["status"], found["missing"], found["faults"]) == ("done", [], [])
    assert found["sha256"] == sha256_of_the_set(folder)
    for row in rows:
        assert row["sha256"] == hashlib.sha256((folder / row["file"]).read_bytes()).hexdigest()
    merged = parts.merge(reversed(rows))
    assert all(found[name] == merged[name] for name in merged)


def test_a_missing_part_is_named_and_parts_of_other_sweeps_are_refused(tmp_path: Path) -> None:
    requested = SweepPlan.of(**ARGUMENTS, output=tmp_path)
    requested.write(2)
    found = requested.check()
    assert (found["status"], found["missing"]) == ("partial", [1, 3, 4])
    other = SweepPlan.of(**{**ARGUMENTS, "wrt": ()}, output=tmp_path)
    with pytest.raises(PartError, match="part 2 of 4: .*different derivatives") as caught:
        other.write(2)
    again = pickle.loads(pickle.dumps(caught.value))
    assert (type(again), str(again), again.part) == (PartError, str(caught.value), 2)
    # a part is refused for an existing part of another sweep: which message comes first depends on
    # the order of the files
    with pytest.raises(PartError, match="parts of one|different derivatives"):
        parts.sweep(**{**ARGUMENTS, "wrt": ()}, output=tmp_path, processes=1, retries=0)
    with pytest.raises(InputError, match="it has no part of a sweep"):
        (tmp_path / "empty").mkdir()
        parts.check(tmp_path / "empty")
    with pytest.raises(longdrive.Error, match="at most 9 parts"):
        SweepPlan.of(**{**ARGUMENTS, "parts": 10}, output=tmp_path / "new").write(1)
    with pytest.raises(InputError, match="manifests"):
        parts.merge([{"part": 1}])


def test_numbers_are_si_and_texts_carry_their_unit() -> None:
    requested = SweepPlan.of(
        over={"swing.speed": (40.0, "50 m/s", 3), "aero.cd0": (0.2, 0.3)}, output="a", parts=1
    )
    assert [word for word in requested.words if word.startswith("--over")] == [
        "--over=swing.speed=40.0 m/s..50 m/s:3", "--over=aero.cd0=0.2..0.3"
    ]
    assert pickle.loads(pickle.dumps(requested)) == requested


GOOD: dict[str, Any] = {"over": {"club.loft": (0.1, 0.3, 3000)}, "parts": 2}

# fmt: skip
UNSOUND: list[tuple[dict[str, Any], str]] = [
    (
        {"over": {"club.lofft": (0.1, 0.3, 3000)}},
        "^unknown parameter 'club.lofft'; did you mean 'club.loft'",
    ),
    ({"of": "cary"}, "^unknown outcome 'cary'; did you mean 'carry'"),
    ({"of": 3}, "^of is an int; expected a name or a list of names"),
    ({"wrt": "club.lofft"}, "^unknown parameter 'club.lofft'"),
    ({"wrt": [1.0]}, r"^wrt\[0\] is a float; expected a name$"),
    ({"over": {"club.loft": (0.1, 9.0, 3000)}}, "club.loft"),
    (
        {"sample": 3000},
        "sample says how many points there are; write club.loft=0.1 rad..0.3 rad, without a count",
    ),
    ({"histogram": {"carry": (100.0, "300 kg", 20)}}, "300 kg"),
    ({"highest": 3}, "^highest is an int; expected a dict of outcomes with their number of rows"),
    ({"lowest": {"carry": 0.5}}, "^lowest of carry = 0.5; expected a whole number of 1 or more"),
    ({"tolerance": "1 kg"}, "^tolerance: "),
    ({"instructions": "sse"}, "^invalid value 'sse' for 'instructions'"),
    ({"points": "no-such-file.csv", "over": ()}, "^no-such-file.csv: it cannot be read"),
    ({"parts": 100}, "divide it into at most 3 parts"),
    ({"over": ()}, "over"),
]


@pytest.mark.parametrize(("change", "words"), UNSOUND)
def test_an_invalid_sweep_is_refused_before_its_first_part(
    change: dict[str, Any], words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def begun(*arguments: Any) -> None:
        raise AssertionError("a part was begun")

    monkeypatch.setattr(parts, "_in_processes", begun)
    folder = tmp_path / "drives"
    with pytest.raises(InputError, match=words):
        parts.sweep("mae494", **{**GOOD, **change}, output=folder)
    assert not folder.exists() and not list(tmp_path.iterdir())


def test_a_valid_sweep_is_planned_without_a_file(tmp_path: Path) -> None:
    requested = SweepPlan.of(
        "mae494",
        **GOOD,
        output=tmp_path / "drives",
        tolerance=1e-3,
        histogram={"carry": (100.0, 300.0, 20)},
    )
    requested.validate()
    assert (
        "--tolerance=0.001 m" in requested.words
        and "--histogram=carry=100.0 m..300.0 m:20" in requested.words
    )
    assert not list(tmp_path.iterdir())


def test_a_relative_folder_is_that_of_the_caller(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    begun = parts._in_processes

    def moved(
        requested: SweepPlan,
        left: list[int],
        tries: dict[int, int],
        manifests: dict[int, dict[str, Any]],
        processes: int,
        retries: int,
    ) -> None:
        # change the folder, as for workers of a cluster that were started in another folder
        monkeypatch.chdir(elsewhere)
        begun(requested, left, tries, manifests, processes, retries)
        monkeypatch.chdir(tmp_path)

    monkeypatch.setattr(parts, "_in_processes", moved)
    found = parts.sweep("mae494", **GOOD, output="drives", processes=1)
    assert (
        found.output == str(tmp_path / "drives")
        and len(list((tmp_path / "drives").glob("part-*"))) == 2
    )
    assert not list(elsewhere.iterdir())


def test_the_message_on_an_engine_names_the_argument() -> None:
    pytest.importorskip("distributed")
    import longdrive.dask

    for client in ("x", None):
        with pytest.raises(
            InputError, match="^client is a .*; expected a distributed.Client of the cluster"
        ):
            longdrive.dask.sweep(client)  # type: ignore[arg-type]


LARGE: dict[str, Any] = {"over": {"club.loft": (0.5, 1.2, 7168)}, "parts": 7}


def test_same_warnings_of_a_part_as_of_a_sweep(tmp_path: Path) -> None:
    whole = longdrive.sweep(None, LARGE["over"]).warnings
    assert "1 rad is 57.3°" in whole[0] and "the launch is outside" in whole[1]
    with pytest.warns(longdrive.LongdriveWarning) as planned:
        requested = SweepPlan.of(**LARGE, output=tmp_path)
    assert [str(one.message) for one in planned] == whole[:1]
    with pytest.warns(longdrive.LongdriveWarning) as written:
        row = requested.write(7)
    assert [str(one.message) for one in written] == row["warnings"]
    # only the numbers of drives differ
    assert row["warnings"][0].partition(" of ")[0] == "1024"
    assert row["warnings"][0].partition(": ")[2] == whole[1].partition(": ")[2]
    assert {one.filename for one in [*planned, *written]} == {__file__}


def test_a_sweep_of_processes_warns_once_of_its_parts(tmp_path: Path) -> None:
    with pytest.warns(longdrive.LongdriveWarning) as caught:
        found = parts.sweep(**LARGE, output=tmp_path, processes=1)
    of_angles, of_parts = [str(one.message) for one in caught]
    assert "1 rad is 57.3°" in of_angles
    texts = of_parts.split("\n")
    rows = [row for row in found.manifests if row["warnings"]]
    assert len(rows) == 6
    assert texts == [
        *(f"part {row['part']} of 7: {row['warnings'][0]}" for row in rows[:5]),
        "… and 1 more in the rows of `manifests`",
    ]
    assert caught[1].message.answer == found  # type: ignore[union-attr]
    assert longdrive.parts.merge(found.manifests) == found.summary


def test_a_stated_value_of_a_swept_parameter_is_refused(tmp_path: Path) -> None:
    stated: dict[str, Any] = {"setup": {"club.loft": "9 deg"}, **LARGE}
    message = "club.loft of the setup: every drive of the sweep has a value of its own, so this one"
    for call in (
        lambda: SweepPlan.of(**stated, output=tmp_path).validate(),
        lambda: parts.sweep(**stated, output=tmp_path),
        lambda: pickle.loads(pickle.dumps(SweepPlan.of(**stated, output=tmp_path))).write(1),
    ):
        with pytest.raises(longdrive.Error, match=message):
            call()
    assert not list(tmp_path.iterdir())
