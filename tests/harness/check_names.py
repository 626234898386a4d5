#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that no two files of one program define the same name. Usage: check_names.py [ROOT]

Two different types of one qualified name violate the one-definition rule, which neither the compiler
nor the linker reports: a program may then use the members of the one in an object of the other. The
check applies to the types of src/, of tests/support/ and of each folder of tests/. Anonymous
namespaces separate the names of the files of src/; specialisations and declarations do not count.

The files of a test folder may be compiled as one (UNITY_BUILD in tests/CMakeLists.txt), which joins
their anonymous namespaces. So the types, functions and variables in these differ too; operators do by what
they take.
"""
import collections
import itertools
import json
import pathlib
import re
import shutil
import subprocess
import sys

SKIPPED = 77
SUFFIXES = {".cpp", ".hpp", ".cuh", ".cu"}
TYPES = {"struct", "class", "enum", "union"}
REMEDY = "rename one, or define it once in a header that both files include"


def program_of(path: pathlib.Path) -> str:
    """Returns the test folder whose program alone contains the file; "" = every program may."""
    is_shared = path.parts[0] == "src" or path.parts[:2] == ("tests", "support")
    return "" if is_shared else path.parent.as_posix()


def entries_of(root: pathlib.Path) -> list[dict]:
    """Returns what ctags says of each type, function and variable of src/ and tests/."""
    files = [file.relative_to(root).as_posix() for folder in ("src", "tests")
             for file in sorted((root / folder).rglob("*")) if file.suffix in SUFFIXES]
    listing = subprocess.run(
        ["ctags", "--options=NONE", "--quiet", "--language-force=C++", "--kinds-C++=scgufv",
         "--fields=+neKZs", "--fields-C++=+{specialization}", "--output-format=json",
         "-I", "KERF_FUNCTION", "-f", "-", "-L", "-"],
        input="\n".join(files), cwd=root, check=True, capture_output=True, text=True)
    return [json.loads(line) for line in listing.stdout.splitlines()]


def name_of(entry: dict) -> str:
    """Returns the qualified name of a definition that must be the only one; "" = none."""
    name, kind, scope = entry["name"], entry["kind"], entry.get("scope", "")
    around = {"namespace"} | TYPES if kind in TYPES else {"namespace"}
    is_macro = kind == "function" and name.isupper()  # such as TEST of GoogleTest
    if name.startswith(("__anon", "operator ")) or is_macro or entry.get("scopeKind", "namespace") not in around:
        return ""
    if "specialization" in entry:
        return ""
    is_anonymous = "__anon" in scope
    is_test = entry["path"].startswith("tests/") and entry["path"].endswith(".cpp")
    if is_anonymous and not is_test or not is_anonymous and kind not in TYPES:
        return ""
    return re.sub(r"__anon\w+", "(anonymous)", f"{scope}::{name}" if scope else name)


def repeated_names(entries: list[dict]) -> list[str]:
    """Returns one line for each file that defines a name of another file of its program."""
    places = collections.defaultdict(dict)
    for entry in entries:
        if name := name_of(entry):
            places[name].setdefault(pathlib.Path(entry["path"]), entry["line"])
    wrong = {}  # by file and name
    for name, lines in places.items():
        for other, path in itertools.combinations(sorted(lines), 2):
            if len({program_of(path), program_of(other)} - {""}) <= 1:
                wrong.setdefault((path, name), f"{path}:{lines[path]}: {name} is also defined in "
                                               f"{other}:{lines[other]}: {REMEDY}")
    return list(wrong.values())


def main() -> int:
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    root = root if root.is_dir() else root.parents[2]
    if not shutil.which("ctags"):
        print("Universal Ctags is not installed: skipped")
        return SKIPPED
    entries = entries_of(root)
    wrong = repeated_names(entries)
    print(*wrong, f"{len(entries)} definitions, {len(wrong)} defined twice", sep="\n")
    return 1 if wrong or not entries else 0


if __name__ == "__main__":
    sys.exit(main())
