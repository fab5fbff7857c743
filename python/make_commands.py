"""Writes ``longdrive/commands.py`` and ``longdrive/plot.py``: a function for each command, of what the commands say of their options.

    python make_commands.py          writes them
    python make_commands.py --check  fails if they are not as they would be written
"""

from __future__ import annotations

import importlib.machinery
import importlib.util
import re
import sys
import textwrap
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).parent / "python" / "longdrive"
WIDTH = 100

# functions written by hand do these
BY_HAND = {"simulate", "gradient", "parameters", "presets", "sweep"}
# what Python does by other means: Setup.replace, objects as answers, lists
LEFT_OUT = {"set", "set-a", "set-b", "json", "csv"}
LEFT_OUT |= {"speed", "attack", "loft", "temperature", "wind", "altitude"}  # a dict of parameters
# a port is listened to by the program
OF_THE_PROGRAM = {"fly": {"listen", "address"}}
SEARCHES = {"optimize", "optimum-sensitivity", "design", "robust"}

TEXTS = {
    "tolerance": "every length is within this length of its exact value, m or a text; without it 1 um where many drives are flown, unless the setup gives " "flight.method or flight.step.",
    "own-step": "integrate by flight.method and flight.step of the setup in every case.",
}
"""What options mean in Python, where the program speaks of its other commands and options."""

HEAD = '''"""{title}

Each of them raises :class:`longdrive.InputError` for bad input, with the program's message, :class:`longdrive.NoAnswerError` for a sound question
without an answer, and :class:`longdrive.Interrupted` after Ctrl-C, with what was found so far. ``progress`` is True for a bar, or a function that is
called with how many parts of how many are done: 0 of 0 while the parts cannot be counted.

Written by make_commands.py from what the program says of its commands; change it there.
"""

from __future__ import annotations

from typing import Literal

{imports}

__all__ = [{names}]
'''


def main() -> int:
    commands = compiled().described()
    plots = next(command for command in commands if command["name"] == "plot")["commands"]
    studies = [command for command in commands if command["name"] not in BY_HAND | {"plot"}]
    written = {
        "commands.py": module(
            "The studies: a function for each command of the program.",
            "from ._ask import ask\nfrom .optimum import Optimum, optimum\nfrom .progress import Progress\nfrom .reply import Reply, as_reply\n" "from .rows import flown\nfrom .types import Amount, Goals, Given, Names, PathLike, SetupLike, TableLike",
            studies,
            "",
        ),
        "plot.py": module(
            "Plots, as pictures for notebooks and files: a function for each kind.",
            "from ._ask import ask\nfrom .picture import Picture, picture\nfrom .progress import Progress\n" "from .types import Amount, Goals, Given, Names, PathLike, SetupLike, TableLike",
            plots,
            "plot ",
        ),
    }
    stale = [name for name, text in written.items() if read(FOLDER / name) != text]
    if "--check" in sys.argv[1:]:
        for name in stale:
            print(
                f"{name} is not what the commands say of their options; run python make_commands.py",
                file=sys.stderr,
            )
        return 1 if stale else 0
    for name, text in written.items():
        (FOLDER / name).write_text(text, encoding="utf-8")
    return 0


def compiled() -> Any:
    """The compiled half of the package, without what is to be written."""
    folders = [FOLDER, *(Path(folder) / "longdrive" for folder in sys.path)]
    files = [
        file
        for folder in folders
        for file in folder.glob("_longdrive.*")
        if file.suffix in (".so", ".pyd")
    ]
    loader = importlib.machinery.ExtensionFileLoader("_longdrive", str(files[0]))
    spec = importlib.util.spec_from_loader("_longdrive", loader)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


def read(path: Path) -> str:
    return path.read_text(encoding="utf-8") if path.exists() else ""


def module(title: str, imports: str, commands: list[dict[str, Any]], before: str) -> str:
    functions = "\n\n".join(function(command, before) for command in commands)
    used = "\n".join(
        line for line in (kept(line, functions) for line in imports.split("\n")) if line
    )
    names = (
        "\n"
        + "".join(
            f'    "{name(command)}",\n'
            for command in sorted(commands, key=lambda command: name(command))
        )
    )
    head = HEAD.format(title=title, imports=used, names=names)
    if "Literal[" not in functions:
        head = head.replace("from typing import Literal\n\n", "")
    return f"{head}\n\n{functions}"


def kept(line: str, text: str) -> str:
    """An import of what is used."""
    source, names = line.split(" import ")
    used = [name for name in names.split(", ") if re.search(rf"\b{name}\b", text)]
    return f"{source} import {', '.join(sorted(used))}" if used else ""


def name(command: dict[str, Any]) -> str:
    return str(command["name"]).replace("-", "_")


