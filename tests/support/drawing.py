"""Settles which renderer this process draws with, before anything in it imports mujoco."""

from __future__ import annotations

import json
import os
from dataclasses import asdict

from dynsplines.picture.graphics import Graphics, choose

CHOSEN = "DYNSPLINES_TESTS_GRAPHICS"  # of the first process; the others need no trial

if CHOSEN not in os.environ:
    os.environ[CHOSEN] = json.dumps(asdict(choose()))
GRAPHICS = Graphics(**json.loads(os.environ[CHOSEN]))
