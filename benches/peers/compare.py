"""Runs longdrive and its peers in turn, counts their instructions, and writes the tables. Called
by run.sh."""

import datetime
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
BUILD = HERE / "target/peers"
OURS = HERE / "target/release/peers"
PROGRAM = HERE / "target/release/longdrive"
DOCUMENT = HERE / "../../docs/performance.md"
ROUNDS = 3
TASKS = ["T1", "T2", "T3", "T4", "T5", "T6"]
# tasks that no peer computes
OWN = ["all", "3-D", "3-D-all", "W&T", "W&T-1um", "T6-whole"]
TITLES = {
    "T1": "T1 value",
    "T2": "T2 gradient, 2",
    "T3": "T3 Hessian, 2",
    "T4": "T4 gradient, 12",
    "T5": "T5 optimum",
    "T6": "T6 grid, a point",
    "T6-whole": "T6 whole call, a point",
    "all": "gradient, all",
    "3-D": "value, 3-D drive",
    "3-D-all": "gradient, all, 3-D drive",
    "W&T": "23 optima, Winfield & Tan",
    "W&T-1um": "the 23 at 1 µm",
}
# number of operations of each task in a run under valgrind, which counts instructions. An operation
# of T6 computes GRID_POINTS points, or SAMPLED_POINTS if the peer computes every 25th attack angle
OPERATIONS = {
    "T1": 10,
    "T2": 10,
    "T3": 5,
    "T4": 5,
    "T5": 2,
    "T6": 1,
    "all": 3,
    "3-D": 5,
    "3-D-all": 2,
    "W&T": 1,
    "W&T-1um": 1,
}
GRID_POINTS, SAMPLED_POINTS = 2000, 80

# lower bounds of the computation time (Limits in docs/performance.md), clock cycles: of a single
# drive, as a range, and of a point of the grid
LATENCY, GRID_CYCLES = (28700, 33100), 5050

# expected results of every task, with the method and step of the preset
CARRY, GRADIENT = 114.312855130798, [336.769746388603, 298.564796806673]
HESSIAN = [-3068.07279459, -1950.16104589, -1588.91207472]
OPTIMUM, PLACE = 153.333552730536, [14.6829225319, 10.0]
CHECK_SUM, SPINNING_CHECK_SUM = 161794.6416163, 160749.2680134


def core():
    allowed = sorted(os.sched_getaffinity(0))
    return os.environ.get("CORE", str(allowed[-1]))


PIN = ["taskset", "-c", core()] if shutil.which("taskset") else []


def run(command, patience=600):
    done = subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, timeout=patience
    )
    if done.returncode != 0:
        print(f"failed: {' '.join(map(str, command))}\n{done.stderr[-2000:]}", file=sys.stderr)
    return done


def lines(command, patience=600):
    return [
        json.loads(line)
        for line in run(PIN + list(command), patience).stdout.splitlines()
        if line.startswith("{")
    ]


class Peer:
    """A program that does tasks. `timed` is the command that times a task, `counted` the command
    whose instructions valgrind counts (None: they are not counted)."""

    def __init__(self, name, tasks, timed, counted=None, is_sampled=False, note=""):
        self.name, self.tasks, self.timed, self.counted = name, tasks, timed, counted
        self.is_sampled, self.note = is_sampled, note

    def count(self, task):
        """Instructions of an operation, for T6 of a point: the difference between a run with N
        operations and a run with none, divided by N."""
        if self.counted is None or task not in OPERATIONS or not shutil.which("valgrind"):
            return None
        n = OPERATIONS[task]
        totals = []
        for operations in (n, 0):
            tool = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"]
            done = run(tool + self.counted + [task, "count", operations])
            found = re.search(r"Collected : (\d+)", done.stderr)
            if done.returncode != 0 or not found:
                return None
            totals.append(int(found[1]))
        points = 1 if task != "T6" else SAMPLED_POINTS if self.is_sampled else GRID_POINTS
        return (totals[0] - totals[1]) / (n * points)


