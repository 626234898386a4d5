# SPDX-License-Identifier: Apache-2.0
"""Runs, step by step."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from types import TracebackType
from typing import Any

from kerf import _kerf
from kerf.results import Result


@dataclass
class _Call:
    """A function that is called during a run."""

    function: Callable[[Run], object]
    interval: float  # s; 0 = after each step
    due: float  # s, the next time


class Run(_kerf.Run):
    """A run of a case; it writes the files that `kerf run` writes, with the same bits.

    Parameters
    ----------
    case : Case
        The case.
    out : path
        The folder of the results; default out/ and the name of the case.
    threads : int
        Threads of all runs of this process; 0 = every core.
    device : "cpu" or "gpu"
        Where the particles are computed.
    resume : bool
        Continue from the last checkpoint in the folder.
    force : bool
        Replace the run in the folder.
    ignore_memory : bool
        Run a case whose estimated memory is more than is free.
    progress : bool
        Show a progress bar with the remaining time.

    Raises
    ------
    FileError
        If the folder holds a run already, or cannot be written.
    CaseError
        If the case cannot be laid out, or needs more memory than is free.

    Used as a context manager it writes a checkpoint at the end of the block, unless it has
    finished, and lets go of the folder, which no other run can use before.
    """

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self._calls: list[_Call] = []

    def every(self, interval: float, function: Callable[[Run], object]) -> None:
        """Call `function(run)` during `step`, `until` and `finish`.

        Parameters
        ----------
        interval
            s; at the first step at or after each multiple of it, as output is written. 0 calls it
            after each step. Calls do not change what is computed.
        function
            A return value is ignored; an exception stops the run, which can then go on.
        """
        interval = _seconds("interval", interval)
        if interval < 0.0 or math.isinf(interval):
            raise ValueError(f"interval = {interval} s. Allowed: 0 and above.")
        if not callable(function):
            raise TypeError(
                f"function = {function!r}. Allowed: a function of the run, such as "
                "lambda run: print(run.time)."
            )
        self._calls.append(_Call(function, interval, self.time))

    def step(self, count: int = 1) -> None:
        """Take a number of time steps, at most up to the end of the run."""
        if not self._calls:
            self._step(count)
            return
        for _ in range(count):
            self._step(1)
            self._notify()

    def until(self, time: float) -> None:
        """Take steps until the time, s, is reached or passed; a step is never shortened for it."""
        time = _seconds("time", time)
        while self.time < time and not self.is_over:
            next_call = min((call.due for call in self._calls), default=time)
            if next_call <= self.time:
                self._step(1)
            else:
                self._until(min(time, next_call))
            self._notify()

    def finish(self) -> Result:
        """Run to the end, write the result and the report, and return the results."""
        if self._calls and not self.is_over:
            self.until(float("inf"))
        self._finish()
        return Result(self.folder)

    def _notify(self) -> None:
        for call in self._calls:
            if call.due > self.time:
                continue
            while call.interval > 0.0 and call.due <= self.time:
                call.due += call.interval
            call.function(self)

    def __enter__(self) -> Run:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if not self.is_over and not isinstance(error, _kerf.RunError):
            self.save()
        self.close()

    def __repr__(self) -> str:
        if not hasattr(self, "_calls"):  # the run could not start
            return "<kerf.Run, not started>"
        if self.is_over:
            return f"<kerf.Run in {self.folder}, over>"
        return (
            f"<kerf.Run in {self.folder}, {1e3 * self.time:.6g} ms, step {self.steps}, "
            f"{self.particles} particles>"
        )

    def _repr_png_(self) -> bytes | None:
        try:
            return self.picture(0.5)
        except _kerf.KerfError:
            return Result(self.folder)._repr_png_()


def _seconds(name: str, value: object) -> float:
    """Return a number of seconds; texts with units stand in cases only."""
    if isinstance(value, str) or not hasattr(value, "__float__"):
        raise TypeError(f"{name} = {value!r}. Allowed: a number of seconds, such as 5e-3 for 5 ms.")
    seconds = float(value)
    if math.isnan(seconds):
        raise ValueError(f"{name} = {seconds} s. Allowed: a number of seconds.")
    return seconds
