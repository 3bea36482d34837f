"""Smooth motion through keyframes under soft constraints: the mathematics, no files.

After R. Ramamoorthi, C. Ball and A. H. Barr, "Dynamic Splines with Constraints for Animation".
"""

from .figure import Figure as Figure
from .figure import FigureError as FigureError
from .frame import Frame as Frame
from .frame import Timeline as Timeline
from .frame import TimelineError as TimelineError
from .inbetween import Improvement as Improvement
from .inbetween import Motion as Motion
from .inbetween import Settings as Settings
from .inbetween import inbetween as inbetween
from .objective import Objective as Objective
from .optimiser import Stop as Stop
from .optimiser import StopSearch as StopSearch
from .quadrature import Quadrature as Quadrature
from .spline import Path as Path
