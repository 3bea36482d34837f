"""What is said to the process that solves, without a process, and what it says."""

from __future__ import annotations


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
