"""Gradients with respect to quantities of samples, pulled back to y, y', y'': the transposes of `kinematics`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal, get_args

import numpy as np

from ..array import Array, Index
from .algebra import (
    combine,
    conjugate,
    cross,
    dot,
    hamilton,
    outer,
    rotate,
    rotate_back,
    swing_pulled_back,
    vector_product,
)
from .kinematics import Samples, from_parents, hinge_quaternions
from .wrenches import Wrenches

Gradients = tuple[Array | None, Array | None, Array | None]


Quantity = Literal["y", "y_d", "y_dd", "q", "q_d", "q_dd", "x", "x_d", "x_dd", "omega", "alpha", "turn", "swing"]
ON_LINKS: dict[Quantity, str] = {
    "x": "force",
    "turn": "torque",
    "x_d": "force_d",
    "omega": "torque_d",
    "alpha": "torque_dd",
}  # by quantity, the part of `Wrenches` that is its gradient
QUANTITIES: tuple[Quantity, ...] = get_args(Quantity)
OF_THE_STATE: tuple[tuple[Quantity, Quantity, Quantity], ...] = (
    ("y", "q", "x"),
    ("y_d", "q_d", "x_d"),
    ("y_dd", "q_dd", "x_dd"),
)


class Cotangent:
    """Gradients of one scalar with respect to any quantities of samples, accumulated and pulled back to y, y', y''.

    The quantities, by name; any other name raises ValueError:

    y y_d y_dd                      (S, N) the state
    q q_d q_dd                      (4, n, S) its quaternion blocks
    x x_d x_dd omega alpha          (3, L, S) the links' origins and rotations, in the world
    turn                            (3, L, S) a small rotation of the link in the world, at constant ω and ω'
    swing                           (3, 3, L, S) the matrix of `swing_matrix`
    """

    def __init__(self, samples: Samples) -> None:
        self.samples = samples
        self._parts: dict[Quantity, Array] = {}
        self._wrenches: list[Wrenches] = []
        self._deferred: dict[Callable[[Cotangent, Array], None], Array] = {}

    def defer(self, flush: Callable[[Cotangent, Array], None], kinds: int) -> Array:
        """Return a zero buffer (kinds, 3, L, S) for gradients with respect to a quantity derived from the motion.

        All callers with the same `flush` add to the same buffer. `flush` pulls it back once, at the end.
        """
        if flush not in self._deferred:
            self._deferred[flush] = np.zeros((kinds, 3, len(self.samples.figure.links), self.samples.count))
        return self._deferred[flush]

    def accumulate(self, name: Quantity, gradient: Array, *, donate: bool = False) -> None:
        """Add a gradient with respect to one of the quantities.

        Args:
            name: The name of the quantity.
            gradient: The gradient, see the class for shapes.
            donate: Whether the array may be stored and modified, because the caller does not use it again.
        """
        if self._has(name):
            self._parts[name] += gradient
        else:
            self._parts[name] = gradient if donate else np.array(gradient)

    def buffer(self, name: Quantity) -> Array:
        """Return the array of a gradient, initially zero, to add to by index."""
        if not self._has(name):
            self._parts[name] = np.zeros(self._shape(name))
        return self._parts[name]

    def _has(self, name: Quantity) -> bool:
        if name in self._parts:
            return True
        if name not in QUANTITIES:
            raise ValueError(f"no gradient with respect to '{name}'; there are: {', '.join(QUANTITIES)}")
        return False

    def _shape(self, name: Quantity) -> tuple[int, ...]:
        samples = self.samples
        if name[0] == "y":
            return samples.y.shape
        if name[0] == "q":
            return samples.q.shape
        links = (len(samples.figure.links), samples.count)
        return (3, 3, *links) if name == "swing" else (3, *links)

    def add_wrenches(self, wrenches: Wrenches) -> None:
        self._wrenches.append(wrenches)

    def _flush_wrenches(self) -> None:
        count, shape = self.samples.count, (3, len(self.samples.figure.links), self.samples.count)
        size = shape[1] * shape[2]
        for name, kind in ON_LINKS.items():
            parts_of_kind = [(w, part) for w in self._wrenches if (part := getattr(w, kind)) is not None]
            if parts_of_kind:
                flat = np.concatenate([w.link * count + w.at for w, _ in parts_of_kind])
                places = flat + size * np.arange(3)[:, None]
                vectors = np.concatenate([part for _, part in parts_of_kind], axis=1)
                self.accumulate(
                    name,
                    np.bincount(places.ravel(), vectors.ravel(), 3 * size).astype(float).reshape(shape),
                    donate=True,
                )

    def gradients(self) -> tuple[Array, Array, Array]:
        """Return the gradients with respect to y, y', y'', each (S, N). The cotangent must not be used again."""
        samples = self.samples
        for flush, buffer in self._deferred.items():
            flush(self, buffer)
        if self._wrenches:
            self._flush_wrenches()
        if self._parts.keys() & {"x", "x_d", "x_dd", "omega", "alpha", "turn", "swing"}:
            _origins_pulled_back(self)
            if "swing" in self._parts:
                by_omega, by_alpha = swing_pulled_back(self._parts["swing"], samples.links.omega)
                self.accumulate("omega", by_omega, donate=True)
                self.accumulate("alpha", by_alpha, donate=True)
            quaternions = _quaternion_gradients(self)
            if samples.figure.is_world:
                blocks = [g[:, 1:] for g in quaternions]
            else:
                blocks = _products_pulled_back(self, quaternions)
            for (_, name, _), block in zip(OF_THE_STATE, blocks, strict=False):
                self.accumulate(name, block, donate=True)
        g, g_d, g_dd = (self._by_entries(y, q) for y, q, _ in OF_THE_STATE)
        return g, g_d, g_dd

    def _by_entries(self, name: Quantity, blocks: Quantity) -> Array:
        """Return the gradient with respect to y, y' or y'', (S, N), including that of the quaternion blocks."""
        part = self._parts.get(blocks)
        if part is None:
            return self.buffer(name)
        samples, tables = self.samples, self.samples.figure.tables
        rows = np.zeros((samples.y.shape[1], samples.count))
        if tables.quaternion_slice is None:
            rows[tables.quaternion_columns] = part
        else:
            rows[tables.quaternion_slice].reshape(-1, 4, samples.count)[:] = part.swapaxes(0, 1)
        total = np.ascontiguousarray(rows.T)
        if name in self._parts:
            total += self._parts[name]
        return total

    def get(self, name: Quantity) -> Array | None:
        return self._parts.get(name)


