# SPDX-License-Identifier: Apache-2.0
"""Runs in Python: the same bits and files as the command, and what can be seen between steps."""

import signal
import threading
from pathlib import Path

import numpy as np
import pytest

import kerf


def run_by_command(case: kerf.Case, folder: Path) -> kerf.Result:
    file = folder.parent / "small.toml"
    file.write_text(case.text, encoding="utf-8")
    kerf.command("run", file, "--out", folder, "--quiet")
    return kerf.Result(folder)


def test_same_bits_as_the_command(case: kerf.Case, tmp_path: Path) -> None:
    run = kerf.Run(case, tmp_path / "python")
    run.step(7)
    run.until(1.3e-3)
    here, there = run.finish(), run_by_command(case, tmp_path / "command")
    assert (here.folder / "series.csv").read_bytes() == (there.folder / "series.csv").read_bytes()
    assert here.verdict == there.verdict
    assert here.metrics["kerf"] == there.metrics["kerf"]
    last, other = here.frame(-1), there.frame(-1)
    assert last.keys() == other.keys()
    for name in last.keys():
        np.testing.assert_array_equal(last[name], other[name])
    assert (here.folder / "report.html").is_file()


def test_a_pause_changes_nothing(case: kerf.Case, tmp_path: Path) -> None:
    whole = kerf.Run(case, tmp_path / "whole").finish()
    with kerf.Run(case, tmp_path / "parts", threads=1) as run:
        run.until(1e-3)
    resumed = kerf.Run(case, tmp_path / "parts", resume=True, threads=2)
    assert resumed.time >= 1e-3
    parts = resumed.finish()
    assert (whole.folder / "series.csv").read_bytes() == (parts.folder / "series.csv").read_bytes()


def test_steps_and_times(case: kerf.Case, tmp_path: Path) -> None:
    run = kerf.Run(case, tmp_path / "run")
    assert (run.steps, run.time, run.is_over) == (0, 0.0, False)
    run.step(3)
    assert run.steps == 3
    dt = run.last_step["dt"]
    run.step()
    assert run.steps == 4 and dt > 0.0
    run.until(1e-3)
    assert 1e-3 <= run.time < 1e-3 + 10 * run.last_step["dt"]
    run.until(1.0)
    assert run.is_over
    assert run.time == pytest.approx(case.end)


def test_views_share_the_memory_of_the_run(case: kerf.Case, tmp_path: Path) -> None:
    run = kerf.Run(case, tmp_path / "run")
    run.until(1e-3)
    assert run.fields["position"] == (run.particles, 2)
    position, again = run.view("position"), run.view("position")
    assert position.shape == (run.particles, 2) and position.dtype == np.float64
    assert np.shares_memory(position, again)
    with pytest.raises(ValueError, match="read-only"):
        position[0, 0] = 0.0
    frame = run.frame()
    here, there = np.argsort(run.view("id")), np.argsort(frame["id"])
    np.testing.assert_array_equal(position[here], frame["position"][there][:, :2])
    np.testing.assert_array_equal(run.view("velocity")[here], frame["velocity"][there][:, :2])
    np.testing.assert_array_equal(run.view("pressure")[here], frame["pressure"][there])
    with pytest.raises(BufferError, match="copy"):
        run.step()
    part = position[:3]
    del position, again
    with pytest.raises(BufferError):
        run.step()  # a slice holds the memory as well
    del part
    run.step()
    with pytest.raises(KeyError, match="no field"):
        run.view("temperature")


def test_frames_own_their_columns(case: kerf.Case, tmp_path: Path) -> None:
    run = kerf.Run(case, tmp_path / "run")
    frame = run.frame()
    velocity = frame["velocity"]
    assert np.shares_memory(velocity, frame["velocity"])
    before = velocity.copy()
    run.step(50)
    del frame
    np.testing.assert_array_equal(velocity, before)
    assert run.frame().units["velocity"] == "m/s"
    assert "velocity" in run.frame() and "temperature" not in run.frame()


