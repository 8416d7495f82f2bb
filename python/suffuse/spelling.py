"""Wrong names of arguments answered as the command line answers wrong options: with the nearest that there is."""

import functools
import inspect

from suffuse import _core


def spelled(function):
    """Calls `function`; for an unknown argument the error suggests the intended one."""
    known = [name for name, one in inspect.signature(function).parameters.items() if name != "self"]

    @functools.wraps(function)
    def call(*args, **named):
        for name in named:
            if name not in known:
                owner = function.__qualname__.removesuffix(".__init__").replace("CaseFile", "Case").lstrip("_")
                raise TypeError(_core.unknown_argument(owner, name, known))
        return function(*args, **named)

    return call
