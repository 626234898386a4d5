# SPDX-License-Identifier: Apache-2.0
"""Changes of cases."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from typing import Any

from kerf._kerf import Case, CaseError


def replaced(case: Case, changes: Mapping[str, Any]) -> Case:
    """Return a copy of a case with other values.

    Parameters
    ----------
    case
        The case, which remains as it is.
    changes
        Values by their paths: ``{"jet.jet.speed": "20 m/s", "time.end": "5 ms"}``. An entry of a
        list is given by its ``name`` or its number from 0, a component of a vector by its number.
        A material that the case takes from the library gets a table of its own, based on the
        library's. None removes a key.

    Raises
    ------
    CaseError
        If the new case is not valid.
    KeyError
        If a path leads through something that is no table or list of the case, or if two paths
        lead to the same key.
    """
    tables = tomllib.loads(case.text)
    taken: dict[tuple[str, ...], str] = {}
    named: dict[str, str] = {}  # the paths by the keys of messages
    for path, value in changes.items():
        place = _put(tables, path, value)
        if place in taken:
            raise KeyError(f"{path}: this is the same key as {taken[place]}; name it once")
        taken[place] = path
        named[_key_of(place)] = path
    try:
        return Case(tables, case.file)
    except CaseError as error:
        message = str(error)
        for key, path in named.items():
            message = message.replace(f"{key} =", f"{path} =")
        raise CaseError(message) from None


def _key_of(place: tuple[str, ...]) -> str:
    """Return a place as messages write it, such as ``jet[1].speed``; they count from 1."""
    key = ""
    for name in place:
        key += f"[{int(name) + 1}]" if name.isdigit() else f".{name}"
    return key.removeprefix(".")


def _put(tables: dict[str, Any], path: str, value: Any) -> tuple[str, ...]:
    """Put a value at a path and return its place, which is the same for all paths to the key."""
    *way, last = path.split(".")
    inner: Any = tables
    place: list[str] = []
    for key in way:
        is_material = place == ["materials"] and key not in inner
        place.append(_key_in(inner, key, path))
        inner = _step(inner, key, path)
        if is_material and key in _materials_in_use(tables):
            inner["base"] = key
    place.append(_key_in(inner, last, path))
    if isinstance(inner, list):
        inner[_index(inner, last, path)] = value
    elif not isinstance(inner, dict):
        raise KeyError(f"{path}: there is no table before {last}")
    elif value is None:
        inner.pop(last, None)
    else:
        inner[last] = value
    return tuple(place)


def _materials_in_use(tables: dict[str, Any]) -> set[str]:
    entries = [*tables.get("body", []), *tables.get("jet", [])]
    return {"water", *(entry["material"] for entry in entries if "material" in entry)}


def _key_in(inner: Any, key: str, path: str) -> str:
    return str(_index(inner, key, path)) if isinstance(inner, list) else key


def _step(inner: Any, key: str, path: str) -> Any:
    if isinstance(inner, list):
        return inner[_index(inner, key, path)]
    if isinstance(inner, dict):
        return inner.setdefault(key, {})
    raise KeyError(f"{path}: {key} is below a value that is no table")


def _index(entries: list[Any], key: str, path: str) -> int:
    names = [entry.get("name") if isinstance(entry, dict) else None for entry in entries]
    if key in names:
        return names.index(key)
    if key.isdigit() and int(key) < len(entries):
        return int(key)
    known = ", ".join(f'"{name}"' for name in names if name)
    raise KeyError(
        f"{path}: {key} is no name and no index of a list of {len(entries)}"
        + (f", whose names are {known}" if known else "")
    )
