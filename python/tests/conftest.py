"""Fixtures of several tests."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections import deque
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]

# Python ignores Ctrl-C in a background job of a shell, but some tests press it: set its handler
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def independent_drives() -> list[dict[str, Any]]:
    """Drives of an independent program (tests/data/README.md), printed to 12 digits."""
    drives: list[dict[str, Any]] = json.loads(
        (ROOT / "tests/data/reference_drives.json").read_text()
    )["drives"]
    for drive in drives:
        drive["setup"] = {"preset": "winfield-tan", **drive["setup"]}
    return drives


@pytest.fixture(scope="session")
def program() -> Callable[..., subprocess.CompletedProcess[str]]:
    """Runs the program of LONGDRIVE_PROGRAM, or else of the package, with some arguments."""
    found = os.environ.get("LONGDRIVE_PROGRAM")
    command = [found] if found else [sys.executable, "-m", "longdrive"]

    def run(*words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([*command, *words], capture_output=True, text=True, check=False)

    return run


@pytest.fixture(scope="session")
def unit() -> Any:
    """The units of pint, which take a while to load."""
    return pytest.importorskip("pint").UnitRegistry()


@pytest.fixture
def at_work() -> threading.Event:
    """An event that starts a second thread of Python, which presses Ctrl-C during long work.

    The thread first waits until it has run five times within 15 ms. Long work checks for Ctrl-C
    every 20 ms: if other threads could run only at these checks, it would never press Ctrl-C.
    """
    event = threading.Event()

    def run() -> None:
        event.wait()
        times = deque([-1.0], maxlen=5)
        while time.monotonic() - times[0] > 0.015:
            times.append(time.monotonic())
            time.sleep(0.001)
        signal.raise_signal(signal.SIGINT)

    threading.Thread(target=run, daemon=True).start()
    return event


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Runs the type checkers first: they take longest, and would delay the end of the run."""
    items.sort(key=lambda item: item.path.name != "test_types.py")
