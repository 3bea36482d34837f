"""Inference from keyframes and recordings, before the search.

gait              the walking or running cycle of keyframes, as a Gaussian process of poses
gait_period       the choice of the cycle: periods that suit the size of the body, feet that do not slip
pose_vectors      poses as vectors: the joints' deviation from their mean, independent of place and heading
recording         a recording as a curve to track: smoothed according to its noise, bridged in gaps
point_likelihood  the likelihood of the places of a point that moves
stances           the stances of a recording's soles
ground_alignment  a recording moved down or up onto the ground
"""
