# SPDX-License-Identifier: Apache-2.0
"""Studies: those of `kerf study`, and runs that a function of the user chooses."""

from __future__ import annotations

import hashlib
import json
import warnings
from collections.abc import Callable, Generator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from kerf._kerf import Case, KerfError, RunError
from kerf.cases import replaced
from kerf.program import command, program
from kerf.results import Result

Setting = Mapping[str, Any]
Metrics = Mapping[str, Callable[[Result], Any]]


@dataclass(frozen=True)
class StudyResult:
    """The results in the folder of a study of the command `kerf study`."""

    folder: Path

    @property
    def answer(self) -> dict[str, Any]:
        """All numbers of the study, study.json (docs/studies.md)."""
        loaded: dict[str, Any] = json.loads((self.folder / "study.json").read_text("utf-8"))
        return loaded

    def pandas(self) -> Any:
        """Return the runs with their metrics as a `pandas.DataFrame`; the header has the units."""
        import pandas

        return pandas.read_csv(self.folder / "study.csv", float_precision="round_trip")


def study(file: str | Path, out: str | Path, *, jobs: int | None = None) -> StudyResult:
    """Run a study file, or continue it, as `kerf study` does.

    Parameters
    ----------
    file
        The study file (docs/studies.md).
    out
        The folder of the results.
    jobs
        Greatest number of runs at the same time; by default one per core.

    Raises
    ------
    CaseError, RunError, FileError
        With the message of the command.
    """
    at_once = [] if jobs is None else ["--jobs", str(jobs)]
    command("study", file, "--out", out, "--quiet", *at_once)
    return StudyResult(Path(out))


@dataclass
class Study:
    """Runs of a case at settings that the user, or a search of his own, chooses.

    Parameters
    ----------
    case
        The case that the settings change.
    out
        The folder of the study. Each case has one run in it, which is not made again.
    metrics
        Numbers of the results by name: ``{"depth": lambda result: result.metrics["front_depth"]}``.
    jobs
        Runs at the same time, each with one thread.
    """

    case: Case
    out: str | Path
    metrics: Metrics = field(default_factory=dict)
    jobs: int = 1
    rows: list[dict[str, Any]] = field(default_factory=list, init=False)

    def __post_init__(self) -> None:
        if self.jobs < 1:
            raise ValueError(f"jobs = {self.jobs}. Allowed: 1 and above.")

    def run(self, settings: Sequence[Setting]) -> list[dict[str, Any]]:
        """Run the case at settings (`kerf.replaced`) and return a row for each.

        A row holds the setting, the metrics, `verdict`, `folder`, and `error` of a run that
        failed, whose other entries are None. Settings that give the same case share one run. All
        rows so far are in `rows`.

        Raises
        ------
        CaseError
            If a setting gives no valid case; nothing is run then.
        FileError
            If a case has yet to run and there is no command `kerf`; nothing is run then.
        """
        cases = [replaced(self.case, setting) for setting in settings]
        folders = [self._folder(case) for case in cases]
        case_of = dict(zip(folders, cases))
        if not all(_has_finished(folder) for folder in case_of):
            program()
        with ThreadPoolExecutor(self.jobs) as pool:
            outcomes = dict(zip(case_of, pool.map(self._outcome, case_of.values(), case_of)))
        rows = [{**setting, **outcomes[folder]} for setting, folder in zip(settings, folders)]
        self.rows += rows
        return rows

    def search(
        self, strategy: Generator[Sequence[Setting], list[dict[str, Any]], Any]
    ) -> Any:
        """Let a generator choose the settings: it yields them and gets their rows.

        >>> def narrow(low, high):
        ...     while high - low > 0.1:
        ...         third = (high - low) / 3
        ...         speeds = [low + third, high - third]
        ...         rows = yield [{"jet.0.speed": f"{speed} m/s"} for speed in speeds]
        ...         for speed, row in zip(speeds, rows):
        ...             if row["error"]:
        ...                 raise kerf.RunError(row["error"])
        ...             if row["through"]:
        ...                 high = min(high, speed)
        ...             else:
        ...                 low = max(low, speed)
        ...     return high
        >>> Study(case, "out/least", {"through": through}, jobs=2).search(narrow(2, 5))

        A failed run has a row with its `error`, and a warning is given. Where all runs of a round
        have failed, the generator gets a RunError in place of their rows.

        Returns
        -------
        What the generator returns.

        Raises
        ------
        RunError
            If all runs of a round failed, unless the generator catches it.
        """
        try:
            settings = next(strategy)
            while True:
                rows = self.run(settings)
                failure = _failure_of(rows)
                settings = strategy.throw(failure) if failure else strategy.send(rows)
        except StopIteration as end:
            return end.value

    def pandas(self) -> Any:
        """Return all rows so far as a `pandas.DataFrame`."""
        import pandas

        return pandas.DataFrame(self.rows)

    def _folder(self, case: Case) -> Path:
        name = hashlib.sha1(case.used.encode(), usedforsecurity=False).hexdigest()[:15]
        return Path(self.out) / "runs" / name

    def _outcome(self, case: Case, folder: Path) -> dict[str, Any]:
        outcome: dict[str, Any] = {"folder": folder, "verdict": None, "error": None}
        outcome |= {metric: None for metric in self.metrics}
        try:
            result = self._result(case, folder)
        except KerfError as error:
            return outcome | {"error": str(error)}
        values = {metric: value(result) for metric, value in self.metrics.items()}
        return outcome | {"verdict": result.verdict} | values

    @staticmethod
    def _result(case: Case, folder: Path) -> Result:
        if _has_finished(folder):
            return Result(folder)
        folder.parent.mkdir(parents=True, exist_ok=True)
        file = folder.parent / f"{folder.name}.toml"
        file.write_text(case.used, encoding="utf-8")
        goes_on = ["--resume"] if (folder / "checkpoint.h5").is_file() else ["--force"]
        command("run", file, "--out", folder, "--threads", "1", "--quiet", *goes_on)
        return Result(folder)


def _has_finished(folder: Path) -> bool:
    return (folder / "result.json").is_file()


def _failure_of(rows: Sequence[Mapping[str, Any]]) -> RunError | None:
    """Warn of the runs that failed; return an error if all of them did."""
    failed = [row for row in rows if row["error"]]
    if not failed:
        return None
    first = f"{failed[0]['folder']}: {failed[0]['error']}"
    if len(failed) == len(rows):
        return RunError(f"{len(failed)} of {len(rows)} runs of this round of the search failed: {first}")
    warnings.warn(
        f"{len(failed)} of {len(rows)} runs failed, such as {first}", RuntimeWarning, stacklevel=3
    )
    return None
