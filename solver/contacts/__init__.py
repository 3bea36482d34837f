"""Inference of when and where figures touch their surroundings, from keyframes, clips and recordings.

schedule          all contacts of one clip: stances, grasps, flights, gait
contact           a point that stays in one place
stances           where a figure stands, from keyframes: planted points, the footings that carry it, steps of its legs
grasp             which links are held, and where they rest before and after
flight            free fall around keyframes in the air
keyframe_points   positions and heights of points at keyframes, from which all these are inferred
gait              the walking or running cycle of keyframes: a Gaussian process of poses, and the choice of its period
pose_vectors      poses as vectors: the joints' deviation from their mean, without position and heading
recorded_stances  the stances of a recording's soles, by the likelihood of their positions
ground_alignment  vertical alignment of a recording with the ground
thresholds        all distances, times and speeds that decide, relative to the size of the figure
"""

from .contact import Contact as Contact
from .contact import Interval as Interval
from .contact import within as within
from .grasp import grasped_links as grasped_links
from .grasp import resting_objects as resting_objects
from .grasp import surfaces_on as surfaces_on
from .grasp import tree_of as tree_of
from .schedule import ContactSchedule as ContactSchedule
from .stances import Steps as Steps
from .stances import footings as footings
from .stances import stances as stances
