"""Work that others go before: all of it is done, once and in order, by a nicer thread or without one."""

from __future__ import annotations

import os
import sys
import threading

import pytest

from dynsplines.studio.solving.process import LATER, yielding


def nice() -> int:
    return os.getpriority(os.PRIO_PROCESS, threading.get_native_id())


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux lets one thread be nicer than others")
def test_others_go_before_the_work_and_before_nothing_else():
    before, seen = nice(), []
    yielding([lambda: seen.append(nice()), lambda: seen.append(nice())], patience=60)
    assert seen == [max(LATER, before)] * 2
    assert nice() == before


def test_without_patience_it_is_work_like_any_other():
    before, seen = nice(), []
    yielding([lambda: seen.append(nice()), lambda: seen.append(threading.current_thread())], patience=0)
    assert seen == [before, threading.main_thread()]


def test_all_is_done_once_and_in_order_whatever_fails():
    done = []

    def fails() -> None:
        done.append(2)
        raise ImportError("no such module")

    with pytest.raises(ZeroDivisionError):
        yielding([lambda: done.append(1), fails, lambda: done.append(3), lambda: 1 / 0], patience=60)
    assert done == [1, 2, 3]
