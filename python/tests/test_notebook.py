# SPDX-License-Identifier: Apache-2.0
"""The notebook runs from its first cell to its last."""

import ast
import json
from pathlib import Path
from typing import Any

import pytest

notebook = Path(__file__).parents[1] / "tutorial.ipynb"


def test_every_cell_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    cells = [
        "".join(cell["source"])
        for cell in json.loads(notebook.read_text(encoding="utf-8"))["cells"]
        if cell["cell_type"] == "code"
    ]
    names: dict[str, Any] = {}
    shown = []
    for number, cell in enumerate(cells):
        *body, last = ast.parse(cell).body
        if isinstance(last, ast.Expr):
            exec(compile(ast.Module(body, []), f"cell {number}", "exec"), names)
            shown.append(eval(compile(ast.Expression(last.value), f"cell {number}", "eval"), names))
        else:
            exec(compile(cell, f"cell {number}", "exec"), names)
    assert len(cells) >= 6
    printed = capsys.readouterr().out
    assert "kpa" in printed and "begins to break the block" in printed
    assert any(hasattr(value, "_repr_png_") for value in shown)
