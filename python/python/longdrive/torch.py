"""Outcomes as functions of PyTorch, with exact derivatives under ``autograd`` and ``torch.func``.

Only these functions need PyTorch: ``pip install longdrive[torch]``.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .arguments import kind_of
from .errors import InputError

if TYPE_CHECKING:
    import torch

    from .types import Amount, Names, SetupLike

__all__ = ["outcome"]


def outcome(
    setup: SetupLike,
    of: Names = "carry",
    wrt: Names | None = None,
    *,
    tolerance: Amount | None = None,
    own_step: bool = False,
) -> Callable[[torch.Tensor], torch.Tensor]:
    """An outcome, or several, as a function of PyTorch.

    The function takes x, shape (parameters,), SI, and returns a tensor without dimensions, or for
    several outcomes a tensor of shape (outcomes,). Its first and second derivatives are exact under
    ``autograd``, and ``vmap``, ``grad``, ``jacrev``, ``jacfwd`` and ``hessian`` of ``torch.func``;
    third derivatives are refused. ``vmap`` makes one batched call on all processors. Without a
    drive (no flight, a value outside its range) the value is NaN; :func:`longdrive.simulate` gives
    the reason.

    Method and step are chosen once, for values around the values of the setup.
    Numbers have the precision of x: ``torch.float64`` gives all digits. The function can be
    pickled, for processes and clusters.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, or a dict.
    of : Names
        The outcome, or several.
    wrt : Names | None
        The parameters in the order of x; without it loft and attack angle.
    tolerance : Amount | None
        The largest error of a length, m or a text; without it 1 µm, unless the setup states its
        method or step.
    own_step : bool
        Keep ``flight.method`` and ``flight.step`` of the setup.

    Returns
    -------
    Callable[[torch.Tensor], torch.Tensor]
        The function.

    Raises
    ------
    InputError
        For an unknown name, and for x of another shape.

    Warns
    -----
    LongdriveWarning
        As :func:`longdrive.gradient`.

    Examples
    --------
    >>> import torch, longdrive.torch
    >>> carry = longdrive.torch.outcome("tour-average", "carry", ["club.loft", "swing.speed"])
    >>> x = torch.tensor([0.18, 50.0], dtype=torch.float64)
    >>> torch.func.grad(carry)(x).shape
    torch.Size([2])
    """
    import torch
    from torch.autograd import Function

    from .pointwise import NO_THIRD, OutcomeFunction, Pointwise

    point = Pointwise(setup, of, wrt, tolerance, own_step)

    def called(x: torch.Tensor, order: int) -> tuple[torch.Tensor, ...]:
        found = point(x.detach().cpu().numpy(), order)
        return tuple(torch.from_numpy(array.copy()).to(x) for array in found)

    def along(matrix: torch.Tensor, vector: torch.Tensor) -> torch.Tensor:
        return (matrix @ vector.unsqueeze(-1)).squeeze(-1)

    class Curvatures(Function):
        """Values, Jacobian and Hessians."""

        @staticmethod
        def forward(x: torch.Tensor) -> tuple[torch.Tensor, ...]:
            return called(x, 2)

        @staticmethod
        def setup_context(ctx: Any, inputs: tuple[Any, ...], output: Any) -> None:
            pass

        @staticmethod
        def backward(ctx: Any, *along: Any) -> Any:
            raise InputError(NO_THIRD.format("torch"))

        @staticmethod
        def vmap(info: Any, in_dims: tuple[int | None, ...], x: torch.Tensor) -> Any:
            return batched(Curvatures, info, in_dims, x), (0, 0, 0)

    class Slopes(Function):
        """Values and Jacobian.

        The Jacobian is also a result: it is computed together with the values, and it can be
        differentiated again.
        """

        @staticmethod
        def forward(x: torch.Tensor) -> tuple[torch.Tensor, ...]:
            return called(x, 1)

        @staticmethod
        def setup_context(ctx: Any, inputs: tuple[Any, ...], output: Any) -> None:
            ctx.set_materialize_grads(False)
            ctx.save_for_backward(inputs[0], output[1])
            ctx.save_for_forward(inputs[0], output[1])

        @staticmethod
        def backward(ctx: Any, of_values: Any, of_jacobian: Any) -> Any:
            x, jacobian = ctx.saved_tensors
            found = None
            if of_values is not None:
                found = (of_values.unsqueeze(-1) * jacobian).sum(-2)
            if of_jacobian is not None:
                hessian = Curvatures.apply(x)[2]
                more = (of_jacobian.unsqueeze(-1) * hessian).sum((-3, -2))
                found = more if found is None else found + more
            return found

        @staticmethod
        def jvp(ctx: Any, of_x: Any) -> Any:
            x, jacobian = ctx.saved_tensors
            hessian = Curvatures.apply(x)[2]
            return along(jacobian, of_x), along(
                hessian, of_x.unsqueeze(-2).expand(hessian.shape[:-1])
            )

        @staticmethod
        def vmap(info: Any, in_dims: tuple[int | None, ...], x: torch.Tensor) -> Any:
            return batched(Slopes, info, in_dims, x), (0, 0)

    def batched(function: Any, info: Any, in_dims: tuple[int | None, ...], x: torch.Tensor) -> Any:
        # compute all points in one call: they become the first dimension of x and of every result
        at = in_dims[0]
        return function.apply(
            x.expand(info.batch_size, *x.shape) if at is None else x.movedim(at, 0)
        )

    def function(x: torch.Tensor) -> torch.Tensor:
        if not isinstance(x, torch.Tensor):
            raise InputError(f"x is {kind_of(x)}; expected a tensor, shape ({len(point.wrt)},)")
        point.check(tuple(x.shape), "f" if x.is_floating_point() else str(x.dtype))
        values: torch.Tensor = Slopes.apply(x)[0]
        return values[0] if point.is_single else values

    return OutcomeFunction(outcome, point, function)
