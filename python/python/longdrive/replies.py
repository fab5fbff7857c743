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
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    interrupted: bool
    """True if the fit, or a fit of the cross-validation, was interrupted."""
    data: dict[str, Any]
    """The data."""
    estimates: dict[str, dict[str, Any]]
    """The estimate of each fitted parameter."""
    covariance: dict[str, Any]
    """The covariances of the estimates, each in the product of the SI units of its two
    parameters."""
    correlation: dict[str, Any]
    """The correlations of the estimates, −1 to 1."""
    undetermined: list[dict[str, float | None]]
    """Combinations of parameters that the data do not determine. Each combination consists of
    changes of its parameters, SI."""
    chi_square: float | None
    """χ² of the fit."""
    degrees_of_freedom: int
    """The number of measured values minus the number of parameters that they determine, at least 0.
    Parameters at a bound are not counted."""
    probability: float | None
    """The probability of a χ² at least this large, if the model is right; `None` unless the data
    state every uncertainty and leave degrees of freedom, and with Huber's loss: its weighted χ²
    does not have the χ² distribution."""
    uncertainty_scale: float | None
    """Factor by which the standard uncertainties are multiplied. It is 1 if the data state every
    uncertainty. Otherwise it is √(χ²/degrees of freedom), if there are degrees of freedom and the
    residuals exceed rounding. If not, it is 1 if the uncertainty of every value is known, and
    `None` if one is unknown. With Huber's loss, also for stated uncertainties, it is √(Σψ²/degrees
    of freedom)/mean ψ′, where ψ is the derivative of the loss; `None` if every residual exceeds
    1.345 standard uncertainties."""
    iterations: int
    """Iterations of the fit."""
    evaluations: int
    """Evaluations of the residuals."""
    refused: dict[str, Any]
    """The trial points that the fit rejected."""
    starts: dict[str, Any]
    """The results of the searches from several starts."""
    residuals: list[dict[str, Any]]
    """The residual of each measured value."""
    held_out: list[dict[str, Any]]
    """The prediction errors on held-out data."""
    setup: dict[str, Any]
    """Every parameter of the fitted setup by its dotted name."""
    file: str | None
    """The setup file that was written; `None` if none was written."""
    folder: str | None
    """The folder of the written page; `None` if none was written."""


class ChartReply(Reply):
    """The answer of ``chart``."""

    status: str
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    parameter: str
    """The parameter along which the chart runs."""
    objective: str
    """The outcome that is optimized."""
    sense: str
    """`maximize` or `minimize`."""
    points: list[dict[str, Any]]
    """The points of the chart, in order."""
    begun: str | None
    """The reason why the chart begins after the start of the range; `None` if the chart covers the
    start."""
    ended: str | None
    """The reason why the chart ends before the end of the range; `None` if the chart covers the
    end."""


class CompareReply(Reply):
    """The answer of ``compare``."""

    status: str
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    a: dict[str, Any]
    """The first drive, as computed."""
    b: dict[str, Any]
    """The second drive, as computed."""
    outcomes: list[dict[str, Any]]
    """The differences of the requested outcomes, in the order of the request."""


class DeliveryReply(Reply):
    """The answer of ``delivery``."""

    status: str
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    rows: list[dict[str, Any]]
    """The delivery of each shot; one entry for a single shot."""
    spread: list[dict[str, Any]]
    """Mean and standard deviation of each parameter over the shots."""
    population: dict[str, Any] | None
    """The normal distribution of the swings behind the shots, without the measurement errors of the
    launch monitor; `None` for fewer than 10 shots with a delivery."""


class FlyReply(Reply):
    """The answer of ``fly``."""

    status: str
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    file: str | None
    """The file of the rows; `None` if the rows are not written to a file."""
    source: str | None
    """The maker of the export, if its column heads identify it; for JSON, the name of the
    format."""
    rows: int
    """Number of rows."""
    flown: int
    """Number of rows whose ball landed."""
    refused: list[dict[str, Any]]
    """The rows whose ball did not land, by kind of reason."""
    noted: int
    """Number of rows with assumed values, or with measured values that are not compared with
    predictions."""
    spin_not_measured: int
    """Number of rows whose export states an estimated or modelled spin."""
    normalized: int
    """Number of rows whose export states normalized values."""
    residuals: list[dict[str, Any]]
    """The residuals of each outcome, predicted − measured."""
    clubs: list[dict[str, Any]]
    """The shots of each club; empty unless the table names several clubs."""
    remarks: list[str]
    """Remarks about the columns."""
    shots: list[dict[str, Any]]
    """The rows, if they are not written to a file."""


class LawsReply(Reply):
    """The answer of ``laws``."""

    status: str
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    laws: list[dict[str, Any]]
    """Each law with its published coefficients, then the user's table, if one is given."""


