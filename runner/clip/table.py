"""The tables of a clip's file: keys, values, and combinations of keys."""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self

import numpy as np
from numpy.typing import ArrayLike
from pydantic import BaseModel, ConfigDict, Field, Strict, model_validator

from ..system.quantity import LARGEST

if TYPE_CHECKING:
    from dynsplines.solver.array import Array


# A text in Annotated is the value that a key takes, in the words of errors; without it those of pydantic.
Real = Annotated[float, Strict(), Field(allow_inf_nan=False), "a number"]
Number = Annotated[Real, Field(ge=-LARGEST, le=LARGEST)]
Whole = Annotated[int, Strict(), "a whole number"]
Flag = Annotated[bool, Strict(), "true or false"]
Word = Annotated[str, "a word in quotes"]
Name = Annotated[str, Field(min_length=1), "a name in quotes"]
Names = Annotated[list[str], "a list of names"]
Length = Annotated[Real, Field(gt=0, le=1000)]
Angle = Annotated[Real, Field(gt=0, le=360)]
Axis = Number | Literal["free"]
Share = Annotated[Real, Field(ge=0, le=1)]
Place = Annotated[tuple[Number, Number, Number], "[x, y, z] in metres"]
Axes = Annotated[tuple[Axis, Axis, Axis], '[x, y, z] in metres, each a number or "free"']
KEY = "key:"  # prefix of the name of a <key> of the model
ROTATION = "{rotvec = [x, y, z]}, {euler = [...], order = ...} or {quat = [w, x, y, z]}"
DIGITS = 9  # decimal places of degrees, finer than the rounding of conversions (1e-11 rad)
UP, IDENTITY = np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0, 0.0])  # the vertical; no rotation, wxyz
ModelKey = Annotated[str, Strict(), Field(pattern=f"^{KEY}.+")]


class Table(BaseModel):
    """A table of a clip's file, which accepts no other keys."""

    model_config = ConfigDict(extra="forbid", strict=False)

    @classmethod
    def without_checks(cls, **values: Any) -> Self:
        return cls.model_construct(set(values), **values)

    @property
    def specified(self) -> Mapping[str, object]:
        """The values of the keys that are set."""
        return {name: getattr(self, name) for name in type(self).model_fields if name in self.model_fields_set}

    def change(self, **values: object) -> Self:
        """Return a copy with other values, unchecked. An unset key stays unset unless its value changes."""
        changes = {k: v for k, v in values.items() if k in self.model_fields_set or v != getattr(self, k)}
        return self.model_copy(update=changes)

    def without(self, *names: str) -> Self:
        fields = type(self).model_fields
        out = self.model_copy(update={name: fields[name].get_default(call_default_factory=True) for name in names})
        out.model_fields_set.difference_update(names)
        return out


def degrees(radians: float) -> float:
    """Return an angle in degrees, rounded to `DIGITS` places; zero has no sign."""
    return round(float(np.degrees(radians)), DIGITS) + 0.0


