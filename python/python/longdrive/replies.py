"""The answers of the studies: a class for each command.

Written by make_commands.py; change it there.
"""

from __future__ import annotations

from typing import Any

from .reply import Reply

__all__ = [
    "CalibrateReply",
    "ChartReply",
    "CompareReply",
    "DeliveryReply",
    "FlyReply",
    "LawsReply",
    "ParetoReply",
    "ReportReply",
    "ReproduceReply",
    "SensitivityReply",
    "SweepReply",
    "UncertaintyReply",
    "ValidateReply",
    "VerifyReply",
]


class CalibrateReply(Reply):
    """The answer of ``calibrate``."""

    status: str
    message: str | None
    interrupted: bool
    """Whether the fit, or one for the held-out error, was interrupted."""
    data: dict[str, Any]
    estimates: dict[str, dict[str, Any]]
    """By fitted parameter."""
    covariance: dict[str, Any]
    correlation: dict[str, Any]
    undetermined: list[dict[str, float | None]]
    """Combinations of parameters that the data do not determine: how much each changes."""
    chi_square: float | None
    degrees_of_freedom: int
    probability: float | None
    uncertainty_scale: float | None
    """What standard uncertainties were multiplied by: 1 where those of the data are stated, or
    where the residuals give no scale; None where no uncertainty is known either."""
    iterations: int
    evaluations: int
    refused: dict[str, Any]
    """Trial points that could not be computed."""
    starts: dict[str, Any]
    residuals: list[dict[str, Any]]
    """Each measured value."""
    held_out: list[dict[str, Any]]
    """How well rows are told that were left out of the fit."""
    setup: dict[str, Any]
    file: str | None
    """The setup file written."""
    folder: str | None
    """The folder of the report written."""


class ChartReply(Reply):
    """The answer of ``chart``."""

    status: str
    message: str | None
    parameter: str
    """The parameter that the chart runs along."""
    objective: str
    sense: str
    points: list[dict[str, Any]]
    begun: str | None
    """Why it begins after the range does."""
    ended: str | None
    """Why it ends before the range does."""


class CompareReply(Reply):
    """The answer of ``compare``."""

    status: str
    message: str | None
    a: dict[str, Any]
    """The first drive, as it was flown."""
    b: dict[str, Any]
    """The second drive."""
    outcomes: list[dict[str, Any]]
    """Each outcome, in the order asked for."""


class DeliveryReply(Reply):
    """The answer of ``delivery``."""

    status: str
    message: str | None
    rows: list[dict[str, Any]]
    """Each shot; one for a launch given by options."""
    spread: list[dict[str, Any]]
    """Each parameter over the shots whose search converged."""
    population: dict[str, Any] | None
    """The normal distribution of the swings behind the shots, without the errors of the launch
    monitor; None of fewer than 10 shots that were found."""


class FlyReply(Reply):
    """The answer of ``fly``."""

    message: str | None
    status: str
    address: str
    """Where it listened."""
    connections: int
    """Connections that were accepted."""
    flown: int
    """Shots that were answered with a flight (Code 200)."""
    others: int
    """Messages without a shot (Code 201), and shots whose ball does not land (Code 200)."""
    refused: int
    """Messages that could not be read (Code 501)."""
    file: str | None
    """Where the rows are; None where they are not written into a file."""
    source: str | None
    """Whose export it is, where its heads tell; of JSON, what wrote the messages or lines."""
    rows: int
    """All rows."""
    noted: int
    """Rows with a value that is assumed or not compared."""
    spin_not_measured: int
    """Rows whose spin is estimated or modelled, as the export says."""
    normalized: int
    """Rows whose values are normalized to other conditions, as the export says."""
    residuals: list[dict[str, Any]]
    """Predicted − measured, of each outcome."""
    clubs: list[dict[str, Any]]
    """The shots of each club, where the table names several."""
    remarks: list[str]
    """What its reader should know of the columns."""
    shots: list[dict[str, Any]]
    """The rows, if they are not written to a file."""


class LawsReply(Reply):
    """The answer of ``laws``."""

    status: str
    message: str | None
    laws: list[dict[str, Any]]


