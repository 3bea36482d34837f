"""Where the command begins: signals are heeded before anything is imported that takes time."""

from __future__ import annotations

import sys
from collections.abc import Callable

from .system import signals

STOPPED = 130  # the exit code of Ctrl-C


def _dynsplines() -> None:
    from .cli import main as command

    command()


def main(command: Callable[[], None] = _dynsplines) -> None:
    """Run a command, `dynsplines` unless another one is named; its imports are its first part."""
    signals.heed()
    try:
        command()
    except KeyboardInterrupt:
        _stopped()
    except SystemExit:
        signals.ignore()
        raise
    except MemoryError:
        print("dynsplines: not enough memory for this", file=sys.stderr)
        sys.exit(2)
    except Exception:
        if not signals.was_asked():
            raise
        _stopped()  # an import that is interrupted can end in any error


def _stopped() -> None:
    signals.ignore()
    print("dynsplines: stopped", file=sys.stderr)
    sys.exit(signals.code(STOPPED))
