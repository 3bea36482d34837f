"""Smooth motion of a MuJoCo figure through a few keyframes. This module is the Python API.

    from dynsplines import load, inbetween

    motion = inbetween(load("run_and_step"))
    qpos = motion.at(1.5)

clips, figures                             names of shipped clips and figures
load, build                      -> Clip   a problem: keyframes of a figure (`Keyframe`), and soft constraints
inbetween                        -> Motion its solution
load_motion, import_motion       -> Motion from files
UserError                                  raised for every error that the caller can correct

Names are imported on first use, so `import dynsplines` itself is fast.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dynsplines.models import clips as clips
    from dynsplines.models import figures as figures

    from .clip.build import Clip as Clip
    from .errors import UserError as UserError
    from .python.functions import Keyframe as Keyframe
    from .python.functions import build as build
    from .python.functions import import_motion as import_motion
    from .python.functions import inbetween as inbetween
    from .python.functions import load as load
    from .python.functions import load_motion as load_motion
    from .python.motion import Motion as Motion
else:
    _HOMES = {
        "Clip": "dynsplines.clip.build",
        "Keyframe": "dynsplines.python.functions",
        "Motion": "dynsplines.python.motion",
        "UserError": "dynsplines.errors",
        "build": "dynsplines.python.functions",
        "clips": "dynsplines.models",
        "figures": "dynsplines.models",
        "import_motion": "dynsplines.python.functions",
        "inbetween": "dynsplines.python.functions",
        "load": "dynsplines.python.functions",
        "load_motion": "dynsplines.python.functions",
    }

    def __getattr__(name):
        """Return a name of the API from its module (PEP 562)."""
        from importlib import import_module

        if name not in _HOMES:
            raise AttributeError(f"module 'dynsplines' has no attribute '{name}'; it has: {', '.join(sorted(_HOMES))}")
        value = getattr(import_module(_HOMES[name]), name)
        globals()[name] = value
        return value

    def __dir__():
        return sorted({*globals(), *_HOMES})


__all__ = [
    "Clip", "Keyframe", "Motion", "UserError", "build", "clips", "figures", "import_motion", "inbetween", "load",
    "load_motion",
]  # fmt: skip
