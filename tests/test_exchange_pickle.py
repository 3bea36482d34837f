"""Pickles: plain data is read whoever wrote it, and nothing in one is ever run."""

import os
import pickle
import pickletools
from collections import OrderedDict

import numpy as np
import pytest

from runner.errors import UserError
from runner.exchange import plain_pickle

ARRAYS = {
    "matrix": np.arange(12.0).reshape(3, 4),
    "columns": np.asfortranarray(np.arange(6.0).reshape(2, 3)),
    "single": np.float32(2.5),
    "names": ["pelvis", "chest"],
    "nothing": None,
    "counts": np.array([1, 2], np.int64),
    "texts": np.array(["a", "b"]),
}


@pytest.mark.parametrize("protocol", range(6))
def test_arrays_numbers_and_texts_are_read_in_every_protocol(protocol, tmp_path):
    (tmp_path / "a.pkl").write_bytes(pickle.dumps(OrderedDict(ARRAYS), protocol=protocol))
    found = plain_pickle.load(tmp_path / "a.pkl").entries
    assert list(found) == list(ARRAYS)
    for name, value in ARRAYS.items():
        np.testing.assert_array_equal(found[name], value)


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


@pytest.mark.parametrize("content", [b"", b"no pickle", pickle.dumps({"a": 1})[:-3], b"\x80\x04\x95\xff\xff\xff"])
def test_damaged_pickles_are_told(content, tmp_path):
    (tmp_path / "bad.pkl").write_bytes(content)
    with pytest.raises(UserError, match=r"bad.pkl: not a readable pickle") as error:
        plain_pickle.load(tmp_path / "bad.pkl")
    assert "\n" not in str(error.value)
    (tmp_path / "list.pkl").write_bytes(pickle.dumps([1]))
    with pytest.raises(UserError, match="it holds a list, not a dict"):
        plain_pickle.load(tmp_path / "list.pkl")
