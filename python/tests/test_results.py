# SPDX-License-Identifier: Apache-2.0
"""Results, frames for VTK, and studies."""

from collections.abc import Generator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import kerf


def test_results_of_a_folder(case: kerf.Case, tmp_path: Path) -> None:
    result = kerf.Run(case, tmp_path / "run").finish()
    assert result.case.used == case.used
    np.testing.assert_allclose(result.times, [0.0, 1e-3, 2e-3, 3e-3], atol=1e-4)
    assert [frame.step for frame in result.frames] == sorted(f.step for f in result.frames)
    assert result.frame(0).time == 0.0
    series = result.series
    time = next(name for name in series if name.startswith("time"))
    assert series[time][-1] == pytest.approx(case.end)
    assert result.verdict in repr(result)
    with pytest.raises(kerf.FileError, match="no run of Kerf"):
        kerf.Result(tmp_path)


def test_series_is_that_of_pandas(case: kerf.Case, tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    result = kerf.Run(case, tmp_path / "run").finish()
    table = result.pandas()
    for name, values in result.series.items():
        np.testing.assert_array_equal(table[name].to_numpy(float), values)


def test_vtk_has_all_columns(case: kerf.Case, tmp_path: Path) -> None:
    pytest.importorskip("vtkmodules")
    run = kerf.Run(case, tmp_path / "run")
    run.step(20)
    frame = run.frame()
    data = kerf.to_vtk(frame)
    assert data.GetNumberOfPoints() == data.GetNumberOfVerts() == len(frame)
    for index in (0, len(frame) - 1):
        assert data.GetPoint(index) == pytest.approx(frame["position"][index])
        velocity = data.GetPointData().GetArray("velocity").GetTuple(index)
        assert velocity == pytest.approx(frame["velocity"][index])
    assert data.GetPointData().GetNumberOfArrays() == len(frame.keys()) - 1


def depth(result: kerf.Result) -> float:
    return float(result.metrics["front_depth"])


def test_an_own_search_runs_each_case_once(case: kerf.Case, tmp_path: Path) -> None:
    study = kerf.Study(
        kerf.replaced(case, {"time.end": "1 ms"}), tmp_path / "study", {"depth": depth}, jobs=2
    )

    def two_rounds() -> Generator[list[dict[str, Any]], list[dict[str, Any]], float]:
        slow, fast = yield [{"jet.0.speed": "5 m/s"}, {"jet.0.speed": "20 m/s"}]
        assert slow["depth"] < fast["depth"]
        [again] = yield [{"jet.0.speed": "20 m/s"}]
        assert again["folder"] == fast["folder"]
        return float(fast["depth"])

    assert study.search(two_rounds()) > 0.0
    assert len(study.rows) == 3
    assert len(list((tmp_path / "study" / "runs").glob("*/result.json"))) == 2


def test_a_setting_that_is_no_case_runs_nothing(case: kerf.Case, tmp_path: Path) -> None:
    study = kerf.Study(case, tmp_path / "study")
    with pytest.raises(kerf.CaseError, match="speed"):
        study.run([{"jet.0.speed": "5 m/s"}, {"jet.0.speed": "5 kg"}])
    assert study.rows == [] and not (tmp_path / "study").exists()


def test_a_study_file(case: kerf.Case, tmp_path: Path) -> None:
    (tmp_path / "small.toml").write_text(case.text, encoding="utf-8")
    (tmp_path / "study.toml").write_text(
        'title = "Two speeds"\nbase = "small.toml"\n[set]\n"time.end" = "0.5 ms"\n'
        '[vary]\n"jet.jet.speed" = ["5 m/s", "10 m/s"]\n',
        encoding="utf-8",
    )
    result = kerf.study(tmp_path / "study.toml", tmp_path / "out", jobs=1)
    assert result.answer["title"] == "Two speeds"
    pytest.importorskip("pandas")
    assert len(result.pandas()) == 2
    with pytest.raises(kerf.KerfError, match="missing.toml"):
        kerf.study(tmp_path / "missing.toml", tmp_path / "other")
