"""Documents that are not as the program writes them: one place that says so."""
from __future__ import annotations

import functools
import inspect
from typing import Any, Callable, TypeVar

from .errors import BrokenFolder, PlicaError

Class = TypeVar("Class", bound=type)


ANEW = "run the command anew"


def reads(file: str, right: str = ANEW) -> Callable[[Class], Class]:
    """Of a class whose `folder` or `_folder` has `file` ("": that of its objects), or whose `path`
    is one: what properties and methods without arguments do not find there, or of another kind, is
    a BrokenFolder, which says what is `right`."""
    def guard(cls: Class) -> Class:
        for name, member in list(vars(cls).items()):
            if isinstance(member, property):
                setattr(cls, name, property(_guarded(member.fget, file, right), doc=member.__doc__))
            elif isinstance(member, functools.cached_property):
                member.func = _guarded(member.func, file, right)
            elif inspect.isfunction(member) and len(inspect.signature(member).parameters) == 1:
                setattr(cls, name, _guarded(member, file, right))
        return cls
    return guard


def _guarded(function: Any, file: str, right: str) -> Any:
    @functools.wraps(function)
    def get(self: Any) -> Any:
        try:
            return function(self)
        except PlicaError:
            raise
        except (LookupError, TypeError, ValueError, AttributeError) as error:
            folder = getattr(self, "folder", None) or getattr(self, "_folder", None)
            place = folder.path / (file or self.file) if folder else self.path
            raise broken(str(place), error, right) from error
    return get


def broken(file: str, error: Exception, right: str = ANEW) -> BrokenFolder:
    """What was missing in a file, or of another kind."""
    said = f"has no {error}" if isinstance(error, KeyError) else \
        f"is not as plica {'writes' if right == ANEW else 'reads'} it: {error}"
    return BrokenFolder(f"{file}: {said}; {right}")
