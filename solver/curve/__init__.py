"""The curve: frames in time, the C² spline through them, and what of it may move.

frame       the state of a figure at one time, with the entries that are fixed; timelines of them
spline      the C² cubic B-spline through a timeline's frames, eqs. 2-6
quadrature  sample times and weights of the integral E (eq. 1)
banded      banded matrices, by LAPACK
seam        the seam of a loop: where its last frame stands beside its first
closing     how the keyframes of a loop close it: travel and heading
winding     which way round a joint turns from one keyframe to the next: the signs of quaternions
arcs        the straight way between keyframes: one arc at one speed a joint (SLERP)
symmetry    which link of a figure is on the other side of which, at rest
mirror      left and right exchanged: motion reflected in the x-z plane, as a linear map of states
unknowns    the decision vector x of a timeline, and the affine map from it to the spline's rows
"""
