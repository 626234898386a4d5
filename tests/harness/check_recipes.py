#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Applies the recipes of CONTRIBUTING.md to a copy of the tree, builds it and runs cases.

With --apply-only it builds nothing: the edits find their lines, and CONTRIBUTING.md shows them.

A folder tests/recipes/NAME/ is one recipe, "To add ...". Its folder `files` holds the new files, as they
lie in the tree; its `edits.toml` the lines that go into files that are there already:
    [[edit]]
    file = "src/..."
    after = "the line to insert after, without its indentation"     (or its beginning and "...")
    insert = "the new line"
or, where a line is changed, `line` and `with`. CONTRIBUTING.md shows every new line. `most_edits` is how many such
lines the recipe may take. The cases of tests/recipes/cases/ use what the recipes add, and tests/recipes/expected.toml
says what must come out of them. Usage: check_recipes.py ROOT FOLDER [--apply-only] [CMAKE_ARGUMENT...]
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tomllib


def copy_tree(root: pathlib.Path, tree: pathlib.Path) -> None:
    """Copies what a build needs. Files that did not change keep their time, so that ninja rests."""
    for name in ("CMakeLists.txt", "LICENSE", "README.md", "cmake", "src", "cases", "examples", "materials",
                 "experiments", "validation", "web"):
        source = root / name
        files = [source] if source.is_file() else [f for f in source.rglob("*") if f.is_file()]
        for file in files:
            if "node_modules" in file.parts:
                continue
            to = tree / file.relative_to(root)
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(file, to)


def place_of(lines: list[str], wanted: str) -> list[int]:
    """The numbers of the lines that are `wanted`, or begin with it where it ends with "..."."""
    wanted = wanted.strip()
    if wanted.endswith("..."):
        return [n for n, line in enumerate(lines) if line.strip().startswith(wanted[:-3])]
    return [n for n, line in enumerate(lines) if line.strip() == wanted]


def change(file: pathlib.Path, edit: dict) -> str:
    """Makes one edit with the indentation of the line that is there; returns what is wrong."""
    lines = file.read_text(encoding="utf8").split("\n")
    wanted = edit["line"] if "line" in edit else edit["after"]
    places = place_of(lines, wanted)
    if len(places) != 1:
        return f"{file}: {len(places)} lines are {wanted!r}, not one"
    at = places[0]
    indentation = lines[at][:len(lines[at]) - len(lines[at].lstrip())]
    if "line" in edit:
        lines[at] = indentation + edit["with"].strip()
    else:
        lines.insert(at + 1, indentation + edit["insert"].strip())
    file.write_text("\n".join(lines), encoding="utf8")
    return ""


def apply(recipe: pathlib.Path, tree: pathlib.Path, guide: str) -> list[str]:
    """Applies one recipe to the tree; returns what is wrong with it."""
    description = tomllib.loads((recipe / "edits.toml").read_text(encoding="utf8"))
    edits, wrong = description.get("edit", []), []
    if len(edits) > description["most_edits"]:
        wrong.append(f"{recipe.name}: {len(edits)} edited lines, {description['most_edits']} allowed")
    for edit in edits:
        problem = change(tree / edit["file"], edit)
        wrong += [f"{recipe.name}: {problem}"] if problem else []
        new = (edit["with"] if "line" in edit else edit["insert"]).strip()
        if new not in guide:
            wrong.append(f"{recipe.name}: CONTRIBUTING.md does not show {new!r}")
    for file in (recipe / "files").rglob("*"):
        if file.is_file():
            to = tree / file.relative_to(recipe / "files")
            if to.exists():
                wrong.append(f"{recipe.name}: {to.relative_to(tree)} is in the tree already")
                continue
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(file, to)
            if str(file.relative_to(recipe / "files").parent) not in guide:
                wrong.append(f"{recipe.name}: CONTRIBUTING.md does not name the folder of {file.name}")
    return wrong


def run(*command: str, folder: str | None = None) -> str:
    done = subprocess.run(command, check=False, capture_output=True, text=True, cwd=folder)
    if done.returncode != 0:
        print(done.stdout[-8000:], done.stderr[-8000:], sep="\n")
        sys.exit(f"{' '.join(command[:4])} ...: exit code {done.returncode}")
    return done.stdout


def value_of(result: dict, path: str):
    for part in path.split("."):
        result = result[int(part)] if isinstance(result, list) else result[part]
    return result


def check_number(row: dict, results: dict) -> str:
    """Compares a number of a result with its value, or with that of another case."""
    found = value_of(results[row["case"]], row["path"])
    due = row["value"] if "value" in row else value_of(results[row["other_case"]], row["path"])
    apart = abs(found - due) / max(abs(due), 1e-300)
    if apart > row.get("tolerance", float("inf")):
        return f"{row['case']}: {row['path']} = {found}, expected {due} within {row['tolerance']}"
    if apart < row.get("least_difference", 0.0):
        return f"{row['case']}: {row['path']} = {found}, should differ from {due}"
    return ""


def check_results(recipes: pathlib.Path, out: pathlib.Path) -> list[str]:
    """Compares what the cases gave with expected.toml."""
    expected = tomllib.loads((recipes / "expected.toml").read_text(encoding="utf8"))
    results = {folder.name: json.loads((folder / "result.json").read_text(encoding="utf8"))
               for folder in out.iterdir()}
    wrong = [problem for row in expected["number"] if (problem := check_number(row, results))]
    for row in expected["text"]:
        files = sorted((out / row["case"]).glob(row["file"]))
        if not files or row["text"].encode() not in files[-1].read_bytes():
            wrong.append(f"{row['case']}/{row['file']} does not hold {row['text']!r}")
    return wrong


def main() -> int:
    apply_only = "--apply-only" in sys.argv
    if apply_only:
        sys.argv.remove("--apply-only")
    root, work = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    recipes, tree, build = root / "tests/recipes", work / "tree", work / "build"
    shutil.rmtree(tree, ignore_errors=True)
    copy_tree(root, tree)
    guide = (root / "CONTRIBUTING.md").read_text(encoding="utf8")
    applied = sorted(file.parent for file in recipes.glob("*/edits.toml"))
    wrong = [line for recipe in applied for line in apply(recipe, tree, guide)]
    if not wrong and not apply_only:
        # Without precompiled headers the compiler also finds an #include that a recipe lacks.
        run("cmake", "-S", str(tree), "-B", str(build), "-G", "Ninja", "-DKERF_TESTS=OFF",
            "-DKERF_ENGINES=standard_2d_mixed", "-DCMAKE_BUILD_TYPE=Release",
            "-DCMAKE_CXX_FLAGS_RELEASE=-O1", "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON", *sys.argv[3:])
        run("cmake", "--build", str(build), "--parallel", str(os.cpu_count()), "--target", "kerf")
        out = work / "out"
        shutil.rmtree(out, ignore_errors=True)
        for case in sorted((recipes / "cases").glob("*.toml")):
            run(str(build / "kerf"), "run", str(case), "--out", str(out / case.stem))
        wrong = check_results(recipes, out)
    print(*wrong, f"{len(applied)} recipes, {len(wrong)} faults", sep="\n")
    return 1 if wrong or len(applied) < 3 else 0


if __name__ == "__main__":
    sys.exit(main())
