"""Samples of a path as motion of the figure's links, all at once, and the adjoint sweep that pulls gradients back.

One forward sweep: state -> world quaternions Q, Q', Q'' of every link -> rotation, ω, ω', origin and its derivatives.
One reverse sweep takes cotangents of any of these back to y, y', y''. Arrays are component first, sample last:
(3, L, S) for L links (the world is link 0) and S samples, so that every formula is one pass over contiguous memory.

Eq. 13 with MuJoCo's body origins; ω and ω' are eqs. 19 and 20, exact for quaternions of any length. A rotation of the
link by a small world vector δφ changes δω = δφ' + δφ × ω and δω' = δφ'' + δφ' × ω + δφ × ω'; with δφ = 2 vec(δQ Q⁻¹)
these give the quaternion gradients.
"""

from __future__ import annotations

from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from .figure import Figure, Tables
from .quaternion import Array, Index


def cross(a: Array, b: Array) -> Array:
    """a × b, component first: (3, ...) with (3, ...)."""
    out = np.empty(np.broadcast_shapes(a.shape, b.shape))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        np.multiply(a[j], b[k], out=out[i])
        out[i] -= a[k] * b[j]
    return out


def dot(a: Array, b: Array) -> Array:
    """a · b over the first axis."""
    return np.einsum("i...,i...->...", a, b)


def turned(rotation: Array, vectors: Array) -> Array:
    """R c for constant local vectors: (3, 3, n, S) with (3, n) -> (3, n, S)."""
    c = vectors[:, :, None]
    return rotation[:, 0] * c[0] + rotation[:, 1] * c[1] + rotation[:, 2] * c[2]


def applied(rotation: Array, vectors: Array) -> Array:
    """R v for moving vectors: (3, 3, n, S) with (3, n, S)."""
    return rotation[:, 0] * vectors[0] + rotation[:, 1] * vectors[1] + rotation[:, 2] * vectors[2]


def turned_back(rotation: Array, vectors: Array) -> Array:
    """Rᵀ v: (3, 3, n, S) with (3, n, S)."""
    return rotation[0] * vectors[0] + rotation[1] * vectors[1] + rotation[2] * vectors[2]


def gathered(weights: Array, vectors: Array) -> Array:
    """Linear combinations over the link axis: (m, n) with (3, n, S) -> (3, m, S)."""
    return np.matmul(weights, vectors)


def add_at(room: Array, links: Index, vectors: Array) -> None:
    """room[:, links] += vectors, where a link may come up more than once: (3, L, S) with (n,) and (3, n, S)."""
    for i, link in enumerate(links):
        room[:, link] += vectors[:, i]


def hamilton(p: Array, q: Array) -> Array:
    """p ⊗ q, component first: (4, ...) with (4, ...)."""
    out = np.empty(np.broadcast_shapes(p.shape, q.shape))
    out[0] = p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3]
    out[1] = p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2]
    out[2] = p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1]
    out[3] = p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]
    return out


def vector_times(v: Array, q: Array) -> Array:
    """(0, v) ⊗ q: (3, ...) with (4, ...)."""
    out = np.empty((4, *np.broadcast_shapes(v.shape[1:], q.shape[1:])))
    out[0] = -(v[0] * q[1] + v[1] * q[2] + v[2] * q[3])
    out[1] = v[0] * q[0] + v[1] * q[3] - v[2] * q[2]
    out[2] = v[1] * q[0] + v[2] * q[1] - v[0] * q[3]
    out[3] = v[2] * q[0] + v[0] * q[2] - v[1] * q[1]
    return out


def vector_of_quotient(p: Array, q: Array) -> Array:
    """vec(p ⊗ conj(q)): (4, ...) with (4, ...) -> (3, ...)."""
    out = np.empty((3, *np.broadcast_shapes(p.shape[1:], q.shape[1:])))
    out[0] = p[1] * q[0] - p[0] * q[1] - p[2] * q[3] + p[3] * q[2]
    out[1] = p[2] * q[0] - p[0] * q[2] - p[3] * q[1] + p[1] * q[3]
    out[2] = p[3] * q[0] - p[0] * q[3] - p[1] * q[2] + p[2] * q[1]
    return out


def conjugated(q: Array) -> Array:
    """The conjugate, component first."""
    return np.concatenate([q[:1], -q[1:]])


