"""The longest drive by Newton's method in JAX, from many starts at once, through the exact derivatives of longdrive.

Needs JAX. Run: python jax_newton.py
"""

import jax
import jax.numpy as jnp
import numpy as np

import longdrive
import longdrive.jax

jax.config.update("jax_enable_x64", True)

carry = longdrive.jax.outcome("mae494", "carry", ["club.loft"])


@jax.jit
@jax.vmap
def step(x: jax.Array) -> jax.Array:
    slope, curvature = jax.grad(carry)(x), jax.hessian(carry)(x)[0]
    # where the carry is not concave, Newton's step would go downhill: go a small step uphill
    return x + jnp.where(curvature < 0, -slope / curvature, 0.02 * jnp.sign(slope))


x = jnp.radians(jnp.linspace(5, 25, 8))[:, None]
for _ in range(25):
    x = step(x)
print("lofts", np.degrees(x[:, 0]).round(9), "deg")
print("carry", np.asarray(jax.vmap(carry)(x)).round(6), "m")
