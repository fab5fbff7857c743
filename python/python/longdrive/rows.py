"""Rows that a command has written."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

__all__ = ["SHOTS"]


def _read_rows(folder: Path) -> list[dict[str, Any]]:
    """The rows of a command, a dict each, SI."""
    with (folder / "rows.jsonl").open(encoding="utf-8") as file:
        return [json.loads(line) for line in file]


SHOTS = ("shots", _read_rows)
"""Rows of shots, kept in a reply under ``shots``."""
