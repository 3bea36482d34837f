"""Clips that use every table there is, of a small figure: texts to be changed, and tables drawn at random.

What is drawn comes from a `random.Random`, so that a seed makes it again, and hypothesis can make it smaller.
"""

import random
from collections.abc import Callable, Sequence

import mujoco
import problems
from fuzz.mangle import Rng, mangled_text
from texts import read_data

from dynsplines.clip.kinds import KINDS as PENALTIES
from dynsplines.clip.text import text_of
from dynsplines.solver.search.nlopt_methods import METHODS

MODEL = read_data("rich.xml")

CLIP = read_data("every_table.toml")

SIMPLE = problems.changed("evaluations = 8", "evaluations = 2")
SOURCES = (SIMPLE, SIMPLE, CLIP)
ODD = (0, -1, 1e9, -1e9, float("nan"), float("inf"), 10**30, True, "", "free", [], {}, [0, 0, 0], 1e-12, "naïve", [[]])
BODIES, JOINTS = ("pelvis", "left_shin", "nobody", "world"), ("left_knee", "root", "none")
SITES = ("left_toe", "no_site")
SURE = ("torque", "unit", "acceleration", "limits", "attach", "collision")
ODDLY = 0.004  # of all values are of another kind


def spec() -> mujoco.MjSpec:
    """The tiny figure."""
    return mujoco.MjSpec.from_string(problems.FIGURE)


def mangled_clip(rng: Rng) -> bytes:
    """A good clip's text, changed."""
    source = SOURCES[int(rng.integers(len(SOURCES)))]
    return mangled_text(source, rng)


def random_clip(rng: Rng) -> bytes:
    """Tables drawn at random, most of their keys known."""
    return table(random.Random(int(rng.integers(2**62)))).encode("utf-8", "surrogatepass")


def solvable_clip(rng: Rng) -> bytes:
    """A clip of the tiny figure whose values all make sense, nearly always; a tenth of texts that are changed."""
    if rng.random() < 0.1:
        return mangled_clip(rng)
    return _Drawn(random.Random(int(rng.integers(2**62))), 0.0).clip().encode()


def solvable_text(seed: int) -> str:
    """A clip of the tiny figure whose values all make sense."""
    return _Drawn(random.Random(seed), 0.0).clip()


def table(draw: random.Random) -> str:
    """A clip's text."""
    return _Drawn(draw, ODDLY).clip()