class RotationTable(Table):
    """A rotation in one of several notations, followed by a heading about the vertical."""

    rotvec: Annotated[tuple[Number, Number, Number] | None, "three angles [x, y, z] in degrees"] = None
    euler: Annotated[list[Number] | None, "a list of angles in degrees"] = None
    order: Word | None = None
    quat: Annotated[tuple[Number, Number, Number, Number] | None, "four numbers [w, x, y, z]"] = None
    heading: Number | None = None

    @property
    def is_rotation(self) -> bool:
        return not self.model_fields_set.isdisjoint(RotationTable.model_fields)

    @property
    def is_heading(self) -> bool:
        return self.heading is not None and self.model_fields_set.isdisjoint({"rotvec", "euler", "quat", "order"})

    @classmethod
    def of(cls, quaternion: ArrayLike) -> RotationTable:
        """Return the table of a rotation, a quaternion (4,) wxyz: its rotation vector in degrees."""
        from dynsplines.solver import quaternion as quat  # imported here, see `quaternion`

        x, y, z = (degrees(x) for x in quat.rotation_vector(quat.normalise(quaternion)))
        return RotationTable(rotvec=(x, y, z))

    def quaternion(self, rest: Array = IDENTITY) -> Array:
        """Return the rotation as a quaternion, (4,) wxyz.

        A heading rotates the other notation about the vertical; without one, it rotates the orientation in the rest
        pose, `rest` (4,) wxyz.
        """
        # imported here: it imports mujoco, which must wait until a renderer is chosen, see `graphics.choose`
        from dynsplines.solver import quaternion as quat

        if self.is_heading:
            other = rest
        elif self.rotvec is not None:
            other = quat.from_rotation_vector(np.radians(self.rotvec))
        elif self.quat is not None:
            other = quat.normalise(self.quat)
        else:
            other = quat.from_euler(np.radians(self.euler or []), self.order or "xyz")
        if self.heading is None:
            return other
        return quat.product(quat.from_rotation_vector(np.radians(self.heading) * UP), other)

    def check_rotation(self) -> None:
        """Raise ValueError unless there is exactly one rotation."""
        notations = [name for name in ("rotvec", "euler", "quat") if getattr(self, name) is not None]
        if self.is_heading:
            return
        if len(notations) != 1:
            names = " and ".join(notations) or "none (a root, a body or an obstacle may have heading alone)"
            raise ValueError(f"give exactly one of rotvec, euler, quat, not {names}")
        if self.order is not None and self.euler is None:
            raise ValueError(f"order goes with euler, not with {notations[0]}")
        if self.quat is not None and math.hypot(*self.quat) < 1e-6:
            raise ValueError("the quaternion is zero")
        order = "xyz" if self.order is None else self.order
        if self.euler is not None and (not order or set(order) - set("xyz") or len(order) != len(self.euler)):
            raise ValueError(
                f"euler has {len(self.euler)} angles and order = '{order}'; order names an axis x, y or z for each"
            )

    @model_validator(mode="after")
    def check(self) -> Self:
        """Raise ValueError for an invalid combination of keys."""
        self.check_rotation()
        return self


class RootTable(Table):
    """The position and orientation of a free body."""

    position: Axes | Literal["free"] = "free"
    rotation: Annotated[RotationTable | Literal["free"], f'{ROTATION} or "free"'] = "free"


class BodyTable(RotationTable):
    """The target orientation of a body, and the target position of its origin, or of the point `at` in its axes."""

    flat: Annotated[Flag | None, "true"] = None
    position: Axes | None = None
    at: Annotated[Place | None, "[x, y, z] in metres, in the body's own axes"] = None

    @model_validator(mode="after")
    def check(self) -> Self:
        """Raise ValueError unless it has a position, is flat, or has a rotation."""
        if self.at is not None and self.position is None:
            raise ValueError("'at' is a point of the body; give its target as position = [x, y, z]")
        if self.flat is not None and self.is_rotation and not self.is_heading:
            raise ValueError("give flat or a rotation, not both; heading may be added to flat")
        if self.flat is False:
            raise ValueError(f"flat = false has no effect; give flat = true or a rotation, {ROTATION}")
        if self.is_rotation or (self.flat is None and self.position is None):
            self.check_rotation()
        return self


Joint = Annotated[RotationTable | Number | Literal["free"], f'{ROTATION}, a number or "free"']
Body = Annotated[BodyTable, f"{{flat = true}} or a rotation, {ROTATION}, or {{position = [x, y, z]}}"]
Root = Annotated[RootTable, "a table: position and rotation of a free joint"]
Others = Annotated[
    Literal["free", "rest", "previous"] | ModelKey,
    "'free', 'rest', 'previous' or 'key:NAME', a <key> of the model",
]


