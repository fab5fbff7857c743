"""Values that are too deep, too large or no text are refused as bad input, with the argument and
its value."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import longdrive
import longdrive.parts
from longdrive import InputError

HUGE = 10**30
# more than 4300 digits, which Python refuses to convert to a text
ENDLESS = 10**5000
HALF = "carry\ud800"
OVER: dict[str, Any] = {"club.loft": (0.1, 0.2, 3)}
SPREAD: dict[str, Any] = {"swing.path": ("normal", 0.0, 0.02)}


def within_itself() -> dict[str, Any]:
    found: dict[str, Any] = {}
    found["club"] = found
    return found


def deep() -> dict[str, Any]:
    found: dict[str, Any] = {"loft": 0.2}
    for _ in range(100_000):
        found = {"club": found}
    return found


@pytest.mark.parametrize("made", [within_itself, deep])
@pytest.mark.parametrize(
    "call",
    [
        longdrive.Setup,
        longdrive.simulate,
        longdrive.optimize,
        longdrive.objective,
        longdrive.gradient,
        longdrive.parameters,
        lambda given: longdrive.batch(given, {"club.loft": [0.2]}),
        lambda given: longdrive.Setup().replace(given),
        lambda given: longdrive.Setup().replace(**given),
        lambda given: longdrive.compare("mae494", given),
    ],
)
def test_a_dict_within_itself_or_within_very_many_is_refused(
    call: Callable[[Any], Any], made: Callable[[], Any]
) -> None:
    with pytest.raises(
        InputError,
        match="'club.club.club.club' is a dict within 4 others, or within itself; a name has three parts at most",
    ):
        call(made())


def test_a_dict_within_itself_is_no_value_of_an_argument() -> None:
    for made in (within_itself(), deep()):
        with pytest.raises(InputError, match="club.loft: .* is a dict"):
            longdrive.optimize(vary={"club.loft": made})
        with pytest.raises(InputError, match="points: club.loft has dtype object"):
            longdrive.batch("mae494", {"club.loft": made})


U32 = r"expected a whole number of 0 or more \(at most 4294967295\)$"
MOST = r"or more \(at most 9223372036854775807\)$"


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (
            lambda: longdrive.sweep("mae494", {"club.loft": (0.1, 0.2)}, sample=4, seed=2**32),
            f"^seed = 4294967296; {U32}",
        ),
        (
            lambda: longdrive.objective(
                "mae494", "mean(carry)", distribution=SPREAD, scenarios=8, seed=2**32
            ),
            f"^seed = 4294967296; {U32}",
        ),
        (
            lambda: longdrive.objective("mae494", "mean(carry)", distribution=SPREAD, seed=ENDLESS),
            f"^seed = an int too long to show; {U32}",
        ),
        (
            lambda: longdrive.objective(
                "mae494", "mean(carry)", distribution=SPREAD, scenarios=HUGE
            ),
            r"^scenarios = 10+; .*\(at most 100000\)$",
        ),
        (
            lambda: longdrive.sweep("mae494", {"club.loft": (0.1, 0.2)}, sample=HUGE),
            f"^sample = 10+; .*{MOST}",
        ),
        (lambda: longdrive.sweep("mae494", OVER, threads=HUGE), f"^threads = 10+; .*{MOST}"),
        (
            lambda: longdrive.batch("mae494", {"club.loft": [0.2]}, threads=HUGE),
            f"^threads = 10+; .*{MOST}",
        ),
        (
            lambda: longdrive.batch("mae494", {"club.loft": [0.2]}, first_row=HUGE),
            f"^first_row = 10+; .*{MOST}",
        ),
        (lambda: longdrive.optimize(distribution=SPREAD, scenarios=HUGE), "scenarios"),
        (
            lambda: longdrive.optimize(distribution=SPREAD, scenarios=ENDLESS),
            "^scenarios = an int too long to show; expected a whole number$",
        ),
        (lambda: longdrive.uncertainty(samples=ENDLESS), "^samples = an int too long to show"),
        (
            lambda: longdrive.optimize(vary={"club.loft": (0.1, 10**400)}),
            "^club.loft: 10+.* is too large for a 64-bit float",
        ),
        (
            lambda: longdrive.optimize(vary={"club.loft": (0.1, ENDLESS)}),
            "^club.loft: an int too long to show is too large for a 64-bit float",
        ),
        (
            lambda: longdrive.Setup({"club.loft": 10**400}),
            "^'club.loft' = 10+.* is too large for a 64-bit float",
        ),
        (
            lambda: longdrive.Setup({ENDLESS: 1}),
            "^the key an int too long to show of a setup is no text",
        ),
        (
            lambda: longdrive.batch("mae494", {"club.loft": [10**400]}),
            "^points: club.loft has dtype object",
        ),
        (
            lambda: longdrive.batch("mae494", {"club.loft": [0.2]}, tolerance=10**400),
            "^tolerance = ",
        ),
        (
            lambda: longdrive.sweep("mae494", {"club.loft": (0.1, 0.2, HUGE)}),
            "club.loft|the count of club.loft",
        ),
        (
            lambda: longdrive.parts.sweep("mae494", over=OVER, output="never", parts=HUGE),
            f"^parts = 10+; .*{MOST}",
        ),
    ],
)
def test_the_message_on_a_number_that_is_too_large_names_the_argument(
    call: Callable[[], Any], words: str
) -> None:
    with pytest.raises(InputError, match=words):
        call()


@pytest.mark.parametrize(
    ("call", "name"),
    [
        (lambda: longdrive.Setup(HALF), "setup = "),
        (lambda: longdrive.Setup({"preset": HALF}), "'preset' = "),
        (lambda: longdrive.Setup({"club.loft": HALF}), "'club.loft' = "),
        (lambda: longdrive.Setup({HALF: 1.0}), "a name of a setup = "),
        (lambda: longdrive.Setup.from_toml(HALF), "text = "),
        (lambda: longdrive.simulate(of=HALF), "of = "),
        (lambda: longdrive.simulate(of=["carry", HALF]), r"of\[1\] = "),
        (lambda: longdrive.gradient(of=HALF), "of: "),
        (lambda: longdrive.gradient(wrt=HALF), "wrt = "),
        (lambda: longdrive.objective(of=HALF), "of: "),
        (lambda: longdrive.objective(sense=HALF), "sense: "),  # type: ignore[arg-type]
        (lambda: longdrive.objective(invalid=HALF), "invalid: "),  # type: ignore[arg-type]
        (lambda: longdrive.objective(of="mean(carry)", distribution=HALF), "distribution: "),
        (lambda: longdrive.optimize(maximize=HALF), "maximize: "),
        (lambda: longdrive.optimize(vary=[HALF]), "vary: "),
        (lambda: longdrive.optimize(output=HALF), "output: "),
        (lambda: longdrive.plot.trajectory("mae494").save(HALF), "path: "),
        (lambda: longdrive.Setup.read(HALF), ""),
        (lambda: longdrive.fly({HALF: [1.0]}), "shots: "),
        (lambda: longdrive.batch("mae494", {HALF: [0.2]}), "points: a name = "),
    (lambda: longdrive.batch({"club.loft": 0.2}, {HALF: [0.2]}), "points: a name = "),
        (lambda: longdrive.batch("mae494", {"club.loft": HALF}), "points: club.loft = "),
        (lambda: longdrive.batch("mae494", {"club.loft": [0.2]}, tolerance=HALF), "tolerance = "),
        (lambda: longdrive.sweep("mae494", [HALF]), "over: "),
        (lambda: longdrive.sweep("mae494", OVER, of=HALF), "of = "),
    ],
)
def test_the_message_on_a_lone_surrogate_names_the_argument(
    call: Callable[[], Any], name: str
) -> None:
    with pytest.raises(InputError, match=rf"^{name}'carry\\ud800' has half a character"):
        call()


def test_objects_other_than_names_are_not_in_a_setup_or_table() -> None:
    setup = longdrive.Setup()
    assert HALF not in setup and 3 not in setup and None not in setup
    for look in (
        lambda: setup[HALF],
        lambda: longdrive.simulate()[HALF],
        lambda: longdrive.batch("mae494", {"club.loft": [0.2]})[HALF],
    ):
        with pytest.raises(longdrive.UnknownKeyError):
            look()


def test_a_batch_larger_than_memory_is_refused_before_its_rows_are_read() -> None:
    with pytest.raises(
        InputError, match="100000000000 drives with 2 numbers each do not fit into memory"
    ):
        longdrive.batch("mae494", {"club.loft": np.broadcast_to(0.16, 10**11)})
