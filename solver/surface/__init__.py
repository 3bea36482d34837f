"""What touches: points of a figure, and surfaces that they stay out of, one shape a file.

surface  the interface of shapes: depth, proximity, height
plane, box, capsule, cylinder, ellipsoid, height_field, hull  the shapes
static   static geoms of the scene as surfaces, and those of a moving object
touch    which of a model's geoms are in the way, and which are to be kept clear
points   what of a figure touches: spheres on its links
cover    a body's inside filled with spheres, so that nothing small can be in it
heights  how high spheres are over what one can stand on
"""

from .box import Box as Box
from .capsule import Capsule as Capsule
from .capsule import Sphere as Sphere
from .cylinder import Cylinder as Cylinder
from .ellipsoid import Ellipsoid as Ellipsoid
from .height_field import HeightField as HeightField
from .hull import Hull as Hull
from .plane import Plane as Plane
from .static import hull_of as hull_of
from .static import moving_surface as moving_surface
from .static import static_surfaces as static_surfaces
from .surface import Surface as Surface
