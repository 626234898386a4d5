# SPDX-License-Identifier: Apache-2.0
"""Calls of other programs, for the checks of this folder."""
import subprocess
import sys


def output_of(*command: object) -> str:
    """Returns what a command prints; ends this program with its output where it fails."""
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{result.stdout}{result.stderr}")
    return result.stdout
