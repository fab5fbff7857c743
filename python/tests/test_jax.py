"""The function of JAX: values, first and second derivatives, batches; skipped without JAX."""

from __future__ import annotations

import math
import pickle
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import InputError, Setup

jax = pytest.importorskip("jax")
jnp = pytest.importorskip("jax.numpy")
jax.config.update("jax_enable_x64", True)

WRT = ["club.loft", "swing.attack_angle", "swing.speed"]
# with a stated step, so that functions and single drives use equal steps
SETUP = Setup({"preset": "modern-driver", "flight.step": 0.01})
X = np.array([SETUP[name] for name in WRT])


def outcome(*arguments: Any) -> Any:
    from longdrive.jax import outcome

    return outcome(*arguments)


def xs(rows: int) -> Any:
    return X + np.random.default_rng(3).uniform(-1, 1, (rows, 3)) * [0.05, 0.05, 5.0]


def agree(ours: Any, theirs: Any) -> None:
    ours, theirs = np.asarray(ours), np.asarray(theirs)
    assert ours.shape == theirs.shape
    np.testing.assert_allclose(ours, theirs, rtol=1e-12, atol=1e-12 * np.abs(theirs).max())


def test_same_derivatives_as_a_single_drive_in_every_mode() -> None:
    carry = outcome(SETUP, "carry", WRT)
    value, gradient, hessian = longdrive.hessian(SETUP, "carry", WRT)
    for function in (carry, jax.jit(carry)):
        agree(function(X), value)
        for way in (jax.grad, jax.jacfwd, jax.jacrev):
            agree(way(function)(X), gradient)
        agree(jax.value_and_grad(function)(X)[1], gradient)
        for way in (
            jax.hessian,
            lambda f: jax.jacrev(jax.jacfwd(f)),
            lambda f: jax.jacfwd(jax.grad(f)),
            lambda f: jax.jacrev(jax.grad(f)),
        ):
            agree(way(function)(X), hessian)
            agree(jax.jit(way(function))(X), hessian)


def test_several_outcomes_have_a_jacobian() -> None:
    both = outcome(SETUP, ["carry", "spin"], WRT)
    values, rows = longdrive.jacobian(SETUP, ["carry", "spin"], WRT)
    agree(both(X), values)
    agree(jax.jacrev(both)(X), rows)
    agree(jax.jacfwd(both)(X), rows)
    assert jax.hessian(both)(X).shape == (2, 3, 3)


def test_a_batch_is_one_call_and_equal_to_its_rows() -> None:
    carry, many = outcome(SETUP, "carry", WRT), xs(8)
    for function in (carry, jax.grad(carry), jax.hessian(carry)):
        rows = np.stack([function(x) for x in many])
        agree(jax.vmap(function)(many), rows)
        agree(jax.jit(jax.vmap(function))(many), rows)
    grid = many.reshape(4, 2, 3)
    agree(jax.vmap(jax.vmap(carry))(grid), np.asarray(jax.vmap(carry)(many)).reshape(4, 2))
    agree(jax.vmap(carry, in_axes=1)(many.T), jax.vmap(carry)(many))


def test_a_batch_calls_longdrive_once(monkeypatch: pytest.MonkeyPatch) -> None:
    import longdrive.pointwise

    calls: list[int] = []
    batch = longdrive.pointwise.computed
    monkeypatch.setattr(
        longdrive.pointwise, "computed", lambda *a, **k: calls.append(1) or batch(*a, **k)
    )
    jax.block_until_ready(jax.vmap(jax.value_and_grad(outcome(SETUP, "carry", WRT)))(xs(100)))
    assert len(calls) == 1


def test_an_objective_composes_with_a_users_function() -> None:
    carry, x = outcome(SETUP, "carry", WRT), jnp.asarray(X)
    value, gradient, hessian = longdrive.hessian(SETUP, "carry", WRT)
    agree(
        jax.grad(lambda x: jnp.sin(carry(2 * x) / 100))(x / 2),
        np.cos(value / 100) / 100 * 2 * gradient,
    )
    scaled = jax.hessian(lambda x: carry(x) ** 2)(x)
    agree(scaled, 2 * np.outer(gradient, gradient) + 2 * value * hessian)