class Samples:
    """y, y', y'' of a figure at S times, and everything the penalties derive from them, computed once when asked for.

    y, y_d, y_dd  (S, N) state and its derivatives [1/s, 1/s²]
    t             (S,) times [s], for penalties that hold for a part of the clip; zeros where nobody says
    q, q_d, q_dd  (4, n, S) the state's quaternion blocks
    """

    def __init__(
        self, figure: Figure, y: ArrayLike, y_d: ArrayLike, y_dd: ArrayLike, t: ArrayLike | None = None
    ) -> None:
        self.figure = figure
        self.y, self.y_d, self.y_dd = np.asarray(y, float), np.asarray(y_d, float), np.asarray(y_dd, float)
        self.t = np.zeros(len(self.y)) if t is None else np.asarray(t, float)

    @property
    def count(self) -> int:
        """S"""
        return self.y.shape[0]

    def taken(self, at: Index) -> Samples:
        """The samples of these indices (R,), which may repeat, as samples of their own."""
        return Samples(self.figure, self.y[at], self.y_d[at], self.y_dd[at], t=self.t[at])

    def columns(self, indices: Index, order: int = 0) -> Array:
        """Chosen columns of y, y' or y'', component first: indices (...) -> (..., S)."""
        return np.ascontiguousarray((self.y, self.y_d, self.y_dd)[order].T)[indices]

    @cached_property
    def q(self) -> Array:
        return self.columns(self.figure.tables.quaternion_columns, 0)

    @cached_property
    def q_d(self) -> Array:
        return self.columns(self.figure.tables.quaternion_columns, 1)

    @cached_property
    def q_dd(self) -> Array:
        return self.columns(self.figure.tables.quaternion_columns, 2)

    @cached_property
    def links(self) -> LinkMotion:
        return LinkMotion(self)


class LinkMotion:
    """The links' motion in the world; see the module's text for shapes.

    Q, Q_d, Q_dd   (4, L, S) world quaternions, any length
    rotation       (3, 3, L, S)
    omega, alpha   (3, L, S) angular velocity and acceleration [rad/s, rad/s²], world axes
    x, x_d, x_dd   (3, L, S) origin of the link [m, m/s, m/s²]
    """

    def __init__(self, samples: Samples) -> None:
        self.samples = samples
        self.figure = samples.figure
        self.Q, self.Q_d, self.Q_dd = _world_quaternions(samples)

    @cached_property
    def length_squared(self) -> Array:
        """b = Q·Q, (L, S)."""
        return dot(self.Q, self.Q)

    @cached_property
    def rotation(self) -> Array:
        w, x, y, z = self.Q
        s = 2 / self.length_squared
        out = np.empty((3, 3, *w.shape))
        xs, ys, zs = s * x, s * y, s * z
        wx, wy, wz = w * xs, w * ys, w * zs
        xx, xy, xz, yy, yz, zz = x * xs, x * ys, x * zs, y * ys, y * zs, z * zs
        out[0, 0], out[0, 1], out[0, 2] = 1 - yy - zz, xy - wz, xz + wy
        out[1, 0], out[1, 1], out[1, 2] = xy + wz, 1 - xx - zz, yz - wx
        out[2, 0], out[2, 1], out[2, 2] = xz - wy, yz + wx, 1 - xx - yy
        return out

    @cached_property
    def stretch_rate(self) -> Array:
        """(Q·Q')/b, the rate at which the quaternion's length grows, (L, S) [1/s]."""
        return dot(self.Q, self.Q_d) / self.length_squared

    @cached_property
    def omega(self) -> Array:
        return vector_of_quotient(self.Q_d, self.Q) * (2 / self.length_squared)

    @cached_property
    def alpha(self) -> Array:
        return vector_of_quotient(self.Q_dd, self.Q) * (2 / self.length_squared) - 2 * self.stretch_rate * self.omega

    @cached_property
    def step(self) -> Array:
        """R_parent · offset, the vector from the parent's origin to the joint's anchor, (3, L, S)."""
        tables = self.figure.tables
        return turned(self.rotation[:, :, tables.parents], tables.offset)

    @cached_property
    def hang(self) -> Array | None:
        """R · anchor, from the link's origin to its joint's anchor, or None if all joints sit at bodies' origins."""
        tables = self.figure.tables
        return turned(self.rotation, tables.anchor) if tables.has_anchors else None

    @cached_property
    def anchor(self) -> Array:
        """Where each link's joint turns, (3, L, S)."""
        return self.x if self.hang is None else self.x + self.hang

    @cached_property
    def slide_axis(self) -> Array:
        """R · axis of the slides, (3, s, S)."""
        tables = self.figure.tables
        return turned(self.rotation[:, :, tables.slide_links], tables.axis[:, tables.slide_links])

    def _slide(self, order: int) -> Array:
        tables = self.figure.tables
        value = self.samples.columns(tables.slide_columns, order)
        return value - tables.reference[tables.slide_links][:, None] if order == 0 else value

    def _summed(self, own: Array, order: int) -> Array:
        """Sums over the way from the root, plus the free roots' own positions."""
        tables = self.figure.tables
        if tables.free_links.size:
            own[:, tables.free_links] = self.samples.columns(tables.position_columns, order)
        return gathered(tables.path, own)

    @cached_property
    def x(self) -> Array:
        own = self.step.copy() if self.hang is None else self.step - self.hang
        slides = self.figure.tables.slide_links
        if slides.size:
            own[:, slides] += self._slide(0) * self.slide_axis
        return self._summed(own, 0)

    @cached_property
    def x_d(self) -> Array:
        parents, slides = self.figure.tables.parents, self.figure.tables.slide_links
        own = cross(self.omega[:, parents], self.step)
        if self.hang is not None:
            own -= cross(self.omega, self.hang)
        if slides.size:
            e = self.slide_axis
            own[:, slides] += self._slide(1) * e + self._slide(0) * cross(self.omega[:, slides], e)
        return self._summed(own, 1)

    @cached_property
    def x_dd(self) -> Array:
        parents, slides = self.figure.tables.parents, self.figure.tables.slide_links
        own = attached_acceleration(self.omega[:, parents], self.alpha[:, parents], self.step)
        if self.hang is not None:
            own -= attached_acceleration(self.omega, self.alpha, self.hang)
        if slides.size:
            e, omega, alpha = self.slide_axis, self.omega[:, slides], self.alpha[:, slides]
            own[:, slides] += (
                self._slide(2) * e
                + 2 * self._slide(1) * cross(omega, e)
                + self._slide(0) * attached_acceleration(omega, alpha, e)
            )
        return self._summed(own, 2)


