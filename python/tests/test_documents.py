"""Documents of the package: examples in docstrings, README and docs/python.md run, and every public
name has a text."""

from __future__ import annotations

import doctest
import importlib
import inspect
import pkgutil
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import longdrive

ROOT = Path(__file__).parents[2]
MODULES = [f"longdrive.{module.name}" for module in pkgutil.iter_modules(longdrive.__path__)]
NEEDS = {"longdrive.jax": "jax", "longdrive.torch": "torch"}


@pytest.mark.parametrize("name", ["longdrive", *MODULES])
def test_examples_of_docstrings_run(name: str) -> None:
    if name in NEEDS:
        pytest.importorskip(NEEDS[name])
    module = importlib.import_module(name)
    found = doctest.testmod(module, optionflags=doctest.ELLIPSIS)
    assert found.failed == 0
    if name in ("longdrive", "longdrive.derivatives", "longdrive.batches"):
        assert found.attempted > 0


COMPILED = ["Setup", "Setup.replace", "Setup.get", "Setup.from_toml"]
COMPILED += ["outcomes", "parameters", "presets"]


@pytest.mark.parametrize("name", COMPILED)
def test_examples_of_the_compiled_module(name: str) -> None:
    item: Any = longdrive
    for part in name.split("."):
        item = getattr(item, part)
    examples = doctest.DocTestParser().get_doctest(inspect.getdoc(item) or "", {}, name, None, 0)
    assert examples.examples
    assert doctest.DocTestRunner().run(examples).failed == 0


def test_every_function_has_an_example() -> None:
    functions = {name: getattr(longdrive, name) for name in longdrive.__all__}
    functions |= {f"plot.{name}": getattr(longdrive.plot, name) for name in longdrive.plot.__all__}
    for name in ("check", "sweep"):
        functions[f"parts.{name}"] = getattr(longdrive.parts, name)
    for name, function in functions.items():
        if inspect.isroutine(function):
            text = inspect.getdoc(function) or ""
            _, _, examples = text.partition("Examples\n--------\n")
            assert ">>> " in examples, name


def test_every_public_name_has_a_text() -> None:
    for name in longdrive.__all__:
        item = getattr(longdrive, name)
        assert name == "__version__" or inspect.getdoc(item), name
        if inspect.isclass(item) and item.__module__.startswith("longdrive"):
            for member, value in vars(item).items():
                if not member.startswith("_") and (
                    callable(value) or isinstance(value, (property, staticmethod))
                ):
                    assert inspect.getdoc(getattr(item, member)), f"{name}.{member}"


def blocks() -> list[Any]:
    """The Python blocks of README.md and docs/python.md, with their first lines."""
    found = []
    for path in (ROOT / "python/README.md", ROOT / "docs/python.md"):
        text = path.read_text(encoding="utf-8")
        for block in re.finditer(r"```python\n(.*?)```", text, re.DOTALL):
            line = text[: block.start(1)].count("\n") + 1
            found.append(
                pytest.param(path.name, line, block[1], id=f"{path.parent.name}/{path.name}:{line}")
            )
    return found


@pytest.mark.parametrize(("name", "line", "code"), blocks())
def test_the_python_of_the_documents_runs(
    name: str, line: int, code: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for library in re.findall(r"^(?:import|from) (\w+)", code, re.MULTILINE):
        pytest.importorskip(library)
    for needed in (library for module, library in NEEDS.items() if f"import {module}" in code):
        pytest.importorskip(needed)
    # run in a folder that pytest removes: some examples write files
    monkeypatch.chdir(tmp_path)
    exec(compile("\n" * (line - 1) + code, name, "exec"), {})  # noqa: S102


# modules that longdrive must not import at its start: each takes a millisecond or more, and only
# some functions need it
LATER = {
    "concurrent.futures",
    "csv",
    "dataclasses",
    "html",
    "json",
    "logging",
    "longdrive.notebook",
    "longdrive.request",
    "longdrive.types",
    "multiprocessing",
    "numpy.typing",
    "pathlib",
    "tempfile",
}


def test_the_import_loads_only_numpy_and_modules_that_every_use_needs() -> None:
    code = """
import sys, numpy
before = set(sys.modules)
import longdrive
print(*set(sys.modules) - before)
"""
    loaded = set(
        subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, check=True
        ).stdout.split()
    )
    assert "longdrive" in loaded and not loaded & LATER
    packages = {name.partition(".")[0] for name in loaded}
    assert packages <= set(sys.stdlib_module_names) | {"longdrive"}
