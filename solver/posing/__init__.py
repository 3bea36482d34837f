"""Inverse kinematics: poses that meet target positions of points and target rotations of bodies.

inverse_kinematics  the pose for goals, from one or several starting poses
drag                the pose that follows the drag of a point, with soles, floor and support polygon
least_squares       damped least squares
goals               positions of points in the world or on a body, rotations of bodies; the joints that they depend on
bounds              joint ranges, and the bending of knees and elbows
"""

from .drag import Balance as Balance
from .drag import FloorClearance as FloorClearance
from .drag import SupportPolygon as SupportPolygon
from .drag import drag_pose as drag_pose
from .goals import BodyGoal as BodyGoal
from .goals import Goal as Goal
from .goals import PointGoal as PointGoal
from .goals import entries_of as entries_of
from .goals import rest_rotation as rest_rotation
from .goals import same_heading as same_heading
from .inverse_kinematics import MET as MET
from .inverse_kinematics import STARTS as STARTS
from .inverse_kinematics import Posed as Posed
from .inverse_kinematics import PoseSearch as PoseSearch
from .inverse_kinematics import find_pose as find_pose
from .inverse_kinematics import in_winding as in_winding
from .least_squares import Residuals as Residuals
from .least_squares import join as join
from .least_squares import minimise as minimise
