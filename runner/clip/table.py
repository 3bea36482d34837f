"""The clip file's tables: which keys there are and what they hold, and complaints in the file's own words."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, Strict, ValidationError

from ..errors import unknown
from ..system.quantity import LARGEST

Real = Annotated[float, Strict(), Field(allow_inf_nan=False)]
Number = Annotated[Real, Field(ge=-LARGEST, le=LARGEST)]
Whole = Annotated[int, Strict()]
Flag = Annotated[bool, Strict()]
Length = Annotated[Real, Field(gt=0, le=1000)]
Angle = Annotated[Real, Field(gt=0, le=360)]
Axis = Number | Literal["free"]
Share = Annotated[Real, Field(ge=0, le=1)]
Place = tuple[Number, Number, Number]
KEY = "key:"  # before the name of a <key> of the model
ModelKey = Annotated[str, Strict(), Field(pattern=f"^{KEY}.+")]


class Table(BaseModel):
    """Some keys of a clip's file, and no others."""

    model_config = ConfigDict(extra="forbid", strict=False)


class RotationTable(Table):
    """A rotation, said in one of several ways."""

    rotvec: tuple[Number, Number, Number] | None = None
    euler: list[Number] | None = None
    order: str | None = None
    quat: tuple[Number, Number, Number, Number] | None = None
    heading: Number | None = None


class RootTable(Table):
    """Where a free body is, and how it is turned."""

    position: tuple[Axis, Axis, Axis] | Literal["free"] = "free"
    rotation: RotationTable | Literal["free"] = "free"


class SiteTable(Table):
    """Where a site is, and who puts it there."""

    position: tuple[Axis, Axis, Axis]
    by: Literal["pose", "search"] = "pose"


class BodyTable(RotationTable):
    """How a body is turned, and where its origin is, or the point `at` in its axes."""

    flat: Flag | None = None
    position: tuple[Axis, Axis, Axis] | None = None
    at: Place | None = None


class KeyframeTable(Table):
    """The figure at one time, as much of it as is said."""

    time: Number
    root: RootTable = RootTable()
    roots: dict[str, RootTable] = {}
    joints: dict[str, RotationTable | Number | Literal["free"]] = {}
    sites: dict[str, SiteTable | tuple[Axis, Axis, Axis]] = {}
    bodies: dict[str, BodyTable] = {}
    others: Literal["free", "rest", "hold"] | ModelKey = "free"

    @property
    def model_key(self) -> str | None:
        """The name of the model's <key> that the rest is as in, if it is."""
        return self.others.removeprefix(KEY) if self.others.startswith(KEY) else None


class StepTable(Table):
    """A step to climb."""

    x: Number
    height: Length
    length: Length = 3.0
    width: Length = 2.4
    y: Number = 0.0


class _ObstacleTable(Table):
    name: Annotated[str, Field(min_length=1)] | None = None
    body: Annotated[str, Field(min_length=1)] | None = None
    mass: Annotated[Real, Field(gt=0, le=LARGEST)] | None = None
    color: tuple[Share, Share, Share, Share] | None = None
    position: Place | None = None
    rotation: RotationTable | None = None


class BoxTable(_ObstacleTable):
    """A box."""

    size: tuple[Length, Length, Length]


class SphereTable(_ObstacleTable):
    """A ball."""

    radius: Length


class BarTable(_ObstacleTable):
    """A capsule or cylinder: from one point to another, or a length about a position."""

    radius: Length
    length: Length | None = None
    start: Place | None = Field(None, alias="from")
    end: Place | None = Field(None, alias="to")


class SceneTable(Table):
    """What stands about."""

    step: StepTable | None = None
    box: list[BoxTable] = []
    sphere: list[SphereTable] = []
    capsule: list[BarTable] = []
    cylinder: list[BarTable] = []


