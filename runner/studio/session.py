"""One open clip, shown by one page."""

from __future__ import annotations

import asyncio
import json
import pickle
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from ..errors import UserError, one_line
from .document import Document
from .solver import Message, Solver, release_memory

Send = Callable[[str | bytes], None]
WATCH_INTERVAL = 1.0  # [s] between two looks at the clip's file
ANSWERS = (
    "kinds", "stage", "raw", "initial", "best", "document", "loaded", "settled", "status", "offer", "task", "outside",
    "poses",
)  # fmt: skip


class Session:
    """The document, the solver process, and the page.

    Attributes:
        go: Whether edits are followed by a search.
        loaded: Keyframes, contacts and flights of the present text, as the solver loaded it.
        figure: The pickled scene; None before the clip is loaded.
        offer: Unsaved work of an earlier session, until it is restored or discarded.
        settled: Called after every search.
    """

    def __init__(self, document: Document, *, go: bool = True) -> None:
        self.document, self.go = document, go
        self.solver = Solver(self._receive, self._resume)
        self.loaded: Message = {}
        self.figure: bytes | None = None
        self.settled: Callable[[], None] = lambda: None
        self.offer = document.read_unsaved()
        self._page: Send | None = None
        self._shown: dict[str, str | bytes] = {}  # the latest message of each kind in ANSWERS, for the next page
        self._state = "loading"
        self._outline: Message = {}
        self._path: tuple[int, bytes] | None = None  # revision and pickled timeline of the present path
        self._has_curves = False
        self._poses: list[str] = []
        self._outside: str | None = None  # how the file was changed by another program
        self._show_offer()
        self._show_state("loading")

    @property
    def timeline(self) -> Any:
        """The present path, unpickled on use because this needs the solver's imports; None before the first one."""
        return None if self._path is None else pickle.loads(self._path[1])  # data of this program only

    def start(self) -> None:
        """Start the process and load the clip. Messages are queued until the session listens."""
        self.solver.start()
        self.solver.send(self._load_request(self.document.text, self.document.revision))

    def begin(self) -> None:
        """Listen to the process, and start it if necessary."""
        if not self.solver.is_started:
            self.start()
        self.solver.listen()

    def close(self) -> None:
        """End the process."""
        self.solver.close()

    # ---- the page

    def enter(self, send: Send) -> None:
        """Show the session on a page instead of the present one."""
        self._switch_curves(on=False)
        self._page = send
        for kind in ANSWERS:
            if kind in self._shown:
                send(self._shown[kind])

    def leave(self, send: Send) -> None:
        """Remove a page, unless another one has replaced it."""
        if self._page == send:
            self._switch_curves(on=False)
            self._page = None

    def tell(self, message: Message) -> None:
        """Send a message to the page."""
        if self._page is not None:
            self._page(json.dumps(message))

    def _show(self, kind: str, data: Message | bytes) -> None:
        """Send the page a message that a later page gets, too."""
        shown = data if isinstance(data, bytes) else json.dumps({"is": kind, **data})
        self._shown[kind] = shown
        if self._page is not None:
            self._page(shown)

    def show_document(self) -> None:
        self._show("document", {**self.document.state(), **self._outline})

    def show_poses(self) -> None:
        """Show the names of the saved poses, if they have changed."""
        if (names := self.document.pose_names()) != self._poses:
            self._poses = names
            self._show("poses", {"names": names})

    def show_task(self, what: str, words: str | None) -> None:
        """Show the progress of a file that is being written; None after its end."""
        self._show("task", {"words": None if words is None else f"{what}: {words}"})

    def _show_offer(self) -> None:
        words = None
        if self.offer is not None:
            date = time.localtime(self.document.unsaved_file.stat().st_mtime)
            words = f"unsaved work on {self.document.place} from {time.strftime('%Y-%m-%d %H:%M', date)}"
        self._show("offer", {"words": words})

    def _show_state(self, state: str, **details: Any) -> None:
        self._state = state
        self._show("status", {"state": state, "go": self.go, **details})

    # ---- edits

    async def edit(self, name: str, arguments: Message) -> str:
        """Apply an edit by name. If it raises UserError, nothing has changed.

        The argument "stroke", if specified, identifies a run of edits that are undone together.
        """
        from .edits import EDITS  # imported here, as in `document`

        self.check_offer()
        stroke = arguments.pop("stroke", None)
        if name not in EDITS:
            raise UserError(f"no edit '{name}'; there are: {', '.join(EDITS)}")
        tree = self.document.tree()
        try:
            words = EDITS[name](tree, **arguments)
        except TypeError as error:
            raise UserError(f"{name}: {one_line(error)}") from None
        text = tree.as_string()
        if text != self.document.text:
            loaded = await self._validate(text)
            self.document.commit(text, words, stroke)
            words = self._accept_change(loaded, words)
        return words

    async def undo(self) -> str:
        return await self._step("undo")

    async def redo(self) -> str:
        return await self._step("redo")

    async def _step(self, verb: str) -> str:
        self.check_offer()
        if not self.document.steps[verb]:
            raise UserError(f"nothing to {verb}")
        step = self.document.steps[verb][-1]
        loaded = await self._validate(step.apply(self.document.text))
        self.document.step(verb)
        return self._accept_change(loaded, f"{verb}: {step.words}")

    def check_offer(self) -> None:
        """Raise UserError while unsaved work is offered: it would be replaced."""
        if self.offer is not None:
            raise UserError("restore or discard the unsaved work first")

    async def take_offer(self, *, yes: bool) -> str:
        """Restore or discard unsaved work of an earlier session. If it raises UserError, the work is still offered."""
        offer, words = self.offer, "restore unsaved work" if yes else "discarded unsaved work"
        if offer is None:
            raise UserError("there is no unsaved work")
        loaded = await self._validate(offer) if yes else None
        self.document.adopt(offer)
        self.offer = None
        if loaded is None:
            self.document.discard()
        else:
            self.document.commit(offer, words)
            self.document.numbered_since = self.document.revision
            words = self._accept_change(loaded, words)
        self._show_offer()
        return words

    async def _validate(self, text: str) -> Message:
        """Return a text as the solver has loaded it, which then searches it. Raises UserError for an invalid clip."""
        return await self.solver.ask(self._load_request(text, self.document.revision + 1))

    def _load_request(self, text: str, revision: int) -> Message:
        document = self.document
        place = {"name": document.name, "place": document.place, "folder": str(document.folder)}
        return {"do": "load", "text": text, **place, "revision": revision, "go": self.go}

    def _accept_change(self, loaded: Message, words: str) -> str:
        """Show a changed document, and store it as unsaved work. Return the words, with the reason if it cannot be."""
        self._accept(loaded)
        try:
            self.document.write_unsaved()
        except UserError as error:
            return f"{words}; {one_line(error)}"
        return words

    def _accept(self, loaded: Message) -> None:
        """Make the loaded clip that of the document."""
        path = loaded["revision"], loaded.pop("timeline")
        if self._path is None or self._path[0] < path[0]:  # a better one may have arrived
            self._path = path
        self._outline, self.loaded = loaded.pop("outline"), loaded
        self.show_document()
        self._show("loaded", loaded)

    # ---- the file on the disk

    async def watch(self) -> None:
        """Report saved poses, and changes of the clip's file by other programs, until cancelled."""
        from ..clip.parse import table_of  # imported here, as in `edit`

        while True:
            self.show_poses()
            await asyncio.sleep(WATCH_INTERVAL)
            place, words, loads = self.document.place, None, True
            changed = f"{place} was changed by another program"
            try:
                if (text := self.document.read_changed()) is not None:
                    words = changed
                    table_of(text, place)
            except UserError as error:
                words, loads = f"{changed} and is not a valid clip: {one_line(error)}", False
            if words != self._outside:
                self._show_outside(words, loads=loads)

    def _show_outside(self, words: str | None, *, loads: bool = True) -> None:
        """Show how the clip's file was changed, and whether its text can be loaded; None if it was not."""
        self._outside = words
        self._show("outside", {"words": words, "loads": loads})

    async def reload(self) -> str:
        """Replace the text by that of the changed file; undo restores it."""
        self.check_offer()
        text = self.document.read_changed()
        if text is None:
            raise UserError(f"{self.document.place} has not changed")
        loaded = await self._validate(text)
        self.document.commit(text, "reload the file")
        self.document.saved, self.document.numbered_since = text, self.document.revision
        self._show_outside(None)
        return self._accept_change(loaded, f"reloaded {self.document.place}")

    async def keep(self) -> str:
        """Keep the present text although the file has changed: saving replaces the file."""
        self.document.saved = self.document.read_changed() or self.document.saved
        self.document.write_unsaved()
        self.show_document()
        self._show_outside(None)
        return "kept; save it to replace the file"

    async def replace(self, document: Document) -> None:
        """Open another document."""
        self.check_offer()
        document.revision = self.document.revision
        previous, self.document = self.document, document
        try:
            loaded = await self._validate(document.text)
        except UserError:
            self.document = previous
            raise
        document.revision = document.numbered_since = loaded["revision"]
        self._accept_change(loaded, "")

    # ---- the search

    async def search(self, *, go: bool) -> str:
        """Continue or stop the search; the state applies to later edits."""
        self.go = go
        self.solver.send({"do": "go" if go else "stop"})
        self._show_state(self._state)
        return ""

    async def want_curves(self, *, on: bool) -> str:
        """Switch the curves on or off."""
        self._switch_curves(on=on)
        return ""

    def _switch_curves(self, *, on: bool) -> None:
        if on or self._has_curves:
            self.solver.send({"do": "curves", "on": on})
        self._has_curves = on

    async def save_motion(self, file: Path) -> None:
        """Write the present motion to a file."""
        await self.solver.ask({"do": "save", "file": str(file)})

    # ---- messages of the solver process

    def _receive(self, message: Message) -> None:
        what = message["is"]
        if what == "path":
            self._receive_path(message)
        elif what == "loaded":
            self._accept(message)
        elif what == "searching":
            self._show_state("searching")
        elif what == "kinds":
            self._show("kinds", message)
        elif what == "stage":
            self.figure = message["figure"]
            for kind in ("raw", "initial", "best"):
                self._shown.pop(kind, None)
            self._show("stage", b'{"is":"stage","stage":' + message["stage"] + b"}")
        elif what == "settled":
            self.settled()
            self._show("settled", message)
            self._show_state("settled", stop=message["stop"])
            release_memory()
        else:
            self.tell(message)
            if what in ("refused", "gone"):
                self._show_state(what, words=message["words"])

    def _receive_path(self, message: Message) -> None:
        if message["kind"] != "raw":
            self._path = message["revision"], message["timeline"]
        if message["kind"] == "initial":
            self._shown.pop("best", None)
        self._show(message["kind"], message["data"])

    def _resume(self, words: str) -> None:
        """Resume after a crash: the new process gets the present text."""
        self._show_state("loading")
        self.tell({"is": "note", "words": words})
        self._switch_curves(on=self._has_curves)
        self.solver.send(self._load_request(self.document.text, self.document.revision))