def compiled(name, tasks, is_sampled=True, suffix=""):
    native, haswell = (BUILD / f"{name}{suffix}.{machine}" for machine in ("native", "haswell"))
    return (
        [Peer(name, tasks, [native], [haswell] if haswell.exists() else None, is_sampled)]
        if native.exists()
        else []
    )


def find_peers(near):
    peers = []
    peers.append(Peer("longdrive", TASKS + OWN, [OURS], [OURS]))
    for name, tasks, choice in (
        ("longdrive at 1 µm", ["T1", "T2", "T3", "T5"], near["single"][0]),
        ("longdrive at 1 µm", ["T6"], near["grid"][0]),
        ("longdrive, steps as in T1", ["T6"], near["single"][0]),
    ):
        command = [
            OURS, "--method", choice["method"], "--step", f"{choice['step']:g}", "--peer", name
        ]
        peers.append(
            Peer(name, tasks, command, command, note=f"{choice['method']} {choice['step']:g} s")
        )
    for compiler in ("gcc", "clang"):
        peers += compiled(f"cpp-dual-{compiler}", TASKS)
        peers += compiled(f"cpp-tuned-{compiler}", ["T1", "T2", "T6"])
        peers += compiled(f"cpp-tuned-{compiler}", ["T4"], suffix=".twelve")
        for lanes in ("simd4", "simd8", "simd2x8"):
            peers += compiled(f"cpp-{lanes}-{compiler}", ["T6"], is_sampled=False)
    peers += compiled("ceres-jet", ["T2", "T3", "T4", "T5", "T6"])
    return peers


def is_dual(name):
    return name.startswith("cpp-dual")


def is_by_hand(name):
    return name.startswith(("cpp-tuned", "cpp-simd"))


class Rows:
    """The measurements by task and peer."""

    def __init__(self):
        self.rows = {}

    def add(self, line):
        row = self.rows.setdefault(
            (line["task"], line["peer"]), {**line, "all": [], "instructions": None}
        )
        row["all"].append(line["seconds"])

    def get(self, task, name):
        return self.rows.get((task, name))

    def of(self, task):
        return [row for (its_task, _), row in self.rows.items() if its_task == task]

    def best(self, task, wanted, key=lambda row: min(row["all"])):
        rows = [row for row in self.of(task) if wanted(row["peer"]) and key(row) is not None]
        return min(rows, key=key, default=None)


def instructions(row):
    return row["instructions"]


def number(x, digits=3):
    if x is None:
        return "–"
    if x >= 10 ** (digits - 1):
        return f"{x:,.0f}".replace(",", " ")
    return f"{x:.{digits}g}" if x < 1e-3 else f"{x:#.{digits}g}".rstrip(".")


def duration(seconds):
    if seconds is None:
        return "–"
    return f"{number(seconds * 1e6)} µs" if seconds < 1e-3 else f"{number(seconds * 1e3)} ms"


def scientific(x):
    return f"{x:.0e}".replace("e-0", "e-").replace("e+0", "e+")


def spread(row):
    return (max(row["all"]) - min(row["all"])) / min(row["all"])


def spread_of(row):
    return f"{100 * spread(row):.0f} %" if len(row["all"]) > 1 else "–"


def ratio(ours, theirs, key=lambda row: min(row["all"])):
    if ours is None or theirs is None or key(ours) is None or key(theirs) is None:
        return "–"
    return f"{key(ours) / key(theirs):.2f}"


def table(head, rows):
    alignment = ["---" if i == 0 else "--:" for i in range(len(head))]
    return "\n".join(
        "| " + " | ".join(map(str, row)) + " |" for row in [head, alignment, *rows]
    ).replace("| --- |", "|---|")


# ---- the tables


