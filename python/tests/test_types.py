"""Types: the stub file matches the compiled module, and the package is strictly typed."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("mypy")

PACKAGE = Path(__file__).parents[1] / "python/longdrive"


def run(*arguments: str) -> None:
    done = subprocess.run(
        [sys.executable, "-m", *arguments],
        capture_output=True,
        text=True,
        check=False,
        cwd=PACKAGE.parents[1],
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_stub_file_matches_the_module() -> None:
    run("mypy.stubtest", "longdrive._longdrive")


def test_the_package_and_its_tests_pass_a_strict_type_checker() -> None:
    run("mypy", "--strict", "--python-version", "3.10", str(PACKAGE))