class KeyframeTable(Table):
    """The state of the figure at one time, complete or partial."""

    time: Number
    root: Root = RootTable()
    roots: dict[str, Root] = {}
    joints: dict[str, Joint] = {}
    sites: dict[str, Axes] = {}
    bodies: dict[str, Body] = {}
    others: Others = "free"

    @property
    def model_key(self) -> str | None:
        """The name of the model's <key> for unspecified joints, if any."""
        return self.others.removeprefix(KEY) if self.others.startswith(KEY) else None


class StepTable(Table):
    """A step to climb."""

    x: Number
    height: Length
    length: Length = 3.0
    width: Length = 2.4
    y: Number = 0.0


class _ObstacleTable(Table):
    name: Name | None = None
    body: Name | None = None
    mass: Annotated[Real, Field(gt=0, le=LARGEST)] | None = None
    color: Annotated[tuple[Share, Share, Share, Share] | None, "[red, green, blue, opacity], each from 0 to 1"] = None
    position: Place | None = None
    rotation: Annotated[RotationTable | None, ROTATION] = None

    def check_place(self) -> None:
        if self.position is None and self.body is None:
            raise ValueError("'position' is missing")

    @model_validator(mode="after")
    def check(self) -> Self:
        """Raise ValueError for an invalid combination of keys."""
        self.check_place()
        if self.mass is not None and self.body is None:
            raise ValueError("'mass' is for parts of a body that moves; name it by body = '...'")
        return self


class BoxTable(_ObstacleTable):
    """A box."""

    size: Annotated[tuple[Length, Length, Length], "[length, width, height] in metres"]


class SphereTable(_ObstacleTable):
    """A ball."""

    radius: Length


class BarTable(_ObstacleTable):
    """A capsule or cylinder: from one point to another, or a length about a position."""

    radius: Length
    length: Length | None = None
    start: Place | None = Field(None, alias="from")
    end: Place | None = Field(None, alias="to")

    def check_place(self) -> None:
        """Raise ValueError for a bar without a position and without two end points."""
        if self.start is None and self.end is None:
            if self.length is None:
                raise ValueError("give position and length, or from and to")
            super().check_place()
            return
        if self.start is None or self.end is None:
            raise ValueError("'from' and 'to' go together")
        for name in ("position", "length", "rotation"):
            if getattr(self, name) is not None:
                raise ValueError(f"give from and to, or position and length, not both ('{name}' and 'from')")
        if math.dist(self.start, self.end) < 1e-4:
            raise ValueError("from and to are the same point")


class SceneTable(Table):
    """The surroundings."""

    step: StepTable | None = None
    box: Annotated[list[BoxTable], "[[scene.box]] tables"] = []
    sphere: Annotated[list[SphereTable], "[[scene.sphere]] tables"] = []
    capsule: Annotated[list[BarTable], "[[scene.capsule]] tables"] = []
    cylinder: Annotated[list[BarTable], "[[scene.cylinder]] tables"] = []


class PenaltyTable(Table):
    """A soft constraint: its kind and its options, which the record in `kinds` interprets."""

    model_config = ConfigDict(extra="allow", strict=False)
    kind: Word

    @classmethod
    def of(cls, kind: str, **options: Any) -> PenaltyTable:
        return cls.model_validate({"kind": kind, **options})

    @property
    def options(self) -> Mapping[str, Any]:
        """The options by name, unchecked; `parse.options_of` checks them."""
        return dict(self.model_extra or {})


class ContactTable(Table):
    """A point that rests in an interval [s]."""

    point: Word
    start: Number = Field(alias="from")
    end: Number = Field(alias="to")
    position: Place | None = None


class GraspTable(Table):
    """A site that is fixed on a body in an interval [s].

    Attributes:
        rotation: "free" if the body may rotate in the grasp.
    """

    point: Word = Field(alias="hand")
    body: Annotated[str, "a name in quotes"]
    start: Number = Field(alias="from")
    end: Number = Field(alias="to")
    position: Place | None = None
    rotation: Literal["free"] | None = None