def attached_acceleration(omega: Array, alpha: Array, s: Array) -> Array:
    """s'' of a vector s that turns with its link: ω' × s + ω × (ω × s)."""
    return cross(alpha, s) + cross(omega, cross(omega, s))


def _world_quaternions(samples: Samples) -> tuple[Array, Array, Array]:
    """World quaternions of all links and two derivatives, (4, L, S) each."""
    tables = samples.figure.tables
    shape = (4, len(samples.figure.links), samples.count)
    out = (np.zeros(shape), np.zeros(shape), np.zeros(shape))
    out[0][0, 0] = 1.0
    blocks = (samples.q, samples.q_d, samples.q_dd)
    for target, block in zip(out, blocks, strict=True):
        target[:, tables.quaternion_links] = block
    if samples.figure.is_world:
        return out
    for target, hinge in zip(out, _hinge_quaternions(samples), strict=True):
        target[:, tables.hinge_links] = hinge
    out[0][0, tables.slide_links] = 1.0
    for level in tables.levels:
        level = level[~np.isin(level, tables.free_links)]
        a, a_d, a_dd = (_base(tables, target, level) for target in out)
        c, c_d, c_dd = (target[:, level].copy() for target in out)
        out[0][:, level] = hamilton(a, c)
        out[1][:, level] = hamilton(a_d, c) + hamilton(a, c_d)
        out[2][:, level] = hamilton(a_dd, c) + 2 * hamilton(a_d, c_d) + hamilton(a, c_dd)
    return out


def _base(tables: Tables, quaternions: Array, level: Index) -> Array:
    """Q_parent ⊗ turn for the links of one level."""
    parent = quaternions[:, tables.parents[level]]
    return hamilton(parent, tables.turn[:, level][:, :, None]) if tables.has_turns else parent


