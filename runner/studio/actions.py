"""Page actions that need the figure: poses, keyframes from the path, copies, mirror images."""

from __future__ import annotations

import asyncio
import pickle
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ..errors import UserError, unknown
from .session import Session

if TYPE_CHECKING:
    from ..clip.text import TomlTable
    from .posing import Grip, Poser
    from .solver import Message


@dataclass
class _DragAction:
    """A drag of a point, or a rotation of a joint.

    Attributes:
        body: MuJoCo's id of the body.
        home: The pose before it, (nq,).
        pose: The present pose, (nq,).
        grip: The grabbed point; None for a rotation.
        turned: Time [s] and name of the rotated joint; None for a point.
    """

    body: int
    home: Any
    pose: Any
    grip: Grip | None = None
    turned: tuple[float, str] | None = None


class Actions:
    """The actions of the page on a session; the figure is prepared in the background, so the page never waits."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self._prepared: tuple[bytes, Poser] | None = None  # the poser of a pickled figure
        self._preparing = threading.Lock()
        self._drag: _DragAction | None = None

    def prepare(self) -> None:
        """Create the poser in the background, so that the first drag does not wait."""
        asyncio.get_running_loop().run_in_executor(None, self._poser)

    async def poser(self) -> Poser:
        """Return the poser of the present figure."""
        return await asyncio.to_thread(self._poser)

    def _poser(self) -> Poser:
        with self._preparing:  # the first drag may begin during the preparation
            data, present = self.session.figure, self._prepared
            if data is None:
                raise UserError("there is no figure yet; wait for the clip to load")
            if present is None or present[0] is not data:
                present = self._prepared = data, self._new_poser(data)
            return present[1]

    def _new_poser(self, data: bytes) -> Poser:
        import numpy as np

        from dynsplines.solver.figure.figure import Figure

        from ..clip.parse import table_of
        from .posing import Poser

        figure = Figure(pickle.loads(data).model())  # data of this program only
        whole = [key["qpos"] for key in self.session.loaded.get("keys", ()) if all(key["fixed"])]
        table = table_of(self.session.document.text, self.session.document.place)
        return Poser(figure, table.penalty, np.reshape(np.array(whole, float), (-1, figure.width)))

    async def _same_poser(self, drag: _DragAction) -> Poser:
        """Return the poser of the present figure. Raises UserError if an edit has changed the figure during a drag."""
        poser = await self.poser()
        if len(drag.home) != poser.figure.width:
            await self.cancel()
            raise UserError("the figure has changed; grab it again")
        return poser

    async def grip(
        self,
        *,
        time: float,
        body: int,
        offset: Sequence[float],
        plant: bool = True,
        alone: bool = False,
        locks: Sequence[int] = (),
    ) -> str:
        """Grab a point of a body at a time of the clip. With `alone`, only its limb moves; locked bodies stay."""
        poser = await self.poser()
        home = self.at(time, poser)
        how = {"plant": plant, "alone": alone, "locked": locks}
        grip = await asyncio.to_thread(poser.grip, home, int(body), offset, **how)
        self._drag = _DragAction(int(body), home, home, grip=grip)
        return ""

    async def drag(self, *, position: Sequence[float]) -> Message:
        """Return the pose with that point at a position [m]: position and rotation of every body, and the miss [m]."""
        drag = self._drag
        if drag is None or drag.grip is None:
            raise UserError("no limb is grabbed; press the mouse on one first")
        poser = await self._same_poser(drag)
        begin = time.perf_counter()
        posed = await asyncio.to_thread(poser.pull, drag.grip, position, drag.pose)
        drag.pose = posed.qpos
        bodies = _bodies(poser, posed.qpos)
        return {**bodies, "missed": round(posed.worst, 5), "ms": round(1e3 * (time.perf_counter() - begin), 2)}

    async def turn(self, *, time: float, joint: str, turn: Sequence[float], locks: Sequence[int] = ()) -> Message:
        """Return the pose with one joint rotated, in the format of `drag`."""
        poser, turned, drag = await self.poser(), (float(time), joint), self._drag
        if drag is None or drag.turned != turned:
            home = self.at(time, poser)
            body = next((int(link.body) for link in poser.figure.links[1:] if link.name == joint), 0)
            drag = self._drag = _DragAction(body, home, home, turned=turned)
        pose = (await self._same_poser(drag)).turn(drag.home, joint, turn)
        drag.pose = await asyncio.to_thread(poser.keep, drag.home, pose, locks) if locks else pose
        return _bodies(poser, drag.pose)

    async def drop(self, *, time: float, partial: bool = False) -> str:
        """End the drag and write the pose to the keyframe at this time, or to a new keyframe.

        With `partial`, a new keyframe specifies only what was moved; the optimiser determines the rest.
        """
        drag, self._drag = self._drag, None
        if drag is None:
            return ""
        edit = self._edit_of_drag(drag, await self._same_poser(drag), time, partial=partial)
        return "" if edit is None else await self.session.edit(*edit)

    def _edit_of_drag(
        self, drag: _DragAction, poser: Poser, time: float, *, partial: bool
    ) -> tuple[str, Message] | None:
        """Return the edit, as arguments of `Session.edit`, that ends a drag; None if nothing has moved."""
        home, last, index = drag.home, drag.pose, self.key_at(time)
        entries = poser.keyframe_entries(last, home)
        if not any(entries.values()):
            return None
        if index is None:
            moved = self._limb_entries(drag.body, poser, entries, last) if partial else poser.keyframe_entries(last)
            return "add_key", {"entries": {**moved, "time": time}}
        if "root" in entries:  # the whole pose, because everything attached to the root moves along
            entries = self._without_free_joints(index, poser.keyframe_entries(last), home, last, poser)
            entries = {**entries, **_without(self._targets(index))}
        else:
            entries = self._released_entries(index, _links_in(entries, poser), last, poser, entries)
        return "change", _arguments(index, entries, "pose the figure")

    def _targets(self, index: int) -> list[str]:
        """Return the sites and bodies with a target position in a keyframe."""
        row = self._row(index)
        return [name for group in ("sites", "bodies") for name in row.get(group, {})]

    def _released_entries(self, index: int, names: set[str], qpos: Any, poser: Poser, entries: TomlTable) -> TomlTable:
        """Return the moved joints of a keyframe, and the targets that these override. Other joints that such a target
        determined, of its limb and the root, are fixed as in the pose (nq,)."""
        row = self._row(index)
        places = [name for name in self._targets(index) if poser.deciding_joints(name)[0] & names]
        decided = {joint for name in places for joint in poser.deciding_joints(name)[1]} - set(row.get("joints", {}))
        if places and "root" not in row and poser.root is not None:
            decided |= {poser.root}
        decided = (decided - names) & self._fixed_names(index, poser)
        instead = poser.select_joints(poser.keyframe_entries(qpos), decided)
        out: TomlTable = {"joints": {**instead["joints"], **entries["joints"]}, **_without(places)}
        root: TomlTable = {**instead.get("root", {}), **entries.get("root", {})}
        if root:
            out["root"] = root
        if roots := {**instead.get("roots", {}), **entries.get("roots", {})}:
            out["roots"] = roots
        return out

    @staticmethod
    def _limb_entries(body: int, poser: Poser, entries: TomlTable, qpos: Any) -> TomlTable:
        """Return the moved joints with all other joints of the dragged or rotated limb."""
        limb = poser.limb_names(body)
        limb_joints = {name: value for name, value in poser.keyframe_entries(qpos)["joints"].items() if name in limb}
        return {**entries, "joints": {**limb_joints, **entries["joints"]}}

    def _without_free_joints(self, index: int, entries: TomlTable, home: Any, last: Any, poser: Poser) -> TomlTable:
        """Return the entries without joints that the keyframe leaves free and that the drag did not move."""
        moved = _links_in(poser.keyframe_entries(last, home), poser)
        return poser.select_joints(entries, self._fixed_names(index, poser) | moved)

    async def cancel(self) -> str:
        """End the drag without an edit."""
        self._drag = None
        return ""

    async def key(self, *, time: float, limb: Sequence[str] | None = None) -> str:
        """Add a keyframe from the present path, of the joints in `limb` only, if specified."""
        poser = await self.poser()
        entries = poser.keyframe_entries(self.at(time, poser))
        if limb is not None:
            entries = poser.select_joints(entries, limb)
            if not any(entries.values()):
                raise UserError("none of these joints can be set on its own; select another limb")
        return await self.session.edit("add_key", {"entries": {"time": time, **entries}})

    async def edit(self, *, name: str, plant: bool = False, locks: Sequence[int] = (), **arguments: Any) -> str:
        """Apply an edit by name. With `plant`, feet on the ground stay in place, and so do locked bodies."""
        if plant or locks:
            kept = self._kept(arguments["at"], arguments["entries"], locks, plant=plant)
            arguments["entries"] = await kept
        return await self.session.edit(name, arguments)

    async def _kept(self, at: Sequence[Any], entries: TomlTable, locks: Sequence[int], *, plant: bool) -> TomlTable:
        """Return changed entries of a keyframe, with limbs that keep locked bodies and feet on the ground in place.

        Feet with a target position keep it without this, and free joints stay free.
        """
        poser, index = await self.poser(), int(at[1])
        before = self._state(index)
        try:
            after, _ = poser.with_entries(before, entries)
        except UserError:  # the edit reports it
            return entries
        if self._targets(index):
            return entries
        after = await asyncio.to_thread(poser.keep, before, after, locks, plant=plant or bool(locks))
        changed = {*entries.get("joints", {}), *entries.get("roots", {}), *([poser.root] if "root" in entries else [])}
        others = self._fixed_names(index, poser) - changed
        out = poser.select_joints(poser.keyframe_entries(after, before), others)
        return {**entries, **out, **{name: {**out[name], **entries.get(name, {})} for name in out if name != "root"}}

    async def pose(self, *, time: float, name: str | None = None, partial: bool = False) -> str:
        """Apply a saved pose, or without a name the rest pose, to the keyframe at this time, or to a new keyframe.

        The root stays at its horizontal position and heading. With `partial`, a new keyframe specifies only the pose.
        """
        import numpy as np

        poser, home = await self.poser(), await self._pose_at(time)
        joints = poser.keyframe_entries(poser.figure.model.qpos0)["joints"]
        entries = {"joints": joints} if name is None else self.session.document.read_pose(name)
        pose, is_specified = poser.with_entries(home, entries, f"the pose '{name}'")
        if not is_specified.any():
            raise UserError(f"the pose '{name}' has no joints; list them under [joints]")
        moved = np.where(is_specified, np.inf, home)  # its entries
        self._drag = _DragAction(0, moved, poser.place(pose, home))
        return await self.drop(time=time, partial=partial)

    async def save_pose(self, *, time: float, name: str, overwrite: bool = False) -> str:
        """Save the joints that the keyframe at this time fixes, or the present pose between keyframes, as a file."""
        poser, index = await self.poser(), self.key_at(time)
        entries = poser.keyframe_entries(await self._pose_at(time))
        if index is not None:
            entries = poser.select_joints(entries, self._fixed_names(index, poser))
        entries.pop("roots", None)
        self.session.document.save_pose(name, entries, overwrite=overwrite)
        self.session.show_poses()
        return f"saved the pose '{name}'"

    async def _pose_at(self, time: float) -> Any:
        """Return the pose of the keyframe at this time, or that of the present path, (nq,)."""
        index = self.key_at(time)
        return self.at(time, await self.poser()) if index is None else self._state(index)

    def _fixed_names(self, index: int, poser: Poser) -> set[str]:
        """Return the names of the joints that a keyframe fixes."""
        fixed = self.session.loaded["keys"][index]["fixed"]
        return {link.name for link in poser.figure.links[1:] if fixed[link.qpos]}

    async def pin(self, *, key: int, joints: Sequence[str]) -> str:
        """Fix joints of a keyframe at their values on the present path."""
        poser = await self.poser()
        row = self._row(key)
        entries = poser.select_joints(poser.keyframe_entries(self.at(float(row["time"]), poser)), joints)
        determined = {*joints, *row.get("joints", {}), *row.get("roots", {}), *([poser.root] if "root" in row else [])}
        # targets whose joints are all fixed now
        places = [name for name in self._targets(key) if poser.deciding_joints(name)[0] <= determined]
        return await self.session.edit("change", _arguments(key, {**entries, **_without(places)}, "pin joints"))

    async def free(self, *, key: int, joints: Sequence[str]) -> str:
        """Free joints of a keyframe, and remove the targets that determine them."""
        poser = await self.poser()
        entries: TomlTable = {"joints": {}}
        whole: TomlTable = {"position": "free", "rotation": "free"}
        for link in poser.figure.links[1:]:
            if link.name == poser.root and link.name in joints:
                entries["root"] = whole
            elif link.name in joints and link.kind.name == "FREE":
                entries.setdefault("roots", {})[link.name] = whole
            elif link.name in joints:
                entries["joints"][link.name] = "free"
        entries = self._released_entries(key, set(joints), self._state(key), poser, entries)
        return await self.session.edit("change", _arguments(key, entries, "free joints"))

    async def mirror(self, *, keys: Sequence[int]) -> str:
        """Swap left and right in keyframes."""
        from ..clip.mirror import figure_mirror, mirrored_keyframe
        from ..clip.parse import table_of
        from ..clip.text import tables

        poser = await self.poser()
        table = table_of(self.session.document.text, self.session.document.place)
        mirror, rows = figure_mirror(poser.figure, table, self.session.document.place), table.keyframe
        entries = {str(index): tables(mirrored_keyframe(rows[index], poser.figure, mirror)) for index in keys}
        words = "mirror a keyframe" if len(keys) == 1 else f"mirror {len(keys)} keyframes"
        return await self.session.edit("replace_keys", {"keys": entries, "words": words})

    def at(self, time: float, poser: Poser) -> Any:
        """Return the present path at a time of the clip, (nq,)."""
        import numpy as np

        from dynsplines.solver.curve.spline import path_of

        timeline = self.session.timeline
        if timeline is None:
            raise UserError("there is no path yet; wait for the clip to load")
        inside = float(np.clip(time, timeline.times[0], timeline.times[-1]))
        return poser.figure.to_qpos(path_of(timeline).at(np.array([inside])))[0]

    def _state(self, index: int) -> Any:
        """Return a keyframe as loaded, with the pose solved for its targets, (nq,)."""
        import numpy as np

        self._row(index)
        return np.array(self.session.loaded["keys"][index]["qpos"], float)

    def key_at(self, time: float) -> int | None:
        from ..clip.parse import is_too_near  # imported here because it needs the solver's imports

        times = [float(row["time"]) for row in self.session.document.tree_rows()]
        return next((i for i, key_time in enumerate(times) if is_too_near(key_time, time)), None)

    def _row(self, index: int) -> TomlTable:
        rows = self.session.document.tree_rows()
        if not 0 <= index < len(rows):
            raise UserError(unknown("keyframe", str(index + 1), [str(i + 1) for i in range(len(rows))]))
        return rows[index]


def _bodies(poser: Poser, qpos: Any) -> Message:
    """Return positions (nbody · 3) [m] and rotations (nbody · 4), xyzw, of all bodies."""
    from .paths import poses

    position, rotation, _ = poses(poser.figure, qpos[None])
    return {"position": position[0].round(5).ravel().tolist(), "rotation": rotation[0].round(6).ravel().tolist()}


def _without(places: Sequence[str]) -> TomlTable:
    """Return the entries that remove targets of sites or bodies."""
    return {group: dict.fromkeys(places) for group in ("sites", "bodies")}


def _arguments(index: int, entries: TomlTable, words: str) -> Message:
    """Return the arguments of an edit of a keyframe."""
    return {"at": ["keyframe", index], "entries": entries, "words": words}


def _links_in(entries: TomlTable, poser: Poser) -> set[str]:
    root = {poser.root} if poser.root is not None and entries.get("root") else set()
    return {*entries["joints"], *entries.get("roots", {}), *root}