def attached_pulled_back(
    into: Cotangent, s: Array, gradients: Gradients, owners: Index | None = None, swing: Array | None = None
) -> None:
    """Pull gradients of vectors s (3, n, S) that turn with links, s' = ω × s and s'' = A s, back to those of the links.

    Args:
        gradients: The gradients of s, s', s''.
        owners: The link of each vector, (n,); None: one vector per link.
        swing: The matrices A of these links, (3, 3, n, S), if already computed.
    """
    links = into.samples.links
    g, g_d, g_dd = gradients
    pull = g
    if g_d is not None:
        omega = links.omega if owners is None else links.omega[:, owners]
        pull = cross(g_d, omega) if pull is None else pull + cross(g_d, omega)
        _to_owners(into, "omega", cross(s, g_d), owners)
    if g_dd is not None:
        if swing is None:
            swing = links.swing if owners is None else links.swing[:, :, owners]
        through = rotate_back(swing, g_dd)
        pull = through if pull is None else np.add(pull, through, out=through)
        _to_owners(into, "swing", outer(g_dd, s), owners)
    if pull is not None:
        _to_owners(into, "turn", cross(s, pull), owners)


def _to_owners(into: Cotangent, name: Quantity, part: Array, owners: Index | None) -> None:
    """Add the gradients of vectors to those of their links."""
    if owners is not None:
        incidence = np.zeros((len(into.samples.figure.links), owners.size))
        incidence[owners, np.arange(owners.size)] = 1
        part = np.matmul(incidence, part)
    into.accumulate(name, part, donate=True)