def _hinge_quaternions(samples: Samples) -> tuple[Array, Array, Array]:
    """(cos θ/2, axis sin θ/2) of the hinges and two derivatives, (4, h, S) each."""
    tables = samples.figure.tables
    theta, theta_d, theta_dd = (samples.columns(tables.hinge_columns, k) for k in range(3))
    half = 0.5 * (theta - tables.reference[tables.hinge_links][:, None])
    axis = tables.axis[:, tables.hinge_links][:, :, None]
    q = np.concatenate([np.cos(half)[None], axis * np.sin(half)])
    normal = np.concatenate([-np.sin(half)[None], axis * np.cos(half)])
    return q, 0.5 * theta_d * normal, 0.5 * theta_dd * normal - 0.25 * theta_d**2 * q


class Cotangent:
    """Gradients of one scalar with respect to any of a `Samples`' quantities, gathered and pulled back to y, y', y''.

    `add("x", g)` adds to the gradient with respect to the links' origins, and so on for: y y_d y_dd (S, N);
    q q_d q_dd (4, n, S); x x_d x_dd omega alpha turn (3, L, S), where `turn` is the gradient with respect to a small
    world rotation of the link with ω and ω' held.
    """

    def __init__(self, samples: Samples) -> None:
        self.samples = samples
        self._parts: dict[str, Array] = {}

    def add(self, name: str, gradient: Array) -> None:
        if name in self._parts:
            self._parts[name] += gradient
        else:
            self._parts[name] = np.array(gradient)

    def room(self, name: str) -> Array:
        """The array itself, zeros at first, to add into by index."""
        if name not in self._parts:
            samples = self.samples
            if name[0] == "y":
                shape: tuple[int, ...] = samples.y.shape
            elif name[0] == "q":
                shape = samples.q.shape
            else:
                shape = (3, len(samples.figure.links), samples.count)
            self._parts[name] = np.zeros(shape)
        return self._parts[name]

    def gradients(self) -> tuple[Array, Array, Array]:
        """The three gradients with respect to y, y', y'', each (S, N); the cotangent is used up."""
        samples, tables = self.samples, self.samples.figure.tables
        if self._parts.keys() & {"x", "x_d", "x_dd", "omega", "alpha", "turn"}:
            _origins_pulled_back(self)
            turning = (self.get(name) for name in ("turn", "omega", "alpha"))
            quaternions = quaternion_gradients(samples.links, *turning)
            if samples.figure.is_world:
                blocks = [g[:, tables.quaternion_links] for g in quaternions]
            else:
                blocks = _products_pulled_back(self, quaternions)
            for name, block in zip(("q", "q_d", "q_dd"), blocks, strict=False):
                self.add(name, block)
        out = []
        for y_name, q_name in (("y", "q"), ("y_d", "q_d"), ("y_dd", "q_dd")):
            total = self._parts[y_name] if y_name in self._parts else np.zeros(samples.y.shape)
            if q_name in self._parts:
                columns = tables.quaternion_columns
                total[:, columns.ravel()] += self._parts[q_name].reshape(-1, samples.count).T
            out.append(total)
        return out[0], out[1], out[2]

    def get(self, name: str) -> Array | None:
        return self._parts.get(name)


def attached_pulled_back(
    links: tuple[Array, Array], s: Array, gradients: tuple[Array | None, Array | None, Array | None]
) -> tuple[Array, Array | None, Array | None]:
    """Gradients of s, s' = ω × s, s'' -> gradients of (turn, ω, ω'), for vectors s (3, n, S) that turn with their link.

    links is (ω, ω') of each vector's link, (3, n, S) both.
    """
    omega, alpha = links
    g, g_d, g_dd = gradients
    if g_d is None and g_dd is None:
        assert g is not None
        return cross(s, g), None, None
    back = np.zeros_like(s) if g is None else g
    if g_dd is None:
        assert g_d is not None
        return cross(s, back + cross(g_d, omega)), cross(s, g_d), None
    z_bar = cross(g_dd, omega)
    if g_d is not None:
        z_bar = z_bar + g_d
    back = back + cross(g_dd, alpha) + cross(z_bar, omega)
    return cross(s, back), cross(cross(omega, s), g_dd) + cross(s, z_bar), cross(s, g_dd)


