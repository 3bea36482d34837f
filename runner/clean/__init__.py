"""Recordings made physical: sliding, sinking, floating and jumps are removed, the motion is preserved.

rest_pose_trim  the pose before a recording's motion: that to which cameras or skeleton were set
repairs    gaps, jumps, duplicate and invalid samples, rest poses: found, reported and bridged
cleaning   a repaired recording, its stances, and the motion near it that keeps to them
penetration  how deep a figure is in what is round it, and where a search did not see it
comparison  before and after: depth, slip, ranges, accelerations, forces, and how far what has moved
command    the command `clean`: from a recording's file to a clean one
"""
