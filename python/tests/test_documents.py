"""What the documents of the package say is so: examples in docstrings and in the README, and every public name has a text."""

from __future__ import annotations

import doctest
import importlib
import inspect
import pkgutil
import re
import subprocess
import sys
from pathlib import Path

import pytest

import longdrive

MODULES = [f"longdrive.{module.name}" for module in pkgutil.iter_modules(longdrive.__path__)]
NEEDS = {"longdrive.jax": "jax", "longdrive.torch": "torch"}


@pytest.mark.parametrize("name", ["longdrive", *MODULES])
def test_exact_examples_in_docstrings(name: str) -> None:
    if name in NEEDS:
        pytest.importorskip(NEEDS[name])
    module = importlib.import_module(name)
    found = doctest.testmod(module, optionflags=doctest.ELLIPSIS)
    assert found.failed == 0
    if name in ("longdrive", "longdrive.derivatives", "longdrive.batches"):
        assert found.attempted > 0


def test_every_public_name_has_a_text() -> None:
    for name in longdrive.__all__:
        item = getattr(longdrive, name)
        assert name == "__version__" or inspect.getdoc(item), name
        if inspect.isclass(item) and item.__module__.startswith("longdrive"):
            for member, value in vars(item).items():
                if not member.startswith("_") and (callable(value) or isinstance(value, (property, staticmethod))):
                    assert inspect.getdoc(getattr(item, member)), f"{name}.{member}"


def test_exact_the_readmes_python_runs() -> None:
    text = (Path(__file__).parents[1] / "README.md").read_text()
    for block in re.findall(r"```python\n(.*?)```", text, re.DOTALL):
        exec(compile(block, "README.md", "exec"), {})  # noqa: S102


def test_nothing_but_numpy_is_imported() -> None:
    code = "import sys, numpy; before = set(sys.modules); import longdrive; print(*{name.split('.')[0] for name in set(sys.modules) - before})"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert "longdrive" in loaded and set(loaded) <= set(sys.stdlib_module_names) | {"numpy", "longdrive"}