def _origins_pulled_back(cotangent: Cotangent) -> None:
    """Pull gradients of x, x', x'' back to positions of free roots, slides, and turn, ω and swing of the links."""
    samples, tables = cotangent.samples, cotangent.samples.figure.tables
    gradients: list[Array | None] = []
    for y_name, _, name in OF_THE_STATE:
        whole = cotangent.get(name)
        g = None if whole is None else combine(tables.beyond, whole)
        gradients.append(g)
        if g is not None and tables.free_links.size:
            columns = tables.position_columns.ravel()
            cotangent.buffer(y_name)[:, columns] += g[:, tables.free_links].reshape(-1, samples.count).T
    g, g_d, g_dd = gradients
    if g is None and g_d is None and g_dd is None:
        return
    links = samples.links
    swing = None if g_dd is None else links.parent_swing
    attached_pulled_back(cotangent, links.step, (g, g_d, g_dd), tables.parents, swing)
    if links.hang is not None:
        x, x_d, x_dd = (None if part is None else -part for part in gradients)
        attached_pulled_back(cotangent, links.hang, (x, x_d, x_dd))
    if tables.slide_links.size:
        _slides_pulled_back(cotangent, gradients)


def _slides_pulled_back(cotangent: Cotangent, displacement_gradients: list[Array | None]) -> None:
    """Pull gradients of displacements q e along slides' axes e back to q, q', q'' and the axes."""
    samples, tables = cotangent.samples, cotangent.samples.figure.tables
    links, slides = samples.links, tables.slide_links
    zero = np.zeros((3, slides.size, samples.count))
    g, g_d, g_dd = (zero if part is None else part[:, slides] for part in displacement_gradients)
    e, swing = links.slide_axis, links.swing[:, :, slides]
    e_d, e_dd = cross(links.omega[:, slides], e), rotate(swing, e)
    q, q_d, q_dd = (links.slide(order) for order in range(3))
    columns = tables.slide_columns
    cotangent.buffer("y")[:, columns] += (dot(g, e) + dot(g_d, e_d) + dot(g_dd, e_dd)).T
    cotangent.buffer("y_d")[:, columns] += (dot(g_d, e) + 2 * dot(g_dd, e_d)).T
    cotangent.buffer("y_dd")[:, columns] += dot(g_dd, e).T
    axis = (q * g + q_d * g_d + q_dd * g_dd, q * g_d + 2 * q_d * g_dd, q * g_dd)
    attached_pulled_back(cotangent, e, axis, slides, swing)


def _quaternion_gradients(cotangent: Cotangent) -> list[Array]:
    """Return gradients (4, L, S) with respect to Q, Q', Q'' of the links for those of turn, ω and ω'. Trailing zero
    gradients are omitted. G denotes the matrix of `vector_product`: (0, v) ⊗ Q = Gᵀ v."""
    links = cotangent.samples.links
    turn, omega_bar, alpha_bar = (cotangent.get(name) for name in ("turn", "omega", "alpha"))
    product = links.vector_product
    if omega_bar is None and alpha_bar is None:
        assert turn is not None
        return [rotate_back(product, turn * links.scale)]
    first = np.zeros_like(links.omega) if omega_bar is None else omega_bar
    if alpha_bar is None:
        h0, h1 = cross(links.omega, first), first * links.scale
    else:
        h0 = cross(links.omega, first)
        h0 += cross(links.alpha, alpha_bar)
        h1 = cross(links.omega, alpha_bar)
        h1 += first
        h1 *= links.scale
    if turn is not None:
        h0 += turn
    h0 *= links.scale
    rate = 2 * links.rates[0]
    if alpha_bar is None:
        h0 -= links.rates[0] * h1
        return [_product_sum((product, h0), (vector_product(links.Q_d), h1)), rotate_back(product, h1)]
    h2 = alpha_bar * links.scale
    h1 -= rate * h2
    h0 -= links.rates[0] * h1
    h0 -= (links.rates[1] + dot(links.Q_d, links.Q_d) * links.scale) * h2
    product_d = vector_product(links.Q_d)
    g0 = _product_sum((product, h0), (product_d, h1), (vector_product(links.Q_dd), h2))
    return [g0, _product_sum((product, h1), (product_d, 2 * h2)), rotate_back(product, h2)]


