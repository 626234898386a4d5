# SPDX-License-Identifier: Apache-2.0
"""Kerf, a simulator of water-jet cutting by smoothed particle hydrodynamics (SPH), in Python.

>>> import kerf
>>> case = kerf.Case(kerf.templates()["tofu-5ms-standard"], "tofu.toml")
>>> with kerf.Run(case, "out/tofu") as run:
...     run.until(5e-3)  # s
...     speed = run.view("velocity")  # m/s, a NumPy array without a copy
...     del speed
...     result = run.finish()
>>> result.verdict

All quantities are in SI units. The bits of a run are those of the command `kerf run`.
"""

from kerf._kerf import (
    Case,
    CaseError,
    FileError,
    Frame,
    KerfError,
    RunError,
    __version__,
    templates,
)
from kerf.cases import replaced
from kerf.frames import to_pyvista, to_vtk
from kerf.program import command, program
from kerf.results import Result
from kerf.runs import Run
from kerf.studies import Study, StudyResult, study

__all__ = [
    "Case",
    "CaseError",
    "FileError",
    "Frame",
    "KerfError",
    "Result",
    "Run",
    "RunError",
    "Study",
    "StudyResult",
    "__version__",
    "command",
    "program",
    "replaced",
    "study",
    "templates",
    "to_pyvista",
    "to_vtk",
]
