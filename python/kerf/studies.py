# SPDX-License-Identifier: Apache-2.0
"""Studies: those of `kerf study`, and runs that a function of the user chooses."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Generator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from kerf._kerf import Case, FileError, RunError
from kerf.cases import replaced
from kerf.program import command
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

    def run(self, settings: Sequence[Setting]) -> list[dict[str, Any]]:
        """Run the case at settings (`kerf.replaced`) and return a row for each.

        A row holds the setting, the metrics, `verdict`, `folder`, and `error` of a run that
        failed, whose other entries are None. All rows so far are in `rows`.

        Raises
        ------
        CaseError
            If a setting gives no valid case; nothing is run then.
        """
        cases = [replaced(self.case, setting) for setting in settings]
        with ThreadPoolExecutor(self.jobs) as pool:
            rows = list(pool.map(self._row, settings, cases))
        self.rows += rows
        return rows

    def search(
        self, strategy: Generator[Sequence[Setting], list[dict[str, Any]], Any]
    ) -> Any:
        """Let a generator choose the settings: it yields them and gets their rows.

        >>> def bisect(low, high):
        ...     while high - low > 0.1:
        ...         middle = (low + high) / 2
        ...         [row] = yield [{"jet.0.speed": f"{middle} m/s"}]
        ...         low, high = (low, middle) if row["through"] else (middle, high)
        ...     return high
        >>> Study(case, "out/least", {"through": through}).search(bisect(2, 5))

        Returns
        -------
        What the generator returns.
        """
        try:
            settings = next(strategy)
            while True:
                settings = strategy.send(self.run(settings))
        except StopIteration as end:
            return end.value

    def pandas(self) -> Any:
        """Return all rows so far as a `pandas.DataFrame`."""
        import pandas

        return pandas.DataFrame(self.rows)

    def _row(self, setting: Setting, case: Case) -> dict[str, Any]:
        name = hashlib.sha1(case.used.encode(), usedforsecurity=False).hexdigest()[:15]
        folder = Path(self.out) / "runs" / name
        row: dict[str, Any] = {**setting, "folder": folder, "verdict": None, "error": None}
        row |= {metric: None for metric in self.metrics}
        try:
            result = self._result(case, folder)
        except (RunError, FileError) as error:
            return row | {"error": str(error)}
        values = {metric: value(result) for metric, value in self.metrics.items()}
        return row | {"verdict": result.verdict} | values

    @staticmethod
    def _result(case: Case, folder: Path) -> Result:
        if (folder / "result.json").is_file():
            return Result(folder)
        folder.parent.mkdir(parents=True, exist_ok=True)
        file = folder.parent / f"{folder.name}.toml"
        file.write_text(case.used, encoding="utf-8")
        goes_on = ["--resume"] if (folder / "checkpoint.h5").is_file() else ["--force"]
        command("run", file, "--out", folder, "--threads", "1", "--quiet", *goes_on)
        return Result(folder)
