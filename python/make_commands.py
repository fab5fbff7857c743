"""Writes ``commands.py``, ``plot.py`` and ``replies.py`` of the package.

A function for each command, from its options; a class for each answer, from its JSON schema. The
example of a function is in ``make_examples.py``, if it needs arguments.

    python make_commands.py          writes them
    python make_commands.py --check  fails if they are not up to date
"""

from __future__ import annotations

import importlib.machinery
import importlib.util
import json
import keyword
import re
import sys
import textwrap
from pathlib import Path
from typing import Any

from make_examples import EXAMPLES

HERE = Path(__file__).parent
FOLDER = HERE / "python" / "longdrive"
SCHEMAS = HERE.parent / "docs" / "schema"
WIDTH = 100

# functions that are not generated
BY_HAND = {"simulate", "gradient", "parameters", "presets", "sweep"}
# options that Python does not need: it has Setup.replace, answers as objects, and dicts of
# parameters
LEFT_OUT = {"set", "set-a", "set-b", "json", "csv"}
LEFT_OUT |= {"speed", "attack", "loft", "temperature", "wind", "altitude"}
# options that only the program has, because it listens to a port
OF_THE_PROGRAM = {"fly": {"listen", "address"}}
# answers of the program's other modes: a listener; a part of a sweep, and the check of all parts
ANSWERS_OF_THE_PROGRAM = {"MessageCounts", "WrittenPart", "CheckedParts"}
SEARCHES = {"optimize", "optimum-sensitivity", "design", "robust"}
# commands whose answers have no class of their own
NO_CLASS = BY_HAND - {"sweep"} | SEARCHES | {"plot"}

TEXTS = {
    "tolerance": "the largest error of a length, m or a text; without it 1 um where many drives "
    "are flown, unless the setup states flight.method or flight.step.",
    "own-step": "keep flight.method and flight.step of the setup.",
    "other": 'the second drive, b: a setup, the name of a preset, or a dict like {"club.loft": '
    '"11 deg"}, which changes the first setup unless it names a preset. Without it launch_a or '
    "launch_b gives the difference.",
}
"""Help in Python of options whose help is about the command line of the program."""

AXES = "Axes in which the plot is drawn, in SI units and radians; the answer then has its data."

HEAD = '''"""{title}

Written by make_commands.py; change it there.
"""

from __future__ import annotations

{imports}

__all__ = [{names}]
'''

IMPORTS = """from typing import TYPE_CHECKING, Any, Literal

from .optimum import Optimum, optimum
from .picture import Picture, picture
from .replies import {replies}
from .reply import Reply, as_reply, with_rows
from .run_command import run_command"""

# annotations are not evaluated
TYPES = """
if TYPE_CHECKING:
    from .progress import Progress
    from .types import Amount, AngleUnit, Given, Goals, Names, PathLike, SetupLike, TableLike"""


def main() -> int:
    commands = compiled().described()
    plots = next(command for command in commands if command["name"] == "plot")["commands"]
    studies = [command for command in commands if command["name"] not in BY_HAND | {"plot"}]
    classes = sorted({str(command["name"]) for command in commands} - NO_CLASS)
    written = {
        "commands.py": module("The studies: a function for each command.", studies, "", classes),
        "plot.py": module("Plots, as pictures: a function for each kind.", plots, "plot ", classes),
        "replies.py": replies(classes),
    }
    stale = [name for name, text in written.items() if read(FOLDER / name) != text]
    if "--check" in sys.argv[1:]:
        for name in stale:
            print(f"{name} is not up to date; run python make_commands.py", file=sys.stderr)
        return 1 if stale else 0
    for name, text in written.items():
        (FOLDER / name).write_text(text, encoding="utf-8")
    return 0


def compiled() -> Any:
    """The compiled module. It is imported without the package, whose files this script writes."""
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


def module(title: str, commands: list[dict[str, Any]], before: str, classes: list[str]) -> str:
    functions = "\n\n".join(function(command, before) for command in commands)
    imports = IMPORTS.format(replies=", ".join(map(class_of, classes))) + "\n" + TYPES
    lines = [kept(line, functions) for line in imports.split("\n")]
    used = "\n".join(line for line in lines if line is not None).strip()
    return HEAD.format(title=title, imports=used, names=listed(map(name, commands))) + (
        f"\n\n{functions}"
    )


def listed(names: Any) -> str:
    return "\n" + "".join(f'    "{name}",\n' for name in sorted(names))


