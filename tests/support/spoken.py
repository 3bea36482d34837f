"""What is said to the process that solves, without a process, and what it says."""

from __future__ import annotations

import asyncio

from dynsplines.studio.session import Session


class Line:
    """Keeps what is sent."""

    def __init__(self):
        self.sent = []

    def send(self, message):
        self.sent.append(message)

    def taken(self):
        found, self.sent = self.sent, []
        return found


def load(work, folder, text, revision=0, *, first=False, go=True):
    work.do(
        {
            "do": "load", "text": text, "name": "tiny", "place": "tiny.toml", "folder": str(folder),
            "revision": revision, "go": go, "first": first,
        }
    )  # fmt: skip
    return work.line.taken()


def session_without_solver(document, monkeypatch):
    """A session whose solver accepts every text."""
    session = Session(document)

    def send(message):
        if message["do"] == "load":
            loaded = {"is": "loaded", "revision": message["revision"], "outline": {}, "keys": []}
            asyncio.get_running_loop().call_soon(session._receive, loaded)

    monkeypatch.setattr(session.solver, "send", send)
    return session
