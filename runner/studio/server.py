"""Access control of the studio: pages need the address with the token, and have one connection each.

Another page in the same browser has no token and another origin. A foreign name that resolves to this machine is not
among the accepted hosts.
"""

from __future__ import annotations

import asyncio
import hmac
import itertools
import json
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager, suppress
from functools import partial
from importlib.resources import files
from typing import Any
from urllib.parse import urlsplit

from starlette.applications import Starlette
from starlette.requests import HTTPConnection, Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from ..errors import UserError, one_line
from .actions import Actions, prepared
from .files import Files
from .session import Session
from .solver import Message

POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
HEADERS = {
    "Content-Security-Policy": POLICY,
    "Cache-Control": "no-store",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Cross-Origin-Resource-Policy": "same-origin",
}
PAGE = {
    "": ("index.html", "text/html; charset=utf-8"),
    "studio.js": ("studio.js", "text/javascript; charset=utf-8"),
    "studio.css": ("studio.css", "text/css; charset=utf-8"),
}
NOT_HERE = 4403  # close code of the websocket for a rejected page
MOST_WAITING = 64  # queued messages of a slow page above which paths are omitted
MOST_BYTES = 4_000_000  # [bytes] maximum size of a message from a page


class Door:
    """Access control; `hosts` are the accepted values of the `Host` header, such as "127.0.0.1:8000"."""

    def __init__(self, token: str, hosts: frozenset[str]) -> None:
        self.token, self.hosts = token, hosts

    def refusal(self, connection: HTTPConnection, *, with_token: bool) -> str | None:
        """Return the reason for rejecting a request; None for an accepted one."""
        host = connection.headers.get("host", "")
        if host not in self.hosts:
            return f"no such host: '{host[:100]}'"
        origin = connection.headers.get("origin")
        if origin is not None and urlsplit(origin).netloc not in self.hosts:
            return "this page may not connect to the studio; open the address that the command prints"
        if connection.scope["type"] == "websocket" and origin is None:
            return "a line to the studio needs an origin"
        token = connection.query_params.get("token", "")
        if with_token and not hmac.compare_digest(token.encode(), self.token.encode()):
            return "the address lacks the studio's token; use the one that the command printed"
        return None


def application(session: Session, door: Door) -> Starlette:
    """Return the server of one session."""
    numbers = itertools.count(1)
    writer = Files(session)

    async def page(request: Request) -> Response:
        name = request.path_params.get("name", "")
        if name not in PAGE:
            return PlainTextResponse("there is no such page", 404, HEADERS)
        refused = door.refusal(request, with_token=name == "")
        if refused is not None:
            return PlainTextResponse(refused, 403, HEADERS)
        file, kind = PAGE[name]
        content = (files("dynsplines.studio") / "built" / file).read_bytes()
        return Response(content, headers=HEADERS, media_type=kind)

    async def line(socket: WebSocket) -> None:
        refused = door.refusal(socket, with_token=True)
        if refused is not None:
            await socket.close(NOT_HERE, refused)
            return
        await socket.accept()
        await _Page(session, writer, socket, next(numbers)).live()

    @asynccontextmanager
    async def life(app: Starlette) -> AsyncIterator[None]:
        session.settled = partial(_prepare, session)
        session.begin()
        try:
            yield
        finally:
            session.close()

    routes = [Route("/", page), WebSocketRoute("/line", line), Route("/{name}", page)]
    return Starlette(routes=routes, lifespan=life)


def _prepare(session: Session) -> None:
    """Prepare the poser in the background, so that the first drag does not wait."""
    if session.poser is None or session.poser[0] != session.stages:
        asyncio.get_running_loop().run_in_executor(None, prepared, session)


