"""Where the command begins: signals are heeded before anything is imported that takes time."""

from __future__ import annotations

import sys

from .system import stopping

STOPPED = 130  # the exit code of Ctrl-C


def main() -> None:
    """The command `dynsplines`, see `cli`."""
    stopping.heed()
    try:
        from .cli import main as command

        command()
    except KeyboardInterrupt:
        _stopped()
    except SystemExit:
        stopping.ignore()
        raise
    except Exception:
        if not stopping.was_asked():
            raise
        _stopped()  # an import that is interrupted can end in any error


def _stopped() -> None:
    stopping.ignore()
    print("dynsplines: stopped", file=sys.stderr)
    sys.exit(stopping.code(STOPPED))
