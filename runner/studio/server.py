"""Access control of the studio: the page needs the address with the token, and one tab at a time is connected.

Another page in the same browser has no token and another origin. A foreign name that resolves to this machine is not
among the accepted hosts.
"""

from __future__ import annotations

import asyncio
import hmac
import json
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager, suppress
from importlib.resources import files
from typing import Any
from urllib.parse import urlsplit

from starlette.applications import Starlette
from starlette.requests import HTTPConnection, Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from dynsplines import models

from ..errors import UserError, one_line
from .actions import Actions
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
NOT_HERE, IN_USE = 4403, 4409  # close codes of the websocket: rejected; another tab is open
BACKGROUND = ("export", "render", "stop_task")  # requests that need not wait for others
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
    desk = _Desk(session)

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
        await desk.serve(socket)

    @asynccontextmanager
    async def life(app: Starlette) -> AsyncIterator[None]:
        session.settled = desk.actions.prepare
        session.begin()
        try:
            yield
        finally:
            session.close()

    routes = [Route("/", page), WebSocketRoute("/line", line), Route("/{name}", page)]
    return Starlette(routes=routes, lifespan=life)


class _Desk:
    """The requests of a session, and the connection of the one page that may send them."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.actions, self.writer = Actions(session), Files(session)
        self._turn = asyncio.Lock()  # requests are performed one after another
        self._tab = ""
        self._socket: WebSocket | None = None

    async def serve(self, socket: WebSocket) -> None:
        """Serve a page until it disconnects. A second tab is rejected, or replaces the first one if it wants to."""
        tab, takes_over = socket.query_params.get("tab", ""), "take" in socket.query_params
        if self._socket is not None and tab != self._tab and not takes_over:
            await socket.close(IN_USE)
            return
        before, self._socket, self._tab = self._socket, socket, tab
        connection = _Connection(socket)
        await self.actions.cancel()
        self.session.enter(connection.put)
        if before is not None:
            with suppress(RuntimeError, WebSocketDisconnect):
                await before.close(IN_USE)
        try:
            await connection.live(self._answer)
        finally:
            self.session.leave(connection.put)
            if self._socket is socket:
                self._socket = None

    async def _answer(self, message: Message) -> Message:
        """Perform a request. The answer describes the edit, or the reason for its rejection."""
        answer: Message = {"is": "answer", "id": message.pop("id", None)}
        do = str(message.pop("do", ""))
        try:
            if do in BACKGROUND:
                result = await self._done(do, message)
            else:
                async with self._turn:
                    if (revision := message.pop("revision", None)) is not None:
                        self.session.document.check_numbers(revision)
                    result = await self._done(do, message)
        except UserError as error:
            return {**answer, "ok": False, "words": one_line(error)}
        except (TypeError, ValueError, KeyError, IndexError) as error:
            words = f"invalid request from the page: {type(error).__name__}: {one_line(error)}"
            return {**answer, "ok": False, "words": words}
        return {**answer, "ok": True, **(result if isinstance(result, dict) else {"words": result})}

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
            "formats": writer.formats,
            "stop_task": writer.stop,
        }

    async def _edit(self, name: str, **arguments: Any) -> str:
        return await self.session.edit(name, arguments)

    async def _go(self, anew: bool = False) -> str:
        self.session.search(go=True, restart=anew)
        return ""

    async def _stop(self) -> str:
        self.session.search(go=False)
        return ""

    async def _curves(self, on: bool) -> str:
        self.session.want_curves(bool(on))
        return ""

    async def _offer(self, take: bool) -> str:
        return await self.session.take_offer(yes=bool(take))

    async def _files(self) -> dict[str, list[str]]:
        return {"files": self.writer.listed(), "shipped": list(models.clips())}


class _Connection:
    """The connection of a page. Its requests are answered in turn; its notifications are queued separately."""

    def __init__(self, socket: WebSocket) -> None:
        self.socket = socket
        self._queue: asyncio.Queue[str | bytes] = asyncio.Queue()
        self._tasks: set[asyncio.Task[None]] = set()

    async def live(self, answer: Callable[[Message], Awaitable[Message]]) -> None:
        """Answer requests until the page disconnects."""
        out = asyncio.create_task(self._write())

        async def respond(message: Message) -> None:
            self.put(json.dumps(await answer(message)))

        try:
            while True:
                message = json.loads(await self.socket.receive_text())
                if message.get("do") in BACKGROUND:
                    task = asyncio.create_task(respond(message))
                    self._tasks.add(task)
                    task.add_done_callback(self._tasks.discard)
                else:
                    await respond(message)
        except (WebSocketDisconnect, json.JSONDecodeError, AttributeError, RuntimeError):
            pass
        finally:
            out.cancel()
            for task in list(self._tasks):
                task.cancel()
            with suppress(RuntimeError, WebSocketDisconnect):
                await self.socket.close()

    def put(self, message: str | bytes) -> None:
        """Queue a message; paths are omitted if the page is slow."""
        if self._queue.qsize() > MOST_WAITING and isinstance(message, bytes) and not message.startswith(b"{"):
            return
        self._queue.put_nowait(message)

    async def _write(self) -> None:
        with suppress(WebSocketDisconnect, RuntimeError):
            while True:
                message = await self._queue.get()
                if isinstance(message, bytes) and not message.startswith(b"{"):
                    await self.socket.send_bytes(message)
                else:
                    await self.socket.send_text(message if isinstance(message, str) else message.decode())
