"""Base of the classes: construction, and access to the JSON object of a result."""
from __future__ import annotations

from typing import Any, TypeVar

T = TypeVar("T")


def made(kind: type[T], **held: Any) -> T:
    """Returns an instance with these attributes, without calling the constructor, which is meant for users."""
    one = kind.__new__(kind)
    vars(one).update(held)
    return one


class Entries:
    """Gives access to the values by their keys in the JSON: `found["samples"]`, `"samples" in found`."""

    _content: dict[str, Any]

    def __getitem__(self, key: str) -> Any:
        return self._content[key]

    def __contains__(self, key: object) -> bool:
        return key in self._content

    def to_dict(self) -> dict[str, Any]:
        """Returns the whole JSON object."""
        return self._content
