"""Figure: an MjModel as a tree of links, one joint each, and the state that a spline interpolates.

MuJoCo's qpos and the state have the same columns. They differ in the meaning of quaternions:

    coordinates "world"   the body's orientation in the world (§5 and appendix A of the paper), if only free and ball
                          joints are between the body and the world; otherwise as in "joint"
    coordinates "joint"   qpos itself: the rotation of every ball joint relative to its parent

A body with several joints becomes as many links, of which only the last has mass. The mass of bodies welded to a link
is added to it. Link 0 is the world.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import IntEnum
from functools import cached_property, lru_cache

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from .. import quaternion as quat
from ..array import Array, Index, Mask
from .model import joint_names
from .root import Root, root_of

WEIGHTLESS = int(mujoco.mjtDisableBit.mjDSBL_GRAVITY)


class JointKind(IntEnum):
    """MuJoCo's joint types, with its numbers."""

    FREE = int(mujoco.mjtJoint.mjJNT_FREE)
    BALL = int(mujoco.mjtJoint.mjJNT_BALL)
    SLIDE = int(mujoco.mjtJoint.mjJNT_SLIDE)
    HINGE = int(mujoco.mjtJoint.mjJNT_HINGE)

    @property
    def width(self) -> int:
        """The number of entries in qpos."""
        return {JointKind.FREE: 7, JointKind.BALL: 4}.get(self, 1)

    @property
    def freedom(self) -> int:
        """The number of degrees of freedom."""
        return {JointKind.FREE: 6, JointKind.BALL: 3}.get(self, 1)


@dataclass(frozen=True, eq=False)
class Link:
    """One joint and everything that moves rigidly with it.

    Attributes:
        name: The joint's name, see `joint_names`.
        kind: The type of the joint.
        parent: The index of the parent link (0: the world).
        joint: MuJoCo's joint id.
        body: MuJoCo's body id.
        qpos: The joint's first column of qpos.
        dof: The joint's first degree of freedom.
        turn: The orientation of the joint's frame at rest in the parent link, (4,) wxyz.
        offset: The joint's anchor in the parent link, (3,) [m].
        anchor: The same anchor in this link, (3,) [m]; zero unless the joint is away from the body's origin.
        axis: The axis of a hinge or slide in this link, (3,).
        reference: The value of a hinge [rad] or slide [m] at rest.
        armature: The joint's armature [kg m², kg].
        mass: The mass, with all bodies welded to the link [kg].
        centre: Its centre, in link axes, (3,) [m].
        inertia: Its inertia about the centre, in link axes, (3, 3) [kg m²].
    """

    name: str
    kind: JointKind
    parent: int
    joint: int
    body: int
    qpos: int
    dof: int
    turn: Array
    offset: Array
    anchor: Array
    axis: Array
    reference: float
    armature: float
    mass: float
    centre: Array
    inertia: Array

    @property
    def columns(self) -> slice:
        """The joint's columns of qpos."""
        return slice(self.qpos, self.qpos + self.kind.width)

    @property
    def dofs(self) -> slice:
        """The joint's degrees of freedom."""
        return slice(self.dof, self.dof + self.kind.freedom)


