"""NLopt's methods that there are names for, and how large a problem each copes with."""

from __future__ import annotations

METHODS = {
    "lbfgs": ("LD_LBFGS", "limited-memory BFGS"),
    "slsqp": ("LD_SLSQP", "sequential quadratic programming, as in the paper; dense, O(n³) an iteration"),
    "ccsaq": ("LD_CCSAQ", "conservative convex separable approximations; robust and slower"),
    "tnewton": ("LD_TNEWTON_PRECOND_RESTART", "truncated Newton, preconditioned, with restarts"),
    "var2": ("LD_VAR2", "shifted limited-memory variable metric"),
}

DENSE = {"slsqp": 300}  # unknowns up to which an iteration, O(n³), takes a fifth of a second; 1200 take 15 s


def copes(method: str, size: int) -> bool:
    """Whether a method does anything with so many unknowns while one waits; it hears no Ctrl-C meanwhile."""
    return size <= DENSE.get(method.lower(), size)
