#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the checkers on faulty and on correct input, and fails unless they report the faults."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

HARNESS = pathlib.Path(__file__).resolve().parent
SCRIPTS = HARNESS.parent.parent / "scripts"

LONG_FUNCTION = "int f(int a) {\n" + "  ++a;\n" * 60 + "  return a;\n}\n"
MANY_ARGUMENTS = "int f(int a, int b, int c, int d, int e, int g, int h) { return a; }\n"
DEEP = "int f(int a) {\n  if (a)\n    for (;;)\n      while (a)\n        if (a > 1) return 1;\n}\n"
ELSE_IF = "int f(int a) {\n" + "  if (a) return 1; else" * 5 + " return 2;\n}\n"
EXCUSED = "// budget: nesting: four loops of one stencil\n" + DEEP
PYTHON_DEEP = (
    "def f(a):\n    if a:\n        for b in a:\n            while b:\n                if b:\n"
    "                    return\n"
)

# (file, text, whether it is within the budgets)
BUDGETS = [
    ("long_file.cpp", "int a;\n" * 301, False),
    ("longest_file.cpp", "int a;\n" * 300, True),
    ("long_function.cpp", LONG_FUNCTION, False),
    ("arguments.hpp", MANY_ARGUMENTS, False),
    ("deep.cpp", DEEP, False),
    ("excused.cpp", EXCUSED, True),
    ("else_if.cpp", ELSE_IF, True),
    ("deep.py", PYTHON_DEEP, False),
]

# (pages and files of a tree, which check, whether the tree is correct)
DOCUMENTS = [
    ({"README.md": "[a](docs/a.md)", "docs/a.md": "`src/b.hpp`", "src/b.hpp": ""}, "links", True),
    ({"README.md": "[a](docs/missing.md)"}, "links", False),
    ({"README.md": "[a](#here) see `src/missing.hpp`"}, "links", False),
    ({"README.md": "nothing"}, "links", False),
    ({"scripts/packages.txt": "# c\n[build]\ng++\n", "docs/dependencies.md": "| `g++` | x |\n"},
     "packages", True),
    ({"scripts/packages.txt": "[build]\ng++\ncmake\n", "docs/dependencies.md": "| `g++` | x |\n"},
     "packages", False),
    ({"scripts/packages.txt": "[build]\n", "docs/dependencies.md": "| `g++` | x |\n"},
     "packages", False),
]

# (pages of a site, whether they are correct)
SITES = [
    ({"a.html": '<a href="b/c.html#there">', "b/c.html": '<h2 id="there"><a href="../a.html">'}, True),
    ({"a.html": '<a href="https://example.org/x#y"><img src="a.png">', "a.png": ""}, True),
    ({"a.html": '<a href="missing.html">'}, False),
    ({"a.html": '<a href="#missing">'}, False),
    ({"a.html": '<a href="b.html#missing">', "b.html": '<h2 id="there">'}, False),
    ({"a.html": '<img src="missing.png">'}, False),
    ({"a.html": '<script src="https://example.org/x.js"></script>'}, False),
    ({"a.txt": "no page"}, False),
]

ONE_NAME = "namespace kerf {\nstruct A { int a; };\n}\n"
OTHER_TYPE = "namespace kerf {\n\nenum class A { one, two };\n}\n"
FORWARD = "namespace kerf {\nstruct A;\nenum class E : int;\n}\n"
NESTED = "namespace kerf {\nstruct B {\n  struct A {};\n};\n}\n"
SPECIAL = "namespace kerf {\ntemplate <>\nstruct A<int> {};\n}\n"
HIDDEN = "namespace kerf {\nnamespace {\nstruct A {};\nint f() {\n  return 1;\n}\n}\n}\n"
HIDDEN_FUNCTION = "namespace kerf {\nnamespace {\nint f() {\n  return 2;\n}\n}\n}\n"
MACROS = "namespace {\nTEST(A, B) {\n}\n}\n"
OWN_NAMESPACE = HIDDEN_FUNCTION.replace("kerf {", "kerf::b_test {")

# (files of a tree, the two places that the report names; none = the tree is correct)
NAMES = [
    ({"src/a/a.hpp": ONE_NAME, "src/b/b.hpp": OTHER_TYPE}, ["src/a/a.hpp:2", "src/b/b.hpp:3"]),
    ({"src/a/a.hpp": ONE_NAME, "src/b/b.cpp": OTHER_TYPE}, ["src/a/a.hpp:2", "src/b/b.cpp:3"]),
    ({"src/a/a.hpp": NESTED, "src/b/b.hpp": NESTED}, ["src/a/a.hpp:2", "src/b/b.hpp:2"]),
    ({"src/a/a.hpp": ONE_NAME, "src/b/b.hpp": FORWARD, "src/b/c.hpp": FORWARD}, []),
    ({"src/a/a.hpp": ONE_NAME, "src/b/b.hpp": NESTED}, []),
    ({"src/a/a.hpp": SPECIAL, "src/b/b.hpp": SPECIAL.replace("int", "long")}, []),
    ({"src/a/a.cpp": HIDDEN, "src/b/b.cpp": HIDDEN}, []),
    ({"src/a/a.hpp": ONE_NAME, "tests/b/b.hpp": OTHER_TYPE}, ["src/a/a.hpp:2", "tests/b/b.hpp:3"]),
    ({"tests/a/a.hpp": ONE_NAME, "tests/b/b.hpp": OTHER_TYPE}, []),
    ({"tests/a/a.cpp": HIDDEN, "tests/a/b.cpp": HIDDEN_FUNCTION}, ["a/a.cpp:4", "a/b.cpp:3"]),
    ({"tests/a/a.cpp": HIDDEN, "tests/b/b.cpp": HIDDEN}, []),
    ({"tests/a/a.cpp": HIDDEN, "tests/a/b.cpp": OWN_NAMESPACE}, []),
    ({"tests/a/a.cpp": MACROS, "tests/a/b.cpp": MACROS}, []),
]


def agrees(command, in_order, label, words=()):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    right = done.returncode == (0 if in_order else 1) and all(word in done.stdout for word in words)
    if not right:
        print(f"{label}: expected {'no ' if in_order else 'a '}complaint, status "
              f"{done.returncode}:\n{done.stdout}{done.stderr}")
    return right


def write(folder, name, text):
    path = pathlib.Path(folder) / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    return path


def check_budgets():
    with tempfile.TemporaryDirectory() as folder:
        for name, text, in_order in BUDGETS:
            path = write(folder, name, text)
            yield agrees([SCRIPTS / "check_budgets.py", path], in_order, name)


def check_documents():
    for number, (files, what, in_order) in enumerate(DOCUMENTS):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                write(folder, name, text)
            command = [SCRIPTS / "check_docs.py", what, "--root", folder]
            yield agrees(command, in_order, f"document {number}")


def check_sites():
    for number, (files, in_order) in enumerate(SITES):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                write(folder, name, text)
            yield agrees([SCRIPTS / "check_site.py", folder], in_order, f"site {number}")


def check_names():
    for number, (files, places) in enumerate(NAMES):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                write(folder, name, text)
            command = [HARNESS / "check_names.py", folder]
            yield agrees([sys.executable, *command], not places, f"names {number}", places)


if __name__ == "__main__":
    if not shutil.which("ctags"):
        print("Universal Ctags is not installed: skipped")
        sys.exit(77)
    sys.exit(0 if all([*check_budgets(), *check_documents(), *check_names(),
                          *check_sites()]) else 1)
