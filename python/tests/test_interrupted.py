"""Ctrl-C: results so far, progress, and how to continue."""

from __future__ import annotations

import logging
import pickle
import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import Interrupted, commands, plot
from longdrive.progress import Bar

SWINGS: dict[str, Any] = {
    "distribution": {
        "swing.speed": ("normal", 50.0, 1.5),
        "swing.path": ("normal", 0.0, 0.04),
        "strike.toe": ("normal", 0.0, 0.01),
    },
    "vary": {"club.loft": (0.1, 0.3), "club.bulge_radius": (0.2, 0.6)},
    "maximize": "mean(carry) - 0.5*std(lateral)",
    "scenarios": 2000,
}


def press_ctrl_c() -> None:
    signal.raise_signal(signal.SIGINT)


def when(is_time: Callable[[int], bool]) -> Callable[[int, int], None]:
    """A progress function that presses Ctrl-C once `is_time` is true for the parts done."""
    pressed: list[int] = []

    def look(done: int, of: int) -> None:
        if is_time(done) and not pressed:
            pressed.append(done)
            press_ctrl_c()

    return look


@pytest.fixture
def pressing_at() -> Iterator[Callable[[str], None]]:
    """Presses Ctrl-C after a pattern in a remark of a command."""
    log, handlers = logging.getLogger("longdrive"), []
    level = log.level
    log.setLevel(logging.INFO)

    class Pressing(logging.Handler):
        def __init__(self, pattern: str) -> None:
            super().__init__()
            self.pattern, self.pressed = re.compile(pattern), False

        def emit(self, record: logging.LogRecord) -> None:
            if not self.pressed and self.pattern.search(record.getMessage()):
                self.pressed = True
                press_ctrl_c()

    def at(pattern: str) -> None:
        handlers.append(Pressing(pattern))
        log.addHandler(handlers[-1])

    yield at
    log.setLevel(level)
    for handler in handlers:
        log.removeHandler(handler)


def test_an_interrupted_search_has_its_best_point_and_iterations() -> None:
    with pytest.raises(Interrupted) as caught:
        longdrive.optimize(
            "mae494",
            starts=2000,
            vary={"club.loft": (0.05, 0.5), "swing.attack_angle": (-0.1, 0.1)},
            progress=when(lambda done: done > 10),
        )
    error, found = caught.value, caught.value.answer
    assert isinstance(found, longdrive.Optimum) and not found.success
    assert found.ended == "interrupted" and "of 2000 searches ended" in found.message
    # the value in the answer is the carry at the best point so far
    assert longdrive.gradient(found.setup, "carry", "club.loft").value == pytest.approx(
        found.fun, abs=1e-5
    )
    for word in (
        "longdrive.optimize was interrupted",
        found.message,
        f"carry = {found.fun:.6g}",
        f"club.loft = {found.x[0]:.6g}",
        "checkpoint=FILE",
    ):
        assert word in str(error)
    again = pickle.loads(pickle.dumps(error))
    assert str(again) == str(error) and again.answer.fun == found.fun


def test_a_search_interrupted_within_an_iteration_has_the_previous_point(
    pressing_at: Callable[[str], None]
) -> None:
    # after the first iteration is reported, the next one is in progress: an evaluation of 8000
    # swings
    pressing_at(r"  1  mean\(carry\)")
    requested: dict[str, Any] = {**SWINGS, "scenarios": 8000}
    with pytest.raises(Interrupted) as caught:
        longdrive.optimize("tour-average", **requested)
    found = caught.value.answer
    assert isinstance(found, longdrive.Optimum) and found.ended == "interrupted"
    assert found.nit >= 1 and found.message.startswith(f"stopped after {found.nit} iteration")
    # the reported value is the goal at the reported point
    goal, wrt = requested.pop("maximize"), list(requested.pop("vary"))
    assert (
        found.names == wrt
        and longdrive.objective("tour-average", goal, wrt, **requested).fun(found.x) == pytest.approx(
            found.fun, rel=1e-6
        )
    )


def test_a_search_interrupted_before_its_first_point_raises() -> None:
    looks: list[int] = []

    def look(done: int, of: int) -> None:
        looks.append(done)
        if len(looks) == 2:
            press_ctrl_c()

    with pytest.raises(Interrupted) as caught:
        longdrive.optimize(
            "tour-average", **{**SWINGS, "scenarios": 100_000, "starts": 2}, progress=look
        )
    error = caught.value
    assert error.answer is None and "`answer`" not in str(error) and "begins again" in str(error)
    assert "0 of 2 searches ended" in str(error) or "stopped before" in str(error)


