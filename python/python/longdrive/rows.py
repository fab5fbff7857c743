"""The rows of shots that ``fly`` returns."""

from __future__ import annotations

import json

from .replies import FlyReply
from .reply import Reply
from .request import Request

__all__ = ["flown"]


def flown(reply: Reply, request: Request) -> FlyReply:
    """The answer of ``fly``: without a file, with its rows under ``shots``, a dict each, SI."""
    if reply["file"] is None and request.content:
        reply["shots"] = [json.loads(line) for line in request.content.splitlines()]
    return FlyReply(reply)
