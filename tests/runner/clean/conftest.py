"""The command `dynsplines`, run in the process of the tests."""

from __future__ import annotations

import pytest
from processes import Command, commanded


@pytest.fixture
def command(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Command:
    return commanded(monkeypatch, capsys)