def _origins_pulled_back(cotangent: Cotangent) -> None:
    """x, x', x'' -> positions of the free roots, slides, and (turn, ω, ω') of the links."""
    names = ("x", "x_d", "x_dd")
    if not any(cotangent.get(name) is not None for name in names):
        return
    samples, tables = cotangent.samples, cotangent.samples.figure.tables
    links = samples.links
    beyond = np.ascontiguousarray(tables.path.T)

    def carried(name: str) -> Array | None:
        g = cotangent.get(name)
        return None if g is None else gathered(beyond, g)

    own = (carried("x"), carried("x_d"), carried("x_dd"))
    for name, g in zip(("y", "y_d", "y_dd"), own, strict=True):
        if g is not None and tables.free_links.size:
            room = cotangent.room(name)
            room[:, tables.position_columns.ravel()] += g[:, tables.free_links].reshape(-1, samples.count).T
            g[:, tables.free_links] = 0
    moving = own[1] is not None or own[2] is not None
    still = np.zeros(1)
    omega, alpha = (links.omega, links.alpha) if moving else (still, still)
    at_parent = (omega[:, tables.parents], alpha[:, tables.parents]) if moving else (still, still)
    _scatter(cotangent, tables.parents, attached_pulled_back(at_parent, links.step, own))
    if links.hang is not None:
        every = np.arange(len(samples.figure.links))
        x, x_d, x_dd = (None if g is None else -g for g in own)
        _scatter(cotangent, every, attached_pulled_back((omega, alpha), links.hang, (x, x_d, x_dd)))
    if tables.slide_links.size:
        _slides_pulled_back(cotangent, own)


def _scatter(cotangent: Cotangent, owners: Index, parts: tuple[Array | None, Array | None, Array | None]) -> None:
    """Adds gradients of vectors to those of the links they turn with."""
    count = len(cotangent.samples.figure.links)
    incidence = np.zeros((count, owners.size))
    incidence[owners, np.arange(owners.size)] = 1
    for name, part in zip(("turn", "omega", "alpha"), parts, strict=True):
        if part is not None:
            cotangent.add(name, gathered(incidence, part))


def _slides_pulled_back(cotangent: Cotangent, own: tuple[Array | None, ...]) -> None:
    """Displacement q e along a slide's axis e: gradients of q, q', q'' and of the axis."""
    samples, tables = cotangent.samples, cotangent.samples.figure.tables
    links, slides = samples.links, tables.slide_links
    zero = np.zeros((3, slides.size, samples.count))
    g, g_d, g_dd = (zero if part is None else part[:, slides] for part in own)
    e, omega, alpha = links.slide_axis, links.omega[:, slides], links.alpha[:, slides]
    e_d, e_dd = cross(omega, e), attached_acceleration(omega, alpha, e)
    q, q_d, q_dd = (links._slide(order) for order in range(3))
    columns = tables.slide_columns
    cotangent.room("y")[:, columns] += (dot(g, e) + dot(g_d, e_d) + dot(g_dd, e_dd)).T
    cotangent.room("y_d")[:, columns] += (dot(g_d, e) + 2 * dot(g_dd, e_d)).T
    cotangent.room("y_dd")[:, columns] += dot(g_dd, e).T
    axis = (q * g + q_d * g_d + q_dd * g_dd, q * g_d + 2 * q_d * g_dd, q * g_dd)
    _scatter(cotangent, slides, attached_pulled_back((omega, alpha), e, axis))


class Turning(Protocol):
    """What the gradients of a link's quaternion need of its motion: Q, Q', Q'', ω, ω' and |Q|² and its rate."""

    Q: Array
    Q_d: Array
    Q_dd: Array
    omega: Array
    alpha: Array
    length_squared: Array
    stretch_rate: Array


def quaternion_gradients(
    links: LinkMotion | Turning, turn: Array | None, omega_bar: Array | None, alpha_bar: Array | None
) -> list[Array]:
    """(turn, ω, ω') -> gradients with respect to Q, Q', Q'' of the links, (4, L, S); later ones left out if zero."""
    b = links.length_squared
    v = links.Q * (2 / b)
    if omega_bar is None and alpha_bar is None:
        assert turn is not None
        return [vector_times(turn, v)]
    p1 = np.zeros_like(links.omega) if omega_bar is None else omega_bar.copy()
    p0 = cross(links.omega, p1)
    if turn is not None:
        p0 += turn
    if alpha_bar is not None:
        p1 += cross(links.omega, alpha_bar)
        p0 += cross(links.alpha, alpha_bar)
    rate = 2 * links.stretch_rate
    v_d = links.Q_d * (2 / b) - v * rate
    g0 = vector_times(p0, v) + vector_times(p1, v_d)
    g1 = vector_times(p1, v)
    if alpha_bar is None:
        return [g0, g1]
    b_dd = 2 * (dot(links.Q, links.Q_dd) + dot(links.Q_d, links.Q_d)) / b
    v_dd = (links.Q_dd - 2 * rate * links.Q_d) * (2 / b) + v * (2 * rate**2 - b_dd)
    g0 += vector_times(alpha_bar, v_dd)
    g1 += 2 * vector_times(alpha_bar, v_d)
    return [g0, g1, vector_times(alpha_bar, v)]


