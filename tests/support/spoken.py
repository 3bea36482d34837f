"""The solver loop without a process, and a session without a solver."""

from __future__ import annotations

import asyncio

from dynsplines.studio.session import Session
from dynsplines.studio.solving.loop import SolverLoop


class Recorded(SolverLoop):
    """A solver loop that records its messages. `is_interrupted` makes a message wait from the next check on."""

    def __init__(self):
        self.sent, self.is_interrupted = [], False
        super().__init__(self.sent.append, lambda: self.is_interrupted)

    def taken(self):
        messages, self.sent[:] = list(self.sent), []
        return messages

    def asked(self, do, **arguments):
        self.do({"do": do, **arguments})
        return self.taken()

    def loaded(self, folder, text, revision=0, *, first=False, go=True):
        place = {"name": "tiny", "place": "tiny.toml", "folder": str(folder)}
        return self.asked("load", text=text, **place, revision=revision, go=go, first=first, id=7)


def session_without_solver(document, monkeypatch):
    """A session whose solver accepts every text."""
    session = Session(document)

    def send(message):
        if message["do"] == "load":
            loaded = {"is": "loaded", "id": message.get("id"), "revision": message["revision"]}
            asyncio.get_running_loop().call_soon(session.solver.answer, {**loaded, "outline": {}, "timeline": b""})

    monkeypatch.setattr(session.solver, "send", send)
    return session
