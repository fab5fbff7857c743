"""Rows that a command has written."""

from __future__ import annotations

import json

from ._question import Question
from .reply import Reply

__all__ = ["flown"]


def flown(reply: Reply, question: Question) -> Reply:
    """The answer of ``fly``: without a file of its own, with the rows under ``shots``, a dict each, SI."""
    path = question.scratch
    if reply["file"] is None and path is not None and path.exists():
        with path.open(encoding="utf-8") as file:
            reply["shots"] = [json.loads(line) for line in file]
    return reply
