"""Inverse kinematics: poses that meet target positions of points and target rotations of bodies.

inverse_kinematics  the pose for goals, from several starting poses
pose_search         damped least squares from one starting pose
goals               positions of points, rotations of bodies, grasps; the joints that they depend on
bounds              joint ranges, and the bending of knees and elbows
"""

from .bounds import Part as Part
from .bounds import joined as joined
from .goals import BodyGoal as BodyGoal
from .goals import Goal as Goal
from .goals import GraspGoal as GraspGoal
from .goals import PointGoal as PointGoal
from .goals import chain as chain
from .goals import entries as entries
from .goals import limb as limb
from .goals import reached as reached
from .inverse_kinematics import STARTS as STARTS
from .inverse_kinematics import in_winding as in_winding
from .inverse_kinematics import posed as posed
from .pose_search import MET as MET
from .pose_search import Posed as Posed
from .pose_search import PoseSearch as PoseSearch
