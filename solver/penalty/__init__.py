"""The soft constraints: one concept a file."""

from .bend import Bend as Bend
from .bend import BendLimits as BendLimits
from .contact import Contact as Contact
from .contact import Point as Point
from .contact import body_points as body_points
from .contact import site_points as site_points
from .covariant import CovariantAcceleration as CovariantAcceleration
from .grounded import Grounded as Grounded
from .grounded import grounded_intervals as grounded_intervals
from .penalty import Penalty as Penalty
from .penalty import Scale as Scale
from .planted import Planted as Planted
from .planted import Stance as Stance
from .planted import stances as stances
from .posture import Posture as Posture
from .resting import Rest as Rest
from .resting import Resting as Resting
from .root import RootAcceleration as RootAcceleration
from .skate import Skate as Skate
from .torque import Torque as Torque
from .unit import UnitMagnitude as UnitMagnitude
