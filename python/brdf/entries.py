"""What the classes share: how they are made, and the JSON object that one stands for."""
from __future__ import annotations

from typing import Any, TypeVar

T = TypeVar("T")


def made(kind: type[T], **held: Any) -> T:
    """One with these attributes, without its constructor, which is for people."""
    one = kind.__new__(kind)
    vars(one).update(held)
    return one


class Entries:
    """Asked for by their keys in the JSON: `found["samples"]`, `"samples" in found`."""

    _content: dict[str, Any]

    def __getitem__(self, key: str) -> Any:
        return self._content[key]

    def __contains__(self, key: object) -> bool:
        return key in self._content

    def to_dict(self) -> dict[str, Any]:
        """The JSON object as a whole."""
        return self._content
