"""Edits of motions: retimed, joined, thinned.

retime  edits of a timeline that do not change its curve
join    two motions in sequence, the second moved to the end of the first
thin    few keyframes that approximate a recorded motion within a bound
"""
