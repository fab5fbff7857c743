"""Exceptions: classes, pickling, and panics as exceptions."""

from __future__ import annotations

import copy
import pickle
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import pytest

import longdrive
from longdrive import Error, InputError, InternalError, NoAnswerError, _longdrive

NO_FLIGHT = {"preset": "tour-average", "swing.attack_angle": "-40 deg"}


def test_a_panic_is_an_internal_error_that_except_exception_catches(
    capfd: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(InternalError, match="please report it.*: on purpose") as caught:
        _longdrive._panic_for_a_test("on purpose")
    assert isinstance(caught.value, (Error, RuntimeError)) and isinstance(caught.value, Exception)
    capfd.readouterr()


def test_the_gradient_of_a_drive_that_does_not_fly_raises_with_the_reason() -> None:
    with pytest.raises(NoAnswerError, match="no flight") as caught:
        longdrive.gradient(NO_FLIGHT)
    assert caught.value.status == "no-flight"
    assert not isinstance(caught.value, ValueError)


@pytest.mark.parametrize("error", [
    Error("a"), InputError("b"), InternalError("c"), NoAnswerError("d", "aloft"),
], ids=lambda error: type(error).__name__)
def test_every_error_pickles_and_copies(error: Error) -> None:
    for other in (pickle.loads(pickle.dumps(error)), copy.copy(error), copy.deepcopy(error)):
        assert type(other) is type(error) and str(other) == str(error)
        assert getattr(other, "status", None) == getattr(error, "status", None)


def no_answer(_: int) -> None:
    longdrive.gradient(NO_FLIGHT)


def bad_input(_: int) -> None:
    longdrive.Setup({"club.lofft": 1.0})


@pytest.mark.parametrize("method", ["spawn", "forkserver"])
def test_errors_come_back_from_another_process(method: str) -> None:
    with ProcessPoolExecutor(1, mp_context=get_context(method)) as pool:
        with pytest.raises(NoAnswerError) as caught:
            pool.submit(no_answer, 0).result()
        assert caught.value.status == "no-flight"
        with pytest.raises(InputError, match="did you mean 'club.loft'"):
            pool.submit(bad_input, 0).result()


def test_a_free_threaded_python_is_refused_with_the_python_to_use() -> None:
    # version strings of such a build, in 3.13 and in 3.14
    for version in (
        "3.13.5 experimental free-threading build (main, Jun 11 2025)",
        "3.14.0 free-threading build (main, Oct 7 2025)",
    ):
        output = subprocess.run(
            [sys.executable, "-c", f"import sys; sys.version = {version!r}; import longdrive"],
            capture_output=True,
            text=True,
        )
        assert output.returncode == 1 and "Traceback" in output.stderr
        assert (
            "ImportError: longdrive needs Python with the global interpreter lock" in output.stderr
            and "use the ordinary build" in output.stderr
        )
