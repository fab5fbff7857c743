"""Types: the stub file matches the compiled module; package, examples and notebooks are typed."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("mypy")

FOLDER = Path(__file__).parents[1]
PACKAGE = FOLDER / "python/longdrive"
EXAMPLES = sorted((FOLDER / "examples").glob("*.py"))
# leave out examples of other packages: if ray is not installed, a checker would take
# `longdrive/ray.py` for it
NEEDS = {"ray_sweep.py", "spark_sweep.py", "torch_ascent.py"}


def run(*arguments: str) -> None:
    done = subprocess.run(
        [sys.executable, "-m", *arguments],
        capture_output=True,
        text=True,
        check=False,
        cwd=FOLDER,
    )
    assert done.returncode == 0, done.stdout + done.stderr


def code_of_notebooks(folder: Path) -> list[str]:
    """The code of each notebook in a file, without the magics of IPython."""
    files = []
    for notebook in sorted((FOLDER / "notebooks").glob("*.ipynb")):
        cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
        code = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")
        lines = [line for line in code.splitlines() if not line.startswith("%")]
        file = folder / f"{notebook.stem.replace('-', '_')}.py"
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        files.append(str(file))
    return files


def test_the_stub_file_matches_the_module() -> None:
    run("mypy.stubtest", "longdrive._longdrive")


def test_the_package_passes_a_strict_type_checker() -> None:
    run("mypy", "--strict", "--python-version", "3.10", str(PACKAGE))


def examples_and_notebooks(folder: Path) -> list[str]:
    examples = [str(file) for file in EXAMPLES if file.name not in NEEDS]
    return [*examples, *code_of_notebooks(folder)]


def test_examples_and_notebooks_pass_a_strict_type_checker(tmp_path: Path) -> None:
    files = examples_and_notebooks(tmp_path)
    run("mypy", "--strict", "--config-file", "pyproject.toml", *files)


def test_package_examples_and_notebooks_pass_another_type_checker(tmp_path: Path) -> None:
    pytest.importorskip("pyright")
    files = examples_and_notebooks(tmp_path)
    run("pyright", "--pythonpath", sys.executable, str(PACKAGE), *files)
