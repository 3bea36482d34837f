"""Who may speak to the studio: the token, Host and Origin; files of the clip's folder and no others."""

import asyncio
import json
import socket
import sys
import threading
import warnings

import browser as browsers
import problems
import pytest
from processes import refusal

with warnings.catch_warnings():  # of one version's preference for another client library
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from dynsplines.errors import UserError
from dynsplines.picture import graphics
from dynsplines.studio import files, launch
from dynsplines.studio.actions import Actions
from dynsplines.studio.document import Document
from dynsplines.studio.server import application
from dynsplines.studio.session import Session

TOKEN = "a token that nobody guesses"
HOST = "127.0.0.1:4711"
ORIGIN = f"http://{HOST}"


@pytest.fixture
def session(tmp_path):
    return Session(Document("clip", 'figure = "human"\n', tmp_path))


@pytest.fixture
def client(session):
    app = application(session, TOKEN, frozenset({HOST, "localhost:4711"}))
    return TestClient(app, base_url=ORIGIN)  # without its life: no process is begun


def test_the_page_is_there_for_who_has_the_token_and_loads_nothing_from_elsewhere_nor_is_shown_in_another(client):
    found = client.get("/", params={"token": TOKEN})
    assert found.status_code == 200
    assert "<title>dynsplines studio</title>" in found.text
    policy = found.headers["content-security-policy"]
    for words in ("default-src 'none'", "script-src 'self'", "connect-src 'self'", "frame-ancestors 'none'"):
        assert words in policy
    assert "unsafe-eval" not in policy
    assert found.headers["cache-control"] == "no-store"
    assert found.headers["referrer-policy"] == "no-referrer"
    assert client.get("/studio.js").status_code == 200
    assert client.get("/studio.css").status_code == 200


HOSTS = ("evil.example", "evil.example:4711", "127.0.0.1", "127.0.0.1:4712", "127.0.0.1.nip.io")
ORIGINS = ("http://evil.example", "https://evil.example:4711", "null", "http://127.0.0.1:80")


@pytest.mark.parametrize(
    ("token", "headers"),
    [
        *((token, {"host": HOST, "origin": ORIGIN}) for token in ("", "another", TOKEN[:-1], TOKEN + "x", "ä")),
        *((TOKEN, {"host": host, "origin": f"http://{host}"}) for host in HOSTS),
        *((TOKEN, {"host": HOST, "origin": origin}) for origin in ORIGINS),
    ],
)
def test_without_the_token_and_from_foreign_hosts_and_pages_there_is_nothing(client, token, headers):
    assert client.get("/", params={"token": token}, headers=headers).status_code == 403
    if headers["host"] != HOST:
        assert client.get("/studio.js", headers=headers).status_code == 403
    with (
        pytest.raises(WebSocketDisconnect) as closed,
        client.websocket_connect(f"/line?token={token}", headers=headers),
    ):
        pass
    assert closed.value.code == 4403


def test_a_line_needs_an_origin(client):
    with pytest.raises(WebSocketDisconnect), client.websocket_connect(f"/line?token={TOKEN}", headers={"host": HOST}):
        pass


@pytest.mark.parametrize("path", ["/sources.txt", "/../pyproject.toml", "/%2e%2e/document.py", "/index.html", "/a/b"])
def test_nothing_else_is_served(client, path):
    assert client.get(path, params={"token": TOKEN}).status_code == 404


def connected(client, more=""):
    return client.websocket_connect(f"/line?token={TOKEN}{more}", headers={"host": HOST, "origin": ORIGIN})


def answer(line, message):
    line.send_text(json.dumps(message))
    while (told := json.loads(line.receive_text()))["is"] != "answer":
        pass
    return told


def answers(client, *asked):
    """Return the answers to requests of one page."""
    with connected(client) as line:
        return [answer(line, {"id": number, **message}) for number, message in enumerate(asked)]


def is_closed(line):
    try:
        while True:
            line.receive_text()
    except WebSocketDisconnect as closed:
        return closed.code == 4409


UNKNOWN = {"do": "unknown", "id": 1}


