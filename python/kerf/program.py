# SPDX-License-Identifier: Apache-2.0
"""The command `kerf`, which studies use."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

from kerf._kerf import CaseError, FileError, KerfError, RunError

_errors = {1: CaseError, 3: RunError, 4: FileError}


def program() -> Path:
    """Return the path of the command `kerf`.

    It is the one that the environment variable KERF_PROGRAM names, the one of the same build or
    package, or the one on the PATH.

    Raises
    ------
    FileError
        If there is none.
    """
    folder = Path(__file__).parent
    if "KERF_PROGRAM" in os.environ:
        named = shutil.which(os.environ["KERF_PROGRAM"])
        if named is None:
            raise FileError(
                f"KERF_PROGRAM = {os.environ['KERF_PROGRAM']}: there is no such program; name the "
                "command kerf by its path, or remove the variable"
            )
        return Path(named)
    build = Path(os.path.abspath(folder)).parents[1]
    for path in (folder / "bin" / "kerf", build / "kerf"):
        if path.is_file() and os.access(path, os.X_OK):
            return path
    found = shutil.which("kerf")
    if found is None:
        raise FileError("there is no command kerf; put it on the PATH, or name it by KERF_PROGRAM")
    return Path(found)


def command(*arguments: str | os.PathLike[str]) -> str:
    """Run `kerf` with these arguments and return what it prints.

    Raises
    ------
    KerfError
        With the message of the command, as CaseError, RunError or FileError by its exit code.
    """
    done = subprocess.run(
        [program(), *arguments], capture_output=True, encoding="utf-8", check=False
    )
    if done.returncode != 0:
        message = done.stderr.strip().removeprefix("kerf: error: ") or (
            f"kerf {arguments[0]} ended by the signal {-done.returncode}"
            if done.returncode < 0
            else f"kerf {arguments[0]} ended with the code {done.returncode} and no message"
        )
        raise _errors.get(done.returncode, KerfError)(message)
    return done.stdout


def main() -> None:
    """Become the command `kerf`: the script that a wheel installs."""
    path = program()
    os.execv(path, [str(path), *sys.argv[1:]])
