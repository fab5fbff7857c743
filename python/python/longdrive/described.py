"""What the program says of its commands and their options."""

from __future__ import annotations

from functools import cache
from typing import Any

from . import _longdrive

__all__ = ["commands", "name_or_carry"]


@cache
def commands() -> dict[str, list[dict[str, Any]]]:
    """The options of each command, by its name: ``optimize``, ``plot contour``."""
    found: dict[str, list[dict[str, Any]]] = {}
    for command in _longdrive.described():
        found[command["name"]] = command["options"]
        found.update(
            {
                f"{command['name']} {below['name']}": below["options"]
                for below in command["commands"]
            }
        )
    return found


def name_or_carry(name: str) -> str:
    """The name of an outcome, for an example: that which was asked for, or carry."""
    return name if any(row["name"] == name for row in _longdrive.outcomes()) else "carry"