class PenaltyTable(Table):
    """A soft constraint: its kind, and what is said of it, which its record in `kinds` knows."""

    model_config = ConfigDict(extra="allow", strict=False)
    kind: str

    @classmethod
    def of(cls, kind: str, **said: Any) -> PenaltyTable:
        """As a file would have it."""
        return cls.model_validate({"kind": kind, **said})

    @property
    def said(self) -> dict[str, Any]:
        """The options by name, as they were given."""
        return dict(self.model_extra or {})


class ContactTable(Table):
    """A point that rests, from one time to another [s]."""

    point: str
    start: Number = Field(alias="from")
    end: Number = Field(alias="to")
    position: Place | None = None

    @property
    def subject(self) -> str:
        """What can be in one place at a time only."""
        return self.point


class HoldTable(Table):
    """A site that stays where it is on a body, from one time to another [s]."""

    hand: str
    body: str
    start: Number = Field(alias="from")
    end: Number = Field(alias="to")
    position: Place | None = None

    @property
    def subject(self) -> str:
        """What can hold one thing at a time only."""
        return self.hand


class SolveTable(Table):
    """How the spline ends and how the search goes; None: as it is best."""

    coordinates: Literal["auto", "world", "joint"] = "auto"
    ends: Literal["free", "clamped", "periodic"] = "free"
    travel: tuple[Number, Number, Number] | None = None
    turn: Annotated[Real, Field(ge=-360, le=360)] | None = None
    variable: Annotated[Whole, Field(ge=0, le=50)] | None = None
    frames: Annotated[Whole, Field(ge=0, le=100_000)] | None = None
    criterion: str | None = None
    threshold: Annotated[Real, Field(ge=0)] | None = None
    optimiser: str | None = None
    evaluations: Annotated[Whole, Field(ge=1, le=1_000_000)] | None = None
    tolerance: Annotated[Real, Field(gt=0, le=1)] | None = None
    quadrature: Literal["gauss", "uniform"] = "gauss"
    samples: Annotated[Whole, Field(ge=1, le=10_000)] | None = None


class RecordingTable(Table):
    """A motion that was recorded, which keyframes edit: what of it, when, and how much it counts.

    file    a motion (.npz), a recording (.bvh, ...), a clip (.toml) or the name of one that ships
    repeat  how often a loop comes
    start, end  [s] what of it is used;  at  [s] when that begins in the clip;  speed  times as fast
    times   [s, s] moments of the recording and when they come in the clip, in place of at and speed
    weight  how much it counts;  blend  [s] before and after every keyframe, outside of which nothing is changed
    """

    file: str
    repeat: Annotated[Whole, Field(ge=1, le=1000)] | None = None
    start: Number | None = Field(default=None, alias="from")
    end: Number | None = Field(default=None, alias="to")
    at: Number | None = None
    speed: Annotated[Real, Field(ge=0.05, le=20)] | None = None
    times: list[tuple[Number, Number]] | None = None
    weight: Annotated[Real, Field(gt=0, le=1e6)] = 1.0
    blend: Annotated[Real, Field(gt=0, le=60)] | None = None


class SurroundingsTable(Table):
    """What is round a recording: the scene that it was made in, and the contacts in it."""

    scene: SceneTable = SceneTable()
    contact: list[ContactTable] = []


class MapTable(Table):
    """Bone map, by role: bodies of a figure, joints of a recording; "" for none."""

    figure: dict[str, str] = {}
    recording: dict[str, str] = {}


class ClipTable(Table):
    """All of a clip's file."""

    figure: str
    fps: Annotated[Real, Field(ge=0.01, le=1000)] = 30.0
    scene: SceneTable = SceneTable()
    solve: SolveTable = SolveTable()
    penalty: list[PenaltyTable] = []
    contact: list[ContactTable] = []
    hold: list[HoldTable] = []
    recording: RecordingTable | None = None
    keyframe: list[KeyframeTable] = []