def test_a_search_resumes_from_its_checkpoint(
    pressing_at: Callable[[str], None], tmp_path: Path
) -> None:
    file = tmp_path / "search.json"
    pressing_at("KKT")
    with pytest.raises(Interrupted) as caught:
        longdrive.optimize("tour-average", **SWINGS, checkpoint=file)
    assert f"the same call goes on from the checkpoint '{file}'" in str(caught.value)
    assert (
        "mean(carry) - 0.5*std(lateral) = " in str(caught.value)
        or "last message:" in str(caught.value)
    )
    kept = file.read_bytes()
    gone_on = longdrive.optimize("tour-average", **SWINGS, checkpoint=file)
    assert gone_on.success and file.read_bytes() != kept
    np.testing.assert_allclose(gone_on.x, longdrive.optimize("tour-average", **SWINGS).x, rtol=1e-9)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (
            lambda look: longdrive.uncertainty(samples=4000, progress=look),
            "longdrive.uncertainty was interrupted before there was an answer",
        ),
        (
            lambda look: longdrive.plot.contour(progress=look),
            "longdrive.plot.contour was interrupted",
        ),
    ],
)
def test_the_message_of_every_interrupted_command_names_its_work(
    call: Callable[[Any], Any], words: str
) -> None:
    with pytest.raises(Interrupted, match="interrupted") as caught:
        call(when(lambda done: True))
    assert words in str(caught.value)
    assert "batch" not in str(caught.value) and caught.value.table is None


def test_interrupted_shots_in_memory_name_no_file(
    pressing_at: Callable[[str], None], tmp_path: Path
) -> None:
    file = tmp_path / "shots.csv"
    file.write_text("Ball Speed,Launch Angle,Spin\n" + "160,11,2500\n" * 300_000)
    # before the first row is flown
    pressing_at("heads without a unit")
    with pytest.raises(
        Interrupted, match=r"longdrive.fly was interrupted: stopped after \d+ rows?; `answer`"
    ) as caught:
        longdrive.fly(file)
    assert "rows.jsonl" not in str(caught.value) and "is not written" not in str(caught.value)
    assert caught.value.answer is not None and caught.value.answer.file is None