class _Page:
    """One page and its connection. Its requests are answered in turn; its notifications are queued separately."""

    def __init__(self, session: Session, writer: Files, socket: WebSocket, number: int) -> None:
        self.session, self.writer, self.socket, self.number = session, writer, socket, number
        self.actions = Actions(session, number)
        self.queue: asyncio.Queue[str | bytes] = asyncio.Queue()
        self.tasks: set[asyncio.Task[None]] = set()

    async def live(self) -> None:
        """Run until the page disconnects."""
        out = asyncio.create_task(self._write())
        self.session.enter(self.number, self._put)
        try:
            while True:
                message = json.loads(await self.socket.receive_text())
                if message.get("do") in ("export", "render", "stop_task"):
                    task = asyncio.create_task(self._answer(message))
                    self.tasks.add(task)
                    task.add_done_callback(self.tasks.discard)
                else:
                    await self._answer(message)
        except (WebSocketDisconnect, json.JSONDecodeError, AttributeError, RuntimeError):
            pass
        finally:
            self.session.leave(self.number)
            out.cancel()
            for task in list(self.tasks):
                task.cancel()
            with suppress(RuntimeError):
                await self.socket.close()

    def _put(self, message: str | bytes) -> None:
        if self.queue.qsize() > MOST_WAITING and isinstance(message, bytes) and not message.startswith(b"{"):
            return
        self.queue.put_nowait(message)

    async def _write(self) -> None:
        with suppress(WebSocketDisconnect, RuntimeError):
            while True:
                message = await self.queue.get()
                if isinstance(message, bytes) and not message.startswith(b"{"):
                    await self.socket.send_bytes(message)
                else:
                    await self.socket.send_text(message if isinstance(message, str) else message.decode())

    async def _answer(self, message: Message) -> None:
        """Perform a page's request. The answer describes the edit, or the reason for its rejection."""
        number = message.pop("id", None)
        try:
            result = await self._done(str(message.pop("do", "")), message)
            answer = {
                "is": "answer",
                "id": number,
                "ok": True,
                **(result if isinstance(result, dict) else {"words": result}),
            }
        except UserError as error:
            answer = {"is": "answer", "id": number, "ok": False, "words": one_line(error)}
        except (TypeError, ValueError, KeyError, IndexError) as error:
            words = f"invalid request from the page: {type(error).__name__}: {one_line(error)}"
            answer = {"is": "answer", "id": number, "ok": False, "words": words}
        self._put(json.dumps(answer))

    async def _done(self, do: str, arguments: Message) -> Any:
        request = self._requests.get(do)
        if request is None:
            raise UserError(f"'{do}': unknown request; reload the page")
        return await request(**arguments)

    @property
    def _requests(self) -> dict[str, Callable[..., Awaitable[Any]]]:
        session, actions, writer = self.session, self.actions, self.writer
        methods = {name: getattr(self, f"_{name}") for name in ("edit", "go", "stop", "curves", "offer", "files")}
        posing = ("grip", "drag", "turn", "drop", "cancel", "key", "rest", "pin", "free", "mirror", "copy", "paste")
        return {
            **methods,
            **{name: getattr(actions, name) for name in posing},
            "undo": session.undo,
            "redo": session.redo,
            "save": writer.save,
            "open": writer.open,
            "export": writer.export,
            "render": writer.render,
            "stop_task": writer.stop,
        }

    async def _edit(self, name: str, revision: int | None = None, **arguments: Any) -> str:
        return await self.session.edit(name, arguments, revision)

    async def _go(self, anew: bool = False) -> str:
        self.session.search(go=True, restart=anew)
        return ""

    async def _stop(self) -> str:
        self.session.search(go=False)
        return ""

    async def _curves(self, on: bool) -> str:
        self.session.want_curves(self.number, bool(on))
        return ""

    async def _offer(self, take: bool) -> str:
        return await self.session.take_offer(yes=bool(take))

    async def _files(self) -> dict[str, list[str]]:
        from dynsplines import models

        return {"files": await asyncio.to_thread(self.writer.listed), "shipped": list(models.clips())}
