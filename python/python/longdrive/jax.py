"""Outcomes as functions of JAX, with exact derivatives under ``jit``, ``vmap``, ``grad`` and others.

Only these functions need JAX: ``pip install longdrive[jax]``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import InputError

if TYPE_CHECKING:
    from .types import Amount, Names, SetupLike

__all__ = ["outcome"]


def outcome(
    setup: SetupLike,
    of: Names = "carry",
    wrt: Names | None = None,
    *,
    tolerance: Amount | None = None,
    own_step: bool = False,
) -> Callable[[Any], Any]:
    """An outcome, or several, as a function of JAX.

    The function takes x, shape (parameters,), SI, and returns a number, or for several outcomes an
    array, shape (outcomes,). Its first and second derivatives are exact under ``jit``, ``vmap``,
    ``grad``, ``jacfwd``, ``jacrev`` and ``hessian``; third derivatives are refused. ``vmap`` makes
    one batched call on all processors. Without a drive (no flight, a value outside its range) the
    value is NaN, because compiled code raises no exception; :func:`longdrive.simulate` gives
    the reason.

    Method and step are chosen once, for values around the values of the setup.
    Numbers have the precision of x: with the 32 bits that are usual in JAX, carry is exact to about
    3e-5 m; ``jax.config.update("jax_enable_x64", True)`` gives all digits.

    The function can be pickled, for processes and clusters. The results of ``jit``, ``grad`` and
    ``vmap`` can be pickled only with ``cloudpickle``, which Dask and joblib use; with ``pickle``,
    send the function itself, and transform it in the other process.

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
    Callable[[Any], Any]
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
    >>> import jax, longdrive.jax
    >>> carry = longdrive.jax.outcome("tour-average", "carry", ["club.loft", "swing.speed"])
    >>> jax.grad(carry)(jax.numpy.array([0.18, 50.0])).shape
    (2,)
    """
    import jax
    import jax.numpy as jnp

    from .pointwise import NO_THIRD, OutcomeFunction, Pointwise

    point = Pointwise(setup, of, wrt, tolerance, own_step)
    outcomes, parameters = len(point.of), len(point.wrt)

    def called(order: int, x: Any) -> Any:
        shapes = [(outcomes, *(parameters,) * k) for k in range(order + 1)]
        results = [jax.ShapeDtypeStruct(shape, x.dtype) for shape in shapes]

        # uses only NumPy: JAX within a callback of JAX would deadlock
        def host(x: Any) -> Sequence[Any]:
            x = np.asarray(x)
            return [np.asarray(found, dtype=x.dtype) for found in point(x, order)]

        return tuple(jax.pure_callback(host, results, x, vmap_method="broadcast_all"))

    @jax.custom_jvp
    def values(x: Any) -> Any:
        return called(0, x)[0]

    @jax.custom_jvp
    def slopes(x: Any) -> Any:
        return called(1, x)

    @jax.custom_jvp
    def curvatures(x: Any) -> Any:
        return called(2, x)

    @values.defjvp
    def _(at: Any, along: Any) -> Any:
        value, jacobian = slopes(*at)
        return value, jacobian @ along[0]

    @slopes.defjvp
    def _(at: Any, along: Any) -> Any:
        value, jacobian, hessian = curvatures(*at)
        return (value, jacobian), (jacobian @ along[0], hessian @ along[0])

    @curvatures.defjvp
    def _(at: Any, along: Any) -> Any:
        raise InputError(NO_THIRD.format("jax"))

    def function(x: Any) -> Any:
        x = jnp.asarray(x)
        point.check(x.shape, x.dtype.kind)
        found = values(x)
        return found[0] if point.is_single else found

    return OutcomeFunction(outcome, point, function)
