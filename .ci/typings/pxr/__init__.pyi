# usd-core brings no types; its names are made when it is imported.
from . import Gf as Gf
from . import Sdf as Sdf
from . import Tf as Tf
from . import Usd as Usd
from . import UsdGeom as UsdGeom
from . import UsdShade as UsdShade
from . import UsdSkel as UsdSkel
from . import Vt as Vt
