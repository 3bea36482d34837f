"""Edits of motions: retimed, trimmed, repeated, thinned.

timelines  speed, trimming and repetition
thin       few keyframes that approximate a recorded motion within a bound
"""
