#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Types docs/tutorial.md: writes its files and runs its commands in an empty folder.

scripts/check_tutorial.py KERF
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

FENCE = re.compile(r"^```(\w+)(?: +(\S+))?\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def type_in(program, line, folder):
    words = line.split()
    if words[0] != "kerf":
        sys.exit(f"tutorial.md: \"{line}\" is no command of kerf")
    ended = subprocess.run([program, *words[1:]], cwd=folder, capture_output=True, text=True)
    if ended.returncode != 0:
        sys.exit(f"tutorial.md: \"{line}\" ended with {ended.returncode}:\n{ended.stderr}")


def main():
    page = pathlib.Path(__file__).parent.parent / "docs" / "tutorial.md"
    commands = 0
    with tempfile.TemporaryDirectory() as folder:
        for kind, name, text in FENCE.findall(page.read_text()):
            if kind == "toml":
                (pathlib.Path(folder) / name).write_text(text)
            for line in text.strip().splitlines() if kind == "sh" else []:
                type_in(sys.argv[1], line, folder)
                commands += 1
        result = json.loads((pathlib.Path(folder) / "out/my/result.json").read_text())
        if not result["verdict"] or not (pathlib.Path(folder) / "out/my/report.html").exists():
            sys.exit("tutorial.md: no verdict or no report")
    if commands < 3:
        sys.exit(f"tutorial.md: only {commands} commands")
    print(f"{commands} commands run; {result['verdict']}")


if __name__ == "__main__":
    main()