def test_a_second_tab_is_rejected_until_it_takes_over_and_one_that_is_loaded_again_replaces_its_connection(client):
    with connected(client, "&tab=1") as first:
        with connected(client, "&tab=2") as second:
            assert is_closed(second)
        assert answer(first, UNKNOWN)["id"] == 1
        with connected(client, "&tab=2&take") as second:
            assert is_closed(first)
            with connected(client, "&tab=2") as again:
                assert is_closed(second)
                assert answer(again, UNKNOWN)["id"] == 1
    with connected(client, "&tab=3") as third:  # no other tab is open
        assert answer(third, UNKNOWN)["id"] == 1


def test_requests_of_a_lost_connection_are_performed_once_before_those_of_the_next_one(client, session, monkeypatch):
    done, begun, may_end = [], threading.Event(), threading.Event()

    async def edit(self, name, arguments):
        begun.set()
        await asyncio.to_thread(may_end.wait, 10)
        done.append(name)
        return ""

    monkeypatch.setattr(Session, "edit", edit)
    with client:
        with connected(client, "&tab=1") as line:
            for name in ("first", "second"):
                line.send_text(json.dumps({"do": "edit", "id": 1, "name": name}))
            assert begun.wait(10)
        with connected(client, "&tab=1") as line:
            line.send_text(json.dumps({"do": "edit", "id": 1, "name": "third"}))
            may_end.set()
            while json.loads(line.receive_text())["is"] != "answer":
                pass
    assert done == ["first", "second", "third"]


def test_a_request_with_numbers_of_another_revision_is_rejected(client):
    message = {"do": "edit", "name": "change", "at": ["keyframe", 0], "entries": {}, "revision": 1}
    (told,) = answers(client, message)
    assert told["words"] == "the clip has changed meanwhile; check it, and try again"


OUTSIDE = [
    "../clip.toml",
    "/etc/passwd.toml",
    "a/b.toml",
    "..",
    ".hidden.toml",
    "a\\b.toml",
    "nul\0.toml",
    "",
    "x" * 200,
]


@pytest.mark.parametrize("name", OUTSIDE)
def test_no_file_outside_the_clips_folder_is_read_or_written(client, session, tmp_path, name):
    (tmp_path.parent / "clip.toml").write_text("secret")
    for told in answers(
        client,
        {"do": "save", "name": name},
        {"do": "export", "to": "bvh", "name": name},
        {"do": "render", "name": name},
    ):
        assert not told["ok"]
        assert "clip's folder" in told["words"] or "plain name" in told["words"], told
    assert list(tmp_path.iterdir()) == []


def test_a_link_that_leads_out_of_the_folder_is_not_followed(tmp_path):
    (tmp_path / "inner").mkdir()
    (tmp_path / "there.toml").write_text("")
    (tmp_path / "inner" / "link.toml").symlink_to(tmp_path / "there.toml")
    with pytest.raises(UserError, match="outside"):
        files.inside(tmp_path / "inner", "link.toml")


def test_a_file_is_replaced_only_after_a_confirmation_if_it_is_another_one_or_was_changed(client, tmp_path):
    file = tmp_path / "mine.toml"
    file.write_text("theirs")
    (refused,) = answers(client, {"do": "save", "name": "mine.toml"})
    assert "already exists" in refused["words"]
    saved = answers(client, {"do": "save", "name": "mine", "overwrite": True}, {"do": "save"})
    assert [told["words"] for told in saved] == ["saved mine.toml"] * 2
    file.write_text("theirs")
    for told in answers(client, {"do": "save"}, {"do": "save", "name": "mine.toml"}):
        assert "'mine.toml' was changed by another program" in told["words"]
    assert file.read_text() == "theirs"
    assert answers(client, {"do": "save", "name": "mine", "overwrite": True})[0]["ok"]
    file.unlink()
    assert answers(client, {"do": "save"})[0]["ok"]
    assert file.read_text() == 'figure = "human"\n'


