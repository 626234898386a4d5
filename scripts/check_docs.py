#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the documentation agrees with the tree and the program.

    scripts/check_docs.py links              every file that a page names exists
    scripts/check_docs.py packages           docs/dependencies.md has every package, and no other
    scripts/check_docs.py commands PROGRAM   README.md has every command of the program, and no other
    scripts/check_docs.py --root FOLDER ...  the same for another tree
"""
import argparse
import pathlib
import re
import subprocess
import sys

# Folders whose files a page may name although a run or a build creates them.
MADE = ("out/", "build/", "frames/")
NAMED_FOLDERS = "src|docs|cases|tests|scripts|cmake|benchmarks|validation|experiments|\\.ci"


def pages(root):
    for name in sorted([*root.glob("*.md"), *root.glob("docs/**/*.md")]):
        yield name, name.read_text()


def names_in(text):
    """Yields (target, is_link) of Markdown links and of paths in backquotes outside code blocks."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if not re.match(r"[a-z]+:|#", target):
            yield target.split("#")[0], True
    for target in re.findall(r"`([^`\s]+)`", text):
        is_path = re.match(rf"({NAMED_FOLDERS})/|[\w.-]+/[\w./-]+\.(hpp|cpp|md|toml|py)$", target)
        if is_path and not target.startswith(MADE) and not re.search(r"[<>$]|NAME", target):
            yield target, False


def exists(root, page, target, is_link):
    if is_link:
        return (page.parent / target).exists()
    # A path in running text starts at the root of the tree, or at src/ like an #include.
    return any(
        any(base.glob(spelling))
        for base in (root, root / "src")
        for spelling in expand(target.rstrip("/"))
    )


def expand(target):
    """Expands a/{b,c}.hpp to a/b.hpp and a/c.hpp."""
    braces = re.search(r"\{([^}]*)\}", target)
    if not braces:
        return [target]
    return [target.replace(braces.group(), choice) for choice in braces.group(1).split(",")]


def check_links(root):
    seen = 0
    for page, text in pages(root):
        for target, is_link in names_in(text):
            seen += 1
            if not exists(root, page, target, is_link):
                yield f"{page.relative_to(root)}: names {target}, which does not exist"
    if not seen:
        yield "no page names any file"


def differences(expected, found, where):
    for name in sorted(expected - found):
        yield f"{where} lacks {name}"
    for name in sorted(found - expected):
        yield f"{where} has {name}, which does not exist"


def check_packages(root):
    lines = (root / "scripts/packages.txt").read_text().splitlines()
    packages = {line for line in lines if re.match(r"[a-z0-9]", line)}
    table = (root / "docs/dependencies.md").read_text()
    rows = re.findall(r"^\|([^|]*)\|", table, flags=re.MULTILINE)
    documented = {name for row in rows for name in re.findall(r"`([^`]+)`", row)}
    yield from differences(packages, documented, "docs/dependencies.md")


def check_commands(root, program):
    text = subprocess.run([program, "--help"], check=True, capture_output=True, text=True).stdout
    listed = text[text.index("Subcommands:") :].splitlines()[1:]
    commands = {line.split()[0] for line in listed if re.match(r"  \w", line)}
    readme = (root / "README.md").read_text()
    documented = set(re.findall(r"^\| `kerf (\w+)", readme, flags=re.MULTILINE))
    yield from differences(commands, documented, "the table of commands of README.md")


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("what", choices=["links", "packages", "commands"])
    arguments.add_argument("program", nargs="?")
    arguments.add_argument("--root", type=pathlib.Path,
                           default=pathlib.Path(__file__).resolve().parent.parent)
    options = arguments.parse_args()
    if options.what == "commands":
        problems = list(check_commands(options.root, options.program))
    else:
        check = {"links": check_links, "packages": check_packages}[options.what]
        problems = list(check(options.root))
    print("\n".join(problems) or "no problem found")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
