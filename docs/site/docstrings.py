"""Docstrings as Markdown: :class:`Name` as code; those of the compiled module from the module."""

from __future__ import annotations

import importlib
import inspect
import re
from typing import Any

import griffe

# an example, with its output up to an empty line
EXAMPLE = re.compile(r"(?:^>>> .*(?:\n(?!\s*$).*)*\n?)+", re.MULTILINE)
ROLE = re.compile(r":(?:class|func|meth|mod):(`[^`]+`)")
# for who changes the code
FOR_MAINTAINERS = re.compile(r"^Written by make_commands\.py.*(?:\n.+)*", re.MULTILINE)


class Docstrings(griffe.Extension):
    """Rewrites the text of each docstring before it is parsed."""

    def on_object(self, *, obj: griffe.Object, **_: Any) -> None:
        text = obj.docstring.value if obj.docstring else ""
        # the stubs of the compiled module have types, itself has the text
        if not obj.is_module and str(obj.filepath).endswith("_longdrive.pyi") and not obj.name.startswith("_"):
            text = compiled(obj.path) or text
        if text:
            text = FOR_MAINTAINERS.sub("", ROLE.sub(r"\1", text))
            if "\nExamples\n----" not in text:
                text = EXAMPLE.sub(lambda example: f"```pycon\n{example[0].rstrip()}\n```\n", text)
            if obj.docstring:
                obj.docstring.value = text.strip()
            else:
                obj.docstring = griffe.Docstring(text.strip(), parent=obj, parser="numpy")


def compiled(path: str) -> str | None:
    """The text of an item of the compiled module."""
    module, _, names = path.partition("._longdrive.")
    item: Any = importlib.import_module(f"{module}._longdrive")
    for name in names.split("."):
        item = getattr(item, name, None)
    return inspect.getdoc(item) if item is not None else None
