"""Runs the notebooks of this folder, each from its first cell to its last; their assertions are the checks.

    python run.py                  runs all; fails on the first error of each, and where outputs name a folder of this machine
    python run.py longest-drive    runs one
    python run.py --write          stores the outputs too, so that the notebooks can be read without running them

Needs nbclient, ipykernel, matplotlib and SciPy beside longdrive.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

FOLDER = Path(__file__).resolve().parent
LARGEST = 400_000
MOST_CELLS = 20
# time limit of a hanging notebook, s
PATIENCE = 1200


def main() -> int:
    parser = argparse.ArgumentParser(description="Runs the notebooks.")
    parser.add_argument("names", nargs="*", help="notebooks to run; all without")
    parser.add_argument("--write", action="store_true", help="store the outputs in the notebooks")
    given = parser.parse_args()
    paths = (
        [FOLDER / f"{name.removesuffix('.ipynb')}.ipynb" for name in given.names]
        or sorted(FOLDER.glob("*.ipynb"))
    )
    # no dates in pictures; matplotlibrc makes the rest of them reproducible
    os.environ.setdefault("SOURCE_DATE_EPOCH", "0")
    faults = [fault for path in paths for fault in run(path, given.write)]
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


def run(path: Path, is_writing: bool) -> list[str]:
    """Runs one notebook, and returns its faults."""
    if not path.exists():
        return [
            f"{path.name}: there is no such notebook; there are {', '.join(sorted(other.stem for other in FOLDER.glob('*.ipynb')))}"
        ]
    notebook = nbformat.read(path, as_version=4)
    began = time.monotonic()
    try:
        NotebookClient(
            notebook, kernel_name="python3", timeout=PATIENCE, startup_timeout=PATIENCE,
            extra_arguments=["--log-level=ERROR"], resources={"metadata": {"path": str(FOLDER)}},
        ).execute()  # fmt: skip
    except CellExecutionError as error:
        return [f"{path.name}: {error}"]
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
        for output in cell.get("outputs", []):
            as_picture(output)
    text = nbformat.writes(notebook) + "\n"
    print(
        f"{path.name}: {time.monotonic() - began:.1f} s, {len(notebook.cells)} cells, {len(text.encode()) / 1000:.0f} kB"
    )
    faults = [f"{path.name}: {fault}" for fault in wrong(notebook, text)]
    if is_writing and not faults:
        path.write_text(text, encoding="utf-8")
    return faults


def as_picture(output: Any) -> None:
    """Stores an SVG picture with the MIME type of SVG instead of HTML: viewers of notebooks on the
    web remove SVG from HTML."""
    data = output.get("data", {})
    if data.get("text/html", "").startswith("<svg"):
        data["image/svg+xml"] = data.pop("text/html")
    if "image/svg+xml" in data:
        data.pop("text/plain", None)


def wrong(notebook: Any, text: str) -> list[str]:
    """The faults of a notebook, as messages."""
    faults = []
    if len(text.encode()) > LARGEST:
        faults.append(
            f"it has {len(text.encode()) / 1000:.0f} kB with its outputs; make its pictures simpler, so that it has {LARGEST / 1000:.0f} kB at most"
        )
    if len(notebook.cells) > MOST_CELLS:
        faults.append(
            f"it has {len(notebook.cells)} cells; {MOST_CELLS} are what one reads at a sitting"
        )
    if not any(cell.cell_type == "code" and "assert " in cell.source for cell in notebook.cells):
        faults.append("no cell asserts what the text claims")
    folders = {str(FOLDER.parents[1]), str(Path.home()), tempfile.gettempdir(), sys.prefix} - {"/"}
    for number, cell in enumerate(notebook.cells, 1):
        for output in cell.get("outputs", []):
            if output.output_type == "stream" and output.name == "stderr":
                faults.append(
                    f"cell {number} writes to standard error: {output.text.strip()[:200]}"
                )
            shown = (
                str(output.get("text", ""))
                + "".join(str(part) for part in output.get("data", {}).values())
            )
            faults += [
                f"cell {number} shows a folder of this machine, {folder}"
                for folder in sorted(folders)
                if folder in shown
            ]
    return faults


if __name__ == "__main__":
    sys.exit(main())
