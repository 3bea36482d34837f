"""The environment of the tests, imported before NumPy and MuJoCo: one thread, bytecode, signals, renderer."""

import json
import os
import signal
import sys
from dataclasses import asdict

from dynsplines.picture.graphics import Graphics, choose
from dynsplines.system import threads

# Tests solve as the command does: on one thread. Imported before anything that imports NumPy; processes inherit it.

threads.use_one_thread()


# Compiled modules are kept while tests run, whatever the environment says: they start Python some hundred times.

os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False


# Processes that tests start hear Ctrl-C and hangups, also where the tests themselves were started deaf to them: behind
# `nohup`, or by `&` in a script. What a process ignores those that it starts ignore too; a handler is not handed on.

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP") and signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:
    signal.signal(signal.SIGHUP, lambda *_: None)


# The renderer of these tests. The first process tries OpenGL, the others inherit the result.

CHOSEN = "DYNSPLINES_TESTS_GRAPHICS"
if CHOSEN not in os.environ:
    os.environ[CHOSEN] = json.dumps(asdict(choose()))
GRAPHICS = Graphics(**json.loads(os.environ[CHOSEN]))
