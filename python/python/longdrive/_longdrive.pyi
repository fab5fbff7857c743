"""The compiled module of longdrive. A test compares this file with it (``stubtest``)."""

from collections.abc import (
    Callable,
    ItemsView,
    Iterator,
    KeysView,
    Mapping,
    Sequence,
    ValuesView,
)
from os import PathLike
from typing import Any, Literal, final

import numpy as np
import numpy.typing as npt

from .conversion import Value
from .types import AngleUnit, Floats, Names, Sense, SetupLike

__all__ = [
    "BatchResult",
    "Integration",
    "Objective",
    "Setup",
    "Simulated",
    "__version__",
    "_panic_for_a_test",
    "arrow_stream",
    "batch",
    "command",
    "described",
    "gradient",
    "hessian",
    "in_python",
    "is_out_of_range",
    "jacobian",
    "main",
    "merge_parts",
    "outcomes",
    "parameter_names_in",
    "parameters",
    "plan",
    "presets",
    "requested_names",
    "simulate",
    "unit_of",
    "unit_of_goal",
    "unknown_key",
    "word_of",
    "words_of",
]

__version__: str

@final
class Setup(Mapping[str, Any]):
    """All parameters of a drive."""

    def __new__(cls, given: SetupLike = None, /, *, angles: AngleUnit | None = None) -> Setup: ...
    @staticmethod
    def read(path: str | PathLike[str]) -> Setup: ...
    @staticmethod
    def from_toml(text: str, file: str = "setup.toml") -> Setup: ...
    def _for_command(self) -> tuple[str, bool]: ...
    @staticmethod
    def _of_call(
        given: SetupLike, angles: AngleUnit, base: Setup | None
    ) -> tuple[Setup, list[str], list[tuple[str, float]]]: ...
    def _refuse_idle(self, stated: Sequence[str], columns: Sequence[str], why: str) -> None: ...
    def _warnings_of_club(self) -> list[str]: ...
    @staticmethod
    def _from_state(differences: Mapping[str, Any], table: str | None) -> Setup: ...
    def _with_values(self, values: Mapping[str, Any]) -> Setup: ...
    def replace(
        self,
        changes: Mapping[str, Any] | None = None,
        /,
        *,
        angles: AngleUnit | None = None,
        **named: Any,
    ) -> Setup: ...
    def keys(self) -> KeysView[str]: ...
    def values(self) -> ValuesView[Any]: ...
    def items(self) -> ItemsView[str, Any]: ...
    def get(self, name: str, default: Any = None, /) -> Any: ...
    def __or__(self, changes: Mapping[str, Any], /) -> Setup: ...
    def __ror__(self, changes: Any, /) -> Any: ...
    @property
    def preset(self) -> str: ...
    def to_toml(self) -> str: ...
    def to_dict(self) -> dict[str, Any]: ...
    def warnings(self) -> list[str]: ...
    def __getitem__(self, name: str, /) -> Any: ...
    def __contains__(self, name: object, /) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...
    def __hash__(self, /) -> int: ...
    def _repr_html_(self) -> str: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __copy__(self) -> Setup: ...
    def __deepcopy__(self, _memo: Any) -> Setup: ...

@final
class Objective:
    """An outcome, or a goal over swings, as a function of some parameters."""

    def __new__(
        cls,
        setup: SetupLike,
        of: str = "carry",
        wrt: Names | None = None,
        sense: Sense | None = None,
        invalid: Literal["raise", "nan"] = "raise",
        swings: str | PathLike[str] | None = None,
        distribution: Sequence[str] = ...,
        correlation: Sequence[str] = ...,
        scenarios: int | None = None,
        seed: int | None = None,
        strokes: str | PathLike[str] | None = None,
        tolerance: float | str | None = None,
        own_step: bool = False,
        stated: Sequence[str] = ...,
    ) -> Objective: ...
    def fun(self, x: npt.ArrayLike) -> float: ...
    def jac(self, x: npt.ArrayLike) -> Floats: ...
    def hess(self, x: npt.ArrayLike) -> Floats: ...
    def fun_and_jac(self, x: npt.ArrayLike) -> tuple[float, Floats]: ...
    def __call__(self, x: npt.ArrayLike) -> float: ...
    @property
    def names(self) -> list[str]: ...
    @property
    def of(self) -> str: ...
    @property
    def setup(self) -> Setup: ...
    @property
    def x0(self) -> Floats: ...
    @property
    def bounds(self) -> list[tuple[float, float]]: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __copy__(self) -> Objective: ...
    def __deepcopy__(self, _memo: Any) -> Objective: ...

