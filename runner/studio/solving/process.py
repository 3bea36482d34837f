"""The start of the solver process. Nothing is imported before it is known that this is not the server."""

from __future__ import annotations

from functools import partial
from importlib import import_module
from typing import Any

HEAVY = (  # slow imports, in parts of a few tenths of a second
    "scipy.sparse",
    "scipy.linalg",
    "mujoco",
    "dynsplines.solver.inbetween",
    "dynsplines.clip.table",
    "dynsplines.clip.load",
    "dynsplines.studio.solving.loop",
)
PATIENCE = 2.5  # [s] duration of low priority of imports, while the page draws its first view


def entry(line: Any, outside: bool, shows_view: bool) -> None:
    """Run the solver process.

    With `outside`, models may refer to files anywhere. `shows_view` is whether pages show a view before this process
    reports.
    """
    from ...picture.graphics import do_without
    from ...system import mujoco_warnings
    from ...system.low_priority import yielding
    from ...system.threads import use_one_thread, without_tools

    use_one_thread()
    do_without()
    yielding([without_tools, *(partial(import_module, name) for name in HEAVY)], PATIENCE if shows_view else 0.0)
    from .loop import serve

    with mujoco_warnings.reported_to(mujoco_warnings.print_note):
        serve(line, outside)
