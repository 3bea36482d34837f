"""Processes that tests start hear Ctrl-C and hangups, also where the tests themselves were started deaf to them: behind
`nohup`, or by `&` in a script. What a process ignores those that it starts ignore too; a handler is not handed on."""

import signal

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP") and signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:
    signal.signal(signal.SIGHUP, lambda *_: None)
