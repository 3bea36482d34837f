"""Curves: frames in time, the C² spline through them, and its unknowns.

frame       the state of a figure at one time, with a mask of fixed entries; timelines of frames
spline      the C² cubic B-spline through a timeline's frames (eqs. 2-6)
quadrature  sample times and weights of the integral E (eq. 1)
banded      banded matrices, by LAPACK
seam        the seam of a loop: the map from its first frame to its last, and keyframes consistent with it
raw         the curves through keyframes before any search: the raw spline, and the straight path (SLERP)
symmetry    pairs of links on opposite sides of a figure at rest
mirror      motion reflected in the x-z plane, as a linear map of states
unknowns    the decision vector x of a timeline, and the affine map from x to the spline's rows
"""
