"""Messages of the program in the words of Python.

The program names options of its command line; here they are arguments. This is the one place that turns one into the other.
"""

from __future__ import annotations

import re
from typing import Any

from . import _longdrive
from .described import commands, options, places

__all__ = ["answer_in_python", "argument_of", "in_python"]

RENAMED = {"outcomes": "of"}
"""Options whose arguments have another name."""

UNKNOWN = {"json", "csv", "listen", "address"}
"""Options that no function has."""

TEXTS = {"message", "warnings", "notes", "remarks", "reason"}
"""Keys of answers under which there are sentences."""

# 'longdrive optimize mine.toml --vary …' is for a shell, and stays
SHELL = re.compile(r"'longdrive [^']*'")
COMMAND = re.compile(r"'longdrive ([a-z-]+)'")
PLACE = re.compile(r"'<([A-Z_]+)>'")
SHORT = re.compile(r"(?<![\w-])-o(?![\w-])")
# a value is in quotes, has a sign that no word has, is a number, or a word in capitals that stands for one
VALUE = r'"[^"]*"|[^\s,;()\'"]*(?:=|\.\.)(?:"[^"]*"|[^\s,;()\'"]*(?:\([^()]*\))?)|[\d.][^\s,;()\'"]*|[A-Z]{2,}\b|[a-z_]+\b'
OPTION = re.compile(rf"(?<![\w-])--([a-z]+(?:-[a-z]+)*)(?![\w-])(?: <[^>]*>(?:\.\.\.)?|[ =]({VALUE}))?")


def argument_of(option: str) -> str:
    """The argument that an option is."""
    name = option.replace("-", "_")
    return RENAMED.get(name, name)


def in_python(text: str) -> str:
    """A message of the program, with options as arguments: ``--subject-to`` is ``subject_to``."""
    text = PLACE.sub(lambda found: f"'{places().get(found[1], found[1].lower())}'", text)
    if "-" not in text and "'longdrive " not in text:
        return text
    parts, at = [], 0
    for shell in SHELL.finditer(text):
        parts += [_arguments(text[at : shell.start()]), COMMAND.sub(_function, shell[0])]
        at = shell.end()
    return "".join([*parts, _arguments(text[at:])])


def answer_in_python(answer: Any, is_text: bool = False) -> Any:
    """An answer of the program, with its sentences in the words of Python."""
    if isinstance(answer, dict):
        return {name: answer_in_python(value, name in TEXTS) for name, value in answer.items()}
    if isinstance(answer, list):
        return [answer_in_python(value, is_text) for value in answer]
    return in_python(answer) if is_text and isinstance(answer, str) else answer


def _function(command: re.Match[str]) -> str:
    return f"longdrive.{command[1].replace('-', '_')}()" if command[1] in commands() else command[0]


def _arguments(text: str) -> str:
    return OPTION.sub(_argument, SHORT.sub("--output", text))


def _argument(found: re.Match[str]) -> str:
    option, value = found[1], found[2]
    if option not in options() or option in UNKNOWN:
        return found[0]
    if option in ("set", "set-a", "set-b"):
        return _set(value)
    if not options()[option]:
        return f"{argument_of(option)}=True{found[0][len(option) + 2 :]}"
    if value is None or not _is_value(option, value):
        rest = found[0][len(option) + 2 :]
        return argument_of(option) + ("" if rest.startswith(" <") else rest)
    text = value.rstrip(".:")
    is_plain = (text.isupper() and "=" not in text) or text.startswith('"') or _is_number(text)
    shown = text if is_plain else f'"{text}"'
    return f"{argument_of(option)}={shown}{value[len(text) :]}"


def _is_value(option: str, value: str) -> bool:
    if not (value.islower() and value.replace("_", "").isalpha()):
        return True
    # a word is a value where it is one that the option takes, or an outcome
    choices = (choice for command in commands().values() for row in command if row["name"] == option for choice in row["choices"])
    return value in choices or any(value == row["name"] for row in _longdrive.outcomes())


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _set(value: str | None) -> str:
    if value is None or "=" not in value:
        return "setup.replace({…})" + ("" if value is None else f" {value}")
    text = value.rstrip(".:")
    name, _, amount = text.partition("=")
    amount = amount.strip('"')
    return f'setup.replace({{"{name}": "{amount}"}}){value[len(text) :]}'