def kept(line: str, text: str) -> str | None:
    """An import statement, reduced to the names that the text uses; None if it uses none."""
    if not line or line == "if TYPE_CHECKING:":
        return line
    source, names = line.split(" import ")
    used = [name for name in names.split(", ") if is_used(name, text)]
    short = f"{source} import {', '.join(used)}"
    if len(short) > WIDTH:
        return f"{source} import (\n" + "".join(f"    {name},\n" for name in sorted(used)) + ")"
    return short if used else None


def is_used(name: str, text: str) -> bool:
    # look only for a use of `optimum` in code: docstrings contain the word, too
    pattern = rf"\b{name}\b" if name[0].isupper() else rf"(, |return ){name}[()]"
    return name == "TYPE_CHECKING" or re.search(pattern, text) is not None


def class_of(command: str) -> str:
    """The name of the class of an answer: ``CompareReply``."""
    return "".join(word.title() for word in command.split("-")) + "Reply"


# attributes of the base class with the same type in every answer
OF_EVERY_REPLY = ("command", "warnings", "held", "advice")


def replies(commands: list[str]) -> str:
    """The classes of the answers of these commands, with their keys as attributes."""
    classes = []
    for command in commands:
        schema = json.loads((SCHEMAS / f"{command}.json").read_text(encoding="utf-8"))
        known = schema["$defs"]
        lines = [f"class {class_of(command)}(Reply):", f'    """The answer of ``{command}``."""', ""]
        found = properties_of(schema, known)
        if command == "fly":
            rows = {"type": "array", "items": {"type": "object"}}
            found["shots"] = rows | {"description": "The rows, if they are not written to a file."}
        for key, value in found.items():
            if not key.isidentifier() or keyword.iskeyword(key) or key in OF_EVERY_REPLY:
                continue
            lines.append(f"    {key}: {python_type(value, known)}")
            text = value.get("description")
            if text:
                text = re.sub(r"\bnull\b", "None", text.replace("\\", "\\\\"))
                lines += wrapped(f'"""{text.removesuffix(".")}."""', "    ")
        classes.append("\n".join(lines) + "\n")
    imports = "from typing import Any\n\nfrom .reply import Reply"
    title = "The answers of the studies: a class for each command."
    head = HEAD.format(title=title, imports=imports, names=listed(map(class_of, commands)))
    return f"{head}\n\n" + "\n\n".join(classes)


def properties_of(schema: dict[str, Any], definitions: dict[str, Any]) -> dict[str, Any]:
    """The properties of an answer, in all its branches that Python can get."""
    schema = resolved(schema, definitions)
    found = dict(schema.get("properties", {}))
    branches = [schema[word] for word in ("then", "else") if word in schema]
    for word in ("anyOf", "oneOf", "allOf"):
        branches += schema.get(word, [])
    for branch in branches:
        if branch.get("$ref", "").rpartition("/")[2] in ANSWERS_OF_THE_PROGRAM:
            continue
        for key, value in properties_of(branch, definitions).items():
            found.setdefault(key, value)
    return found


def resolved(schema: dict[str, Any], definitions: dict[str, Any]) -> dict[str, Any]:
    reference = schema.get("$ref", "")
    if "#/$defs/" not in reference:
        return schema
    inner = definitions.get(reference.rpartition("/")[2], {})
    return schema if inner is schema else resolved(inner, definitions)


def python_type(schema: Any, definitions: dict[str, Any]) -> str:
    """The type of a JSON value in Python."""
    if not isinstance(schema, dict):
        return "Any"
    schema = resolved(schema, definitions)
    for word in ("anyOf", "oneOf"):
        if word in schema:
            types = [python_type(branch, definitions) for branch in schema[word]]
            return united(part for found in types for part in found.split(" | "))
    kinds = schema.get("type")
    values = schema.get("enum", [schema["const"]] if "const" in schema else [])
    if values:
        return united(type_name(value) for value in values)
    if kinds is None:
        return "Any"
    kinds = kinds if isinstance(kinds, list) else [kinds]
    return united(type_of_kind(kind, schema, definitions) for kind in kinds)


def type_of_kind(kind: str, schema: dict[str, Any], definitions: dict[str, Any]) -> str:
    if kind == "array":
        return f"list[{python_type(schema.get('items'), definitions)}]"
    if kind == "object":
        values = schema.get("additionalProperties")
        is_uniform = isinstance(values, dict) and "properties" not in schema
        return f"dict[str, {python_type(values, definitions) if is_uniform else 'Any'}]"
    names = {"string": "str", "number": "float", "integer": "int", "boolean": "bool"}
    return names.get(kind, "None")


def type_name(value: Any) -> str:
    if value in ("inf", "-inf"):
        # Python has infinity as a number
        return "float"
    return "None" if value is None else type(value).__name__


