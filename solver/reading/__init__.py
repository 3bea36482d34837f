"""What keyframes and recordings tell by themselves, before anything is searched.

rhythm        the walking or running cycle that keyframes tell, as a Gaussian process of poses
stride        which cycle a figure's legs make of its keyframes
pose_vectors  poses as vectors: what a figure's joints do about their mean, wherever it is and wherever it faces
recorded      a recording as a curve to be near: smoothed as much as its own noise asks for, bridged in gaps
moving        how likely the places of a point are if it moves
stances       which points of the soles stood when, read off a recording
settled       a recording set down on what stands
"""