@dataclass(frozen=True, eq=False)
class Figure:
    """A jointed figure: links, the columns of its state, and the conversions between state and qpos.

    Figures with the same model and coordinates are equal, so that functions of a figure can be cached.

    Link 0 is the world, and every other link has one joint. `body_link` (nbody,) contains the link of each body,
    `body_offset` (nbody, 3) [m] and `body_turn` (nbody, 4), wxyz, its origin and its orientation in the link. `tables`
    contains the links' constants as arrays.

    Attributes:
        model: The MuJoCo model.
        coordinates: What rotations in the state are relative to: "world", or "joint" for the parent. "auto" is
            replaced by one of these, depending on the kinds of joints.
    """

    model: mujoco.MjModel
    coordinates: str = "auto"
    links: tuple[Link, ...] = field(init=False)
    body_link: Index = field(init=False)
    body_offset: Array = field(init=False)
    body_turn: Array = field(init=False)
    tables: Tables = field(init=False, repr=False)

    def __post_init__(self) -> None:
        if self.coordinates not in ("auto", "world", "joint"):
            raise ValueError(f"coordinates = {self.coordinates!r}: not one of 'auto', 'world', 'joint'")
        if self.model.njnt == 0:
            raise ValueError("the model has no joints: nothing can move")
        if self.model.nflex:
            name = mujoco.mj_id2name(self.model, mujoco.mjtObj.mjOBJ_FLEX, 0)
            raise ValueError(f"the model has a flex, '{name}': soft bodies are not for keyframes")
        links, body_link, body_offset, body_turn = _links(self.model)
        if self.coordinates == "auto":
            turning = {link.kind for link in links[1:]} <= {JointKind.FREE, JointKind.BALL}
            balls = any(link.kind is JointKind.BALL and up for link, up in zip(links, _upright(links), strict=True))
            object.__setattr__(self, "coordinates", "world" if turning or balls else "joint")
        object.__setattr__(self, "links", links)
        object.__setattr__(self, "body_link", body_link)
        object.__setattr__(self, "body_offset", body_offset)
        object.__setattr__(self, "body_turn", body_turn)
        object.__setattr__(self, "tables", Tables.of(self))

    @property
    def width(self) -> int:
        """N = nq, the number of entries of a state."""
        return int(self.model.nq)

    @cached_property
    def digest(self) -> bytes:
        """A hash that is equal for figures with the same model and coordinates."""
        content = np.zeros(mujoco.mj_sizeModel(self.model), np.uint8)
        mujoco.mj_saveModel(self.model, None, content)
        return hashlib.sha256(content.data).digest() + self.coordinates.encode()

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, Figure) and self.digest == other.digest)

    def __hash__(self) -> int:
        return hash(self.digest)

    @cached_property
    def root(self) -> Root | None:
        """The joints that carry the articulated tree; None if no tree moves in the world."""
        return root_of(self.model)

    @property
    def is_world(self) -> bool:
        """Whether every link has a quaternion in the state, which is its orientation in the world."""
        return self.tables.all_in_world

    @property
    def gravity(self) -> Array:
        """The gravity, (3,) [m/s²]; zero if the model disables it."""
        option = self.model.opt
        return np.zeros(3) if option.disableflags & WEIGHTLESS else np.array(option.gravity)

    def to_state(self, qpos: ArrayLike) -> Array:
        """Return the states (..., N) of MuJoCo configurations qpos (..., nq), with unit quaternions."""
        state = np.array(qpos, float)
        for i, link in enumerate(self.links[1:], start=1):
            columns = quaternion_columns(link)
            if columns is None:
                continue
            relative = quat.normalise(state[..., columns])
            if self.tables.in_world[i] and link.kind is JointKind.BALL:
                relative = quat.product(self._joint_base(state, link), relative)
            state[..., columns] = relative
        return state

    def to_state_near(self, qpos: ArrayLike, states: Array) -> Array:
        """Return `to_state` with every quaternion on the hemisphere of that in `states` (..., N)."""
        out = self.to_state(qpos)
        for columns in self.tables.quaternion_columns.T:
            out[..., columns] *= np.where(np.sum(out[..., columns] * states[..., columns], axis=-1) < 0, -1, 1)[
                ..., None
            ]
        return out

    def to_qpos(self, state: ArrayLike) -> Array:
        """Return MuJoCo configurations of states.

        Args:
            state: States (..., N), with quaternions of any length above 0.

        Returns:
            qpos (..., nq), with unit quaternions.
        """
        state = np.asarray(state, float)
        qpos = state.copy()
        for i, link in enumerate(self.links[1:], start=1):
            columns = quaternion_columns(link)
            if columns is None:
                continue
            rotation = state[..., columns]
            if self.tables.in_world[i] and link.kind is JointKind.BALL:
                rotation = quat.product(quat.inverse(self._joint_base(state, link)), rotation)
            qpos[..., columns] = quat.normalise(rotation)
        return qpos

    def _joint_base(self, state: Array, link: Link) -> Array:
        """Return the world orientation of a ball joint at rest, in world coordinates: Q_parent ⊗ turn."""
        parent = self.links[link.parent]
        columns = quaternion_columns(parent)
        if columns is None:
            return link.turn
        return quat.product(state[..., columns], link.turn)

    def body_name(self, link: int) -> str:
        """Return the name of a link's body, or that of its joint if the body has none."""
        return str(self.model.body(self.links[link].body).name) or self.links[link].name

    def chain(self, body: int) -> list[int]:
        """Return the links from the link of a body up to the root."""
        links, link = [], int(self.body_link[body])
        while link:
            links.append(link)
            link = self.links[link].parent
        return links

    def limb(self, body: int) -> list[int]:
        """Return the links from the link of a body towards the root, up to the first link with several children."""
        links = self.chain(body)
        forks = [i for i, link in enumerate(links) if i > 0 and self.tables.children[link] > 1]
        return links[: forks[0]] if forks else links

    @cached_property
    def limbs(self) -> tuple[tuple[int, ...], ...]:
        """The limbs, each from its end, a link without children, towards the root, see `limb`."""
        ends = np.flatnonzero(self.tables.children[1:] == 0) + 1
        return tuple(tuple(self.limb(self.links[end].body)) for end in ends)

    def point_on_link(self, body: int, position: ArrayLike) -> tuple[int, Array]:
        """Return points of a body in the frame of its link.

        Args:
            body: MuJoCo's id of the body.
            position: Points (..., 3) in the body's frame [m].

        Returns:
            The index of the link, and the points (..., 3) in the link's frame [m].
        """
        offset = quat.rotate(self.body_turn[body], np.asarray(position, float))
        return int(self.body_link[body]), self.body_offset[body] + offset