def united(types: Any) -> str:
    """A union with None last."""
    found = dict.fromkeys(types)
    if "Any" in found:
        return "Any"
    if "float" in found:
        found.pop("int", None)
    names = [name for name in found if name != "None"]
    return " | ".join([*names, *(["None"] if "None" in found else [])])


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
        return "PathLike" if (option["help"] or "").startswith("Write ") else "TableLike"
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
    if has_angles(options):
        parameters.append('angles: AngleUnit = "rad"')
    if is_plot:
        parameters.append("ax: Any = None")
    parameters.append("progress: Progress = False")
    if not others:
        parameters.insert(len(required) + len(setups), "*")
    head = "".join(f"    {parameter},\n" for parameter in parameters)
    described = docstring(command, [*required, *setups, *others], before)
    returned = answer(command, before)[0]
    return f"def {own}(\n{head}) -> {returned}:\n{described}\n{body(command, before)}"


def has_angles(options: list[dict[str, Any]]) -> bool:
    """True if a number among the arguments may be an angle."""
    values = [option["value"] or "" for option in options]
    return any("=" in value or value in ("ANGLE", "SETUP") for value in values)


def answer(command: dict[str, Any], before: str) -> tuple[str, str]:
    """The class of the answer, and the function that makes the answer from the reply of the
    command."""
    own = command["name"]
    if before:
        return "Picture", "picture"
    if own in SEARCHES:
        return "Optimum", "optimum"
    if own == "fly":
        return "FlyReply", "with_rows(FlyReply)"
    kind = class_of(own)
    return kind, f"as_reply({kind})"


def body(command: dict[str, Any], before: str) -> str:
    made = answer(command, before)[1]
    return f'    return run_command("{before}{command["name"]}", locals(), {made})\n'


def docstring(command: dict[str, Any], options: list[dict[str, Any]], before: str) -> str:
    """The docstring, in the style of numpydoc."""
    summary, *more = (command["about"] or "").split("\n\n", 1)
    lines = wrapped(as_python(summary).rstrip(".") + ".", '    """', "    ")
    if more:
        lines += ["", *wrapped(as_python(more[0]).rstrip(".") + ".", "    ")]
    lines += section("Parameters")
    for option in options:
        text = lower(text_of(command["name"], option)).removesuffix(".")
        lines += item(option["name"].replace("-", "_"), type_of(option), f"{text}.")
    if has_angles(options):
        lines += item("angles", '{"rad", "deg"}', "The unit of angles without a unit.")
    if before:
        lines += item("ax", "matplotlib.axes.Axes", AXES)
    progress = (
        "True for a bar, or a function of the parts done and all parts, 0 of 0 while they cannot "
        "be counted."
    )
    lines += item("progress", "bool or callable", progress)
    lines += section("Returns")
    lines += item(answer(command, before)[0], "", "The answer.")
    lines += section("Raises")
    lines += item("InputError", "", "For bad input.")
    lines += item("NoAnswerError", "", "For a valid request without an answer.")
    lines += item("Interrupted", "", "After Ctrl-C, with the result so far.")
    lines += section("Examples")
    usual = f">>> longdrive.{name(command)}().status\n'done'"
    example = EXAMPLES.get(f"{before}{command['name']}", usual).strip("\n")
    lines += [f"    {line}".rstrip() for line in ("import longdrive\n" + example).split("\n")]
    first = len(lines) - len(example.split("\n")) - 1
    lines[first] = f"    >>> {lines[first].strip()}"
    return "\n".join(lines) + '\n    """'


def section(title: str) -> list[str]:
    return ["", f"    {title}", f"    {'-' * len(title)}"]


def item(name: str, kind: str, text: str) -> list[str]:
    text = text[0].upper() + text[1:]
    return [f"    {name} : {kind}" if kind else f"    {name}", *wrapped(text, "        ")]


def text_of(command: str, option: dict[str, Any]) -> str:
    """The help of an option in Python."""
    name, default = option["name"], option["default"]
    if name == "setup":
        preset = "modern-driver" if command == "design" else "tour-average"
        text = f"a setup, the name of a preset, a dict, or None for the preset {preset}"
        return f"the first drive, a in messages: {text}" if command == "compare" else text
    text = TEXTS.get(name) or as_python(option["help"] or "")
    has_default = default not in (None, "false", "-") and not option["positional"]
    if has_default and option["takes"] != "nothing":
        text += f" [default: {default}]"
    return text


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
    """Replaces options by the names of Python's arguments in a help text."""
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
