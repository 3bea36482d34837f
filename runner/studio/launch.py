"""The command `studio`: a free port, a token, the address on the terminal, the browser."""

from __future__ import annotations

import ipaddress
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
LOCAL = ("127.0.0.1", "localhost", "[::1]")


def run(
    document: Document,
    *,
    host: str,
    port: int,
    browser: bool,
    allow_remote: bool,
    report: Callable[[str], None] = PRINT,
) -> None:
    """Serve a document until Ctrl-C. Raises UserError for an unavailable host or port."""
    check_host(host, allow_remote=allow_remote)
    listening = _bound(host, port)
    session = Session(document)
    session.start()  # before the server's imports, so that both run in parallel
    token, port = secrets.token_urlsafe(24), listening.getsockname()[1]
    shown = f"[{host}]" if ":" in host else host
    hosts = frozenset(f"{name}:{port}" for name in {*LOCAL, shown})
    if host in ("0.0.0.0", "::"):  # every address of the machine
        hosts |= frozenset(f"{name}:{port}" for name in (socket.gethostname(), socket.getfqdn(), *_own_addresses()))
        shown = socket.gethostname()
    address = f"http://{shown}:{port}/?token={token}"
    report(address)
    if not _is_loopback(host):
        report(
            "note: anyone with this address and access to this machine can edit the clip and write files next to it;"
        )
        report("note: the connection is not encrypted")
    if browser:
        webbrowser.open(address)
    try:
        _serve(session, listening, token, hosts)
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
        server_header=False,
        timeout_graceful_shutdown=1,  # [s], so that pages receive the end of the server
    )
    uvicorn.Server(settings).run(sockets=[listening])


def check_packages() -> None:
    """Raise UserError if a package of the studio is missing."""
    for name in PACKAGES:
        if sys.modules.get(name) is None and (name in sys.modules or find_spec(name) is None):
            raise missing_package("the studio", name, "studio")


def check_host(host: str, *, allow_remote: bool) -> None:
    """Raise UserError for an address that other machines can reach, unless this was allowed."""
    if not _is_loopback(host) and not allow_remote:
        raise UserError(
            f"--host {host}: other machines could reach the studio, edit the clip and write files next to it, "
            "unencrypted; add --allow-remote to allow it, or omit --host"
        )


def _is_loopback(host: str) -> bool:
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def _own_addresses() -> list[str]:
    try:
        return socket.gethostbyname_ex(socket.gethostname())[2]
    except OSError:
        return []


def _bound(host: str, port: int) -> socket.socket:
    """Return a listening socket. Raises UserError for a port that is in use."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    listening = socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)  # named: asyncio then sets TCP_NODELAY
    listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listening.bind((host, port))
    except (OSError, OverflowError) as error:
        listening.close()
        raise UserError(f"--host {host} --port {port}: {getattr(error, 'strerror', None) or error}") from None
    listening.listen()
    return listening