def quaternion_columns(link: Link) -> slice | None:
    """Return the state's columns of a link's quaternion; None for hinges, slides and the world."""
    if link.kind is JointKind.FREE and link.joint >= 0:
        return slice(link.qpos + 3, link.qpos + 7)
    if link.kind is JointKind.BALL:
        return slice(link.qpos, link.qpos + 4)
    return None


WORLD_LINK = Link(
    "world", JointKind.FREE, 0, -1, 0, -1, -1,
    np.array([1.0, 0, 0, 0]), np.zeros(3), np.zeros(3), np.zeros(3), 0.0, 0.0, 0.0, np.zeros(3), np.zeros((3, 3)),
)  # fmt: skip


def _upright(links: tuple[Link, ...]) -> Mask:
    """Return which links have only free and ball joints between them and the world, (L,)."""
    out = np.ones(len(links), bool)
    for i, link in enumerate(links[1:], start=1):
        out[i] = link.kind is JointKind.FREE or (link.kind is JointKind.BALL and out[link.parent])
    return out


def _links(model: mujoco.MjModel) -> tuple[tuple[Link, ...], Index, Array, Array]:
    """Return links in MuJoCo's depth-first order, and each body's link with its place in it."""
    rows: list[dict] = [WORLD_LINK.__dict__]
    body_link = np.zeros(model.nbody, np.intp)
    body_offset = np.zeros((model.nbody, 3))
    body_turn = np.zeros((model.nbody, 4))
    body_turn[0, 0] = 1.0
    loads: list[list[tuple[float, Array, Array]]] = [[]]
    names = joint_names(model)
    for body in range(1, model.nbody):
        parent = int(model.body_parentid[body])
        link = int(body_link[parent])
        offset = body_offset[parent] + quat.rotate(body_turn[parent], model.body_pos[body])
        turn = quat.normalise(quat.product(body_turn[parent], model.body_quat[body]))
        for joint in range(model.body_jntadr[body], model.body_jntadr[body] + model.body_jntnum[body]):
            kind = JointKind(int(model.jnt_type[joint]))
            place = np.zeros(3) if kind is JointKind.FREE else np.array(model.jnt_pos[joint])
            rows.append(
                {
                    "name": names[joint],
                    "kind": kind,
                    "parent": link,
                    "joint": joint,
                    "body": body,
                    "qpos": int(model.jnt_qposadr[joint]),
                    "dof": int(model.jnt_dofadr[joint]),
                    "turn": turn,
                    "offset": offset + quat.rotate(turn, place),
                    "anchor": place,
                    "axis": np.array(model.jnt_axis[joint]),
                    "reference": float(model.qpos0[model.jnt_qposadr[joint]]),
                    "armature": float(model.dof_armature[model.jnt_dofadr[joint]]),
                }
            )
            loads.append([])
            link, offset, turn = len(rows) - 1, np.zeros(3), np.array([1.0, 0, 0, 0])
        body_link[body], body_offset[body], body_turn[body] = link, offset, turn
        centre = offset + quat.rotate(turn, model.body_ipos[body])
        axes = quat.product(turn, model.body_iquat[body])
        matrix = quat.matrices(axes)
        loads[link].append(
            (float(model.body_mass[body]), centre, matrix @ np.diag(model.body_inertia[body]) @ matrix.T)
        )
    links = [WORLD_LINK]
    for row, load in zip(rows[1:], loads[1:], strict=True):
        mass, centre, inertia = _composite(load)
        links.append(Link(**row, mass=mass, centre=centre, inertia=inertia))
    return tuple(links), body_link, body_offset, body_turn


