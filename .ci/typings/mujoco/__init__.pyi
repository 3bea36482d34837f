# MuJoCo's wheel ships no type information for its compiled module: every name of it is Any.
from typing import Any

def __getattr__(name: str) -> Any: ...