def _product_sum(*terms: tuple[Array, Array]) -> Array:
    """Return Σ Gᵀ h, (4, L, S)."""
    (matrix, vector), *rest = terms
    total = rotate_back(matrix, vector)
    for matrix, vector in rest:
        total += rotate_back(matrix, vector)
    return total


def _products_pulled_back(cotangent: Cotangent, gradients: list[Array]) -> list[Array]:
    """Pull gradients of world quaternions C = A ⊗ c back to those of joint coordinates, from the leaves to the root."""
    samples, tables = cotangent.samples, cotangent.samples.figure.tables
    links = samples.links
    local, base = from_parents(links.states).swapaxes(0, 1), links.quaternions.swapaxes(0, 1)
    grads = np.zeros_like(base)
    for order, gradient in enumerate(gradients):
        grads[:, order] = gradient
    for level in reversed(tables.levels):
        parents = tables.parents[level]
        g, a, c = grads[:, :, level], base[:, :, parents], local[:, :, level]
        pairs = _OF_SUM, _OF_OTHER
        up = _summed_back(hamilton(g[:, pairs[0]], conjugate(c[:, pairs[1]])))
        grads[:, :, level] = _summed_back(hamilton(conjugate(a[:, pairs[1]]), g[:, pairs[0]]))
        for i, parent in enumerate(parents):
            grads[:, :, parent] += up[:, :, i]
    if tables.has_turns and tables.levels:
        below = np.concatenate(tables.levels)
        grads[:, :, below] = hamilton(conjugate(tables.turn[:, None, below, None]), grads[:, :, below])
    grads = grads.swapaxes(0, 1)
    _hinges_pulled_back(cotangent, [grad[:, tables.hinge_links] for grad in grads])
    return [grad[:, tables.quaternion_links] for grad in grads]


# for the gradients of either factor: orders of the gradients of C, and of the other factor that multiplies them
_OF_SUM, _OF_OTHER = np.array([0, 1, 2, 1, 2, 2]), np.array([0, 1, 2, 0, 1, 0])


def _summed_back(parts: Array) -> Array:
    """Return the gradients of a factor and its two derivatives, (4, 3, l, S), for the products (4, 6, l, S)."""
    return np.stack([parts[:, 0] + parts[:, 1] + parts[:, 2], parts[:, 3] + 2 * parts[:, 4], parts[:, 5]], axis=1)


def _hinges_pulled_back(cotangent: Cotangent, grads: list[Array]) -> None:
    """Pull gradients of (cos θ/2, axis sin θ/2) and its derivatives back to θ, θ', θ''."""
    samples, tables = cotangent.samples, cotangent.samples.figure.tables
    if not tables.hinge_links.size:
        return
    q, _, _ = hinge_quaternions(samples.links.states)
    axis = tables.axis[:, tables.hinge_links][:, :, None]
    normal = np.concatenate([-dot(q[1:], axis + 0 * q[1:])[None], axis * q[0]])
    theta_d, theta_dd = (samples.columns(tables.hinge_columns, k) for k in (1, 2))
    g, g_d, g_dd = grads
    along, along_d, along_dd = dot(g, normal), dot(g_d, normal), dot(g_dd, normal)
    out_d, out_dd = dot(g_d, q), dot(g_dd, q)
    columns = tables.hinge_columns
    cotangent.buffer("y")[:, columns] += (
        0.5 * along - 0.25 * theta_d * out_d - 0.25 * theta_dd * out_dd - 0.125 * theta_d**2 * along_dd
    ).T
    cotangent.buffer("y_d")[:, columns] += (0.5 * along_d - 0.5 * theta_d * out_dd).T
    cotangent.buffer("y_dd")[:, columns] += (0.5 * along_dd).T
