"""Edits that keep the mathematics: a motion reflected, played otherwise, joined, thinned.

mirror  left and right exchanged: a figure's motion reflected in the x-z plane, as a linear map of its states
retime  edits of a timeline that keep its curve
join    two motions made one: the second is moved to where the first goes on
thin    as few keyframes of a recorded motion as keep it within a bound
"""
