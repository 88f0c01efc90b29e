"""Documents that are not as the program writes them: one place that says so."""
from __future__ import annotations

import functools
import inspect
from typing import Any, Callable, TypeVar

from .errors import BrokenFolder, PlicaError

Class = TypeVar("Class", bound=type)


def reads(file: str) -> Callable[[Class], Class]:
    """Of a class whose `folder` or `_folder` has `file` ("": that of its objects): what properties
    and methods without arguments do not find there, or of another kind, is a BrokenFolder."""
    def guard(cls: Class) -> Class:
        for name, member in list(vars(cls).items()):
            if isinstance(member, property):
                setattr(cls, name, property(_guarded(member.fget, file), doc=member.__doc__))
            elif isinstance(member, functools.cached_property):
                member.func = _guarded(member.func, file)
            elif inspect.isfunction(member) and len(inspect.signature(member).parameters) == 1:
                setattr(cls, name, _guarded(member, file))
        return cls
    return guard


def _guarded(function: Any, file: str) -> Any:
    @functools.wraps(function)
    def get(self: Any) -> Any:
        try:
            return function(self)
        except PlicaError:
            raise
        except (LookupError, TypeError, ValueError, AttributeError) as error:
            folder = getattr(self, "folder", None) or getattr(self, "_folder")
            raise broken(str(folder.path / (file or self.file)), error) from error
    return get


def broken(file: str, error: Exception) -> BrokenFolder:
    """What was missing in a file, or of another kind."""
    said = f"has no {error}" if isinstance(error, KeyError) else \
        f"is not as plica writes it: {error}"
    return BrokenFolder(f"{file}: {said}; run the command anew")
