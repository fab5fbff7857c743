"""A request of a command: typed arguments, the setup, and tables in memory."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import is_dataclass
from typing import TYPE_CHECKING, Any

from . import _longdrive
from ._longdrive import Setup
from .angles import BareAngles, check_unit
from .arguments import kind_of, refuse_stated_launch, shown, switch_of, whole_characters
from .axes import check_axes
from .conversion import FILES, Converter, Value, refuse_empty
from .errors import InputError
from .options import Option, options_of
from .setups import CallSetup
from .tables import csv_of

if TYPE_CHECKING:
    from .types import AngleUnit

__all__ = ["Request"]

_TABLES = {"points", "shots", "data", "strokes", "swings"}
"""Arguments that also take a table in memory, if their option takes a file."""


class Request:
    """The arguments of a call, converted for the compiled module.

    Parameters
    ----------
    command
        The command, as ``optimize`` or ``plot contour``.
    arguments
        The arguments of the Python function, by name.

    Raises
    ------
    InputError
        For an argument that its option does not take.
    """

    def __init__(self, command: str, arguments: Mapping[str, Any]) -> None:
        self.command = command
        self.values: dict[str, Value] = {"json": True}
        """Typed values by the names of the options."""
        self.setup: Setup | None = None
        self.setup_text = ""
        """The text of the setup file that the command reads for the setup ``-``."""
        self.stated: list[str] = []
        """The parameters that a dict in place of a setup states. A search keeps their values."""
        self.files: dict[str, bytes] = {}
        """Tables and setups in memory by name."""
        self.output = ""
        """Name of the output file that stays in memory; empty if the call names a file."""
        self.content: bytes | None = None
        """The content of the output file in memory, once the command has ended."""
        self.axes: Any = None
        """Axes of matplotlib for a plot."""
        if arguments.get("ax") is not None and arguments.get("output") is not None:
            raise InputError("ax and output both say where the plot goes; keep one of the two")
        if command == "delivery":
            refuse_stated_launch(arguments.get("setup"), arguments)
        self._setup_warnings: list[str] = []
        self._angles: AngleUnit = check_unit(arguments.get("angles") or "rad")
        self._bare_angles = BareAngles(self._angles)
        goals = (arguments.get(name) for name in ("maximize", "minimize"))
        goal = str(next((goal for goal in goals if goal is not None), "carry"))
        self._converter = Converter(goal, self._bare_angles)
        for option in options_of(command).values():
            if option.argument in arguments:
                with whole_characters(option.argument):
                    self._take(option, arguments)

    @property
    def bare_angles(self) -> list[float]:
        """The angles, rad, that the arguments give without a unit."""
        return self._bare_angles.numbers

    @property
    def warnings(self) -> list[str]:
        """Warnings about the setups and the arguments."""
        return [*self._setup_warnings, *self._bare_angles.warnings()]

    def _take(self, option: Option, arguments: Mapping[str, Any]) -> None:
        name = option.argument
        given = arguments[name]
        if name == "setup":
            self._take_setup(given, option)
            return
        if name == "output" and given is None and self._memory_output(arguments):
            self._take_output(arguments)
            return
        if given is None:
            if option.is_required or (name == "shots" and option.is_positional):
                raise InputError(f"{name} is None, and {self.command} needs it: {option.help}")
            return
        if not option.is_positional:
            refuse_empty(option, given)
        value: Value = self._value(option, given, arguments)
        if option.value not in FILES and not _takes_table(option):
            _refuse_half_characters(value)
        self.values[option.name] = value

    def _value(self, option: Option, given: Any, arguments: Mapping[str, Any]) -> Value:
        name = option.argument
        if _takes_table(option):
            return self._table(name, given)
        if option.value.startswith("SETUP"):
            # a dict without a preset changes the first setup
            text, is_file = self._setup_of(given, self.setup).setup._for_command()
            if not is_file:
                return text
            self.files[name] = text.encode()
            return name
        if name == "at" and "along" in arguments and not isinstance(given, str):
            return self._converter.places(arguments["along"], given)
        if option.is_positional and not isinstance(given, str):
            raise InputError(f"{name} is {kind_of(given)}; expected a name in quotes")
        if option.is_positional:
            return str(given)
        return self._converter.convert(option, given)

    def _take_setup(self, given: Any, option: Option) -> None:
        given = option.default if given is None else given
        call = self._setup_of(given)
        self.setup, self.stated = call.setup, call.stated
        text, is_file = self.setup._for_command()
        self.setup_text = text if is_file else ""
        self.values[option.name] = "-" if is_file else text

    def _setup_of(self, given: Any, base: Setup | None = None) -> CallSetup:
        call = CallSetup.of(given, self._angles, base)
        self._setup_warnings += call.warnings
        return call

    def _memory_output(self, arguments: Mapping[str, Any]) -> str:
        """The name of the output file that stays in memory.

        Only plots and ``fly`` have one; for other commands the name is empty.
        """
        if not self.command.startswith("plot "):
            return "rows.jsonl" if self.command == "fly" else ""
        return "plot.svg" if arguments.get("ax") is None else "plot.csv"

    def _take_output(self, arguments: Mapping[str, Any]) -> None:
        """Makes the command keep a picture, or the rows of shots, in memory."""
        if arguments.get("ax") is not None:
            check_axes(arguments["ax"])
            _refuse_picture(arguments)
            self.axes = arguments["ax"]
        if arguments.get("format") is not None:
            raise InputError(
                f"format = {arguments['format']!r} is the format of a file, and no file is "
                "written; give output too, or leave format out"
            )
        overwrite = arguments.get("overwrite")
        if overwrite is not None and switch_of("overwrite", overwrite):
            raise InputError(
                "overwrite is about a file, and no file is written; name one with output, or leave "
                "overwrite out"
            )
        self.output = self._memory_output(arguments)
        self.values["output"] = self.output

    def _table(self, name: str, given: Any) -> str:
        """The name of a file. A table in memory becomes a file in memory, named as the argument."""
        if isinstance(given, (str, os.PathLike)):
            return os.fsdecode(given)
        self.files[name] = csv_of(name, given)
        return name

    def setup_with_launch(self) -> Setup:
        """The setup with the launch conditions of the argument ``launch``."""
        assert self.setup is not None
        if "launch" not in self.values:
            return self.setup
        # the program knows which conditions of the setup the argument replaces
        values = {name: self.values[name] for name in ("json", "setup", "launch")}
        _, answer, _, raised = _longdrive.command(
            "parameters", values, self.setup_text, {}, [], lambda kind, text: None
        )
        if raised is not None:
            raise raised
        values_of_all = {row["parameter"]: row["value"] for row in answer["parameters"]}
        launch = {name: values_of_all[name] for name in values_of_all if name.startswith("launch.")}
        return self.setup._with_values(launch)

    def texts(self, name: str) -> list[str]:
        """The values of an argument as on the command line, for functions that take texts."""
        values = self.values.get(options_of(self.command)[name].name, [])
        listed = values if isinstance(values, list) else [values]
        return [_longdrive.word_of(value) for value in listed]


def _refuse_picture(arguments: Mapping[str, Any]) -> None:
    """Refuses size and colours of a picture beside axes, which have their own."""
    stated = {
        "width": arguments.get("width") is not None,
        "dark": switch_of("dark", arguments.get("dark", False)),
    }
    for name in stated:
        if stated[name]:
            raise InputError(
                f"{name} = {shown(arguments[name])} is about a picture, and ax has its own size "
                f"and colours; leave {name} out"
            )


def _takes_table(option: Option) -> bool:
    is_input = option.value in ("FILE", "SHOTS", "DATA") and not option.is_output
    return option.argument in _TABLES and is_input


def _refuse_half_characters(value: object) -> None:
    """Raises UnicodeEncodeError for a lone surrogate, which only a file name may have."""
    if isinstance(value, str):
        value.encode()
    elif isinstance(value, list):
        for part in value:
            _refuse_half_characters(part)
    elif is_dataclass(value):
        for part in vars(value).values():
            _refuse_half_characters(part)


