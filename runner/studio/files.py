"""Files of a session: saved, exported and rendered, only in the clip's folder."""

from __future__ import annotations

import asyncio
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from dynsplines import models

from ..errors import UserError
from ..picture.graphics import drawing_environment
from .document import FILMS, MODELS, Document, inside
from .session import Session

COMMAND = "import sys; from dynsplines.__main__ import main; sys.argv[0] = 'dynsplines'; main()"


class Files:
    """The files of a session."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self._running: asyncio.subprocess.Process | None = None

    @property
    def folder(self) -> Path:
        return self.session.document.folder

    async def save(self, *, name: str | None = None, overwrite: bool = False) -> str:
        """Save the clip's text, under a new name if specified."""
        self.session.check_offer()
        document = self.session.document
        if name is None and document.file is None:
            raise UserError("this clip has no file yet: save it under a name")
        if name is not None and not name.lower().endswith(".toml"):
            name += ".toml"
        target = document.file if name is None else inside(self.folder, name)
        assert target is not None
        if not overwrite and target != document.file and target.exists():
            raise UserError(f"'{target.name}' already exists; choose another name")
        if not overwrite and target == document.file and document.read_changed() is not None:
            raise UserError(
                f"'{target.name}' was changed by another program; save under another name, or overwrite it by Save as"
            )
        document.save(target)
        self.session.show_document()
        return f"saved {target.name}"

    async def figures(self) -> dict[str, list[str]]:
        """Return the figures of which there can be a new clip: shipped ones, and models in the folder."""
        local = sorted(path.name for path in self.folder.iterdir() if path.suffix.lower() in MODELS)
        return {"figures": [*models.figures(), *local]}

    async def new(self, *, figure: str) -> str:
        """Open a new clip of a figure. Raises UserError while the present clip is not saved."""
        from ..clip.starter import starter  # imported here, because it needs MuJoCo

        if self.session.document.is_dirty:
            raise UserError("the present clip is not saved: save it, or undo its changes, before you open a new one")
        source = figure if figure in models.figures() else str(inside(self.folder, figure))
        name = Path(figure).stem
        text = await asyncio.to_thread(starter, source, self.folder / f"{name}.toml")
        await self.session.replace(Document(name, text, self.folder, saved=text))
        return f"new clip of {name}"

    async def formats(self) -> dict[str, list[dict[str, str]]]:
        """Return the formats that can be written."""
        from ..exchange.formats import FORMATS  # imported here, as the page need not wait for it

        names = ("name", "ending", "description")
        return {"formats": [{name: getattr(entry, name) for name in names} for entry in FORMATS if entry.writes]}

    async def export(self, *, to: str, name: str, overwrite: bool = False) -> str:
        """Export the present motion to another program's format."""
        target = self._target(name, overwrite)
        await self._run(["export", "--to", to, "-o", str(target), *(["--overwrite"] if overwrite else [])])
        return f"exported {target.name}"

    async def render(
        self, *, name: str, size: str = "1280x720", camera: str = "side", only: str = "after", overwrite: bool = False
    ) -> str:
        """Render the present motion as a video."""
        target = self._target(name, overwrite)
        if target.suffix.lower() not in FILMS:
            raise UserError(f"'{name}': a video's name ends in {', '.join(FILMS)}")
        words = ["render", "-o", str(target), "--size", size, "--camera", camera]
        await self._run([*words, *(["--only", only] if only else [])])
        return f"rendered {target.name}"

    def _target(self, name: str, overwrite: bool) -> Path:
        """Return the target of a video or an export. Raises UserError if it exists."""
        target = inside(self.folder, name)
        if target.exists() and not overwrite:
            raise UserError(f"'{target.name}' already exists; choose another name, or overwrite it")
        return target

    async def stop(self) -> str:
        """Stop an export or rendering."""
        if self._running is not None:
            self._running.terminate()
        return "stopped"

    async def _run(self, words: Sequence[str]) -> None:
        """Run one of this program's commands on the present motion and show its progress on the page.

        Raises UserError with the message of the command.
        """
        what, *options = words
        with TemporaryDirectory(prefix="dynsplines-", ignore_cleanup_errors=True) as folder:
            motion = Path(folder) / f"{self.session.document.name}.npz"
            await self.session.save_motion(motion)
            if self._running is not None:
                raise UserError("another file is being written; wait for it, or stop it")
            command = [sys.executable, "-c", COMMAND, what, str(motion), *options]
            pipe = asyncio.subprocess.PIPE
            self._running = await asyncio.create_subprocess_exec(
                *command, stdout=pipe, stderr=pipe, cwd=self.folder, env=drawing_environment()
            )
            try:
                last = await self._followed(self._running, what)
                code = await self._running.wait()
            finally:
                if self._running.returncode is None:
                    self._running.kill()
                self._running = None
                self.session.show_task(what, None)
        if code:
            raise UserError(last.removeprefix("dynsplines: ") if code > 0 else f"{what}: stopped")

    async def _followed(self, process: asyncio.subprocess.Process, what: str) -> str:
        """Return the last line of a process, and show the others as progress."""
        assert process.stderr is not None and process.stdout is not None
        last, rest = f"{what} failed", ""
        drain = asyncio.create_task(process.stdout.read())
        while chunk := await process.stderr.read(4096):
            parts = re.split(r"[\r\n]+", rest + chunk.decode(errors="replace"))
            rest = parts.pop()
            for line in filter(None, map(str.strip, parts)):
                last = line
                if not line.startswith("dynsplines: "):  # a refusal
                    self.session.show_task(what, line[:200])
        await drain
        return rest.strip() or last
