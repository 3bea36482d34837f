"""The start of the command: signal handlers are set before any slow import."""

from __future__ import annotations

import atexit
import gc
import sys
from collections.abc import Callable

from .system import signals


def _dynsplines() -> None:
    from .cli import main as command

    command()


def main(command: Callable[[], None] = _dynsplines) -> None:
    """Run a command, by default `dynsplines`, which begins with its imports."""
    signals.install_handlers()
    atexit.register(gc.freeze)  # Python's last garbage collection takes a fifth of a second
    try:
        command()
    except KeyboardInterrupt:
        _exit_by_signal()
    except SystemExit:
        signals.ignore()
        raise
    except MemoryError:
        print("dynsplines: not enough memory for this", file=sys.stderr)
        sys.exit(2)
    except Exception:
        if not signals.was_received():
            raise
        _exit_by_signal()  # an interrupted import may raise any exception


def _exit_by_signal() -> None:
    signals.ignore()
    print("dynsplines: stopped", file=sys.stderr)
    sys.exit(signals.code(signals.STOPPED))


if __name__ == "__main__":
    main()