def ratios(rows):
    head = [
        "Task",
        "longdrive",
        "/ C++ duals",
        "/ C++ by hand",
        "at 1 µm",
        "1 µm / by hand",
        "Instructions",
        "/ duals",
        "/ by hand",
        "at 1 µm",
    ]
    body = []
    for task in TASKS:
        ours, near = rows.get(task, "longdrive"), rows.get(task, "longdrive at 1 µm")
        dual, hand = rows.best(task, is_dual), rows.best(task, is_by_hand)
        counted = [rows.best(task, wanted, instructions) for wanted in (is_dual, is_by_hand)]
        body.append(
            [
                TITLES[task],
                duration(min(ours["all"])),
                ratio(ours, dual),
                ratio(ours, hand),
                duration(min(near["all"])) if near else "–",
                ratio(near, hand or dual) + ("" if hand or not near else " (duals)"),
                number(ours["instructions"], 4),
                *(ratio(ours, other, instructions) for other in counted),
                number(near["instructions"], 4) if near else "–",
            ]
        )
    return table(head, body)


def further(rows):
    body = []
    for task in OWN:
        row = rows.get(task, "longdrive")
        title = (
            TITLES[task].replace("all", f"all {row['note'].split()[0]}")
            if row["note"]
            else TITLES[task]
        )
        body.append(
            [title, duration(min(row["all"])), spread_of(row), number(row["instructions"], 4)]
        )
    return table(["longdrive alone", "Time", "Spread", "Instructions"], body)


def startups(rows):
    body = []
    for task, title in (
        ("T7 value", "value"), ("T7 gradient", "gradient, 2"), ("T7 optimum", "optimum")
    ):
        ours, dual = rows.get(task, "longdrive"), rows.best(task, is_dual)
        body.append(
            [
                title,
                *(duration(min(row["all"])) if row else "–" for row in (ours, dual)),
                ratio(ours, dual),
            ]
        )
    return table(["T7, process to result", "longdrive", "C++ duals", "ratio"], body)


def everything(rows):
    head = [
        "Task",
        "Peer",
        "Time",
        "Spread",
        "/ C++ duals",
        "/ C++ by hand",
        "Instructions",
        "Off by (relative)",
        "Note",
    ]
    body = []
    for task in TASKS:
        dual, hand = rows.best(task, is_dual), rows.best(task, is_by_hand)
        for row in sorted(rows.of(task), key=lambda row: min(row["all"])):
            off = deviation(row, rows.get(task, "cpp-dual-gcc"))
            body.append(
                [
                    TITLES[task],
                    row["peer"],
                    duration(min(row["all"])),
                    spread_of(row),
                    ratio(row, dual),
                    ratio(row, hand),
                    number(row["instructions"], 4),
                    "–" if off is None else scientific(off),
                    row["note"],
                ]
            )
    return table(head, body)


def deviation(row, reference):
    """The largest relative difference of value and derivatives from the reference."""
    if reference is None:
        return None
    pairs = [] if row["task"] == "T6" else [(row["value"], reference["value"])]
    pairs += zip(row["grad"], reference["grad"])
    if not pairs:
        return None
    return max(abs(a - b) / abs(b) for a, b in pairs)


def precision(ladder):
    head = [
        "Method, step",
        "carry, m",
        "gradient, m/rad",
        "Hessian, m/rad²",
        "value",
        "gradient",
        "Hessian",
        "instructions: value",
        "gradient",
        "Hessian",
    ]
    body = [
        [
            f"{row['method']} {row['step']:g} s",
            *map(scientific, row["errors"]),
            *map(duration, row["seconds"]),
            *(number(count, 4) for count in row["instructions"]),
        ]
        for row in ladder
    ]
    return table(head, body)


# ---- expected results