def _composite(load: list[tuple[float, Array, Array]]) -> tuple[float, Array, Array]:
    """Return mass, centre of mass and inertia of bodies welded together, by the parallel axis theorem."""
    mass = sum(part[0] for part in load)
    if mass == 0:
        return 0.0, np.zeros(3), np.zeros((3, 3))
    centre = sum((m * c for m, c, _ in load), np.zeros(3)) / mass
    inertia = np.zeros((3, 3))
    for m, c, tensor in load:
        d = c - centre
        inertia += tensor + m * (d @ d * np.eye(3) - np.outer(d, d))
    return mass, centre, inertia


@dataclass(frozen=True, eq=False)
class Tables:
    """The links' constants as arrays for the batched sweeps. Vectors are (3, L), for L links with the world first.

    Attributes that are not per-link copies of `Link`:

    in_world            (L,) whether the link's quaternion in the state, if any, is its orientation in the world
    all_in_world        whether this applies to all links, and each has one
    quaternion_columns  (4, n) state columns of the n quaternion blocks, in the order of `quaternion_links` (n,)
    quaternion_slice    these columns as a slice, block after block; None if there are others in between
    free_links          (f,) links with a free joint, the root first, with `position_columns` (3, f)
    ball_links          (b,) links with a ball joint; rotary_links  also those with a hinge
    hinge_columns, slide_columns   (h,), (s,) columns of the hinges and slides, in the order of their links
    children            (L,) number of child links; 0 at the end of a limb
    path                (L, L) 1 if the column's link is on the chain from the root to the row's link, inclusive
    beyond              (L, L) the transpose of `path`: 1 if the column's link is the row's or a descendant
    steps               (L, 3 L) each link's offset in its parent's columns; all x first
    centre_offsets      (L, 3 L) each link's centre of mass in its own columns; all x first
    levels              links by depth from the world, without those whose orientation is in the state
    """

    in_world: Mask
    all_in_world: bool
    quaternion_columns: Index
    quaternion_slice: slice | None
    quaternion_links: Index
    free_links: Index
    ball_links: Index
    rotary_links: Index
    position_columns: Index
    hinge_columns: Index
    hinge_links: Index
    slide_columns: Index
    slide_links: Index
    parents: Index
    children: Index
    path: Array
    beyond: Array
    steps: Array
    centre_offsets: Array
    anchor: Array
    axis: Array
    turn: Array
    reference: Array
    levels: tuple[Index, ...]
    mass: Array
    centre: Array
    inertia: Array
    armature: Array
    has_anchors: bool
    has_turns: bool

    @classmethod
    def of(cls, figure: Figure) -> Tables:
        links = figure.links
        count = len(links)
        parents = np.array([link.parent for link in links], np.intp)
        depth = np.zeros(count, int)
        path = np.eye(count)
        path[0] = 0
        for i in range(1, count):
            depth[i] = depth[parents[i]] + 1
            path[i] += path[parents[i]]

        def of_kind(*kinds: JointKind) -> Index:
            return np.array([i for i, link in enumerate(links) if i and link.kind in kinds], np.intp)

        def firsts(indices: Index) -> Index:
            return np.array([links[i].qpos for i in indices], np.intp)

        balls = of_kind(JointKind.FREE, JointKind.BALL)
        free, hinges, slides = of_kind(JointKind.FREE), of_kind(JointKind.HINGE), of_kind(JointKind.SLIDE)
        if figure.root is not None:
            free = np.concatenate([free[free == figure.root.link], free[free != figure.root.link]])
        turns = np.array([link.turn for link in links])
        offset = np.array([np.zeros(3) if link.kind is JointKind.FREE else link.offset for link in links]).T
        centre = np.array([link.centre for link in links]).T
        blocks = (
            firsts(balls) + 3 * np.isin(balls, free) + np.arange(4)[:, None]
        )  # a free joint begins with its position
        in_world = _upright(links)
        if figure.coordinates == "joint":
            in_world &= np.array([link.kind is JointKind.FREE for link in links])
        return cls(
            in_world=in_world,
            all_in_world=bool(in_world.all()),
            quaternion_columns=blocks,
            quaternion_slice=_run(blocks.T.ravel()),
            quaternion_links=balls,
            free_links=free,
            ball_links=of_kind(JointKind.BALL),
            rotary_links=of_kind(JointKind.BALL, JointKind.HINGE),
            position_columns=firsts(free) + np.arange(3)[:, None],
            hinge_columns=firsts(hinges),
            hinge_links=hinges,
            slide_columns=firsts(slides),
            slide_links=slides,
            parents=parents,
            children=np.bincount(parents[1:], minlength=count),
            path=path,
            beyond=np.ascontiguousarray(path.T),
            steps=on_links(offset, parents, count),
            centre_offsets=on_links(centre, np.arange(count), count),
            anchor=np.array([link.anchor for link in links]).T,
            axis=np.array([link.axis for link in links]).T,
            turn=turns.T,
            reference=np.array([link.reference for link in links]),
            levels=tuple(np.flatnonzero((depth == k) & ~in_world) for k in range(1, depth.max() + 1)),
            mass=np.array([link.mass for link in links]),
            centre=centre,
            inertia=np.moveaxis(np.array([link.inertia for link in links]), 0, -1),
            armature=np.array([link.armature for link in links]),
            has_anchors=any(np.any(link.anchor) for link in links),
            has_turns=bool(np.any(turns[:, 1:])),
        )