class StanceTable(Table):
    """A stance inferred from a recording, in a motion's file: interval [s], and the plane below the point.

    Attributes:
        on: A point of the plane and its normal, (6,).
    """

    point: str
    start: Number = Field(alias="from, s")
    end: Number = Field(alias="to, s")
    on: tuple[Number, Number, Number, Number, Number, Number] | None = None


class SolveTable(Table):
    """End conditions of the spline and settings of the search; None: chosen automatically."""

    ends: Literal["free", "clamped", "clamped start", "clamped end", "periodic", "mirrored"] = "free"
    travel: Place | None = None
    turn: Annotated[Real, Field(ge=-360, le=360)] | None = None
    variable: Annotated[Whole, Field(ge=0, le=50)] | None = None
    frames: Annotated[Whole, Field(ge=0, le=100_000)] | None = None
    criterion: Word | None = None
    threshold: Annotated[Real, Field(ge=0)] | None = None
    optimiser: Word | None = None
    evaluations: Annotated[Whole, Field(ge=1, le=1_000_000)] | None = None
    tolerance: Annotated[Real, Field(gt=0, le=1)] | None = None
    quadrature: Literal["gauss", "uniform"] = "gauss"
    samples: Annotated[Whole, Field(ge=1, le=10_000)] | None = None


class RecordingTable(Table):
    """A recorded motion that keyframes edit.

    Attributes:
        file: A motion (.npz), a recording (.bvh, ...), a clip (.toml) or the name of a shipped clip.
        repeat: The number of repetitions of a loop.
        start: The start of the used part [s].
        end: The end of the used part [s].
        at: The time of this start in the clip [s].
        speed: The speed factor.
        times: Pairs of a time of the recording and of the clip [s], instead of `at` and `speed`.
        weight: The factor on the weight of the recording [1].
    """

    file: str
    repeat: Annotated[Whole, Field(ge=1, le=1000)] | None = None
    start: Number | None = Field(default=None, alias="from")
    end: Number | None = Field(default=None, alias="to")
    at: Number | None = None
    speed: Annotated[Real, Field(ge=0.05, le=20)] | None = None
    times: list[tuple[Number, Number]] | None = None
    weight: Annotated[Real, Field(gt=0, le=1e6)] = 1.0

    @model_validator(mode="after")
    def check(self) -> Self:
        """Raise ValueError for an invalid combination of keys."""
        if self.times is not None and (self.at is not None or self.speed is not None):
            raise ValueError("give times, or at and speed, not both")
        moments = self.times or []
        is_rising = all(a < c and b < d for (a, b), (c, d) in pairwise(moments))
        if self.times is not None and (len(moments) < 2 or not is_rising):
            raise ValueError("times are pairs [of the recording, of the clip], two or more, and both rise")
        return self


class SurroundingsTable(Table):
    """The surroundings of a recording: its scene and its contacts."""

    scene: SceneTable = SceneTable()
    contact: list[ContactTable] = []


class MapTable(Table):
    """A bone map by role: bodies of a figure, joints of a recording; "" for none."""

    figure: dict[str, str] = {}
    recording: dict[str, str] = {}


class MirrorTable(Table):
    """Partners of the mirror symmetry whose names do not contain left and right."""

    pairs: Annotated[list[tuple[Name, Name]], 'a list of pairs of names, such as [["arm_1", "arm_2"]]'] = []


class ClipTable(Table):
    """The whole file of a clip."""

    figure: Annotated[str, "the name of a figure or a path in quotes"]
    fps: Annotated[Real, Field(ge=0.01, le=1000)] = 30.0
    scene: SceneTable = SceneTable()
    solve: SolveTable = SolveTable()
    penalty: Annotated[list[PenaltyTable], "[[penalty]] tables"] = []
    contact: Annotated[list[ContactTable], "[[contact]] tables"] = []
    grasp: Annotated[list[GraspTable], "[[grasp]] tables"] = []
    recording: RecordingTable | None = None
    mirror: MirrorTable = MirrorTable()
    keyframe: Annotated[list[KeyframeTable], "[[keyframe]] tables"] = []
