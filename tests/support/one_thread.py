"""Tests solve as the command does: on one thread. Imported before anything that imports NumPy; processes inherit it."""

from dynsplines.system import threads

threads.use_one_thread()