def _run(indices: Index) -> slice | None:
    if not indices.size or np.any(np.diff(indices) != 1):
        return None
    return slice(int(indices[0]), int(indices[-1]) + 1)


def sets_joints(figure: Figure, specified: Mask, links: Sequence[int] | Index) -> Mask:
    """Return whether keyframes specify the joints of n links, (n, K). Of a free joint, only the rotation counts.

    Args:
        specified: Entries of qpos that keyframes specify, (K, nq).
    """
    columns = [quaternion_columns(figure.links[i]) or figure.links[i].qpos for i in links]
    return np.array([np.atleast_2d(specified[:, column].T).all(axis=0) for column in columns])


def on_links(vectors: Array, owners: Index, count: int) -> Array:
    """Return vectors (3, n) on links as weights (n, 3 L) of rotations of `count` links, see `LinkMotion.sum_fixed`."""
    out = np.zeros((owners.size, 3, count))
    out[np.arange(owners.size), :, owners] = vectors.T
    return out.reshape(owners.size, 3 * count)


@lru_cache(maxsize=8)
def independent_joints(figure: Figure, child: tuple[int, ...]) -> list[tuple[Index, Index]]:
    """Return joints in groups that share no link, each with its columns (g, 8): those of the children and of the
    parents.

    Joints without a parent in the state form separate groups with the columns of the children only, (g, 4).
    """
    tables = figure.tables
    place = {int(link): tables.quaternion_columns[:, i] for i, link in enumerate(tables.quaternion_links)}
    parents = [int(tables.parents[c]) for c in child]
    pairs = [[c, p] if p in place else [c] for c, p in zip(child, parents, strict=True)]
    groups: list[tuple[list[int], set[int]]] = []
    for i, pair in enumerate(pairs):
        fitting = (g for g in groups if not g[1] & set(pair) and len(pairs[g[0][0]]) == len(pair))
        group = next(fitting, None)
        if group is None:
            groups.append(group := ([], set()))
        group[0].append(i)
        group[1].update(pair)
    columns = [np.concatenate([place[link] for link in pair]) for pair in pairs]
    return [(np.array(members), np.array([columns[i] for i in members])) for members, _ in groups]