def test_same_derivatives_forward_and_backward() -> None:
    both, draw = outcome(SETUP, ["carry", "lateral", "spin"], WRT), np.random.default_rng(5)
    for _ in range(5):
        dx, dy = draw.normal(size=3), draw.normal(size=3)
        forward = jax.jvp(both, (X,), (dx,))[1]
        backward = jax.vjp(both, X)[1](dy)[0]
        assert np.vdot(dy, forward) == pytest.approx(np.vdot(backward, dx), rel=1e-12)


def test_a_point_without_a_drive_is_nan() -> None:
    carry = outcome(SETUP, "carry", WRT)
    found = jax.vmap(carry)(np.array([X, [2.0, 0.0, 45.0], [0.1, math.radians(-40), 45.0]]))
    assert np.isnan(found).tolist() == [False, True, True]


def test_third_derivatives_and_wrong_shapes_have_a_message() -> None:
    carry = outcome(SETUP, "carry", WRT)
    with pytest.raises(
        InputError,
        match=r"a third derivative was asked for; take it by differences of the Hessian: \(hessian\(x \+ h\)",
    ):
        jax.jacfwd(jax.hessian(carry))(X)
    with pytest.raises(
        InputError,
        match=r"x has shape \(2,\); expected shape \(3,\): club.loft, swing.attack_angle, swing.speed",
    ):
        carry(X[:2])
    with pytest.raises(InputError, match="expected floats"):
        carry(np.array([1, 2, 3]))
    with pytest.raises(InputError, match="did you mean 'club.loft'"):
        outcome(SETUP, "carry", "club.lofft")


def test_differences_of_hessians_make_a_symmetric_third_derivative_as_the_message_advises() -> None:
    # differences of an exact Hessian along each parameter approximate the third derivatives, and
    # must be symmetric like them
    hessian = jax.hessian(outcome(SETUP, "carry", WRT))

    def asymmetry(h: float) -> float:
        steps = h * np.eye(3)
        third = np.stack([(hessian(X + step) - hessian(X - step)) / (2 * h) for step in steps])
        return float(np.abs(third - third.transpose(1, 0, 2)).max() / np.abs(third).max())

    assert asymmetry(1e-5) < 1e-5


@pytest.mark.parametrize("of", ["carry", ["carry", "spin"]])
def test_same_values_and_derivatives_of_a_pickled_function(of: Any) -> None:
    own = outcome(SETUP, of, WRT)
    kept = pickle.loads(pickle.dumps(own))
    for way in (lambda f: f, jax.jit, jax.jacrev, jax.hessian):
        assert (np.asarray(way(kept)(X)) == np.asarray(way(own)(X))).all()
    assert repr(kept) == repr(own) and kept.__doc__ == own.__doc__


def test_cloudpickle_of_jit_and_grad() -> None:
    cloudpickle = pytest.importorskip("cloudpickle")
    own = outcome(SETUP, "carry", WRT)
    for function in (jax.jit(own), jax.grad(own), jax.jit(jax.hessian(own))):
        assert (
            np.asarray(pickle.loads(cloudpickle.dumps(function))(X)) == np.asarray(function(X))
        ).all()


def test_same_values_in_other_processes() -> None:
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    own = outcome(SETUP, "carry", WRT)
    # in 32 bits, the default of a new process of JAX
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        assert float(pool.submit(own, X).result()) == pytest.approx(float(own(X)), rel=1e-6)


def test_numbers_have_the_precision_of_x() -> None:
    carry = outcome(SETUP, "carry", WRT)
    assert carry(X.astype(np.float32)).dtype == np.float32
    assert float(carry(X.astype(np.float32))) == pytest.approx(float(carry(X)), rel=1e-5)


def test_gradient_ascent_in_jax_reaches_the_programs_optimum() -> None:
    # the best loft of mae494 is inside its range, where the derivative is 0: Newton's method by
    # JAX's own derivatives
    carry = outcome("mae494", "carry", ["club.loft"])
    x = jnp.array([Setup("mae494")["club.loft"]])
    step = jax.jit(lambda x: x - jax.grad(carry)(x) / jax.hessian(carry)(x)[0])
    for _ in range(12):
        x = step(x)
    assert abs(
        longdrive.gradient(
            Setup("mae494").replace({"club.loft": float(x[0])}), wrt="club.loft"
        )[1][0]
    ) < 1e-9
