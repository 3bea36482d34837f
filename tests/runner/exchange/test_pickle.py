"""Pickles: plain data is read, and no content is executed."""

import io
import os
import pickle
import pickletools
from collections import OrderedDict
from typing import Any

import numpy as np
import pytest

from dynsplines.errors import UserError
from dynsplines.exchange import plain_pickle

ARRAYS = {"columns": np.asfortranarray(np.arange(6.0).reshape(2, 3)), "names": ["pelvis", "chest"]}


def test_what_is_written_names_numpy_as_before_version_2_and_is_read_by_pickle(tmp_path):
    plain_pickle.dump(ARRAYS, tmp_path / "a.pkl")
    content = (tmp_path / "a.pkl").read_bytes()
    named = {str(argument) for code, argument, _ in pickletools.genops(content) if code.name == "GLOBAL"}
    assert named and not any("numpy._core" in each for each in named)
    for found in (pickle.loads(content), plain_pickle.load(tmp_path / "a.pkl").entries):
        np.testing.assert_array_equal(found["columns"], ARRAYS["columns"])


class Harm:
    """Makes a folder when it is unpickled."""

    def __init__(self, call, *arguments):
        self.call, self.arguments = call, arguments

    def __reduce__(self):
        return self.call, self.arguments


@pytest.mark.parametrize(
    ("call", "arguments"),
    [(os.mkdir, ("harm",)), (eval, ("__import__('os').mkdir('harm')",)), (getattr, (os, "mkdir")), (np.load, ("x",))],
)
@pytest.mark.parametrize("nested", [False, True])
def test_code_in_a_pickle_is_refused_and_not_run(call, arguments, nested, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    harm = Harm(call, *arguments) if call is not getattr else Harm(getattr, Harm(__import__, "os"), "mkdir")
    entries = {"fps": 30, "frames": np.array([harm, 1], dtype=object) if nested else harm}
    (tmp_path / "bad.pkl").write_bytes(pickle.dumps(entries))
    with pytest.raises(UserError, match=r"bad.pkl: it holds '[\w.]+'; only numbers, texts, lists"):
        plain_pickle.load(tmp_path / "bad.pkl")
    assert not (tmp_path / "harm").exists()
    if call is os.mkdir:
        pickle.loads((tmp_path / "bad.pkl").read_bytes())
        assert (tmp_path / "harm").exists()  # it would have


class Named:
    """A name in a pickle, `module.name`."""

    def __init__(self, module: str, name: str):
        self.module, self.name = module, name


OPEN: Any = pickle._Pickler  # in Python, and so open to change


class Spelling(OPEN):
    """Writes what no honest pickler does: calls of names with any arguments, and any state after."""

    def save_named(self, named):
        self.write(b"c" + f"{named.module}\n{named.name}\n".encode())

    def save_call(self, call):
        self.save(call.make)
        self.save(call.arguments)
        self.write(pickle.REDUCE)
        if call.state is not None:
            self.save(call.state)
            self.write(pickle.BUILD)


class Call:
    def __init__(self, module, name, *arguments, state=None):
        self.make, self.arguments, self.state = Named(module, name), arguments, state


Spelling.dispatch = {**OPEN.dispatch, Named: Spelling.save_named, Call: Spelling.save_call}


def spelled(value) -> bytes:
    stream = io.BytesIO()
    Spelling(stream, 3).dump({"frames": value})
    return stream.getvalue()


def kind(text, *state):
    return Call("numpy", "dtype", text, False, True, state=state or (3, "<", None, None, None, -1, -1, 0))


def array(of, shape, data):
    blank = (Named("numpy", "ndarray"), (0,), b"b")
    return Call("numpy.core.multiarray", "_reconstruct", *blank, state=(1, shape, of, False, data))


ADDRESSES = b"\x41" * 16
WITHOUT_REFERENCES = kind("O8", 3, "|", None, None, None, -1, -1, 0)
LIES = {
    "references that are bytes": array(WITHOUT_REFERENCES, (2,), ADDRESSES),
    "references of a buffer": Call("numpy.core.numeric", "_frombuffer", ADDRESSES, WITHOUT_REFERENCES, (2,), "C"),
    "a reference of its own": Call("numpy.core.multiarray", "scalar", WITHOUT_REFERENCES, ADDRESSES[:8]),
    "fewer references than its shape": array(kind("O8", 3, "|", None, None, None, -1, -1, 63), (1000,), [1]),
    "fewer bytes than its shape": array(kind("f8"), (1000,), ADDRESSES),
    "a shape beyond all bounds": array(kind("f8"), (2**40, 2**40), ADDRESSES),
    "a shape below nought": array(kind("f8"), (-2, -1), ADDRESSES),
    "a scalar of more bytes": Call("numpy.core.multiarray", "scalar", kind("S100000"), b"a"),
    "a type larger than it says": array(kind("f8", 3, "<", None, None, None, 800, 8, 0), (200,), ADDRESSES),
    "parts beyond the item": array(
        kind("V8", 3, "|", None, ("a",), {"a": (kind("O8"), 4000)}, 8, 1, 27), (1,), ADDRESSES
    ),
    "a type without a state": array(Call("numpy", "dtype", "f8", False, True), (2,), ADDRESSES),
    "letters that are none": array(kind("U2", 3, "<", None, None, None, 8, 4, 8), (2,), b"\xff" * 16),
    "a state that is none": array(kind("f8", 3), (2,), ADDRESSES),
    "an array without a state": Call("numpy.core.multiarray", "_reconstruct", Named("numpy", "ndarray"), (0,), b"b"),
    "a call of what was made": Call("numpy", "ndarray", (10**9,)),
}


UNREADABLE = "not a readable pickle"
FAR = (2**40).to_bytes(8, "little")
STRANGE: dict[str, tuple[bytes, str]] = {
    "nothing": (b"", UNREADABLE),
    "no pickle": (b"no pickle", UNREADABLE),
    "a pickle without its end": (pickle.dumps({"a": 1})[:-3], UNREADABLE),
    "a frame without its length": (b"\x80\x04\x95\xff\xff\xff", UNREADABLE),
    "a list": (pickle.dumps([1]), "it holds a list, not a dict"),
    "a key that is no text": (pickle.dumps({(1, 2): 3}), "a key in it is a tuple, not a text"),
    "an integer beyond numbers": (pickle.dumps({"fps": 1 << 9000}), "it holds 'an integer of 9001 bits'"),
    "bz2": (b"BZh91AY", "a compressed file; load it in Python and dump it again"),
    "zlib": (b"\x78\x9c\x00", "a compressed file; load it in Python and dump it again"),
    "joblib": (b"cjoblib.numpy_pickle\nNumpyArrayWrapper\n.", "load it in Python with joblib, and dump it again"),
    "no instruction": (b"\xff.", UNREADABLE),
    "bytes that are not there": (b"\x80\x05\x8e" + FAR + b"ab.", "cut short"),
    "an array of bytes that is not there": (b"\x80\x05\x96" + FAR + b"ab.", "cut short"),
    "a frame that is not there": (b"\x80\x05\x95" + FAR + b"ab.", "not a readable pickle"),
    "a persistent name": (b"Pabc\n.", "'PERSID'"),
    "an extension": (b"\x82\x01.", "'EXT1'"),
    "an instance by its class": (b"(ios\nsystem\n.", "'INST'"),
    "an object by its class": (b"(cos\nsystem\no.", "'os.system'"),
    "a name with dots": (b"\x8c\x05numpy\x8c\x0adtype.type\x93.", "'numpy.dtype.type'"),
    "a state of a dict": (b"}}b.", "'a state of an object without one'"),
    "a tensor": (b"ctorch._utils\n_rebuild_tensor_v2\n(tR.", r"'torch\._utils\._rebuild_tensor_v2'.* with \.numpy\(\)"),
    "digits without end": (b"L" + b"9" * 100_000 + b"L\n.", "not a readable pickle"),
    **{lie: (spelled(value), "(it holds '|not a readable pickle|'frames' holds )") for lie, value in LIES.items()},
}


@pytest.mark.parametrize(("content", "message"), STRANGE.values(), ids=STRANGE)
def test_damaged_and_hostile_pickles_are_refused_in_one_line(content, message, tmp_path):
    (tmp_path / "bad.pkl").write_bytes(content)
    with pytest.raises(UserError, match=rf"bad\.pkl: .*{message}") as error:
        plain_pickle.load(tmp_path / "bad.pkl").numbers("frames", "n")
    assert "\n" not in str(error.value)


def test_the_same_spelling_told_truly_is_read(tmp_path):
    (tmp_path / "good.pkl").write_bytes(spelled(array(kind("f8"), (2,), np.array([1.0, 2.0]).tobytes())))
    np.testing.assert_array_equal(plain_pickle.load(tmp_path / "good.pkl").numbers("frames", "n"), [1, 2])
    (tmp_path / "good.pkl").write_bytes(spelled(Call("numpy.core.multiarray", "scalar", kind("f4"), b"\0\0\0\x40")))
    assert plain_pickle.load(tmp_path / "good.pkl").rate("frames") == 2


@pytest.mark.parametrize("protocol", range(6))
@pytest.mark.parametrize("core", ["core", "_core"])
def test_every_plain_type_of_either_numpy_comes_back_as_pickle_loads_it_in_every_protocol(protocol, core, tmp_path):
    plain = [np.array([0, 1, 5]).astype(f"{order}{code}") for order in "<>" for code in ("i2", "u4", "i8", "f2", "f8")]
    plain += [np.array([True, False]), np.array([b"ab", b"c"]), np.array(["é", "yz"]), np.zeros((0, 3)), np.float64(3)]
    plain += [np.array(["a", "b"], object), np.asfortranarray(np.array([["a", "b", "c"], ["d", "e", "f"]], object))]
    plain += [np.arange(24.0).reshape(2, 3, 4).transpose(1, 2, 0), np.array(7)]
    plain += [np.asfortranarray(np.arange(6.0).reshape(2, 3)), ["pelvis", "chest"], None, np.float32(2.5)]
    content = pickle.dumps(OrderedDict((str(i), each) for i, each in enumerate(plain)), protocol)
    loaded = pickle.loads(content)
    if protocol < 4:  # later ones say how long a name is
        content = content.replace(b"numpy._core.", f"numpy.{core}.".encode())
    (tmp_path / "a.pkl").write_bytes(content)
    for found, value in zip(plain_pickle.load(tmp_path / "a.pkl").entries.values(), loaded.values(), strict=True):
        np.testing.assert_array_equal(found, value, strict=True)


@pytest.mark.slow
def test_a_short_pickle_that_asks_for_much_memory_is_refused_at_once(tmp_path, monkeypatch):
    monkeypatch.setenv("DYNSPLINES_LARGEST", "1")
    ten = [1.0] * 10
    for _ in range(7):
        ten = [ten] * 10
    far = b"\x80\x02}r\xff\xff\xff\x7f."  # a place in the memo that makes room for all before it
    for content, name, axes in (
        (pickle.dumps({"a": ten}), "'a' comes to 800 MB|over 1 MB", 8),
        (pickle.dumps({"a": ten}), "deeper than it should", 2),
        (b"(" + b"]" * 20_000 + b"0" * 20_000 + b".", "what it holds comes to", 2),
        (far, "no 'a'; it holds: nothing", 2),
    ):
        (tmp_path / "bad.pkl").write_bytes(content)
        with pytest.raises(UserError, match=name):
            plain_pickle.load(tmp_path / "bad.pkl").numbers("a", *(f"n{i}" for i in range(axes)))
