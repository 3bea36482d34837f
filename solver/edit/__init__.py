"""Edits that keep the mathematics: a motion played otherwise, joined, thinned.

retime  edits of a timeline that keep its curve
join    two motions made one: the second is moved to where the first goes on
thin    as few keyframes of a recorded motion as keep it within a bound
"""