@pytest.mark.parametrize("function", ["_checked", "warn_of"])
def test_ctrl_c_after_the_work_has_its_own_message(
    function: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    from longdrive import run_command

    real = getattr(run_command, function)

    def pressing(*given: Any, **named: Any) -> Any:
        press_ctrl_c()
        return real(*given, **named)

    monkeypatch.setattr(run_command, function, pressing)
    with pytest.raises(
        Interrupted,
        match="longdrive.optimize was interrupted after its work, before it returned; its files are written",
    ):
        longdrive.optimize("mae494", output=tmp_path / "best.toml")
    assert (tmp_path / "best.toml").exists()


def test_ctrl_c_with_the_last_row_keeps_all_rows() -> None:
    with pytest.raises(
        Interrupted, match=r"after 5 of 5 rows, .*first_row=5\) has nothing left to do"
    ) as caught:
        longdrive.batch(
            "mae494", {"club.loft": np.linspace(0.1, 0.2, 5)}, progress=when(lambda done: done == 5)
        )
    assert caught.value.table is not None and caught.value.table.counts() == {"landed": 5}


def test_progress_of_a_batch_never_has_a_total_of_zero_rows() -> None:
    seen: list[tuple[int, int]] = []

    def look(done: int, of: int) -> None:
        seen.append((done, of))

    longdrive.batch("mae494", {"club.loft": []}, progress=look)
    assert seen == []
    longdrive.batch("mae494", {"club.loft": [0.1, 0.2]}, progress=look)
    assert seen[-1] == (2, 2)


def test_uncounted_progress_is_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    bar = Bar("compare")
    for _ in range(5):
        bar(0, 0)
    bar(1, 2)
    bar(2, 2)
    assert capsys.readouterr().err == "\rcompare: 0 s   \rcompare: 2 of 2   \n"


@pytest.mark.parametrize("module", [commands, plot])
def test_the_docstring_of_every_function_names_uncounted_progress(module: Any) -> None:
    for name in module.__all__:
        assert "0 of 0 while they cannot be counted" in " ".join(
            getattr(module, name).__doc__.split()
        ), name


def test_a_front_has_the_points_so_far(pressing_at: Callable[[str], None]) -> None:
    # both ends of the front take four searches, with a remark every second
    pressing_at(r"following the front: ([6-9]|\d\d+) searches so far")
    with pytest.raises(Interrupted, match="points so far"):
        longdrive.pareto(
            {"flight.step": "0.5 ms"}, maximize="carry", minimize="apex_height", points=1000
        )


def test_an_interrupted_fit_has_its_latest_values(pressing_at: Callable[[str], None]) -> None:
    draw, rows = np.random.default_rng(3), 2000
    # fmt: skip
    shots = {
        "ball_speed [m/s]": 60 + 15 * draw.random(rows),
        "launch_angle [deg]": 8 + 8 * draw.random(rows),
        "backspin [rpm]": 2000 + 1500 * draw.random(rows),
        "carry [m]": 180 + 60 * draw.random(rows),
    }
    pressing_at("iteration")
    with pytest.raises(Interrupted, match="longdrive.calibrate was interrupted") as caught:
        longdrive.calibrate(
            shots,
            {"preset": "modern-driver", "aero.law": "robinson"},
            fit=["aero.cd0", "aero.cl_max"],
            folds=20,
        )
    found = caught.value.answer
    assert found is not None and found.interrupted and 0 < found.estimates["aero.cd0"]["value"] < 1
    assert f"aero.cd0 = {found.estimates['aero.cd0']['value']:.6g}" in str(caught.value)
    assert "begins again" in str(caught.value)


def test_interrupted_work_writes_no_file(tmp_path: Path) -> None:
    with pytest.raises(Interrupted):
        longdrive.plot.contour(
            "mae494", output=tmp_path / "left.svg", progress=when(lambda done: True)
        )
    # later work runs on the threads of the interrupted work
    longdrive.plot.contour("mae494", output=tmp_path / "whole.svg")
    assert [path.name for path in tmp_path.iterdir()] == ["whole.svg"]


def test_an_interrupted_sweep_in_memory_has_its_finished_rows_and_advice() -> None:
    over = {"club.loft": (0.1, 0.2, 3000), "swing.speed": (40.0, 50.0, 300)}
    with pytest.raises(Interrupted) as caught:
        longdrive.sweep("mae494", over, progress=when(lambda done: done > 0))
    table = caught.value.table
    assert table is not None and 0 < len(table) < 900_000
    assert str(caught.value).startswith(
        f"longdrive.sweep was interrupted after {len(table)} of 900000 rows"
    )
    assert "first_row" not in str(caught.value) and "resume=True" in str(caught.value)
    assert longdrive.batch("mae494", table.points, own_step=True)["carry"][:100] == pytest.approx(
        table["carry"][:100], abs=1e-3
    )


def test_same_file_of_an_interrupted_and_resumed_sweep(tmp_path: Path) -> None:
    requested: dict[str, Any] = {
        "over": {"club.loft": (0.1, 0.2, 1000), "swing.speed": (40.0, 50.0, 100)},
        "output": tmp_path / "rows.csv",
    }
    with pytest.raises(
        Interrupted, match="rows so far are kept, and the same call with resume=True goes on"
    ) as caught:
        longdrive.sweep("mae494", **requested, progress=when(lambda done: done > 0))
    assert "--" not in str(caught.value)
    with pytest.raises(
        Interrupted, match="same call with resume=True in place of overwrite=True goes on"
    ):
        longdrive.sweep(
            "mae494", **requested, overwrite=True, progress=when(lambda done: done > 0)
        )
    longdrive.sweep("mae494", **requested, resume=True)
    whole = tmp_path / "whole.csv"
    longdrive.sweep("mae494", **{**requested, "output": whole})
    assert whole.read_bytes() == (tmp_path / "rows.csv").read_bytes()


def test_ctrl_c_before_the_first_row_is_interrupted_too() -> None:
    class Pressing(dict[str, Any]):
        def items(self) -> Any:
            press_ctrl_c()
            return super().items()

    with pytest.raises(
        Interrupted, match="longdrive.batch was interrupted before the first row"
    ) as caught:
        longdrive.batch(Pressing(preset="mae494"), {"club.loft": [0.1, 0.2]})
    assert caught.value.table is None
    with pytest.raises(Interrupted, match="longdrive.optimize was interrupted before it began"):
        longdrive.optimize(Pressing(preset="mae494"))


def test_functions_of_numpy_are_loaded_before_ctrl_c_is_handled() -> None:
    # delete NumPy's table of C functions: it must have been read at the import of longdrive
    code = (
        "import longdrive, numpy; del numpy._core.multiarray._ARRAY_API; "
        "print(len(longdrive.sweep('mae494', {'club.loft': (0.1, 0.2, 3)}, wrt='points')))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stdout == "3\n", done.stderr


def test_an_exception_of_a_progress_function_is_raised_unchanged() -> None:
    def refuse(done: int, of: int) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        longdrive.uncertainty(samples=4000, progress=refuse)
    with pytest.raises(RuntimeError, match="enough"):
        longdrive.batch("mae494", {"club.loft": np.linspace(0.1, 0.2, 500_000)}, progress=refuse)


def test_another_thread_is_not_interrupted() -> None:
    found: list[Any] = []
    other = threading.Thread(target=lambda: found.append(longdrive.optimize("mae494", starts=100)))
    with pytest.raises(Interrupted):
        other.start()
        longdrive.batch(
            "mae494",
            {"club.loft": np.linspace(0.1, 0.2, 500_000)},
            progress=when(lambda done: True),
        )
    other.join()
    assert found[0].success
