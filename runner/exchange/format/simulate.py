"""MJCF of a scene for `mj_step`: contacts, actuators, and a <key> with their targets for every sample."""

from __future__ import annotations

from pathlib import Path

from ..simulation.scene import Simulation
from ..simulation.tracking import note, refined
from ..trajectory import SampledTrajectory
from .mjcf_keys import write_keys


def write(trajectory: SampledTrajectory, path: Path) -> None:
    """Write the scene, with notes on what it overrides and how far it follows the motion."""
    simulation, tracked = Simulation.of(trajectory), None
    if len(trajectory.time) > 1:
        simulation, tracked = refined(simulation, trajectory)
    trajectory.notes.append(f"{simulation.model.nu} position actuators; `ctrl` of the keys is what to aim them at")
    trajectory.notes.extend(simulation.notes)
    if tracked is not None:
        trajectory.notes.append(note(tracked, simulation, trajectory))
    write_keys(simulation.root, trajectory, path, simulation.control)
