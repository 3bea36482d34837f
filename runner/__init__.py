"""dynamic-splines: a few keyframes of a MuJoCo figure into smooth motion. Everything that users of Python need is here.

    from dynsplines import load, inbetween

    motion = inbetween(load("run_and_step"))
    qpos = motion.at(1.5)

clips, figures                             what ships, by name
load, build                      -> Clip   a problem: keyframes of a figure, in Keyframe's words, and soft constraints
inbetween                        -> Motion the verb
load_motion, import_motion       -> Motion from files
UserError                                  raised for every error that the caller can correct

Names are imported on first use: `import dynsplines` takes a moment, the first name a few tenths of a second.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dynsplines.models import clips as clips
    from dynsplines.models import figures as figures

    from .clip.build import Clip as Clip
    from .errors import UserError as UserError
    from .python.building import Keyframe as Keyframe
    from .python.building import build as build
    from .python.loading import import_motion as import_motion
    from .python.loading import load as load
    from .python.loading import load_motion as load_motion
    from .python.motion import Motion as Motion
    from .python.motion import inbetween as inbetween
else:
    _HOMES = {
        "Clip": "dynsplines.clip.build",
        "Keyframe": "dynsplines.python.building",
        "Motion": "dynsplines.python.motion",
        "UserError": "dynsplines.errors",
        "build": "dynsplines.python.building",
        "clips": "dynsplines.models",
        "figures": "dynsplines.models",
        "import_motion": "dynsplines.python.loading",
        "inbetween": "dynsplines.python.motion",
        "load": "dynsplines.python.loading",
        "load_motion": "dynsplines.python.loading",
    }

    def __getattr__(name):
        """A name of the API from the module that has it (PEP 562)."""
        from importlib import import_module

        if name not in _HOMES:
            raise AttributeError(f"module 'dynsplines' has no attribute '{name}'; it has: {', '.join(sorted(_HOMES))}")
        found = getattr(import_module(_HOMES[name]), name)
        globals()[name] = found
        return found

    def __dir__():
        return sorted({*globals(), *_HOMES})


__all__ = [
    "Clip", "Keyframe", "Motion", "UserError", "build", "clips", "figures", "import_motion", "inbetween", "load",
    "load_motion",
]  # fmt: skip