def wrong(rows):
    """Messages about all results that differ from the expected results."""
    problems = []

    def expect(row, what, found, wanted, tolerance):
        if not abs(found - wanted) <= tolerance * max(1, abs(wanted)):
            problems.append(f"{row['task']} {row['peer']}: {what} {found!r}, not {wanted!r}")

    for task in TASKS:
        for row in rows.of(task):
            if not row["peer"].startswith(("longdrive", "cpp-", "ceres")):
                continue  # finite differences and other discretizations: their errors are in the table
            if row["peer"] == "longdrive, steps as in T1":
                continue  # short flights have larger errors
            is_near = "at 1 µm" in row["peer"]
            if task == "T6":
                # longdrive: compare the sums without the row of loft 0, where carry has a kink
                # (src/grid.rs)
                if row["peer"].startswith("longdrive"):
                    expect(
                        row,
                        "check sum",
                        row["grad"][0],
                        SPINNING_CHECK_SUM,
                        1e-4 if is_near else 1e-11,
                    )
                else:
                    expect(row, "check sum", row["value"], CHECK_SUM, 1e-11)
            elif task == "T5":
                expect(row, "carry", row["value"], OPTIMUM, 1e-8 if is_near else 1e-12)
                for found, wanted in zip(row["grad"], PLACE):
                    expect(row, "optimum at", found, wanted, 1e-4 if is_near else 1e-9 / 14)
            else:
                expect(row, "carry", row["value"], CARRY, 1e-8 if is_near else 1e-12)
                if is_near:
                    continue
                known = GRADIENT + (HESSIAN if task == "T3" else [])
                for found, wanted in zip(row["grad"], known):
                    expect(row, "derivative", found, wanted, 1e-9)
                reference = rows.get(task, "cpp-dual-gcc")
                for found, wanted in zip(row["grad"], reference["grad"] if reference else []):
                    expect(row, "derivative", found, wanted, 1e-9)
    return problems


# ---- the machine


def first_line(*command):
    try:
        return subprocess.run(
            command, capture_output=True, text=True, cwd=HERE
        ).stdout.splitlines()[0].strip()
    except (OSError, IndexError):
        return "?"


def processor():
    found = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    return found[1] if found else "?"


