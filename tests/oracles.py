"""What MuJoCo can be asked as an oracle, and from which version on."""

import mujoco
import pytest

tells_height_fields = pytest.mark.skipif(
    int(mujoco.__version__[0]) < 4, reason="MuJoCo 3 tells no distances from height fields"
)
