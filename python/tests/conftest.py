# SPDX-License-Identifier: Apache-2.0
"""A small case: a jet on a block of curd in 2D, some hundred steps."""

from typing import Any

import pytest

import kerf


@pytest.fixture
def tables() -> dict[str, Any]:
    """The case as tables of Python."""
    return {
        "title": "Jet on curd",
        "dimension": 2,
        "formulation": "standard",
        "time": {"end": "3 ms"},
        "materials": {
            "curd": {
                "base": "tofu",
                "criterion": "crack_band",
                "failure_strain": 0.05,
                "fracture_energy": "1 J/m2",
            }
        },
        "body": [
            {
                "name": "block",
                "material": "curd",
                "shape": {
                    "type": "box",
                    "minimum": ["-20 mm", "0 mm"],
                    "maximum": ["20 mm", "10 mm"],
                },
                "spacing": "1 mm",
            }
        ],
        "jet": [
            {
                "name": "jet",
                "material": "water",
                "speed": "10 m/s",
                "width": "6 mm",
                "position": ["0 mm", "10 mm"],
                "standoff": "2 mm",
                "spacing": "1 mm",
            }
        ],
        "probe": [{"name": "tip", "kind": "point", "position": ["0 mm", "11 mm"]}],
        "output": {"frame_interval": "1 ms", "series_interval": "0.1 ms"},
    }


@pytest.fixture
def case(tables: dict[str, Any]) -> kerf.Case:
    """The case."""
    return kerf.Case(tables, "small.toml")
