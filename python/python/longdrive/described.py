"""What the program says of its commands and their options."""

from __future__ import annotations

from functools import cache
from typing import Any

from . import _longdrive

__all__ = ["commands", "name_or_carry", "options", "places"]


@cache
def commands() -> dict[str, list[dict[str, Any]]]:
    """The options of each command, by its name: ``optimize``, ``plot contour``."""
    found: dict[str, list[dict[str, Any]]] = {}
    for command in _longdrive.described():
        found[command["name"]] = command["options"]
        found.update({f"{command['name']} {below['name']}": below["options"] for below in command["commands"]})
    return found


@cache
def options() -> dict[str, bool]:
    """Every option of any command, without hyphens, and whether it takes a value."""
    found: dict[str, bool] = {}
    for command in commands().values():
        for option in command:
            if not option["positional"]:
                name = option["name"]
                found[name] = found.get(name, False) or option["takes"] != "nothing"
    return found


@cache
def places() -> dict[str, str]:
    """The arguments that are no options, by what stands for their values in messages: ``STUDY``."""
    return {option["value"]: option["name"] for command in commands().values() for option in command if option["positional"]}


def name_or_carry(name: str) -> str:
    """The name of an outcome, for an example: that which was asked for, or carry."""
    return name if any(row["name"] == name for row in _longdrive.outcomes()) else "carry"