@pytest.mark.parametrize(
    "asked", [{"do": "export", "to": "bvh", "name": "walk.bvh"}, {"do": "render", "name": "walk.mp4"}]
)
def test_a_video_or_an_export_replaces_a_file_only_after_a_confirmation(client, tmp_path, monkeypatch, asked):
    ran = []

    async def run(self, words):
        ran.append("--overwrite" in words)

    monkeypatch.setattr(files.Files, "_run", run)
    (tmp_path / asked["name"]).write_text("theirs")
    (refused,) = answers(client, asked)
    assert "already exists; choose another name" in refused["words"]
    assert ran == []
    assert answers(client, asked | {"overwrite": True})[0]["ok"]
    assert ran == [asked["do"] == "export"]


def test_a_video_is_drawn_by_the_renderer_that_the_command_selects(client, monkeypatch):
    async def save_motion(self, file):
        file.touch()

    monkeypatch.setattr(Session, "save_motion", save_motion)
    monkeypatch.setattr(files, "COMMAND", "import os; exit(f\"drawn with {os.environ.get('MUJOCO_GL')}\")")
    monkeypatch.setenv("MUJOCO_GL", "disable")  # by do_without, in the process of the server
    monkeypatch.setattr(graphics, "_INITIAL", {"MUJOCO_GL": "osmesa"})
    (told,) = answers(client, {"do": "render", "name": "walk.mp4"})
    assert told["words"] == "drawn with osmesa"


def test_what_the_studio_does_not_know_is_answered_in_words(client):
    told = answers(
        client,
        {"do": "format"},
        {"do": "edit", "name": "rm"},
        {"do": "edit"},
        {"do": "grip"},
        {"do": "undo", "x": 1},
        {"do": "save", "name": 5},
    )
    assert [each["ok"] for each in told] == [False] * 6
    assert "unknown request" in told[0]["words"]
    assert "no edit 'rm'" in told[1]["words"]


def test_an_internal_error_is_an_answer_too(client, monkeypatch):
    async def grip(self):
        raise RuntimeError("out of luck")

    monkeypatch.setattr(Actions, "grip", grip)
    (refused,) = answers(client, {"do": "grip"})
    assert not refused["ok"]
    assert refused["words"].startswith("internal error: RuntimeError: out of luck (test_server.py:")


def began(session, monkeypatch):
    """What the command says and serves, without a process and without a server."""
    served, said = [], []
    monkeypatch.setattr(Session, "start", lambda self: None)
    monkeypatch.setattr(
        launch, "_serve", lambda session, listening, *door: served.append((listening.getsockname(), *door))
    )
    launch.run(session.document, report=said.append, port=0, browser=False)
    return served[0], said


def test_it_listens_on_this_machine_alone_behind_a_new_token_each_time(session, monkeypatch):
    (place, token, hosts), (address,) = began(session, monkeypatch)
    assert place[0] == "127.0.0.1"
    assert address == f"http://127.0.0.1:{place[1]}/?token={token}"
    assert hosts == {f"{name}:{place[1]}" for name in ("127.0.0.1", "localhost")}
    assert len(token) >= 32
    assert began(session, monkeypatch)[0][1] != token


def test_a_port_that_is_taken_is_reported():
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        with pytest.raises(UserError, match="--port"):
            launch._listen(taken.getsockname()[1])


def test_undo_with_nothing_to_undo_is_refused(session):
    with pytest.raises(UserError, match="nothing to undo"):
        asyncio.run(session.undo())


def test_what_cannot_be_is_one_line_and_exit_code_2(command):
    assert "65535" in refusal(command("studio", "--port", "70000", "--no-browser"))


def test_without_its_packages_it_says_which_command_brings_them(command, monkeypatch):
    monkeypatch.setitem(sys.modules, "tomlkit", None)
    assert "pip install 'dynamic-splines[studio]'" in refusal(command("studio"))


@pytest.mark.slow
def test_ctrl_c_ends_it_with_no_process_left(tmp_path):
    import psutil

    problems.written(tmp_path)
    running = browsers.Studio(tmp_path, "tiny.toml")
    children = psutil.Process(running.process.pid).children(recursive=True)
    said = running.end()
    assert "Traceback" not in said
    _, alive = psutil.wait_procs(children, timeout=10)
    assert alive == []
    assert not [path for path in tmp_path.iterdir() if path.name.startswith(".")]