def spoken(
    error: ValidationError, raw: dict[str, Any], inside: tuple[int | str, ...] = (), root: type[Table] | None = None
) -> str:
    """The first complaint of a validation, in the clip file's own words.

    inside  where in `raw` that stands which was validated
    root    the whole file's tables, if it is no clip
    """
    complaints = error.errors()
    telling = ("finite_number", "extra_forbidden")
    first = next((c for kind in telling for c in complaints if c["type"] == kind), complaints[0])
    names, words, given = _walked((*inside, *first["loc"]), raw)
    where = "".join(f"{word}: " for word in words)
    key = ".".join(names)
    kind = first["type"]
    if kind == "extra_forbidden":
        above = f"{'.'.join(names[:-1])}: " if names[:-1] else ""
        fields = _schema(words, names[:-1], root or ClipTable).model_fields
        return where + above + unknown("key", names[-1], [field.alias or name for name, field in fields.items()])
    if kind == "missing" and isinstance(first["loc"][-1], str):
        return f"{where}'{key}' is missing"
    if kind == "finite_number":
        return f"{where}{key or 'number'} must be a finite number, not {given}"
    for start, bound in (("greater_than_equal", "at least"), ("greater_than", "above"), ("less_than", "at most")):
        if kind.startswith(start):
            limit = next(iter(first.get("ctx", {}).values()))
            return f"{where}{key} must be {bound} {limit:g}, not {given}"
    plain = "a table" if kind.endswith(("model_type", "dict_type")) else first["msg"].removeprefix("Input should be ")
    expected = _EXPECTED.get(_role(words, names), plain)
    return f"{where}{key + ' ' if key else ''}must be {expected}, not {_shown(given)}"


def _walked(location: tuple[int | str, ...], raw: Any) -> tuple[list[str], list[str], Any]:
    """The keys of a complaint's location, the numbered tables around it, and what stands there.

    pydantic's locations also hold the names of alternatives, which no user knows: a key is what the file has there.
    """
    names: list[str] = []
    words: list[str] = []
    here = raw
    for i, part in enumerate(location):
        if isinstance(here, list) and isinstance(part, int) and part < len(here):
            here = here[part]
            if i == 2 and names[0] == "scene":
                name = here.get("name") if isinstance(here, dict) else None
                words.append(f"{'.'.join(names)} {part + 1}" + (f" ('{name}')" if isinstance(name, str) else ""))
                names.clear()
            if i == 1:
                time = here.get("time") if isinstance(here, dict) else None
                known = isinstance(time, int | float) and not isinstance(time, bool) and abs(time) <= LARGEST
                words.append(f"{names.pop()} {part + 1}" + (f" (t = {time:g} s)" if known else ""))
        elif isinstance(here, dict) and part in here:
            names.append(str(part))
            here = here[part]
        elif isinstance(here, dict) and i == len(location) - 1:
            names.append(str(part))
    return names, words, here


def _role(words: list[str], names: list[str]) -> str:
    """What kind of entry a key is: joints have names of their own."""
    if words and words[0].startswith("penalty") and names and names[0] in _OF_PENALTIES:
        return _OF_PENALTIES[names[0]]
    if len(names) == 2 and names[0] in _NAMED:
        return _NAMED[names[0]][0]
    if words and words[0].startswith(("contact", "hold")) and names:
        return {"from": "time", "to": "time", "position": "obstacle's position", "body": "body's name"}.get(
            names[-1], names[-1]
        )
    if words and words[0].startswith("scene.") and names[-1:] in (["position"], ["rotation"]):
        return f"obstacle's {names[-1]}"
    if words and words[0].startswith("scene.") and names[-1:] == ["body"]:
        return "body's name"
    return names[-1] if names else ""


def _schema(words: list[str], names: list[str], root: type[Table]) -> type[Table]:
    """The table that an unknown key stands in."""
    if len(names) == 2 and names[0] in _NAMED:
        return _NAMED[names[0]][1]
    if names:
        return _TABLES[names[-1]]
    return _TABLES[words[0].split()[0]] if words else root


