# SPDX-License-Identifier: Apache-2.0
"""Changes of cases."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from typing import Any

from kerf._kerf import Case


def replaced(case: Case, changes: Mapping[str, Any]) -> Case:
    """Return a copy of a case with other values.

    Parameters
    ----------
    case
        The case, which remains as it is.
    changes
        Values by their paths: ``{"jet.0.speed": "20 m/s", "time.end": "5 ms"}``. A number in a
        path counts the tables of a list from 0; None removes a key.

    Raises
    ------
    CaseError
        If the new case is not valid.
    KeyError
        If a path leads through something that is no table or list of the case.
    """
    tables = tomllib.loads(case.text)
    for path, value in changes.items():
        _put(tables, path, value)
    return Case(tables, case.file)


def _put(tables: dict[str, Any], path: str, value: Any) -> None:
    *way, last = path.split(".")
    inner: Any = tables
    for key in way:
        inner = _step(inner, key, path)
    if isinstance(inner, list):
        inner[_index(inner, last, path)] = value
    elif not isinstance(inner, dict):
        raise KeyError(f"{path}: there is no table before {last}")
    elif value is None:
        inner.pop(last, None)
    else:
        inner[last] = value


def _step(inner: Any, key: str, path: str) -> Any:
    if isinstance(inner, list):
        return inner[_index(inner, key, path)]
    if isinstance(inner, dict):
        return inner.setdefault(key, {})
    raise KeyError(f"{path}: {key} is below a value that is no table")


def _index(entries: list[Any], key: str, path: str) -> int:
    if not key.isdigit() or int(key) >= len(entries):
        raise KeyError(f"{path}: {key} is no index of a list of {len(entries)}")
    return int(key)
