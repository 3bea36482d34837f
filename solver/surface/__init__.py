"""Contact geometry: points of a figure, and surfaces that they must not penetrate.

surface       the interface of shapes: depth, proximity, height; planes
solid         shapes by their signed distance
round, box, height_field, hull  the shapes
static        static geoms of the scene as surfaces, and those of a moving object
touch         the solid geoms of a model, and pairs that overlap by design
points        the figure's contact geometry: spheres on its links
cover         spheres that fill a body, against thin obstacles
heights       heights of spheres above the surfaces that support a figure
"""

from .box import Box as Box
from .height_field import HeightField as HeightField
from .hull import Hull as Hull
from .round import Capsule as Capsule
from .round import Cylinder as Cylinder
from .round import Ellipsoid as Ellipsoid
from .static import hull_of as hull_of
from .static import moving_surface as moving_surface
from .static import static_surfaces as static_surfaces
from .surface import Plane as Plane
from .surface import Surface as Surface
