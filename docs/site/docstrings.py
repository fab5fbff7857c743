"""Docstrings as Markdown: examples after >>> in a block of code, and :class:`Name` as code."""

from __future__ import annotations

import re
from typing import Any

import griffe

# an example, with its output up to an empty line
EXAMPLE = re.compile(r"(?:^>>> .*(?:\n(?!\s*$).*)*\n?)+", re.MULTILINE)
ROLE = re.compile(r":(?:class|func|meth|mod):(`[^`]+`)")


class Docstrings(griffe.Extension):
    """Rewrites the text of each docstring before it is parsed."""

    def on_object(self, *, obj: griffe.Object, **_: Any) -> None:
        if obj.docstring:
            text = ROLE.sub(r"\1", obj.docstring.value)
            obj.docstring.value = EXAMPLE.sub(lambda example: f"```pycon\n{example[0].rstrip()}\n```\n", text)