def test_balance_closes_and_is_that_of_the_particles(case: kerf.Case, tmp_path: Path) -> None:
    run = kerf.Run(case, tmp_path / "run")
    run.until(2e-3)
    frame, balance = run.frame(), run.balance()
    energy = 0.5 * np.sum(frame["mass"] * np.sum(frame["velocity"] ** 2, axis=1))
    assert balance["kinetic"] == pytest.approx(energy, rel=1e-5)
    assert balance["mass_now"] == pytest.approx(np.sum(frame["mass"], dtype=float), rel=1e-5)
    assert abs(balance["energy_drift"]) < 0.01
    assert len(run.probe_values) == 4
    assert run.metrics()["verdict"].startswith("The ")


def test_calls_come_at_their_times(case: kerf.Case, tmp_path: Path) -> None:
    run = kerf.Run(case, tmp_path / "run")
    times: list[float] = []
    steps: list[int] = []
    run.every(0.5e-3, lambda now: times.append(now.time))
    run.every(0.0, lambda now: steps.append(now.steps))
    run.step(2)
    result = run.finish()
    assert steps == list(range(1, result.metrics["steps"] + 1))
    due = np.arange(len(times)) * 0.5e-3
    assert len(times) == 7
    assert np.all(np.array(times) >= due - 1e-12)
    assert np.all(np.array(times) < due + 1e-4)
    with pytest.raises(ValueError, match="interval"):
        kerf.Run(case, tmp_path / "other").every(-1.0, print)


def test_times_are_numbers_and_calls_functions(case: kerf.Case, tmp_path: Path) -> None:
    run = kerf.Run(case, tmp_path / "run")
    with pytest.raises(TypeError, match="5 ms.*number of seconds, such as 5e-3"):
        run.until("5 ms")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="time = nan"):
        run.until(float("nan"))
    with pytest.raises(ValueError, match="interval = nan"):
        run.every(float("nan"), print)
    with pytest.raises(TypeError, match="function = 3"):
        run.every(1e-3, 3)  # type: ignore[arg-type]
    run.until(np.float64(1e-4))  # type: ignore[arg-type]
    assert run.time >= 1e-4
    with pytest.raises(kerf.KerfError, match="threads = -1. Allowed: 0"):
        kerf.Run(case, tmp_path / "other", threads=-1)


def test_an_exception_in_a_call_stops_between_steps(case: kerf.Case, tmp_path: Path) -> None:
    run = kerf.Run(case, tmp_path / "run")

    def fail(now: kerf.Run) -> None:
        if now.steps == 5:
            raise ZeroDivisionError

    run.every(0.0, fail)
    with pytest.raises(ZeroDivisionError):
        run.until(1e-3)
    assert run.steps == 5
    run.step()
    assert run.steps == 6


def test_ctrl_c_stops_between_steps(case: kerf.Case, tmp_path: Path) -> None:
    run = kerf.Run(kerf.replaced(case, {"time.end": "10 s"}), tmp_path / "run", threads=1)
    timer = threading.Timer(0.5, signal.raise_signal, [signal.SIGINT])
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        run.until(10.0)
    timer.join()
    run.save()
    assert (Path(run.folder) / "checkpoint.h5").is_file()


def test_a_folder_with_a_run_is_refused(case: kerf.Case, tmp_path: Path) -> None:
    run = kerf.Run(case, tmp_path / "run")
    run.finish()
    with pytest.raises(kerf.KerfError, match="finished"):
        run.step()
    with pytest.raises(kerf.FileError, match="contains a run already"):
        kerf.Run(case, tmp_path / "run")
    assert kerf.Run(case, tmp_path / "run", force=True).steps == 0


def test_a_run_beyond_the_memory_is_refused(tmp_path: Path) -> None:
    block = {
        "name": "block",
        "material": "tofu",
        "spacing": "1 cm",
        "shape": {
            "type": "box",
            "minimum": ["-10 m", "0 m", "-10 m"],
            "maximum": ["10 m", "1 m", "10 m"],
        },
    }
    case = kerf.Case({"title": "A large block", "dimension": 3, "time": {"end": "1 ms"}, "body": [block]})
    with pytest.raises(kerf.CaseError, match="memory.*ignore_memory=True"):
        kerf.Run(case, tmp_path / "large")


def test_pictures(case: kerf.Case, tmp_path: Path) -> None:
    run = kerf.Run(case, tmp_path / "run")
    small, full = run.picture(0.25), run.picture()
    assert small.startswith(b"\x89PNG") and full.startswith(b"\x89PNG")
    assert len(small) < len(full)
    assert (run._repr_png_() or b"").startswith(b"\x89PNG")
    assert "step 0" in repr(run)