class _Drawn:
    """Values of a clip, by chance; a few of them are none that it can have."""

    def __init__(self, draw: random.Random, oddly: float) -> None:
        self.draw, self.oddly = draw, oddly

    def clip(self) -> str:
        times = self._times()
        found = {
            "figure": self._odd(lambda: "tiny.xml"),
            "fps": self._odd(lambda: self.draw.choice([10, 24, 30.0, 120])),
            "solve": self._some(self._solve()),
            "penalty": self._penalties(),
            "contact": self._list(lambda: self._span(times) | {"point": self._site()}, 1 if self.oddly else 0),
            "scene": self._some(self._scene()),
            "keyframe": [self._keyframe(number, time) for number, time in enumerate(times)],
        }
        if self.draw.random() < self.oddly:
            found["keyframe"] = self.draw.choice([[], found["keyframe"][:1], found["keyframe"][::-1]])
        return text_of({name: value for name, value in found.items() if value not in ([], {})})

    def _odd(self, usual: Callable[[], object]) -> object:
        return self.draw.choice(ODD) if self.draw.random() < self.oddly else usual()

    def _some(self, values: dict[str, Callable[[], object]], share: float = 0.4) -> dict[str, object]:
        found = {name: self._odd(value) for name, value in values.items() if self.draw.random() < share}
        if self.draw.random() < self.oddly:
            found[self.draw.choice(["wieght", "nme", "0", "a b"])] = 1
        return found

    def _list(self, value: Callable[[], object], most: int) -> list[object]:
        return [value() for _ in range(self.draw.randint(0, most))]

    def _number(self, size: float = 1.0) -> object:
        return self._odd(lambda: round(self.draw.uniform(-size, size), 4))

    def _vector(self, size: float = 1.0) -> object:
        return self._odd(lambda: [self._number(size) for _ in range(3)])

    def _times(self) -> list[float]:
        steps = [self.draw.choice([0.01, 0.1, 0.2, 0.3, 1.0]) for _ in range(self.draw.randint(1, 4))]
        found = [self.draw.choice([0.0, 0.0, 5.0, -1.0])]
        for step in steps:
            found.append(round(found[-1] + step, 4))
        return found

    def _span(self, times: Sequence[float]) -> dict[str, object]:
        first, last = sorted(self.draw.sample(times, 2))
        return {"from": self._odd(lambda: first), "to": self._odd(lambda: last)}

    def _site(self) -> object:
        return self.draw.choice(SITES) if self.oddly else SITES[0]

    def _rotation(self) -> object:
        return self._odd(
            lambda: self.draw.choice(
                [
                    lambda: {"rotvec": self._vector(170)},
                    lambda: {"euler": self._vector(90), "order": self.draw.choice(["xyz", "zyx", "zxy"])},
                    lambda: {"quat": [1.0, *(round(self.draw.uniform(-1, 1), 3) for _ in range(3))]},
                ]
            )()
        )

    def _keyframe(self, number: int, time: float) -> dict[str, object]:
        place: list[object] = [self._number(), self._number(), self._odd(lambda: round(self.draw.uniform(0.5, 1.5), 4))]
        root = {"position": lambda: place, "rotation": self._rotation}
        joints = {"left_knee": lambda: self.draw.choice([self._rotation, self._rotation, lambda: "free"])()}
        ends = number == 0
        found: dict[str, object] = {"time": self._odd(lambda: time), "root": self._some(root, 1.0 if ends else 0.7)}
        if ends or self.draw.random() < 0.3:
            found["others"] = self._odd(lambda: "rest" if ends else self.draw.choice(["rest", "previous", "free"]))
        found |= self._some({"joints": lambda: self._some(joints, 0.9)}, 0.6)
        if self.draw.random() < 10 * self.oddly:
            found["sites"] = {str(self._site()): self._vector(0.5)}
        if self.draw.random() < 10 * self.oddly:
            found["bodies"] = {self.draw.choice(BODIES): self._odd(lambda: {"flat": True})}
        return found

    def _solve(self) -> dict[str, Callable[[], object]]:
        return {
            "ends": lambda: self.draw.choice(["free", "clamped"]),
            "variable": lambda: self.draw.randint(0, 3),
            "frames": lambda: self.draw.randint(0, 6),
            "evaluations": lambda: self.draw.randint(1, 3),
            "criterion": lambda: self.draw.choice(["weak", "residual"]),
            "threshold": lambda: self.draw.choice([0, 0.001, 1]),
            "optimiser": lambda: self.draw.choice([*METHODS]),
            "tolerance": lambda: self.draw.choice([1e-9, 1e-3]),
            "quadrature": lambda: self.draw.choice(["gauss", "uniform"]),
            "samples": lambda: self.draw.randint(1, 20),
        }

    def _penalties(self) -> list[object]:
        known = list(PENALTIES) if self.draw.random() < 50 * self.oddly else SURE
        return [
            self._penalty(self._odd(lambda kind=kind: kind))
            for kind in self.draw.sample(known, self.draw.randint(0, 3))
        ]

    def _weight(self, kind: object) -> object:
        weight = self.draw.choice([0, 0.1, 1, 100, {"self": 1}, {"range": 0}])
        fits = not isinstance(weight, dict) or kind == ("collision" if "self" in weight else "limits")
        return weight if fits or self.oddly else 10

    def _penalty(self, kind: object) -> dict[str, object]:
        found: dict[str, Callable[[], object]] = {"weight": lambda: self._weight(kind)}
        if self.draw.random() < 50 * self.oddly:
            found |= {
                "margin": lambda: 0.01,
                "points": lambda: [self._site()],
                "bend_joints": lambda: [self.draw.choice(JOINTS)],
                "self": lambda: True,
                "friction": lambda: 0.5,
                "intervals": lambda: [[0, 0.1]],
            }
        return {"kind": kind} | self._some(found, 0.3)

    def _scene(self) -> dict[str, Callable[[], object]]:
        size = lambda: [round(self.draw.uniform(0.05, 1), 3) for _ in range(3)]  # noqa: E731
        return {
            "step": lambda: {"x": self._number(3), "height": self._odd(lambda: 0.1)},
            "box": lambda: [{"size": self._odd(size), "position": [3, 0, 0.5]}],
            "sphere": lambda: [{"radius": self._odd(lambda: 0.2), "position": self._vector(3)}],
        }
