"""One thread of linear algebra: while it is asked for, whatever happens in it, and as many as before afterwards."""

from __future__ import annotations

import pytest
from threadpoolctl import ThreadpoolController

from dynsplines.solver.one_thread import one_thread


def threads() -> set[int]:
    return {library["num_threads"] for library in ThreadpoolController().select(user_api="blas").info()}


def test_linear_algebra_has_one_thread_inside_and_as_many_as_before_afterwards():
    before = threads()
    with one_thread():
        assert threads() == {1}
    assert threads() == before
    with pytest.raises(KeyError), one_thread():
        raise KeyError
    assert threads() == before


def test_where_it_has_two_it_has_two_again():
    with ThreadpoolController().select(user_api="blas").limit(limits=2):
        if threads() != {2}:
            pytest.skip("this machine's BLAS has one thread whatever it is told")
        with one_thread():
            assert threads() == {1}
        assert threads() == {2}
