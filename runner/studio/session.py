"""One open clip, shared by all pages that show it."""

from __future__ import annotations

import asyncio
import json
import pickle
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import UserError, one_line
from .document import Document
from .revision_map import renumbered
from .solver import Message, Solver

if TYPE_CHECKING:
    from ..clip.text import TomlTable

Send = Callable[[str | bytes], None]
LOAD_TIMEOUT = 60.0  # [s] time limit for loading an edited clip
PATH_TIMEOUT = 5.0  # [s] time limit for a path of the present text
UNSAVED_DELAY = 0.4  # [s] delay after an edit before unsaved work is written
LISTINGS = ("kinds", "formats")  # messages that do not change: a page that connects later gets them, too
LATEST = ("raw", "initial", "best")  # kinds of paths; a page that connects later gets the last of each


class Session:
    """The document, the solver process, and the pages."""

    def __init__(self, document: Document, *, go: bool = True) -> None:
        self.document, self.go = document, go
        self.solver = Solver(self._receive, self._resume)
        self.pages: dict[int, Send] = {}
        self.loaded: Message = {}
        self._timeline: bytes | None = None
        self.scene: Message | None = None
        self.stages = 0
        self.settled: Callable[[], None] | None = None
        self.poser: tuple[int, Any] | None = None
        self.clipboard: list[TomlTable] = []
        self.offer = document.read_unsaved()
        self.status: Message = {"is": "status", "state": "loading"}
        self.outline: Message = {}
        self._listings: dict[str, Message] = {}
        self._stage: bytes | None = None
        self._paths: dict[str, bytes] = {}
        self._settled: Message | None = None
        self._curves: str | None = None
        self._verdict: asyncio.Future[Message] | None = None
        self._saved_motion: asyncio.Future[str] | None = None
        self._lock = asyncio.Lock()
        self._path_revision = -1  # the revision of the present path
        self._waiting: set[asyncio.Future[None]] = set()
        self._load_request: Message | None = None
        self._unsaved_timer: asyncio.TimerHandle | None = None
        self._curve_pages: set[int] = set()

    @property
    def timeline(self) -> Any:
        """The present path, unpickled on use because this needs the solver's imports."""
        return None if self._timeline is None else pickle.loads(self._timeline)  # data of this program only

    async def wait_for_path(self) -> None:
        """Wait until the present path belongs to the present text, a moment after an edit was accepted."""
        while self._timeline is not None and self._path_revision < self.document.revision:
            waiting: asyncio.Future[None] = asyncio.get_running_loop().create_future()
            self._waiting.add(waiting)
            try:
                await asyncio.wait_for(waiting, PATH_TIMEOUT)
            except TimeoutError:
                return
            finally:
                self._waiting.discard(waiting)

    @property
    def figure(self) -> Any:
        """The figure, unpickled on use; None before the clip is loaded."""
        return None if self.scene is None else pickle.loads(self.scene["figure"])

    def start(self) -> None:
        """Start the process and load the clip. Messages are queued until the session listens."""
        self.solver.start()
        self._load(self.document.text, self.document.revision, first=True)

    def begin(self) -> None:
        """Listen to the process, and start it if necessary."""
        if not self.solver.is_started:
            self.start()
        self.solver.listen()

    def close(self) -> None:
        """End the process, with unsaved work on the disk."""
        self.document.write_unsaved()
        self.solver.close()

    # ---- pages

    def enter(self, number: int, send: Send) -> None:
        """Add a new page and send it the present state."""
        self.pages[number] = send
        for listing in self._listings.values():
            send(json.dumps(listing))
        for data in filter(None, (self._stage, *(self._paths.get(kind) for kind in LATEST))):
            send(data)
        if self.loaded:
            send(self._outline())
            send(json.dumps(self.loaded))
        for message in (self._settled, self.status):
            if message is not None:
                send(json.dumps(message))
        if self.offer is not None:
            send(json.dumps(self._offer_message()))

    def leave(self, number: int) -> None:
        """Remove a page."""
        self.pages.pop(number, None)
        self.want_curves(number, False)

    def broadcast(self, message: Message | bytes) -> None:
        text = message if isinstance(message, bytes) else json.dumps(message)
        for send in list(self.pages.values()):
            send(text)

    def _outline(self) -> str:
        state = {**self.document.state(), **self.outline, "copied": len(self.clipboard)}
        return json.dumps({"is": "document", **state})

    def _offer_message(self) -> Message:
        """Return the message that offers unsaved work, or that hides the offer if there is none."""
        if self.offer is None:
            return {"is": "offer", "words": None}
        date = time.strftime("%Y-%m-%d %H:%M", time.localtime(self.offer.time))
        return {"is": "offer", "words": f"unsaved work on {self.document.place} from {date}"}

    # ---- edits

    async def edit(self, name: str, arguments: Message, revision: int | None = None) -> str:
        """Apply an edit by name. If it raises UserError, nothing has changed.

        `revision` is that of the indices in the arguments, if it is not the present one.
        """
        async with self._lock:
            text, words = self._edited(name, arguments, revision)
            if text != self.document.text:
                verdict = await self._validate(text)
                self.document.commit(text, words)
                self._changed(verdict)
            return words

    def _edited(self, name: str, arguments: Message, revision: int | None) -> tuple[str, str]:
        from .edits import EDITS  # imported here, as in `document`

        if name not in EDITS:
            raise UserError(f"no edit '{name}'; there are: {', '.join(EDITS)}")
        arguments = renumbered(self.document, revision, arguments)
        tree = self.document.tree()
        try:
            words = EDITS[name](tree, **arguments)
        except TypeError as error:
            raise UserError(f"{name}: {one_line(error)}") from None
        return tree.as_string(), words

    async def undo(self) -> str:
        return await self._step(self.document.back, self.document.undo, "undo")

    async def redo(self) -> str:
        return await self._step(self.document.forth, self.document.redo, "redo")

    async def _step(self, peek: Callable[[], tuple[str, str] | None], step: Callable[[], None], verb: str) -> str:
        async with self._lock:
            target = peek()
            if target is None:
                raise UserError(f"nothing to {verb}")
            verdict = await self._validate(target[1])
            step()
            self._changed(verdict)
            return f"{verb}: {target[0]}"

    async def take_offer(self, *, yes: bool) -> str:
        """Restore or discard unsaved work of an earlier session. If it raises UserError, the work is still offered."""
        async with self._lock:
            offer, words = self.offer, "discarded unsaved work"
            if offer is None:
                raise UserError("there is no unsaved work")
            if yes:
                words = "restore unsaved work"
                verdict = await self._validate(offer.text)
                self.document.commit(offer.text, words)
                self.document.discard()  # unsaved work that the restored text replaces
                self.document.unsaved_file = offer.file
                self._changed(verdict)
            else:
                with suppress(OSError):
                    offer.file.unlink(missing_ok=True)
            self.offer = None
            self.broadcast(self._offer_message())
            return words

    async def reopen(self, document: Document) -> str:
        """Open another document, after writing unsaved work of this one to the disk."""
        async with self._lock:
            self.document.write_unsaved()
            before, self.document = self.document, document
            document.revision = before.revision
            try:
                verdict = await self._validate(document.text, first=True)
            except UserError:
                self.document = before
                raise
            self.offer = document.read_unsaved()
            document.revision += 1
            self._changed(verdict)
            self.broadcast(self._offer_message())
            return f"opened {document.place}"

    async def _validate(self, text: str, *, first: bool = False) -> Message:
        """Return the solver's answer to a text, which it then searches. Raises UserError for an invalid clip."""
        self._verdict = asyncio.get_running_loop().create_future()
        self._load(text, self.document.revision + 1, first=first)
        try:
            verdict = await asyncio.wait_for(self._verdict, LOAD_TIMEOUT)
        except TimeoutError:
            self.solver.restart()  # otherwise it would finish this clip first
            raise UserError(f"the clip took longer than {LOAD_TIMEOUT:g} s to load") from None
        finally:
            self._verdict = None
        if verdict["is"] != "loaded":
            raise UserError(verdict["words"])
        return verdict

    def _load(self, text: str, revision: int, *, first: bool = False, initial_path: Any = None) -> None:
        self._load_request = {"do": "load", **self._named(text), "revision": revision, "go": self.go, "first": first}
        self.solver.send(
            self._load_request if initial_path is None else {**self._load_request, "initial_path": initial_path}
        )

    def _named(self, text: str) -> Message:
        document = self.document
        return {"text": text, "name": document.name, "place": document.place, "folder": str(document.folder)}

    def _changed(self, verdict: Message) -> None:
        """Notify every page, and schedule the writing of unsaved work."""
        self._accept(verdict)
        if self._unsaved_timer is not None:
            self._unsaved_timer.cancel()
        self._unsaved_timer = asyncio.get_running_loop().call_later(UNSAVED_DELAY, self.document.write_unsaved)

    def _accept(self, loaded: Message) -> None:
        """Make the loaded clip that of the document."""
        self.outline = loaded.pop("outline")
        self.loaded = loaded
        self.send_outline()
        self.broadcast(loaded)

    def send_outline(self) -> None:
        text = self._outline()
        for send in list(self.pages.values()):
            send(text)

    # ---- the search

    def search(self, *, go: bool, restart: bool = False) -> None:
        """Continue or stop the search; the state applies to later edits."""
        self.go = go
        self.solver.send({"do": "go", "restart": restart} if go else {"do": "stop"})
        self._status(self.status.get("state", "settled"))

    def want_curves(self, number: int, on: bool) -> None:
        had = bool(self._curve_pages)
        (self._curve_pages.add if on else self._curve_pages.discard)(number)
        if bool(self._curve_pages) != had:
            self.solver.send({"do": "curves", "on": bool(self._curve_pages)})
        elif on and self._curves is not None:
            self.pages[number](self._curves)

    async def save_motion(self, file: Path) -> None:
        """Write the present motion to a file."""
        async with self._lock:
            self._saved_motion = asyncio.get_running_loop().create_future()
            self.solver.send({"do": "save", "file": str(file)})
            try:
                await asyncio.wait_for(self._saved_motion, LOAD_TIMEOUT)
            except TimeoutError:
                raise UserError("the solver process did not return the motion; try again") from None
            finally:
                self._saved_motion = None

    # ---- messages of the solver process

    def _receive(self, message: Message) -> None:
        if message["is"] in LISTINGS:
            self._listings[message["is"]] = message
        if message["is"] in (*LISTINGS, "note"):
            self.broadcast(message)
        elif (handle := getattr(self, f"_receive_{message['is']}", None)) is not None:
            handle(message)

    def _receive_stage(self, message: Message) -> None:
        self.stages += 1
        self.scene = message
        self._stage = b'{"is":"stage","stage":' + message["stage"] + b"}"
        self._paths.clear()
        self.broadcast(self._stage)

    def _receive_loaded(self, message: Message) -> None:
        if not self._judge(message):
            self._accept(message)
        self._status("loaded")

    def _receive_refused(self, message: Message) -> None:
        if self._saved_motion is not None and not self._saved_motion.done() and message.get("revision") is None:
            self._saved_motion.set_exception(UserError(message["words"]))
        elif not self._judge(message):
            self.broadcast({"is": "refused", "words": message["words"]})
            self._status("refused", words=message["words"])

    def _judge(self, message: Message) -> bool:
        """Use the answer for the text under trial, but not for the previous text, which a new process loads again."""
        if self._verdict is None or self._verdict.done():
            return False
        if self._load_request is not None and message.get("revision") not in (None, self._load_request["revision"]):
            return False
        self._verdict.set_result(message)
        return True

    def _receive_path(self, message: Message) -> None:
        if message["kind"] != "raw":
            self._timeline, self._path_revision = message["timeline"], message["revision"]
            for waiting in [future for future in self._waiting if not future.done()]:
                waiting.set_result(None)
        if message["kind"] == "initial":
            self._paths.pop("best", None)
        self._paths[message["kind"]] = message["data"]
        self.broadcast(message["data"])

    def _receive_searching(self, message: Message) -> None:
        self._status("searching")

    def _receive_settled(self, message: Message) -> None:
        self._settled = message
        if self.settled is not None:
            self.settled()
        self.broadcast(message)
        self._status("settled", stop=message["stop"])

    def _receive_curves(self, message: Message) -> None:
        self._curves = json.dumps(message)
        for number in self._curve_pages:
            if number in self.pages:
                self.pages[number](self._curves)

    def _receive_saved(self, message: Message) -> None:
        if self._saved_motion is not None and not self._saved_motion.done():
            self._saved_motion.set_result(message["file"])

    def _receive_gone(self, message: Message) -> None:
        self._judge({"is": "refused", "words": message["words"]})
        self.broadcast({"is": "refused", "words": message["words"]})
        self._status("gone", words=message["words"])

    def _resume(self, words: str) -> None:
        """Resume after a crash: the new process gets the present text and the last path."""
        self.broadcast({"is": "note", "words": words})
        if self._curve_pages:
            self.solver.send({"do": "curves", "on": True})
        trying = self._load_request if self._verdict is not None else None
        self._load(
            self.document.text, self.document.revision, first=self._timeline is None, initial_path=self._timeline
        )
        if trying is not None:  # the expected answer is for this text, not for the previous one
            self._load_request = trying
            self.solver.send(trying)

    def _status(self, state: str, **details: Any) -> None:
        self.status = {"is": "status", "state": state, "go": self.go, **details}
        self.broadcast(self.status)
