"""Contact geometry: points of a figure, and surfaces that they must not penetrate. Each file has one shape.

surface       the interface of shapes: depth, proximity, height
solid         shapes by their signed distance
plane, box, capsule, cylinder, ellipsoid, height_field, hull  the shapes
static        static geoms of the scene as surfaces, and those of a moving object
touch         the solid geoms of a model, and pairs that overlap by design
points        the figure's contact geometry: spheres on its links
cover         spheres that fill a body, against thin obstacles
heights       heights of spheres above the surfaces that support a figure
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