@final
class Integration:
    """Method and step of a function of parameters, chosen once."""

    def __new__(
        cls,
        setup: Setup,
        of: Names,
        wrt: Names,
        tolerance: float | str | None,
        own_step: bool,
    ) -> Integration: ...

@final
class Simulated:
    """One drive. Each call of ``report`` computes the report."""

    @property
    def outcomes(self) -> dict[str, float | None]: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def path(self) -> tuple[Floats, Floats, Floats, Floats] | None: ...
    def report(self) -> dict[str, Any]: ...

@final
class BatchResult:
    """The results of a batch, and the exception that ended it early."""

    @property
    def status(self) -> npt.NDArray[np.int8]: ...
    @property
    def columns(self) -> Floats: ...
    @property
    def hessians(self) -> Floats | None: ...
    @property
    def of(self) -> list[str]: ...
    @property
    def wrt(self) -> list[str]: ...
    @property
    def parameters(self) -> list[str]: ...
    @property
    def units(self) -> list[str]: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def done(self) -> int: ...
    @property
    def rows(self) -> int: ...
    @property
    def raised(self) -> BaseException | None: ...

def simulate(
    setup: SetupLike,
    of: Names | None,
    is_traced: bool,
    tolerance: float | str | None,
    own_step: bool,
    warnings: Sequence[str],
) -> Simulated: ...
def gradient(
    setup: SetupLike,
    of: str,
    wrt: Names | None,
    tolerance: float | str | None,
    own_step: bool,
) -> tuple[float, Floats]: ...
def jacobian(
    setup: SetupLike,
    of: Names,
    wrt: Names | None,
    tolerance: float | str | None,
    own_step: bool,
) -> tuple[Floats, Floats]: ...
def hessian(
    setup: SetupLike,
    of: str,
    wrt: Names | None,
    tolerance: float | str | None,
    own_step: bool,
) -> tuple[float, Floats, Floats]: ...
def batch(
    setup: SetupLike,
    points: Mapping[str, npt.ArrayLike],
    of: Names,
    wrt: Names | None,
    tolerance: float | str | None,
    own_step: bool,
    threads: int,
    progress: Callable[[int, int], object] | None,
    first_row: int,
    hessians: bool,
    ranges: Sequence[tuple[str, float, float]] | None = None,
    function: Integration | None = None,
) -> BatchResult: ...
def arrow_stream(
    columns: Sequence[tuple[str, Floats, str]],
    status: npt.NDArray[np.int8] | None,
    names: Sequence[str],
    at: int,
    metadata: Mapping[str, str],
) -> Any: ...
def parameter_names_in(dict: Mapping[str, Any]) -> list[str]: ...
def requested_names(
    setup: SetupLike, of: Names, wrt: Names | None
) -> tuple[list[str], list[str]]: ...
def unknown_key(
    what: Literal["column", "outcome", "parameter"], key: object, keys: Sequence[str], advice: str
) -> str: ...
def outcomes() -> list[dict[str, str]]: ...
def parameters(setup: SetupLike = None) -> dict[str, Any]: ...
def presets() -> dict[str, Any]: ...
def _panic_for_a_test(message: str) -> None: ...

def merge_parts(manifests: str) -> dict[str, Any]: ...
def plan(
    setup: SetupLike,
    over: Sequence[str],
    sample: int | None,
    seed: int,
    table: str | PathLike[str] | None,
    files: Mapping[str, bytes],
    bare_angles: Sequence[float],
) -> tuple[dict[str, Floats], list[tuple[str, float, float]], list[str]]: ...
def command(
    command: str,
    arguments: dict[str, Value],
    setup: str,
    files: Mapping[str, bytes],
    outputs: Sequence[str],
    say: Callable[[str, str], object],
    progress: Callable[[int, int], object] | None = None,
    stated: Sequence[str] | None = None,
) -> tuple[int | None, Any, dict[str, bytes], BaseException | None]: ...
def word_of(value: Value) -> str: ...
def words_of(command: str, arguments: dict[str, Value]) -> list[str]: ...
def unit_of(name: str) -> str | None: ...
def unit_of_goal(goal: str) -> str: ...
def is_out_of_range(name: str, value: float) -> bool: ...
def described() -> list[dict[str, Any]]: ...
def in_python(message: str) -> str: ...
def main(words: Sequence[str]) -> int: ...
