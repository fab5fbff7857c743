"""The options of the commands, as the compiled module describes them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

from . import _longdrive

__all__ = ["Option", "options_of"]


@dataclass(frozen=True)
class Option:
    """An option of a command."""

    name: str
    """The name of the option on the command line, with underscores instead of hyphens."""
    argument: str
    """The name of the argument in Python."""
    value: str
    """The name of the option's value in the help: ``LENGTH``, ``NAME=LOW..HIGH``."""
    takes: str
    """The number of values: ``nothing``, ``one`` or ``several``."""
    is_positional: bool
    is_required: bool
    default: str | None
    help: str
    """The help of the option, with the names of Python's arguments."""

    @property
    def has_default(self) -> bool:
        """True if the option has a default value, or its help describes what happens without it."""
        return bool(self.default or "default" in self.help)

    @property
    def is_output(self) -> bool:
        """True for an option that names an output file, such as `swings` of ``delivery``."""
        return self.help.startswith("Write ")

    @property
    def is_named(self) -> bool:
        """True if the option takes names of parameters or outcomes with a value each."""
        return "=" in self.value


@cache
def options_of(command: str) -> dict[str, Option]:
    """The options of a command such as ``plot contour``, by argument."""
    name, _, below = command.partition(" ")
    described = _described(_longdrive.described(), name)
    if below:
        described = _described(described["commands"], below)
    return {option.argument: option for option in map(_option_of, described["options"])}


def _described(commands: list[dict[str, Any]], name: str) -> dict[str, Any]:
    return next(command for command in commands if command["name"] == name)


def _option_of(described: dict[str, Any]) -> Option:
    return Option(
        name=described["name"].replace("-", "_"),
        argument=described["argument"],
        value=described["value"] or "",
        takes=described["takes"],
        is_positional=described["positional"],
        is_required=described["required"],
        default=described["default"],
        help=described["words"].removesuffix(". Repeatable").replace(". Repeatable [", " ["),
    )