class ParetoReply(Reply):
    """The answer of ``pareto``."""

    status: str
    message: str | None
    goals: list[dict[str, Any]]
    points: list[dict[str, Any]]
    """From the best of the first goal to the best of the second."""
    knee: int | None
    """The place of the knee in points, from 0; None where there is none."""
    bend: float | None
    """How far the front bends off the straight line between its ends, as a part of that line's
    length, with both goals scaled from one end to the other."""
    as_set_up: list[float | None] | None
    """The two goals with the design as set up; None where it does not fly."""
    dominated: int
    """Points left out, since others are better in both goals."""
    swings: dict[str, Any] | None
    """The swings that the goals are about; None for one drive."""
    file: str | None
    """The file written."""


class ReportReply(Reply):
    """The answer of ``report``."""

    status: str
    message: str | None
    folder: str
    files: list[str]


class ReproduceReply(Reply):
    """The answer of ``reproduce``."""

    status: str
    message: str | None
    study: str
    slipped_optimum: dict[str, Any]
    optimum: dict[str, Any]
    table1: list[dict[str, Any]]
    table2: list[dict[str, Any]]
    average: dict[str, Any]
    regression: dict[str, Any]
    energy: dict[str, Any]
    subsystems: dict[str, Any]
    parametric: dict[str, Any]
    noise: dict[str, Any]
    printed: dict[str, Any]
    shot: dict[str, Any]


class SensitivityReply(Reply):
    """The answer of ``sensitivity``."""

    status: str
    message: str | None
    outcomes: list[dict[str, Any]]
    at_optimum: dict[str, Any] | None
    """The optimum, with --at-optimum."""


class SweepReply(Reply):
    """The answer of ``sweep``."""

    status: str
    message: str | None
    file: str
    """Where the rows are: FILE, or FILE.part where the sweep was stopped."""
    rows: int
    """Rows of the whole sweep."""
    written: int
    """Rows that are written."""
    statuses: dict[str, int]
    remarks: list[str]
    """What was not read of the table of points; empty without one."""
    folder: str
    bytes: int
    sha256: str
    """Of the whole file."""
    part: int
    parts: int
    first_row: int
    """Its first row in the whole sweep, from 0."""
    question: str
    """SHA-256 of the question, which is in the file under the key `longdrive`."""
    instructions: str
    """Architecture and instructions of the processor: `x86_64 avx2`."""
    data: str
    """SHA-256 of the bytes before the footer."""
    beyond: list[int]
    """Of the drives that landed: how many begin with what the law was not fitted to, how many were
    struck beside any face, and how many landed flatter than any bounce that was measured."""
    moments: dict[str, dict[str, Any]]
    """Of each outcome and derivative, by the name of its column, SI: rows with a value, their mean,
    the sum of squared deviations from it, the least and the greatest."""
    histograms: list[dict[str, Any]]
    best: list[dict[str, Any]]
    """The rows of --highest, then those of --lowest."""
    present: int
    """Parts that are there and sound."""
    missing: list[int]
    """The numbers of those that are not."""
    faults: list[dict[str, Any]]
    unfinished: list[str]
    """Files of writers that are at work or were killed; they count for nothing."""


class UncertaintyReply(Reply):
    """The answer of ``uncertainty``."""

    status: str
    message: str | None
    inputs: list[dict[str, Any]]
    outcomes: list[dict[str, Any]]
    ellipses: list[dict[str, Any]]
    """Ellipses of the landings."""
    samples: int
    seed: int
    drives: int
    statuses: dict[str, int]


class ValidateReply(Reply):
    """The answer of ``validate``."""

    status: str
    message: str | None
    sets: list[dict[str, Any]]


class VerifyReply(Reply):
    """The answer of ``verify``."""

    status: str
    message: str | None
    passed: bool
    """Whether nothing failed, every planted error was found and nothing was interrupted."""
    rows: list[dict[str, Any]]
    """Each outcome by each parameter, the worst first."""
    negative_control: dict[str, Any]
    """Errors planted on purpose, and in how many rows they were found."""
    landing: list[dict[str, Any]]
    continuity: list[dict[str, Any]]
    convergence: list[dict[str, Any]]
    step_errors: list[dict[str, Any]]
    """What the time step leaves of an error in each outcome of the flight and its derivatives:
    measured, and not part of the verdict."""
    not_examined: list[dict[str, Any]]
    """Checks that were not made of this drive."""
    while_loop: list[dict[str, Any]]
    missing: list[dict[str, Any]]
    """Outcomes that the drive has no derivatives of."""
    left_out: list[str]
    """Parameters of `all` that were left out, with the reason; absent if there are none."""
