"""Settles which renderer this process draws with, before anything in it imports mujoco."""

from __future__ import annotations

from dynsplines.picture.graphics import choose

GRAPHICS = choose()
