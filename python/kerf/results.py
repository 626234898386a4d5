# SPDX-License-Identifier: Apache-2.0
"""The results of a run, read from its folder."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kerf._kerf import Case, FileError, Frame, frame_files, read_frame


class Result:
    """The results in the folder of a run; files are read when they are asked for.

    Parameters
    ----------
    folder
        The folder that the run wrote.

    Raises
    ------
    FileError
        If there is no run of Kerf in it.
    """

    def __init__(self, folder: str | Path) -> None:
        self.folder = Path(folder)
        if not (self.folder / "case.used.toml").is_file():
            raise FileError(f"{self.folder} contains no run of Kerf (there is no case.used.toml)")

    @property
    def case(self) -> Case:
        """The complete case that ran."""
        return Case.read(self.folder / "case.used.toml")

    @property
    def metrics(self) -> dict[str, Any]:
        """All numbers of the result in SI units, as docs/metrics.md defines them."""
        file = self.folder / "result.json"
        if not file.is_file():
            raise FileError(f"{self.folder} has no result.json yet: the run has not finished")
        loaded: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
        return loaded

    @property
    def verdict(self) -> str:
        """One sentence: whether and when the jet cut through, and how deep."""
        return str(self.metrics["verdict"])

    @property
    def series(self) -> dict[str, NDArray[np.float64]]:
        """The quantities of series.csv over time by the names of their columns.

        Columns of words, such as the limit of the time step, are left out.
        """
        with (self.folder / "series.csv").open(encoding="utf-8", newline="") as file:
            names, *rows = csv.reader(file)
        columns = {}
        for name, *values in zip(names, *rows):
            try:
                columns[name] = np.array([float(value or "nan") for value in values])
            except ValueError:
                continue
        return columns

    def pandas(self) -> Any:
        """Return series.csv as a `pandas.DataFrame`; pandas must be installed."""
        import pandas

        return pandas.read_csv(self.folder / "series.csv", float_precision="round_trip")

    @property
    def times(self) -> NDArray[np.float64]:
        """The times of the frames, s."""
        return np.array([time for _, time in frame_files(self.folder)])

    def frame(self, index: int) -> Frame:
        """Return a frame by its index; -1 is the last."""
        return self._read(frame_files(self.folder)[index])

    @property
    def frames(self) -> Iterator[Frame]:
        """The frames in the order of time, each read when it is reached."""
        return (self._read(file) for file in frame_files(self.folder))

    def _read(self, file: tuple[Path, float]) -> Frame:
        return read_frame(file[0], self.case.dimension)

    def __repr__(self) -> str:
        done = (self.folder / "result.json").is_file()
        return f"<kerf.Result {self.folder}: {self.verdict if done else 'not finished'}>"

    def _repr_png_(self) -> bytes | None:
        pictures = sorted((self.folder / "pictures").glob("*.png"))
        return pictures[-1].read_bytes() if pictures else None
