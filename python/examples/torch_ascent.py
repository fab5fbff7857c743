"""The longest drive by an optimizer of PyTorch, through the exact derivatives of longdrive.

Needs PyTorch. Run: python torch_ascent.py
"""

import math

import torch

import longdrive.torch

carry = longdrive.torch.outcome("mae494", "carry", ["club.loft"])
x = torch.tensor([math.radians(10)], dtype=torch.float64, requires_grad=True)
climber = torch.optim.LBFGS([x], max_iter=50, tolerance_grad=1e-10, line_search_fn="strong_wolfe")


def loss() -> torch.Tensor:
    climber.zero_grad()
    lost = -carry(x) / 100
    lost.backward()
    return lost


climber.step(loss)
print(f"loft {math.degrees(x.item()):.6f} deg, carry {carry(x).item():.6f} m")
