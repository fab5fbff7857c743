"""The function of PyTorch: values, first and second derivatives, batches; skipped without PyTorch."""

from __future__ import annotations

import math
import pickle
from typing import Any

import numpy as np
import pytest

import longdrive
from longdrive import InputError, Setup

torch = pytest.importorskip("torch")
# torch warns of deprecated functions that it calls itself
pytestmark = pytest.mark.filterwarnings("ignore::FutureWarning", "ignore::DeprecationWarning")

WRT = ["club.loft", "swing.attack_angle", "swing.speed"]
# with a stated step, so that functions and single drives use equal steps
SETUP = Setup({"preset": "modern-driver", "flight.step": 0.01})
X = np.array([SETUP[name] for name in WRT])


def outcome(*arguments: Any) -> Any:
    from longdrive.torch import outcome

    return outcome(*arguments)


def at(x: Any = X) -> Any:
    return torch.tensor(x, dtype=torch.float64, requires_grad=True)


def xs(rows: int) -> Any:
    return torch.tensor(X + np.random.default_rng(3).uniform(-1, 1, (rows, 3)) * [0.05, 0.05, 5.0])


def agree(ours: Any, theirs: Any) -> None:
    ours, theirs = np.asarray(ours.detach()), np.asarray(theirs)
    assert ours.shape == theirs.shape
    np.testing.assert_allclose(ours, theirs, rtol=1e-12, atol=1e-12 * np.abs(theirs).max())


def test_autograd_backward_once_and_twice() -> None:
    carry, x = outcome(SETUP, "carry", WRT), at()
    value, gradient, hessian = longdrive.hessian(SETUP, "carry", WRT)
    found = carry(x)
    agree(found, value)
    (slope,) = torch.autograd.grad(found, x, create_graph=True)
    agree(slope, gradient)
    rows = [torch.autograd.grad(slope[k], x, retain_graph=True)[0] for k in range(3)]
    agree(torch.stack(rows), hessian)
    agree(torch.autograd.functional.hessian(carry, at()), hessian)


def test_gradcheck_of_torch_itself() -> None:
    # scaled so that torch's differences with steps of 1e-6 suit every parameter
    carry = outcome(SETUP, ["carry", "spin"], WRT)
    assert torch.autograd.gradcheck(carry, (at(),), eps=1e-6, rtol=1e-4)
    assert torch.autograd.gradgradcheck(
        lambda x: carry(x)[0], (at(),), eps=1e-6, rtol=1e-4, atol=1e-2
    )


def test_every_transformation_of_torch_func() -> None:
    carry, x = outcome(SETUP, "carry", WRT), torch.tensor(X)
    value, gradient, hessian = longdrive.hessian(SETUP, "carry", WRT)
    for way in (torch.func.grad, torch.func.jacrev, torch.func.jacfwd):
        agree(way(carry)(x), gradient)
    agree(torch.func.hessian(carry)(x), hessian)
    agree(torch.func.jacrev(torch.func.jacrev(carry))(x), hessian)
    both = outcome(SETUP, ["carry", "spin"], WRT)
    values, rows = longdrive.jacobian(SETUP, ["carry", "spin"], WRT)
    agree(both(x), values)
    agree(torch.func.jacrev(both)(x), rows)
    agree(torch.func.jacfwd(both)(x), rows)


def test_a_batch_is_equal_to_its_rows() -> None:
    carry, many = outcome(SETUP, "carry", WRT), xs(20)
    for function in (carry, torch.func.grad(carry), torch.func.hessian(carry)):
        rows = torch.stack([function(x) for x in many])
        agree(torch.func.vmap(function)(many), rows)
    agree(torch.func.vmap(carry, in_dims=1)(many.T), torch.stack([carry(x) for x in many]))


def test_a_batch_calls_longdrive_once(monkeypatch: pytest.MonkeyPatch) -> None:
    import longdrive.pointwise

    calls: list[int] = []
    batch = longdrive.pointwise.computed
    monkeypatch.setattr(
        longdrive.pointwise, "computed", lambda *a, **k: calls.append(1) or batch(*a, **k)
    )
    torch.func.vmap(torch.func.grad(outcome(SETUP, "carry", WRT)))(xs(100))
    assert len(calls) == 1


def test_a_point_without_a_drive_is_nan() -> None:
    found = torch.func.vmap(outcome(SETUP, "carry", WRT))(
        torch.tensor([X.tolist(), [2.0, 0.0, 45.0], [0.1, math.radians(-40), 45.0]])
    )
    assert found.isnan().tolist() == [False, True, True]


def test_third_derivatives_and_wrong_shapes_have_a_message() -> None:
    carry, x = outcome(SETUP, "carry", WRT), at()
    (slope,) = torch.autograd.grad(carry(x), x, create_graph=True)
    (curvature,) = torch.autograd.grad(slope[0], x, create_graph=True)
    with pytest.raises(
        InputError,
        match=r"a third derivative was asked for; take it by differences of the Hessian: \(hessian\(x \+ h\)",
    ):
        torch.autograd.grad(curvature[0], x)
    with pytest.raises(InputError, match=r"x has shape \(2,\); expected shape \(3,\)"):
        carry(at(X[:2]))
    with pytest.raises(InputError, match="expected floats"):
        carry(torch.tensor([1, 2, 3]))
    with pytest.raises(InputError, match="expected a tensor"):
        carry(X)


def test_an_optimizer_of_torch_climbs() -> None:
    carry = outcome("mae494", "carry", ["club.loft"])
    x = at([Setup("mae494")["club.loft"]])
    climber = torch.optim.LBFGS(
        [x],
        lr=1,
        max_iter=50,
        tolerance_grad=1e-10,
        tolerance_change=1e-14,
        line_search_fn="strong_wolfe",
    )

    def closure() -> Any:
        climber.zero_grad()
        loss = -carry(x) / 100
        loss.backward()
        return loss

    climber.step(closure)
    assert abs(
        longdrive.gradient(Setup("mae494").replace({"club.loft": x.item()}), wrt="club.loft")[1][0]
    ) < 1e-5


def test_same_values_and_derivatives_of_a_pickled_function() -> None:
    for of in ("carry", ["carry", "spin"]):
        own = outcome(SETUP, of, WRT)
        kept = pickle.loads(pickle.dumps(own))
        assert torch.equal(kept(at()), own(at()))
        assert torch.equal(torch.func.jacrev(kept)(at()), torch.func.jacrev(own)(at()))
        assert repr(kept) == repr(own) and kept.__doc__ == own.__doc__
