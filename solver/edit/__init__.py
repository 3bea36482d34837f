"""Edits of motions: retimed, joined, thinned.

timelines  speed, trimming, repetition, and two motions in sequence
thin       few keyframes that approximate a recorded motion within a bound
"""