class ParetoReply(Reply):
    """The answer of ``pareto``."""

    status: str
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    goals: list[dict[str, Any]]
    """The two goals."""
    points: list[dict[str, Any]]
    """The points, from the optimum of the first goal to the optimum of the second."""
    knee: int | None
    """The index of the knee in `points`, from 0; `None` without one."""
    bend: float | None
    """The distance of the knee from the chord between the ends, relative to the length of the
    chord. Each goal is scaled by its difference between the ends."""
    as_set_up: list[float | None] | None
    """The goals before the search, SI; `None` if the ball does not fly in one of the swings."""
    dominated: int
    """Number of omitted points that other points dominate."""
    swings: dict[str, Any] | None
    """The swings; `None` for one drive."""
    file: str | None
    """The file that was written; `None` without one."""


class ReportReply(Reply):
    """The answer of ``report``."""

    status: str
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    folder: str
    """The folder."""
    files: list[str]
    """Names of the files."""


class ReproduceReply(Reply):
    """The answer of ``reproduce``."""

    status: str
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    study: str
    """`mae494`."""
    slipped_optimum: dict[str, Any]
    """The optimum of the report's regression if the fitted polynomial is evaluated with the wrong
    powers, as the report does."""
    optimum: dict[str, Any]
    """The optimum of the report's model."""
    table1: list[dict[str, Any]]
    """The optimum at each attack angle of Table 1."""
    table2: list[dict[str, Any]]
    """The optimum at each loft of Table 2."""
    average: dict[str, Any]
    """The loft with the best average carry."""
    regression: dict[str, Any]
    """The optimum of the report's regression."""
    energy: dict[str, Any]
    """The energy of club and ball."""
    subsystems: dict[str, Any]
    """Optima of impact and flight, separately."""
    parametric: dict[str, Any]
    """The sensitivity of the optimum to the constants of the report's model."""
    noise: dict[str, Any]
    """The noise of the carry that the while-loop computes."""
    printed: dict[str, Any]
    """The numbers that the report prints."""
    shot: dict[str, Any]
    """The single shot."""


class SensitivityReply(Reply):
    """The answer of ``sensitivity``."""

    status: str
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    outcomes: list[dict[str, Any]]
    """Each outcome, in the order requested."""
    at_optimum: dict[str, Any] | None
    """The optimum, if the effects belong to the optimal drive; `None` for the drive as set up."""


class SweepReply(Reply):
    """The answer of ``sweep``."""

    status: str
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    file: str
    """The file with the rows; `FILE.part` if the sweep was interrupted."""
    rows: int
    """Number of rows of the whole sweep."""
    written: int
    """Number of rows that are written."""
    statuses: dict[str, Any]
    """Number of drives by status."""
    remarks: list[str]
    """Remarks about unused columns of the table of points; empty if there are none."""
    left_out: list[str]
    """Parameters that `all` leaves out, with the reason. The key is omitted if there are none."""


class UncertaintyReply(Reply):
    """The answer of ``uncertainty``."""

    status: str
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    inputs: list[dict[str, Any]]
    """The uncertain parameters and their distributions."""
    outcomes: list[dict[str, Any]]
    """The uncertainty of each outcome."""
    ellipses: list[dict[str, Any]]
    """Ellipses of the landings; empty unless carry and lateral were requested."""
    samples: int
    """Number of points of the base sample."""
    seed: int
    """The seed of the sample."""
    drives: int
    """Number of drives flown."""
    statuses: dict[str, Any]
    """Number of drives by status."""


class ValidateReply(Reply):
    """The answer of ``validate``."""

    status: str
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    sets: list[dict[str, Any]]
    """The sets."""


class VerifyReply(Reply):
    """The answer of ``verify``."""

    status: str
    """The status in a word."""
    message: str | None
    """The status in a sentence; `None` if there is nothing to add."""
    passed: bool
    """True if nothing failed, every planted error was detected and the command was not
    interrupted."""
    rows: list[dict[str, Any]]
    """The derivative of each outcome by each parameter, the largest error first."""
    negative_control: dict[str, Any]
    """The negative control: the detection of planted errors."""
    landing: list[dict[str, Any]]
    """Derivatives at the landing, compared with differences at a fixed time."""
    continuity: list[dict[str, Any]]
    """The outcomes at parameter values where the number of time steps changes."""
    convergence: list[dict[str, Any]]
    """The convergence of the outcomes with the time step."""
    step_errors: list[dict[str, Any]]
    """The errors of outcomes and derivatives that the time step causes. They do not affect
    `passed`."""
    not_examined: list[dict[str, Any]]
    """Omitted checks, with the reasons."""
    while_loop: list[dict[str, Any]]
    """For comparison: finite differences of the carry that the while-loop of the MAE 494 report
    computes. The while-loop does not interpolate the landing. Each parameter with a certified
    derivative of carry has a row."""
    missing: list[dict[str, Any]]
    """Outcomes without derivatives at this drive, with the reasons."""
    left_out: list[str]
    """Parameters that `all` leaves out, with the reason. The key is omitted if there are none."""
