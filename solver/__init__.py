"""Quaternion splines through frames, soft constraints and their optimisation: the mathematics, no files."""
