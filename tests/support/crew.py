"""What worker processes do in tests; in a file of its own, which they can import."""

import os
import time
from types import TracebackType
from typing import Self


class Bench:
    """A tool that counts its uses and knows whose it is."""

    def __init__(self) -> None:
        self.owner, self.uses, self.is_open = os.getpid(), 0, False

    def __enter__(self) -> Self:
        self.is_open = True
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.is_open = False


def locked(*_: object) -> Bench:
    raise ValueError("the bench is locked")


def squared(bench: Bench, number: int) -> tuple[int, int, int]:
    """The square, the process, and how often its bench was used; the first items take longest."""
    assert bench.is_open
    bench.uses += 1
    time.sleep(0.2 if number < 2 else 0.01)
    return number**2, bench.owner, bench.uses


def fails_at_three(bench: Bench, number: int) -> int:
    if number == 3:
        raise ValueError("three is too many")
    return number


def leaves(tool: object, item: object) -> None:
    os._exit(3)


def lasts(tool: object, item: object) -> None:
    time.sleep(0.3)


def warns(tool: object, item: object) -> None:
    """Lets MuJoCo warn, as a tool that draws may."""
    import mujoco

    import dynsplines.scene.assets  # noqa: F401

    model = mujoco.MjModel.from_xml_string(
        "<mujoco><worldbody><body><joint/><geom size='1'/></body></worldbody></mujoco>"
    )
    data = mujoco.MjData(model)
    data.qvel[:] = 1e20
    mujoco.mj_step(model, data)
