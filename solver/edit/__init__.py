"""Edits that keep the mathematics: a motion played otherwise, joined, thinned.

retime  edits of a timeline that keep its curve
join    two motions in sequence: the second is moved to the end of the first
thin    as few keyframes of a recorded motion as keep it within a bound
"""