def type_of(option: dict[str, Any]) -> str:
    what = option["value"] or ""
    if option["takes"] == "nothing":
        return "bool"
    if option["choices"]:
        return f"Literal[{', '.join(repr(choice) for choice in option['choices'])}]".replace(
            "'", '"'
        )
    if what in ("SETUP", "SETUP_B"):
        return "SetupLike"
    if what in ("N", "K", "SEED", "PIXELS"):
        return "int"
    if what in ("LENGTH", "AMOUNT", "SPEED", "ANGLE", "SPIN", "NUMBER", "POINT"):
        return "Amount"
    if what in ("DIR", "DIR or FILE.csv", "LAW", "STUDY") or option["name"] in (
        "output", "checkpoint"
    ):
        return (
            "str" if what in ("LAW", "STUDY")
            and option["takes"] == "one" else "Names" if what == "LAW" else "PathLike"
        )
    if what in ("FILE", "SHOTS", "DATA") and option["name"] in (
        "swings", "strokes", "shots", "data", "points"
    ):
        return "TableLike"
    if option["takes"] == "several":
        return "Given" if "=" in what else "Goals" if what == "GOAL" else "Names"
    return "Given" if "=" in what else "str"


def function(command: dict[str, Any], before: str) -> str:
    own = name(command)
    left_out = LEFT_OUT | OF_THE_PROGRAM.get(own, set())
    options = [option for option in command["options"] if option["name"] not in left_out]
    is_plot = before != ""
    required = [
        option
        for option in options
        if option["positional"] and option["name"] not in ("setup", "other")
    ]
    setups = [
        option
        for option in options
        if option["positional"] and option["name"] in ("setup", "other")
    ]
    others = [option for option in options if not option["positional"]]
    is_needed = {
        option["name"]
        for option in others
        if option["required"] and not (is_plot and option["name"] == "output")
    }

    parameters = [
        f"{option['name']}: {type_of(option)}{'' if option['required'] or own == 'fly' else ' | None = None'}"
        for option in required
    ]
    parameters += [f"{option['name']}: SetupLike = None" for option in setups]
    if others:
        parameters.append("*")
        for option in sorted(others, key=lambda option: option["name"] not in is_needed):
            python = option["name"].replace("-", "_")
            plain = type_of(option)
            nothing = (
                " = False"
                if plain == "bool"
                else ""
                if option["name"] in is_needed
                else " | None = None"
            )
            parameters.append(f"{python}: {plain}{nothing}")
    parameters.append("progress: Progress = False")
    if not others:
        parameters.insert(-1, "*")

    returns = "Picture" if is_plot else "Optimum" if command["name"] in SEARCHES else "Reply"
    head = "".join(f"    {parameter},\n" for parameter in parameters)
    return f"def {own}(\n{head}) -> {returns}:\n{docstring(command, required, setups, others)}\n{body(command, before)}"


def body(command: dict[str, Any], before: str) -> str:
    """One line: what the program says of the options tells how each argument is written."""
    answered = (
        "picture"
        if before
        else "optimum"
        if command["name"] in SEARCHES
        else "flown"
        if command["name"] == "fly"
        else "as_reply"
    )
    return f'    return ask("{before}{command["name"]}", locals(), {answered})\n'


def docstring(
    command: dict[str, Any], required: list[Any], setups: list[Any], others: list[Any]
) -> str:
    lines = wrapped(as_python(command["about"] or "").rstrip(".") + ".", "    ")
    lines.append("")
    lines.append("    Args:")
    for option in [*required, *setups, *others]:
        python = option["name"].replace("-", "_")
        text = TEXTS.get(option["name"]) or as_python(option["help"] or "")
        if option["name"] == "setup":
            text = "A setup, the name of a preset, a dict, or None for the preset tour-average."
            if command["name"] == "design":
                text = text.replace("tour-average", "modern-driver")
            if command["name"] == "compare":
                text = "The first drive, which messages call a: " + lower(text)
        if option["name"] == "other":
            text = "The second drive, b, as setup is given: for example setup.replace({\"club.loft\": \"11 deg\"}). Without it launch_a or launch_b says in what it differs."
        default = option["default"]
        if default not in (None, "false") and not option[
            "positional"
        ] and option["takes"] != "nothing" and default != "-":
            text += f" [default: {default}]"
        lines += wrapped(f"{python}: {lower(text).removesuffix('.')}.", "        ", "            ")
    lines += wrapped(
        "progress: True for a bar, or a function of parts done and parts in all, 0 of 0 while they cannot be counted.",
        "        ",
        "            ",
    )
    lines[0] = '    """' + lines[0].strip()
    return "\n".join(lines) + '\n    """'


def wrapped(text: str, first: str, then: str | None = None) -> list[str]:
    return textwrap.wrap(
        text,
        WIDTH,
        initial_indent=first,
        subsequent_indent=then or first,
        break_long_words=False,
        break_on_hyphens=False,
    )


def as_python(text: str) -> str:
    """Help in the words of Python: options as names of arguments."""
    text = re.sub(r"--([a-z]+(?:-[a-z]+)*)", lambda match: match[1].replace("-", "_"), text)
    text = re.sub(r"\.? Repeatable\.?$", "", text).replace(
        ", separated by commas", ", one or several"
    )
    return " ".join(
        text.replace("Repeatable. ", "").replace(" Repeatable [", " [").replace(
            " Repeatable.", ""
        ).replace("\\", "\\\\").split()
    )


def lower(text: str) -> str:
    first = text.split(" ", 1)[0]
    return text if not first.istitle() or first == "Huber's" else text[0].lower() + text[1:]


if __name__ == "__main__":
    sys.exit(main())
