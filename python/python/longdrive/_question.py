"""A question to a command of the program: its options as words of the command line.

What Python gives (numbers, pairs, dicts, tables, quantities of pint) is written as the command line has it, numbers to the last digit; by what the
program says of its options.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Set
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from . import _longdrive
from ._longdrive import Setup
from .arguments import kind_of, path_of, shown, switch_of, whole_characters
from .described import commands
from .errors import InputError
from .written import count_text, is_quantity, number_text, parts_of, write_table

if TYPE_CHECKING:
    from pathlib import Path

__all__ = ["Question"]

UNITS = {"LENGTH": "m", "SPEED": "m/s", "ANGLE": "rad", "SPIN": "rad/s"}
"""The SI units of what single options take."""


OUTSIDE = re.compile(r" = (-?[\d.]+) rad \(.*\) is outside its range")
"""What the program says of an angle that is too large."""


class Question:
    """A command with its options, written as words."""

    def __init__(self, command: str, folder: Path) -> None:
        self.command = command
        self.words = [*command.split(), "--json"]
        self.text = ""
        self.folder = folder
        self.setup: Setup | None = None
        self.goal = "carry"
        self._units: dict[str, str] = {}
        self._radians: list[float] = []

    def take(self, given: Mapping[str, Any]) -> None:
        """All arguments of the command's function, as the program says of its options.

        Raises:
            InputError: for one that is not what the option takes.
        """
        self.goal = str(
            next(
                (given[name] for name in ("maximize", "minimize") if given.get(name) is not None),
                self.goal,
            )
        )
        for option in commands()[self.command]:
            name = option["argument"]
            if name in given:
                with whole_characters(name):
                    self._take(name, option, given)

    def _take(self, name: str, option: Mapping[str, Any], given: Mapping[str, Any]) -> None:
        value, what = given[name], str(option["value"])
        if name == "output" and value is None:
            value = self.scratch
            if value is not None and given.get("format") is not None:
                raise InputError(
                    f"format = {given['format']!r} is of a file, and no file is written; give output too, or leave format out"
                )
            if value is not None and given.get("overwrite") is not None and switch_of(
                "overwrite", given["overwrite"]
            ):
                raise InputError(
                    "overwrite is about a file, and no file is written; name it with output, or leave overwrite out"
                )
        if value is None and (option["required"] or name == "shots" and option["positional"]):
            raise InputError(
                f"{name} is None, and {self.command} needs it: {option['words'].removesuffix('. Repeatable')}"
            )
        if not option["positional"] and _is_empty(value):
            _refuse_empty(name, option)
        if name == "at" and not isinstance(value, str) and value is not None and "along" in given:
            value = self.places(name, value, given["along"])
        at = len(self.words)
        if not option["positional"]:
            self.option(option["name"], value, option["takes"], what, name)
        elif name == "setup":
            self.take_setup(option["default"] if value is None else value)
        elif name == "other":
            self.take_other(name, value)
        elif what in ("SHOTS", "DATA"):
            self.take_file(name, value)
        else:
            self.take_word(name, value)
        # only names of files may have surrogates for bytes
        encode = os.fsencode if what in PATHS or what in ("SETUP", "SHOTS", "DATA") else str.encode
        for word in self.words[at:]:
            encode(word.partition("=")[2] if word.startswith("--") else word)

    @contextmanager
    def named(self) -> Iterator[None]:
        """What is wrong with a table that goes with this question is told of the argument."""
        try:
            yield
        except InputError as error:
            raise type(error)(self.meant(self.shown(str(error)))) from None

    def meant(self, message: str) -> str:
        """What is wrong with a number of radians, with what was meant where it was given without a unit."""
        found = OUTSIDE.search(message)
        if found is None or not any(
            math.isclose(float(found[1]), number, rel_tol=1e-5) for number in self._radians
        ):
            return message
        return f'{message}; a number without a unit is SI; did you mean "{found[1]} deg"?'

    @property
    def scratch(self) -> Path | None:
        """What is written where no file is asked for: a picture, or the rows of shots."""
        if self.command.startswith("plot "):
            return self.folder / "plot.svg"
        return self.folder / "rows.jsonl" if self.command == "fly" else None

    def shown(self, answer: Any) -> Any:
        """What the program says, without the names of files that go with this question: a table is called as its argument is."""
        if isinstance(answer, dict):
            return {name: self.shown(value) for name, value in answer.items()}
        if isinstance(answer, list):
            return [self.shown(value) for value in answer]
        if not isinstance(answer, str) or str(self.folder) not in answer:
            return answer
        if answer == str(self.scratch):
            return None
        # nobody has asked for this file
        answer = answer.replace(f"; {self.scratch} is not written", "")
        for path in self.folder.iterdir():
            answer = answer.replace(str(path), path.stem)
        return answer.replace(str(self.folder) + os.sep, "")

    def continued(self, given: Mapping[str, Any]) -> str:
        """How it can be gone on with after an interruption."""
        if given.get("checkpoint") is not None:
            return f"the same call goes on from the checkpoint '{os.fspath(given['checkpoint'])}'"
        names = {option["name"] for option in commands()[self.command]}
        if "checkpoint" in names:
            return "the same call begins again; one with checkpoint=FILE saves every iteration, and goes on from there"
        return (
            "the rows so far are kept, and the same call with resume=True goes on"
            if "resume" in names
            else "the same call begins again"
        )

    def take_setup(self, given: Any) -> None:
        """The setup, in its place among the words."""
        setup = given if isinstance(given, Setup) else Setup(given)
        text, is_text = setup._asked()
        self.setup, self.text = setup, text if is_text else ""
        self.words.append("-" if is_text else text)

    def take_file(self, name: str, given: Any) -> None:
        """A file, or a table that is written into one."""
        self.words.append(self.file(name, given))

    def take_word(self, name: str, given: Any) -> None:
        """A word that is not an option."""
        if not isinstance(given, str):
            raise InputError(f"{name} is {kind_of(given)}; expected a name in quotes")
        self.words.append(given)

    def take_other(self, name: str, given: Any) -> None:
        """A second setup, after the first."""
        if given is not None:
            self.words.append(self._one(name, given, "SETUP"))

    def file(self, name: str, given: Any) -> str:
        """The name of a file: the given one, or that of a table as CSV."""
        if isinstance(given, (str, os.PathLike)):
            return os.fspath(given)
        path = self.folder / f"{name}.csv"
        write_table(name, given, path)
        return str(path)

    def option(
        self, name: str, value: Any, kind: str, what: str, argument: str | None = None
    ) -> None:
        """An option with its value: `kind` is what it takes (nothing, one, several), `what` the name of its value, `argument` its name in Python."""
        if value is None or value is False:
            return
        option, name = "--" + name.replace("_", "-"), argument or name
        if kind == "nothing":
            self.words.extend([option] if switch_of(name, value) else [])
        elif kind == "one":
            self.words.append(f"{option}={self._one(name, value, what)}")
        else:
            self.words.extend(f"{option}={text}" for text in self._several(name, value, what))

    def texts(self, name: str, value: Any) -> list[str]:
        """What an option takes several times, as texts."""
        if value is None:
            return []
        option = next(option for option in commands()[self.command] if option["argument"] == name)
        if _is_empty(value):
            _refuse_empty(name, option)
        with whole_characters(name):
            texts = list(self._several(name, value, str(option["value"])))
            for text in texts:
                text.encode()
        return texts

    def _one(self, name: str, value: Any, what: str) -> str:
        if what in PATHS:
            return self.file(name, value) if name in TABLES else path_of(name, value, PATHS[what])
        if what == "SETUP":
            path = self.folder / f"{name}.toml"
            path.write_text(
                (value if isinstance(value, Setup) else Setup(value)).to_toml(), encoding="utf-8"
            )
            return str(path)
        if what in UNITS or what == "AMOUNT":
            return self._amount(name, value, UNITS.get(what) or self._unit(_outcome_of(self.goal)))
        if "=" in what:
            return self._only(name, value, what)
        if isinstance(value, (Mapping, Set)) or parts_of(value) is not None:
            raise InputError(
                f"{name} is {kind_of(value)}; expected {ONE.get(what, 'one text').format(name)}"
            )
        try:
            return str(value)
        except ValueError:  # a whole number of more than 4300 digits
            raise InputError(
                f"{name} = {shown(value)}; expected {ONE.get(what, 'one text').format(name)}"
            ) from None

    def _only(self, name: str, value: Any, what: str) -> str:
        """A name with its value, of which there is one."""
        texts = list(self._several(name, value, what))
        names = (
            [part.rpartition(",")[2].strip() for text in texts for part in text.split("=")[:-1]]
            or texts
        )
        if len(names) != 1:
            found = f"has {len(names)} parameters ({', '.join(names)})" if names else "is empty"
            raise InputError(
                f"{name} {found}; expected one, as in {name}={{'swing.speed': (40.0, 50.0)}}"
            )
        return texts[0]

    def _several(self, name: str, value: Any, what: str) -> Iterable[str]:
        if isinstance(value, str):
            return [value]
        if isinstance(value, Mapping):
            if what == "CONSTRAINT":
                raise InputError(
                    f"{name} is {kind_of(value)}; expected a text or a list of texts, as in {name}=['descent_angle >= 38 deg']"
                )
            return [self._pair(name, key, inner, what) for key, inner in value.items()]
        try:
            items = list(value)
        except TypeError:
            message = f"{name} is {kind_of(value)}; expected a text, a list of texts, or a dict of names with values"
            raise InputError(message) from None
        strange = [item for item in items if not isinstance(item, (str, Mapping))]
        if strange:
            instead = (
                f", or one dict for all, as in {name}={{'club.loft': …}}" if "=" in what else ""
            )
            raise InputError(
                f"{name} has {kind_of(strange[0])} in its {type(value).__name__}: {shown(strange[0])}; expected texts{instead}"
            )
        # a dict among them is one value of several parts: the changes that make a model
        return [
            ",".join(self._several(name, item, what)) if isinstance(item, Mapping) else str(item)
            for item in items
        ]

    def _pair(self, name: str, key: Any, value: Any, what: str) -> str:
        """A name with its value: a text as it is, a number with its SI unit, a pair as a range, a triple as one with a count, a kind with numbers."""
        if isinstance(key, tuple):
            names = ",".join(map(str, key))
            return f"{names}={self._amount(names, value, '')}"
        if value is None:
            return str(key)
        parts = parts_of(value)
        if parts is None:
            return f"{key}={self._amount(key, value, is_difference=name in DIFFERENCES)}"
        if "KIND" in what and parts and isinstance(parts[0], str) and parts[0].isidentifier():
            # the deviation of a normal distribution, cut or not, stands behind its mean
            of_deviation = 1 if parts[0] in ("normal", "truncated") else None
            numbers = [
                self._amount(
                    key, number, is_difference=at == of_deviation
                ) for at, number in enumerate(parts[1:])
            ]
            return f"{key}={parts[0]}({','.join(numbers)})"
        # an array or a list of three is values of one's own, and no (low, high, count)
        is_counted = len(parts) == 3 and isinstance(value, tuple) and ":" in what
        if ".." not in what or not (len(parts) == 2 or is_counted):
            raise InputError(
                f"{key} in {name} is {kind_of(value)} of {len(parts)}; expected {_wanted(name, key, what)}"
            )
        count = f":{count_text(key, parts[2])}" if is_counted else ""
        return f"{key}={self._amount(key, parts[0])}..{self._amount(key, parts[1])}{count}"

    def _amount(
        self, name: str, value: Any, unit: str | None = None, is_difference: bool = False
    ) -> str:
        if value is None:
            raise InputError(
                f"{name} has None where a value is needed; give a number (SI), or a text with its unit like '10.5 deg'"
            )
        if isinstance(value, str):
            return value
        if unit is None:
            unit = self._unit(name)
            # of a name that nothing bears the program says so
            value = value.magnitude if name not in self._units and is_quantity(value) else value
        try:
            text = number_text(value, unit, is_difference)
        except InputError as error:
            raise InputError(f"{name}: {error}") from None
        if unit == "rad":
            self._radians.append(float(text.split()[0]))
        return text

    def places(self, name: str, values: Any, along: Any) -> list[str]:
        """Values along a parameter, numbers in its SI unit."""
        first = (
            along
            if isinstance(along, str)
            else str(next(iter(along), ""))
            if isinstance(along, Iterable)
            else ""
        )
        parameter = first.split("=")[0].strip()
        parts = parts_of(values)
        return [self._amount(parameter, value) for value in ([values] if parts is None else parts)]

    def _unit(self, name: str) -> str:
        if not self._units:
            outcomes = {row["name"]: row["si"] for row in _longdrive.outcomes()}
            self._units = (
                outcomes
                | {
                    row["parameter"]: row["unit"]
                    for row in _longdrive.parameters(self.setup)["parameters"]
                }
            )
        return self._units.get(name, "")


PATHS = {"FILE": "file", "DIR": "folder", "DIR or FILE.csv": "folder or of a CSV file"}
"""What an option names, by the name of its value."""

DIFFERENCES = {"sigma", "change"}
"""Arguments whose numbers are differences: of temperatures, 2 degC are 2 K."""

TABLES = {"points", "shots", "strokes", "swings"}
"""Options that are tables: a file, or columns."""

ONE = {
    "OUTCOME": "one outcome or goal, as in {}='carry'",
    **dict.fromkeys(("N", "K", "SEED", "PIXELS"), "a whole number"),
    **dict.fromkeys(("NUMBER", "POINT"), "a number"),
}
"""What is expected where an option takes one value, by the name of the value."""


def _outcome_of(goal: str) -> str:
    """The outcome whose unit a goal has: none of a share of the drives, nor of strokes."""
    words = re.findall("[a-z_]+", re.sub(r"\b(?:within|strokes)\s*\([^)]*\)", "", goal))
    names = {row["name"] for row in _longdrive.outcomes()}
    return next((word for word in words if word in names), "")


def _is_empty(value: Any) -> bool:
    if isinstance(value, str) or not (hasattr(value, "__len__") and hasattr(value, "__iter__")):
        return False
    try:
        return len(value) == 0
    except TypeError:  # a number with a unit of pint has these, and no length
        return False


def _wanted(name: str, key: Any, what: str) -> str:
    """What a dict of an argument has for a name."""
    if "KIND" in what:
        return "a kind with its numbers, as in ('normal', mean, deviation) or ('uniform', low, high), or a text like 'normal(50 m/s, 1.5 m/s)'"
    if ".." not in what:
        return "one number (SI), or a text with its unit"
    if ":" in what:
        own = (
            f"; values of your own, a drive each, go into points={{'{key}': …}}, or to longdrive.batch"
            if name == "over"
            else ""
        )
        return f"a tuple (low, high, count), for values spread evenly{own}"
    return "(low, high)" + ("; values of your own go into at=…" if name == "along" else "")


REFUSED_EMPTY = {"distribution", "sigma", "model"}
"""Arguments without which something else is asked: an empty one is taken for a mistake."""


def _refuse_empty(name: str, option: Mapping[str, Any]) -> None:
    """An empty dict or list of what has a default, or stands for another question, which nobody asked for: no constraints are what an empty list of them says."""
    if name in REFUSED_EMPTY or option["required"] or option[
        "default"
    ] or "default" in option["help"]:
        left_out = "" if option["required"] else ", or leave it out"
        about = option["words"].removesuffix(". Repeatable").replace(". Repeatable [", " [")
        raise InputError(f"{name} is empty; give one or more{left_out}: {about}")