def machine(clocks, loads, near, rows):
    spreads = sorted(spread(row) for task in TASKS for row in rows.of(task) if len(row["all"]) > 1)
    middle, most = spreads[len(spreads) // 2], spreads[-1]
    versions = [
        re.sub(r"\s*\(.*", "", first_line("g++", "--version"))
        + " "
        + first_line("g++", "-dumpfullversion")
    ]
    clang = next((name for name in ("clang++-14", "clang++") if shutil.which(name)), None)
    if clang:
        versions.append(first_line(clang, "--version"))
    versions += [first_line("rustc", "--version"), first_line("valgrind", "--version")]
    code = [
        "../../src", "../../Cargo.toml", "../../Cargo.lock", "src", "cpp", "compare.py", "run.sh"
    ]
    changed = (
        " (changed)" if first_line("git", "diff", "--name-only", "HEAD", "--", *code) != "?" else ""
    )
    commit = first_line("git", "rev-parse", "--short", "HEAD") + changed
    step = lambda choices: f"{choices[0]['method']} at {choices[0]['step']:g} s"
    ghz = [clock["clock_GHz"] for clock in clocks]
    load = f"{min(loads):.1f}–{max(loads):.1f}"
    return (
        f"{datetime.date.today().isoformat()}, longdrive at {commit}; {processor()}, {os.cpu_count()} processors, one used, clock " f"{min(ghz):.2f}–{max(ghz):.2f} GHz; load average {load}. Spread of {ROUNDS} rounds, (max − min)/min: median " f"{100 * middle:.0f} %, largest {100 * most:.0f} %. At 1 µm: T1–T5 {step(near['single'])} (carry within " f"{scientific(near['single'][0]['error'])} m at 10°/0° and at the optimum), T6 {step(near['grid'])} (within " f"{scientific(near['grid'][0]['error'])} m at 1600 points of the grid). The limits below at {max(ghz):.2f} GHz: one drive " f"{LATENCY[0] / max(ghz) / 1e3:.1f}–{LATENCY[1] / max(ghz) / 1e3:.1f} µs, a point of the grid {GRID_CYCLES / max(ghz) / 1e3:.2f} µs. {'; '.join(versions)}."
    )


def between(text, name, content):
    begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
    if begin not in text or end not in text:
        print(f"docs/performance.md has no place for {name}", file=sys.stderr)
        return text
    return (
        text[: text.index(begin) + len(begin)] + "\n\n" + content + "\n\n" + text[text.index(end):]
    )


def main():
    begun = time.time()
    progress = lambda what: print(
        f"{time.time() - begun:5.0f} s  {what}", file=sys.stderr, flush=True
    )
    python = sys.argv[1] if len(sys.argv) > 1 else None
    clocks, loads = lines([BUILD / "machine"]), [os.getloadavg()[0]]
    (near,) = lines([OURS, "one-micrometre"])
    if not (near["single"] and near["grid"]):
        sys.exit("no combination of method and step is within 1 µm of the reference")
    progress(
        "at 1 µm: "
        + "; ".join(
            f"{near[what][0]['method']}, {near[what][0]['step']:g} s" for what in ("single", "grid")
        )
    )
    peers, rows = find_peers(near), Rows()

    for turn in range(ROUNDS):
        for task in [*TASKS, *OWN]:
            for peer in peers:
                if task in peer.tasks:
                    for line in lines(peer.timed + [task]):
                        rows.add(
                            {**line, "note": ", ".join(filter(None, [peer.note, line["note"]]))}
                        )
        clocks += lines([BUILD / "machine"])
        loads.append(os.getloadavg()[0])
        progress(f"round {turn + 1} of {ROUNDS}")

    if python:
        for script in sorted((HERE / "python").glob("*_peer.py")):
            for line in lines([python, script], 900):
                rows.add(line)
            progress(script.name)

    for task, once, arguments in (
        ("T7 value", "T1", ["simulate", "mae494", "--json"]),
        ("T7 gradient", "T2", ["gradient", "mae494", "--json"]),
        ("T7 optimum", "T5", ["optimize", "mae494", "--json", "--vary", "club.loft=0deg..25deg",
                              "--vary", "swing.attack_angle=-10deg..10deg"]),
    ):
        commands = {"longdrive": [PROGRAM, *arguments]}
        for compiler in ("gcc", "clang"):
            if (BUILD / f"cpp-dual-{compiler}.native").exists():
                commands[f"cpp-dual-{compiler}"] = [
                    BUILD / f"cpp-dual-{compiler}.native", once, "once"
                ]
        for name, command in commands.items():
            for line in lines([OURS, "start", name, task, *command]):
                rows.add(line)
    progress("starts of processes")

    ladder = lines([OURS, "work-precision"])
    progress("work and precision, times")

    for peer in peers:
        for task in peer.tasks:
            row = rows.get(task, peer.name)
            if row:
                row["instructions"] = peer.count(task)
        progress(f"instructions of {peer.name}")
    for row in ladder:
        by = ["--method", row["method"], "--step", str(row["step"])]
        step = Peer("", [], [], [OURS, *by])
        row["instructions"] = [step.count(task) for task in ("T1", "T2", "T3")]
    progress("instructions by step")

    about = machine(clocks, loads, near, rows)
    tables = [ratios(rows), startups(rows), further(rows)]
    steps = precision(ladder)
    results = [
        "# Results",
        about,
        *tables,
        "## Every row",
        everything(rows),
        "## Work and precision",
        steps,
    ]
    (HERE / "results.md").write_text("\n\n".join(results) + "\n")
    raw = {"clocks": clocks, "near": near, "rows": list(rows.rows.values()), "ladder": ladder}
    (BUILD / "raw.json").write_text(json.dumps(raw, indent=1))
    if DOCUMENT.exists():
        text = between(DOCUMENT.read_text(), "results", "\n\n".join([about, *tables]))
        DOCUMENT.write_text(text)
    print(tables[0])
    problems = wrong(rows)
    print("\n".join(problems), file=sys.stderr)
    progress("done")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
