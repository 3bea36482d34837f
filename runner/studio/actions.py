"""What a page asks for that takes more than the text: poses, keyframes from the path, copies, mirror images."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..errors import UserError, unknown
from .numbering import renumbered
from .session import Session

if TYPE_CHECKING:
    from .posing import Grip, Poser

AT = 1e-6  # [s] nearer to it, one is at a keyframe
RESTS = 0.1  # [s] without another pose after which a drag may be about to end where it is


class Actions:
    """What one page does to a session. The figure is made when it is needed, aside: the page never waits for it."""

    def __init__(self, session: Session, number: int) -> None:
        self.session, self.number = session, number
        self._grip: Grip | None = None
        self._last: Any = None
        self._home: Any = None
        self._body = 0
        self._time, self._is_partial = 0.0, False
        self._rest: asyncio.TimerHandle | None = None

    async def poser(self) -> Poser:
        """What poses the present figure."""
        return await asyncio.to_thread(prepared, self.session)

    async def grip(
        self,
        *,
        time: float,
        body: int,
        offset: Sequence[float],
        plant: bool = True,
        alone: bool = False,
        partial: bool = False,
    ) -> dict[str, Any]:
        """Takes hold of a point of a body at a time of the clip; alone: of its limb and no more.

        partial  as it will be let go with
        """
        self._moves_on(time, partial)
        poser, qpos = await self.poser(), self.at(time)
        self._home, self._last, self._body = qpos, qpos, int(body)
        self._grip = await asyncio.to_thread(poser.gripped, qpos, int(body), offset, plant=plant, alone=alone)
        return {"planted": [goal.name for goal in self._grip.planted]}

    async def drag(self, *, position: Sequence[float]) -> dict[str, Any]:
        """The pose with that point at a place [m]: positions and rotations of every body, and what is missed [m]."""
        if self._grip is None:
            raise UserError("nothing is held; press the mouse on a limb first")
        self._moves_on()
        poser = await self.poser()
        begin = time.perf_counter()
        found = await asyncio.to_thread(poser.pulled, self._grip, position, self._last)
        self._last = found.qpos
        told = _bodies(poser, found.qpos)
        self._rests()
        return {**told, "missed": round(found.worst, 5), "ms": round(1e3 * (time.perf_counter() - begin), 2)}

    async def turn(self, *, time: float, joint: str, turn: Sequence[float], partial: bool = False) -> dict[str, Any]:
        """The pose with one joint turned: as `drag`."""
        self._moves_on(time, partial)
        poser = await self.poser()
        if self._grip is not None or self._home is None:
            self._grip, self._home = None, self.at(time)
        self._last = poser.turned(self._home, joint, turn)
        self._rests()
        return _bodies(poser, self._last)

    async def drop(self, *, time: float, partial: bool = False) -> str:
        """Lets go: the pose becomes what the keyframe at this time says; a new one, where there is none.

        partial  a new one says only what was moved, and leaves the rest to the optimiser
        """
        self._time, self._is_partial = time, partial
        self._keep_still()
        if self._last is None or self._home is None:
            return ""
        edit = self._meant(await self.poser())
        self._grip = self._home = self._last = None
        return "" if edit is None else await self.session.edit(*edit)

    def _meant(self, poser: Poser) -> tuple[str, dict[str, Any], int | None] | None:
        """The edit that letting go now would be, as `Session.edit` takes it; None where nothing has moved."""
        home, last, index = self._home, self._last, self.key_at(self._time)
        said = poser.said(last, home)
        if not said["joints"] and "root" not in said:
            return None
        if index is None and self._is_partial:
            return "add_key", {"said": self._whole_limb(poser, {**said, "time": self._time}, last)}, None
        if index is None:
            return "add_key", {"said": {**poser.said(last), "time": self._time}}, None
        named = poser.limb_names(self._body) if self._grip is not None else set()
        if "root" in said:
            said = poser.said(last)  # all of it: what holds on to the root comes along
            named = None
        row = self._row(index)
        places = [
            name for group in ("sites", "bodies") for name in row.get(group, {}) if named is None or name in named
        ]
        said = self._kept_free(index, said, home, last, poser) if named is None else said
        return "set_pose", {"key": index, "places": places, **said}, self.session.document.revision

    def _moves_on(self, time: float | None = None, partial: bool = False) -> None:
        """The pose is another from now on, and no more is to be done about the last one."""
        if time is not None:
            self._time, self._is_partial = time, partial
        self._keep_still()
        self.session.wait()

    def _keep_still(self) -> None:
        """Nothing is searched that is not searched yet."""
        if self._rest is not None:
            self._rest.cancel()
            self._rest = None

    def _rests(self) -> None:
        """If no other pose is asked for in a moment, what letting go would come to is searched already."""
        self._keep_still()
        self._rest = asyncio.get_running_loop().call_later(RESTS, self._foresee)

    def _foresee(self) -> None:
        known = self.session.poser
        if self._last is None or self._home is None or known is None or known[0] != self.session.stages:
            return
        edit = self._meant(known[1])
        if edit is not None:
            self.session.foresee(*edit)

    def _whole_limb(self, poser: Poser, said: dict[str, Any], qpos: Any) -> dict[str, Any]:
        """With all joints of the limb that was dragged, moved or not: what it does is said."""
        limb = poser.limb_names(self._body)
        own = {name: value for name, value in poser.said(qpos)["joints"].items() if name in limb}
        return {**said, "joints": {**own, **said["joints"]}}

    def _kept_free(self, index: int, said: Any, home: Any, last: Any, poser: Poser) -> Any:
        """Without joints that the keyframe leaves free and that the drag did not move."""
        fixed = self.session.loaded["keys"][index]["fixed"]
        moved = poser.said(last, home)
        free = {
            link.name for link in poser.figure.links[1:] if not fixed[link.qpos] and link.name not in moved["joints"]
        }
        return {**said, "joints": {name: value for name, value in said["joints"].items() if name not in free}}

    async def cancel(self) -> str:
        """Lets go, and nothing has happened."""
        self._moves_on()
        self._grip = self._home = self._last = None
        return ""

    async def key(self, *, time: float, limb: Sequence[str] | None = None) -> str:
        """A keyframe from the present path; of some joints alone, if they are given."""
        poser = await self.poser()
        said = poser.said(self.at(time))
        if limb is not None:
            said = {"joints": {name: value for name, value in said["joints"].items() if name in limb}}
            if not said["joints"]:
                raise UserError("none of these joints can be said alone; give another limb")
        return await self.session.edit("add_key", {"said": {"time": time, **said}})

    async def rest(self, *, key: int, revision: int | None = None) -> str:
        """A keyframe's joints as at rest; where the root is stays."""
        poser = await self.poser()
        key, revision = self._now(revision, key=key)["key"], self.session.document.revision
        said = poser.said(poser.figure.model.qpos0)
        places = [name for group in ("sites", "bodies") for name in self._row(key).get(group, {})]
        told = {"key": key, "joints": said["joints"], "places": places, "words": "pose as at rest"}
        return await self.session.edit("set_pose", told, revision)

    async def pin(self, *, key: int, joints: Sequence[str], revision: int | None = None) -> str:
        """Joints of a keyframe fixed as the present path has them."""
        poser = await self.poser()
        key, revision = self._now(revision, key=key)["key"], self.session.document.revision
        qpos = self.at(float(self._row(key)["time"]))
        said = poser.said(qpos)
        told: dict[str, Any] = {name: value for name, value in said["joints"].items() if name in joints}
        root = {"root": said["root"]} if any(name not in said["joints"] for name in joints) and "root" in said else {}
        words = f"pin {', '.join(joints[:2])}" + (" ..." if len(joints) > 2 else "")
        return await self.session.edit("set_pose", {"key": key, "joints": told, **root, "words": words}, revision)

    async def free(self, *, key: int, joints: Sequence[str], revision: int | None = None) -> str:
        """Joints of a keyframe left to the optimiser."""
        poser = await self.poser()
        roots = {link.name for link in poser.figure.links[1:] if link.kind.name == "FREE"}
        free: dict[str, Any] = {name: "free" for name in joints if name not in roots}
        root = {"root": {"position": "free", "rotation": "free"}} if any(name in roots for name in joints) else {}
        words = f"free {', '.join(joints[:2])}" + (" ..." if len(joints) > 2 else "")
        return await self.session.edit("set_pose", {"key": key, "joints": free, **root, "words": words}, revision)

    async def mirror(self, *, keys: Sequence[int], revision: int | None = None) -> str:
        """Left and right of keyframes exchanged."""
        from dynsplines.solver.curve.mirror import Mirror, MirrorError

        from ..clip.mirror import mirrored_keyframe

        poser = await self.poser()
        try:
            mirror = Mirror.of(poser.figure)
        except MirrorError as error:
            raise UserError(str(error)) from None
        keys, revision = self._now(revision, keys=keys)["keys"], self.session.document.revision
        said = {str(index): mirrored_keyframe(self._row(index), poser.figure, mirror) for index in keys}
        words = "mirror a keyframe" if len(keys) == 1 else f"mirror {len(keys)} keyframes"
        return await self.session.edit("replace_keys", {"keys": said, "words": words}, revision)

    async def copy(self, *, keys: Sequence[int], revision: int | None = None) -> str:
        """Keyframes on the clipboard, which all pages share."""
        keys = self._now(revision, keys=keys)["keys"]
        self.session.clipboard = [_plain(self._row(index)) for index in sorted(keys)]
        self.session.told()
        return f"copied {len(keys)} keyframe{'s' if len(keys) > 1 else ''}"

    async def paste(self, *, time: float) -> str:
        """What was copied, the first of it at a time."""
        return await self.session.edit("paste_keys", {"copied": self.session.clipboard, "at": time})

    def at(self, time: float) -> Any:
        """(nq,) the present path at a time of the clip."""
        import numpy as np

        from dynsplines.solver.curve.spline import path_of

        timeline, figure = self.session.timeline, prepared(self.session).figure
        if timeline is None:
            raise UserError("there is no path yet; wait for the clip to load")
        inside = float(np.clip(time, timeline.times[0], timeline.times[-1]))
        return figure.to_qpos(path_of(timeline).at(np.array([inside])))[0]

    def key_at(self, time: float) -> int | None:
        """The number, from 0, of the keyframe at a time."""
        times = [float(row["time"]) for row in self.session.document.tree_rows()]
        return next((i for i, each in enumerate(times) if abs(each - time) < AT), None)

    def _now(self, revision: int | None, **said: Any) -> dict[str, Any]:
        """Numbers of a revision as they are in the present one."""
        return renumbered(self.session.document, revision, {k: list(v) if k == "keys" else v for k, v in said.items()})

    def _row(self, index: int) -> dict[str, Any]:
        rows = self.session.document.tree_rows()
        if not 0 <= index < len(rows):
            raise UserError(unknown("keyframe", str(index + 1), [str(i + 1) for i in range(len(rows))]))
        return rows[index]


def prepared(session: Session) -> Poser:
    """What poses a session's figure, made once for a stage."""
    known = session.poser
    if known is not None and known[0] == session.stages:
        return known[1]
    import numpy as np

    from dynsplines.solver.figure.figure import Figure

    from ..clip.load import table_of
    from .posing import Poser

    stages, packed = session.stages, session.figure
    if packed is None:
        raise UserError("there is no figure yet; wait for the clip to load")
    scene, place = packed
    figure = Figure(scene.model(), place)
    whole = [key["qpos"] for key in session.loaded.get("keys", ()) if all(key["fixed"])]
    table = table_of(session.document.text, session.document.place)
    made = Poser(figure, table.penalty, np.reshape(np.array(whole, float), (-1, figure.width)))
    session.poser = stages, made
    return made


def _bodies(poser: Poser, qpos: Any) -> dict[str, Any]:
    from .paths import poses

    position, rotation, _ = poses(poser.figure.model, qpos[None])
    return {"position": position[0].round(5).ravel().tolist(), "rotation": rotation[0].round(6).ravel().tolist()}


def _plain(row: Any) -> dict[str, Any]:
    return {key: value for key, value in row.items() if value is not None}