def _products_pulled_back(cotangent: Cotangent, gradients: list[Array]) -> list[Array]:
    """World quaternions' gradients -> those of joint coordinates: C = A ⊗ c, from the leaves to the root."""
    samples, tables = cotangent.samples, cotangent.samples.figure.tables
    links = samples.links
    local = _local_quaternions(samples)
    grads = [gradients[k] if k < len(gradients) else np.zeros_like(links.Q) for k in range(3)]
    for level in reversed(tables.levels):
        level = level[~np.isin(level, tables.free_links)]
        a, a_d, a_dd = (conjugated(_base(tables, q, level)) for q in (links.Q, links.Q_d, links.Q_dd))
        c, c_d, c_dd = (conjugated(q[:, level]) for q in local)
        g, g_d, g_dd = (grad[:, level].copy() for grad in grads)
        up = (
            hamilton(g, c) + hamilton(g_d, c_d) + hamilton(g_dd, c_dd),
            hamilton(g_d, c) + 2 * hamilton(g_dd, c_d),
            hamilton(g_dd, c),
        )
        down = (
            hamilton(a, g) + hamilton(a_d, g_d) + hamilton(a_dd, g_dd),
            hamilton(a, g_d) + 2 * hamilton(a_d, g_dd),
            hamilton(a, g_dd),
        )
        back = conjugated(tables.turn[:, level][:, :, None])
        for grad, parent, own in zip(grads, up, down, strict=True):
            parent = hamilton(parent, back) if tables.has_turns else parent
            add_at(grad, tables.parents[level], parent)
            grad[:, level] = own
    _hinges_pulled_back(cotangent, [grad[:, tables.hinge_links] for grad in grads])
    return [grad[:, tables.quaternion_links] for grad in grads]


def _local_quaternions(samples: Samples) -> tuple[Array, Array, Array]:
    """Each link's own rotation c, c', c'' relative to its parent, (4, L, S); the identity for slides."""
    tables = samples.figure.tables
    shape = (4, len(samples.figure.links), samples.count)
    out = (np.zeros(shape), np.zeros(shape), np.zeros(shape))
    out[0][0] = 1.0
    blocks = zip((samples.q, samples.q_d, samples.q_dd), _hinge_quaternions(samples), strict=True)
    for target, (block, hinge) in zip(out, blocks, strict=True):
        target[:, tables.quaternion_links] = block
        target[:, tables.hinge_links] = hinge
    return out


def _hinges_pulled_back(cotangent: Cotangent, grads: list[Array]) -> None:
    """Gradients of (cos θ/2, axis sin θ/2) and its derivatives -> θ, θ', θ''."""
    samples, tables = cotangent.samples, cotangent.samples.figure.tables
    if not tables.hinge_links.size:
        return
    q, _, _ = _hinge_quaternions(samples)
    axis = tables.axis[:, tables.hinge_links][:, :, None]
    normal = np.concatenate([-dot(q[1:], axis + 0 * q[1:])[None], axis * q[0]])
    theta_d, theta_dd = (samples.columns(tables.hinge_columns, k) for k in (1, 2))
    g, g_d, g_dd = grads
    along, along_d, along_dd = dot(g, normal), dot(g_d, normal), dot(g_dd, normal)
    out_d, out_dd = dot(g_d, q), dot(g_dd, q)
    columns = tables.hinge_columns
    cotangent.room("y")[:, columns] += (
        0.5 * along - 0.25 * theta_d * out_d - 0.25 * theta_dd * out_dd - 0.125 * theta_d**2 * along_dd
    ).T
    cotangent.room("y_d")[:, columns] += (0.5 * along_d - 0.5 * theta_d * out_dd).T
    cotangent.room("y_dd")[:, columns] += (0.5 * along_dd).T
