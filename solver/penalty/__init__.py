"""The soft constraints.

penalty    the base class, sums of several penalties, tolerance of violations in keyframes, a consistency check
block      the residuals of a penalty, from which value, gradient and curvature are computed
curvature  Gauss-Newton second derivatives, and one-sided residuals
motion, ground, joints  the soft constraints
"""

from .block import Block as Block
from .block import Dense as Dense
from .block import Entries as Entries
from .ground.attachment import Attachment as Attachment
from .ground.attachment import grasp_places as grasp_places
from .ground.collision import Collision as Collision
from .ground.hover import HoverPenalty as HoverPenalty
from .ground.skate import Skate as Skate
from .ground.support import Flight as Flight
from .ground.support import Support as Support
from .joints.bend import Bend as Bend
from .joints.bend import BendLimits as BendLimits
from .joints.equality import Coupling as Coupling
from .joints.equality import CouplingPenalty as CouplingPenalty
from .joints.equality import closures as closures
from .joints.equality import couplings as couplings
from .joints.joint_range import JointRange as JointRange
from .joints.joint_range import Range as Range
from .joints.joint_range import Speed as Speed
from .joints.joint_range import joint_ranges as joint_ranges
from .joints.overshoot import holds as holds
from .joints.overshoot import overshoot as overshoot
from .joints.self_contact import SelfContact as SelfContact
from .joints.upright import Upright as Upright
from .motion.acceleration import CovariantAcceleration as CovariantAcceleration
from .motion.acceleration import PeakAcceleration as PeakAcceleration
from .motion.acceleration import RootAcceleration as RootAcceleration
from .motion.acceleration import UnitMagnitude as UnitMagnitude
from .motion.cycle import Cycle as Cycle
from .motion.posture import Between as Between
from .motion.posture import Posture as Posture
from .motion.prior import Person as Person
from .motion.prior import Prior as Prior
from .motion.torque import Torque as Torque
from .motion.tracking import TrackingPenalty as TrackingPenalty
from .penalty import Allowance as Allowance
from .penalty import Guide as Guide
from .penalty import Normalization as Normalization
from .penalty import Penalty as Penalty
from .penalty import Role as Role
from .penalty import Sum as Sum
from .penalty import check as check
