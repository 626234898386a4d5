#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Follows docs/tutorial.md: writes its files and runs its commands in an empty folder.

scripts/check_tutorial.py KERF
"""
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import urllib.request

FENCE = re.compile(r"^```(\w+)(?: +(\S+))?\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def type_in(program, line, folder):
    words = line.split()
    if words[0] != "kerf":
        sys.exit(f"tutorial.md: \"{line}\" is not a command of kerf")
    ended = subprocess.run([program, *words[1:]], cwd=folder, capture_output=True, text=True)
    if ended.returncode != 0:
        sys.exit(f"tutorial.md: \"{line}\" ended with {ended.returncode}:\n{ended.stderr}")


def view(program, line, folder):
    """Runs a command that serves a page until it is stopped, and requests the page."""
    server = subprocess.Popen([program, *line.split()[1:]], cwd=folder, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    try:
        said = ""
        address = None
        while address is None:
            said += server.stdout.readline()
            if server.poll() is not None:
                sys.exit(f"tutorial.md: \"{line}\" ended:\n{said}")
            address = re.search(r"http://\S+", said)
        with urllib.request.urlopen(address.group(), timeout=30) as page:
            if page.status != 200 or b"<html" not in page.read():
                sys.exit(f"tutorial.md: \"{line}\" serves no page at {address.group()}")
    finally:
        server.send_signal(signal.SIGINT)
        server.wait(30)


def type_page(program, page, folder):
    """Writes the files of the page and runs its commands, those of `sh view` last."""
    lines, views = [], []
    for kind, name, text in FENCE.findall(page.read_text()):
        if kind == "toml":
            (folder / name).write_text(text)
        if kind == "sh":
            (views if name == "view" else lines).extend(text.strip().splitlines())
    for line in lines:
        type_in(program, line, folder)
    for line in views:
        view(program, line, folder)
    if len(lines) < 6 or not views:
        sys.exit(f"tutorial.md: only {len(lines)} commands and {len(views)} views")
    return len(lines) + len(views)


def main():
    page = pathlib.Path(__file__).parent.parent / "docs" / "tutorial.md"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        commands = type_page(sys.argv[1], page, folder)
        result = json.loads((folder / "out/my/result.json").read_text())
        if not result["verdict"] or not (folder / "out/my/report.html").exists():
            sys.exit("tutorial.md: no verdict or no report")
    print(f"{commands} commands run; {result['verdict']}")


if __name__ == "__main__":
    main()