def _shown(value: Any) -> str:
    """A value of the file as a message shows it: short."""
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, bool):
        return str(value).lower()
    text = repr(value) if isinstance(value, str | int | float | list) else str(value)
    return text if len(text) <= 60 else text[:57] + "..."


_OF_PENALTIES = {"weight": "weight", "bodies": "bodies of a penalty", "axis": "axis of a penalty"}
_NAMED: dict[str, tuple[str, type[Table]]] = {
    "joints": ("joint", RotationTable),
    "roots": ("root", RootTable),
    "sites": ("site", SiteTable),
    "bodies": ("body", BodyTable),
}
_TABLES: dict[str, type[Table]] = {
    "keyframe": KeyframeTable,
    "penalty": PenaltyTable,
    "contact": ContactTable,
    "hold": HoldTable,
    "scene": SceneTable,
    "step": StepTable,
    "scene.box": BoxTable,
    "scene.sphere": SphereTable,
    "scene.capsule": BarTable,
    "scene.cylinder": BarTable,
    "solve": SolveTable,
    "recording": RecordingTable,
    "root": RootTable,
    "rotation": RotationTable,
}

ROTATION = "{rotvec = [x, y, z]}, {euler = [...], order = ...} or {quat = [w, x, y, z]}"
_NUMBERS = ("time", "fps", "x", "y", "height", "length", "width", "weight", "margin", "least_bend", "sideways", "twist")
_OF_OTHERS = ("angular", "friction", "heading", "mass", "period", "radius", "reach", "speed", "turn")
_WHOLE = ("variable", "frames", "evaluations", "samples")
_EXPECTED = {
    **dict.fromkeys((*_NUMBERS, *_OF_OTHERS, "threshold", "tolerance"), "a number"),
    **dict.fromkeys(_WHOLE, "a whole number"),
    **dict.fromkeys(("kind", "criterion", "optimiser", "order", "point", "hand"), "a word in quotes"),
    **dict.fromkeys(("points", "bend_joints", "bodies of a penalty"), "a list of names"),
    "intervals": "a list of [from, to] in seconds",
    "others": "'free', 'rest', 'hold' or 'key:NAME', a <key> of the model",
    "figure": "the name of a figure or a path in quotes",
    "keyframe": "[[keyframe]] tables",
    "penalty": "[[penalty]] tables",
    "contact": "[[contact]] tables",
    "hold": "[[hold]] tables",
    **{kind: f"[[scene.{kind}]] tables" for kind in ("box", "sphere", "capsule", "cylinder")},
    **dict.fromkeys(("obstacle's position", "from", "to"), "[x, y, z] in metres"),
    "root": "a table: position and rotation of a free joint",
    "obstacle's rotation": ROTATION,
    "size": "[length, width, height] in metres",
    "color": "[red, green, blue, opacity], each from 0 to 1",
    **dict.fromkeys(("name", "body's name"), "a name in quotes"),
    "position": '[x, y, z] in metres, each a number or "free"',
    "rotation": f'{ROTATION} or "free"',
    "joint": f'{ROTATION}, a number or "free"',
    "site": '[x, y, z] in metres, each a number or "free", or {position = [x, y, z], by = "pose" or "search"}',
    "body": f"{{flat = true}} or a rotation, {ROTATION}, or {{position = [x, y, z]}}",
    "at": "[x, y, z] in metres, in the body's own axes",
    "axis of a penalty": "[x, y, z] in the body's own axes",
    "by": "'pose' or 'search'",
    "flat": "true",
    "self": "true or false",
    "rotvec": "three angles [x, y, z] in degrees",
    "euler": "a list of angles in degrees",
    "quat": "four numbers [w, x, y, z]",
    "coordinates": "'auto', 'world' or 'joint'",
    "ends": "'free', 'clamped' or 'periodic'",
    "travel": "[x, y, z] in metres",
    "quadrature": "'gauss' or 'uniform'",
}
