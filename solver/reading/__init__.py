"""What keyframes tell by themselves, before anything is searched.

rhythm        the walking or running cycle that keyframes tell, as a Gaussian process of poses
stride        which cycle a figure's legs make of its keyframes
pose_vectors  poses as vectors: what a figure's joints do about their mean, wherever it is and wherever it faces
"""
