"""What contact points stay out of: the scene's static geoms, one shape a file."""

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
