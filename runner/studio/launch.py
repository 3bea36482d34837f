"""The command `studio`: a free port, a token, the address on the terminal, the browser."""

from __future__ import annotations

import secrets
import socket
import sys
import webbrowser
from collections.abc import Callable
from functools import partial
from importlib.util import find_spec

from ..errors import UserError, missing_package
from .document import Document
from .session import Session

PACKAGES = ("starlette", "uvicorn", "websockets", "tomlkit")
PRINT = partial(print, flush=True)
LOCAL = ("127.0.0.1", "localhost")


def run(
    document: Document,
    *,
    port: int,
    browser: bool,
    report: Callable[[str], None] = PRINT,
) -> None:
    """Serve a document on this machine until Ctrl-C. Raises UserError for an unavailable port."""
    listening = _listen(port)
    session = Session(document)
    session.start()  # before the server's imports, so that both run in parallel
    token, port = secrets.token_urlsafe(24), listening.getsockname()[1]
    address = f"http://{LOCAL[0]}:{port}/?token={token}"
    report(address)
    if browser:
        webbrowser.open(address)
    try:
        _serve(session, listening, token, frozenset(f"{name}:{port}" for name in LOCAL))
    except KeyboardInterrupt:
        pass
    finally:
        listening.close()
        session.close()
        if session.document.is_dirty:
            print(f"not saved; the next start offers it: {session.document.unsaved_file}", file=sys.stderr)


def _serve(session: Session, listening: socket.socket, token: str, hosts: frozenset[str]) -> None:
    import uvicorn  # imported here, after the start of the solver process

    from .server import MOST_BYTES, application

    settings = uvicorn.Config(
        application(session, token, hosts),
        log_level="critical",
        access_log=False,
        ws="websockets-sansio",
        ws_max_size=MOST_BYTES,
        ws_ping_interval=None,  # a page on this machine may be busy, or asleep, for longer than any timeout
        server_header=False,
        timeout_graceful_shutdown=1,  # [s], so that pages receive the end of the server
    )
    uvicorn.Server(settings).run(sockets=[listening])


def check_packages() -> None:
    """Raise UserError if a package of the studio is missing."""
    for name in PACKAGES:
        if sys.modules.get(name) is None and (name in sys.modules or find_spec(name) is None):
            raise missing_package("the studio", name, "studio")


def _listen(port: int) -> socket.socket:
    """Return a listening socket. Raises UserError for a port that is in use."""
    listening = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)  # asyncio then sets TCP_NODELAY
    listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listening.bind((LOCAL[0], port))
    except OSError as error:
        listening.close()
        raise UserError(f"--port {port}: {error.strerror or error}") from None
    listening.listen()
    return listening
