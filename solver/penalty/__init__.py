"""The soft constraints: one concept a file."""

from .bend import Bend as Bend
from .bend import BendLimits as BendLimits
from .contact import Contact as Contact
from .contact import Point as Point
from .contact import body_points as body_points
from .contact import site_points as site_points
from .covariant import CovariantAcceleration as CovariantAcceleration
from .flight import Flight as Flight
from .flight import within as within
from .footing import Footing as Footing
from .footing import flights as flights
from .footing import footings as footings
from .peak import PeakAcceleration as PeakAcceleration
from .penalty import Penalty as Penalty
from .penalty import Scale as Scale
from .planted import Planted as Planted
from .planted import Stance as Stance
from .planted import stances as stances
from .root import RootAcceleration as RootAcceleration
from .support import Support as Support
from .torque import Torque as Torque
from .unit import UnitMagnitude as UnitMagnitude
