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


def through(result: kerf.Result) -> Any:
    return result.metrics["cut_through"]


def bisection(low: float, high: float) -> Generator[list[dict[str, Any]], Any, float]:
    """A search that takes a missing verdict for one that does not cut."""
    while high - low > 0.5:
        middle = (low + high) / 2
        [row] = yield [{"jet.0.speed": f"{middle} m/s"}]
        low, high = (low, middle) if row["through"] else (middle, high)
    return high


def test_a_missing_program_is_an_error_of_every_study(
    case: kerf.Case, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    study = kerf.Study(case, tmp_path / "study", {"through": through})
    monkeypatch.setenv("KERF_PROGRAM", str(tmp_path / "no" / "kerf"))
    with pytest.raises(kerf.FileError, match="KERF_PROGRAM"):
        study.search(bisection(2.0, 5.0))
    with pytest.raises(kerf.FileError, match="KERF_PROGRAM"):
        kerf.study(tmp_path / "study.toml", tmp_path / "other")
    assert study.rows == []


def failing_program(folder: Path, speed: str) -> Path:
    """A program that fails in the runs whose case has this text, and else is `kerf`."""
    file = folder / "failing"
    file.write_text(
        f'#!/bin/sh\nif grep -q "{speed}" "$2"; then echo "kerf: error: broke down" >&2; exit 3; fi\n'
        f'exec "{kerf.program()}" "$@"\n',
        encoding="utf-8",
    )
    file.chmod(0o755)
    return file


def test_failed_runs_are_no_answer_of_a_search(
    case: kerf.Case, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("KERF_PROGRAM", str(failing_program(tmp_path, "title")))
    study = kerf.Study(case, tmp_path / "study", {"through": through})
    with pytest.raises(kerf.RunError, match="broke down"):
        study.search(bisection(2.0, 5.0))
    assert len(study.rows) == 1 and study.rows[0]["through"] is None

    def patient() -> Generator[list[dict[str, Any]], Any, str]:
        try:
            yield [{"jet.0.speed": "5 m/s"}]
        except kerf.RunError:
            return "went on"
        return "saw rows"

    assert study.search(patient()) == "went on"


def test_a_failed_run_among_others_has_its_error(
    case: kerf.Case, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("KERF_PROGRAM", str(failing_program(tmp_path, "speed = .7 m/s")))
    study = kerf.Study(kerf.replaced(case, {"time.end": "0.2 ms"}), tmp_path / "study")

    def one_round() -> Generator[list[dict[str, Any]], Any, list[dict[str, Any]]]:
        rows: list[dict[str, Any]] = yield [{"jet.0.speed": f"{v} m/s"} for v in (7, 8)]
        return rows

    with pytest.warns(RuntimeWarning, match="1 of 2 runs failed"):
        broken, sound = study.search(one_round())
    assert broken["error"] == "broke down" and broken["verdict"] is None
    assert sound["error"] is None and sound["verdict"]


def test_settings_of_the_same_case_share_a_run(case: kerf.Case, tmp_path: Path) -> None:
    study = kerf.Study(
        kerf.replaced(case, {"time.end": "0.5 ms"}), tmp_path / "study", {"depth": depth}, jobs=2
    )
    settings = [
        {"jet.0.speed": "5 m/s"},
        {"jet.0.speed": "5 m/s"},
        {"jet.0.speed": "5000 mm/s"},
        {"jet.jet.speed": "5 m/s"},
    ]
    rows = study.run(settings)
    assert [row["error"] for row in rows] == [None] * 4
    assert len({row["folder"] for row in rows}) == 1
    assert [list(row)[0] for row in rows] == [list(setting)[0] for setting in settings]
    assert len(list((tmp_path / "study" / "runs").glob("*/result.json"))) == 1
    with pytest.raises(ValueError, match="jobs = 0. Allowed: 1"):
        kerf.Study(case, tmp_path / "none", jobs=0)
