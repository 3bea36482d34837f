"""The start of the solver process. Nothing is imported before it is known that this is not the server."""

from __future__ import annotations

from typing import Any


def entry(line: Any, outside: bool) -> None:
    """Run the solver process. With `outside`, models may refer to files anywhere."""
    from ...picture.graphics import do_without
    from ...system import mujoco_warnings
    from ...system.threads import use_one_thread, without_tools

    use_one_thread()
    do_without()
    without_tools()
    from .loop import serve

    with mujoco_warnings.reported_to(mujoco_warnings.print_note):
        serve(line, outside)
