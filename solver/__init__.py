"""Smooth motion through keyframes under soft constraints: the mathematics, no files.

After R. Ramamoorthi, C. Ball and A. H. Barr, "Dynamic Splines with Constraints for Animation".
"""

from .curve.frame import Frame as Frame
from .curve.frame import Timeline as Timeline
from .curve.frame import TimelineError as TimelineError
from .curve.quadrature import Quadrature as Quadrature
from .curve.spline import Path as Path
from .figure.figure import Figure as Figure
from .inbetween import inbetween as inbetween
from .objective import Objective as Objective
from .problem import Improvement as Improvement
from .problem import Problem as Problem
from .problem import Settings as Settings
from .problem import Solution as Solution
from .search.minimum import Stop as Stop
from .search.minimum import StopSearch as StopSearch
