"""A clip on the page: the figure in its scene, its draggable parts (joints, sites, soles), and the text's content."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import numpy as np

from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.model import kinematics

from ..clip.build import Clip
from ..clip.kinds import KINDS
from ..clip.parse import options_of, table_of
from ..clip.posing.places import posable_sites
from ..clip.table import ClipTable
from ..clip.text import tables
from ..exchange.model_json import visible_parts
from ..exchange.skeleton import hierarchy
from ..scene.triangles import is_still, pieces

FLOOR = 40.0  # [m] half size of an infinite floor


def stage(clip: Clip) -> bytes:
    """Return the figure and its surroundings as JSON."""
    figure, model = clip.figure, clip.figure.model
    moving = sorted({piece.body for piece in pieces(model) if not is_still(model, piece)})
    data = kinematics(model)
    places = data.xpos[moving or [0]]
    description = {
        "bodies": hierarchy.names(model),
        "parents": model.body_parentid.tolist(),
        "still": [bool(model.body_weldid[body] == 0) for body in range(model.nbody)],
        "size": round(float(np.linalg.norm(np.ptp(places, axis=0))) or 1.0, 4),
        "joints": [_joint(figure, i) for i in range(1, len(figure.links))],
        "sites": _sites(figure),
        "soles": [_sole(figure, point) for point in clip.context.points],
        "limbs": limbs(figure),
        **visible_parts(model, FLOOR),
    }
    return json.dumps(description, separators=(",", ":")).encode()


def _joint(figure: Figure, index: int) -> dict[str, Any]:
    """Return a joint: its place in qpos, its range [degrees or m], its axis and anchor in its body [m]."""
    link, model = figure.links[index], figure.model
    limits = None
    if link.kind is not JointKind.FREE and model.jnt_limited[link.joint]:
        values = model.jnt_range[link.joint]
        limits = [round(float(x), 4) for x in (values if link.kind is JointKind.SLIDE else np.degrees(values))]
    return {
        "name": link.name,
        "kind": link.kind.name.lower(),
        "qpos": int(link.qpos),
        "body": int(link.body),
        "range": limits,
        "axis": [round(float(x), 6) for x in model.jnt_axis[link.joint]],
        "anchor": [round(float(x), 6) for x in model.jnt_pos[link.joint]],
    }


def _sites(figure: Figure) -> list[dict[str, Any]]:
    model = figure.model
    entries: list[dict[str, Any]] = []
    for name in posable_sites(model):
        site = model.site(name).id
        body = int(model.site_bodyid[site])
        if model.body_weldid[body]:
            entries.append({"name": name, "body": body, "offset": [round(float(x), 5) for x in model.site_pos[site]]})
    return entries


def _sole(figure: Figure, point: Any) -> dict[str, Any]:
    from dynsplines.solver.posing import PointGoal

    goal = PointGoal.of(figure, point)
    offset = [round(float(x), 5) for x in goal.offsets[0]]
    return {"name": point.name, "body": goal.index, "offset": offset, "radius": round(float(point.radius), 5)}


def limbs(figure: Figure) -> list[dict[str, Any]]:
    """Return the figure's limbs and the trunk as rows of the timeline; a limb extends to the next branch.

    A free body other than the figure's root has a separate row. "end" is the last body of a limb, which is dragged.
    """
    rows: list[dict[str, Any]] = []
    assigned: set[int] = set()
    free, chains = set(figure.tables.free_links.tolist()), figure.limbs
    for links in (links for links in chains if links[0] not in free):
        joints = [figure.links[j].name for j in reversed(links)]
        rows.append({"name": _joint_names(figure, links), "joints": joints, "end": int(figure.links[links[0]].body)})
        assigned |= set(links)
    bodies = [links[0] for links in chains if links[0] in free and links[0] != _root(figure)]
    trunk = [i for i in range(1, len(figure.links)) if i not in assigned and i not in bodies]
    if trunk:
        names = [figure.links[i].name for i in trunk]
        rows.insert(0, {"name": "root and trunk", "joints": names, "end": int(figure.links[trunk[0]].body)})
    for link in (figure.links[i] for i in bodies):
        rows.append({"name": link.name, "joints": [link.name], "end": int(link.body)})
    return rows


def _root(figure: Figure) -> int:
    """Return the link of the figure's free root; 0 if there is none."""
    return figure.root.link if figure.root is not None else 0


def _joint_names(figure: Figure, links: Sequence[int]) -> str:
    """Return the name of a limb: its side and kind, or else its first and last joint."""
    first, last = figure.links[links[-1]].name, figure.links[links[0]].name
    words = f"{first} {last}".lower()
    side = next((word for word in ("left", "right") if word in words), "")
    kinds = {"arm": ("shoulder", "arm", "elbow", "wrist", "hand"), "leg": ("hip", "knee", "ankle", "foot", "leg")}
    kind = next((kind for kind, parts in kinds.items() if any(part in words for part in parts)), "")
    return f"{side} {kind}" if side and kind else (first if first == last else f"{first} … {last}")


def outline(text: str, where: str) -> dict[str, Any]:
    """Return the content of a clip's text for the page. Raises UserError for an invalid clip."""
    table = table_of(text, where)
    content = tables(table)
    scene = content.get("scene", {})
    return {
        "figure": table.figure,
        "fps": table.fps,
        "keys": [{"others": "free", **row} for row in content.get("keyframe", [])],
        "contacts": content.get("contact", []),
        "grasps": content.get("grasp", []),
        "weights": weights(table, where),
        "obstacles": [
            {"kind": kind, "index": index, **obstacle}
            for kind, rows in scene.items()
            for index, obstacle in enumerate([rows] if kind == "step" else rows)
        ],
        "solve": content.get("solve", {}),
    }


def weights(table: ClipTable, where: str) -> dict[str, float]:
    """Return the weights in the clip's text by term; for a clip with a recording, the factors."""
    listed: dict[str, float] = {}
    for name, options in options_of(table.penalty, where).items():
        kind, weight = KINDS[name], options.weight
        weights = {} if weight is None else kind.weights(options) if table.recording is None else kind.factors(options)
        for part in kind.parts:
            if part.name in weights and (not isinstance(weight, dict) or part.name in weight):
                listed[kind.term(part)] = weights[part.name]
    return listed


def kinds() -> list[dict[str, object]]:
    """Return the terms of soft constraints, one per row."""
    return [
        {"kind": kind["kind"], **part}
        for kind in (kind.describe() for kind in KINDS.values())
        for part in kind["parts"]
    ]
