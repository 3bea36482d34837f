"""Access control of the studio: the page needs the address with the token, and one tab at a time is connected.

Another page in the same browser has no token and another origin. A foreign name that resolves to this machine is not
among the accepted hosts.
"""

from __future__ import annotations

import asyncio
import hmac
import json
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from importlib.resources import files
from typing import Any, TypeGuard
from urllib.parse import urlsplit

from starlette.applications import Starlette
from starlette.requests import HTTPConnection, Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from ..errors import UserError, locate, one_line
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
OF_ACTIONS = ("edit", "grip", "drag", "turn", "drop", "cancel", "key", "pose", "save_pose", "pin", "free", "mirror")
OF_SESSION = ("undo", "redo", "reload", "keep", "take_offer", "want_curves", "search")
OF_FILES = ("save", "export", "render", "formats", "figures", "new", "stop")
BACKGROUND = ("export", "render", "stop")  # requests that need not wait for others
MOST_WAITING = 64  # queued messages of a slow page above which paths are omitted
MOST_BYTES = 4_000_000  # [bytes] maximum size of a message from a page


def application(session: Session, token: str, hosts: frozenset[str]) -> Starlette:
    """Return the server of one session. `hosts` are the accepted `Host` headers, such as "127.0.0.1:8000"."""
    desk = _Desk(session)

    def refusal(connection: HTTPConnection, *, with_token: bool) -> str | None:
        """Return the reason for rejecting a request; None for an accepted one."""
        host = connection.headers.get("host", "")
        if host not in hosts:
            return f"no such host: '{host[:100]}'"
        origin = connection.headers.get("origin")
        if origin is not None and urlsplit(origin).netloc not in hosts:
            return "this page may not connect to the studio; open the address that the command prints"
        if connection.scope["type"] == "websocket" and origin is None:
            return "a line to the studio needs an origin"
        if with_token and not hmac.compare_digest(connection.query_params.get("token", "").encode(), token.encode()):
            return "the address lacks the studio's token; use the one that the command printed"
        return None

    async def page(request: Request) -> Response:
        name = request.path_params.get("name", "")
        if name not in PAGE:
            return PlainTextResponse("there is no such page", 404, HEADERS)
        refused = refusal(request, with_token=name == "")
        if refused is not None:
            return PlainTextResponse(refused, 403, HEADERS)
        file, kind = PAGE[name]
        content = (files("dynsplines.studio") / "built" / file).read_bytes()
        return Response(content, headers=HEADERS, media_type=kind)

    async def line(socket: WebSocket) -> None:
        refused = refusal(socket, with_token=True)
        if refused is not None:
            await socket.close(NOT_HERE, refused)
            return
        await socket.accept()
        await desk.serve(socket)

    @asynccontextmanager
    async def life(app: Starlette) -> AsyncIterator[None]:
        session.settled = desk.actions.prepare
        session.begin()
        watching = asyncio.create_task(session.watch())
        try:
            yield
        finally:
            watching.cancel()
            session.close()

    routes = [Route("/", page), WebSocketRoute("/line", line), Route("/{name}", page)]
    return Starlette(routes=routes, lifespan=life)


class _Desk:
    """The requests of a session, and the connection of the one page that may send them."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.actions = Actions(session)
        self._owners = (self.actions, OF_ACTIONS), (session, OF_SESSION), (Files(session), OF_FILES)
        self._turn = asyncio.Lock()  # requests are performed one after another
        self._tasks: set[asyncio.Task[None]] = set()
        self._tab = ""
        self._socket: WebSocket | None = None

    async def serve(self, socket: WebSocket) -> None:
        """Serve a page until it disconnects. A second tab is rejected, or replaces the first one on request.

        A request is received at once and performed in turn, also if the connection is lost meanwhile.
        """
        tab, takes_over = socket.query_params.get("tab", ""), "take" in socket.query_params
        if self._socket is not None and tab != self._tab and not takes_over:
            await socket.close(IN_USE)
            return
        before, self._socket, self._tab = self._socket, socket, tab
        queue = asyncio.Queue[str | bytes]()

        def put(message: str | bytes) -> None:
            """Queue a message; paths are omitted if the page is slow."""
            if queue.qsize() <= MOST_WAITING or not _is_path(message):
                queue.put_nowait(message)

        self._start({"do": "cancel"}, lambda _: None)  # a drag of an earlier page
        self.session.enter(put)
        out = asyncio.create_task(_write(socket, queue))
        try:
            if before is not None:
                with suppress(RuntimeError, WebSocketDisconnect):
                    await before.close(IN_USE)
            while True:
                self._start(dict(json.loads(await socket.receive_text())), put)
        except (WebSocketDisconnect, ValueError, TypeError, RuntimeError):
            pass
        finally:
            out.cancel()
            self.session.leave(put)
            if self._socket is socket:
                self._socket = None
            with suppress(RuntimeError, WebSocketDisconnect):
                await socket.close()

    def _start(self, message: Message, put: Callable[[str], None]) -> None:
        """Perform a request in the background, and send the answer."""
        task = asyncio.create_task(self._answer(message, put))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _answer(self, message: Message, put: Callable[[str], None]) -> None:
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
            answer |= {"ok": True, **(result if isinstance(result, dict) else {"words": result})}
        except UserError as error:
            answer |= {"ok": False, "words": one_line(error)}
        except (TypeError, ValueError, KeyError, IndexError, AttributeError) as error:
            words = f"invalid request from the page: {type(error).__name__}: {one_line(error)}"
            answer |= {"ok": False, "words": words}
        except Exception as error:  # the page waits for an answer
            answer |= {"ok": False, "words": f"internal error: {locate(error)}"}
        put(json.dumps(answer))

    async def _done(self, do: str, arguments: Message) -> Any:
        owner = next((owner for owner, names in self._owners if do in names), None)
        if owner is None:
            raise UserError(f"'{do}': unknown request; reload the page")
        return await getattr(owner, do)(**arguments)


def _is_path(message: str | bytes) -> TypeGuard[bytes]:
    return isinstance(message, bytes) and not message.startswith(b"{")


async def _write(socket: WebSocket, queue: asyncio.Queue[str | bytes]) -> None:
    with suppress(WebSocketDisconnect, RuntimeError):
        while True:
            message = await queue.get()
            if _is_path(message):
                await socket.send_bytes(message)
            else:
                await socket.send_text(message if isinstance(message, str) else message.decode())
