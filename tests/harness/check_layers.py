#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the folders of src/ are layers: no file includes a file of a higher folder.

The order is KERF_LAYERS of cmake/KerfLayers.cmake; docs/flow.md shows the same order in the block
below its heading "Layers". Usage: check_layers.py [ROOT]
"""
import pathlib
import re
import sys


def layers_of_build(root: pathlib.Path) -> list[str]:
    text = (root / "cmake/KerfLayers.cmake").read_text(encoding="utf8")
    return re.search(r"set\(KERF_LAYERS([^)]*)\)", text).group(1).split()


def layers_of_docs(root: pathlib.Path) -> list[str]:
    text = (root / "docs/flow.md").read_text(encoding="utf8")
    block = re.search(r"## Layers\n.*?```\n(.*?)```", text, re.DOTALL)
    return block.group(1).split() if block else []


def wrong_includes(root: pathlib.Path, layers: list[str]) -> list[str]:
    """Returns one line for each include of a higher folder and for each folder that is not a layer."""
    source = root / "src"
    height = {name: number for number, name in enumerate(layers)}
    wrong = []
    for file in sorted(source.rglob("*")):
        if file.suffix not in (".hpp", ".cpp", ".in"):
            continue
        own = file.relative_to(source).parts[0]
        if own not in height:
            wrong.append(f"{file.relative_to(root)}: src/{own}/ is not in KERF_LAYERS")
            continue
        for included in re.findall(r'^\s*#include "([^"]+)"', file.read_text(encoding="utf8"),
                                   re.MULTILINE):
            other = included.split("/")[0]
            if (source / included).exists() and height[other] > height[own]:
                wrong.append(f"{file.relative_to(root)}: includes {included} of a higher layer")
    return wrong


def main() -> int:
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    root = root if root.is_dir() else root.parents[2]
    layers = layers_of_build(root)
    wrong = wrong_includes(root, layers)
    missing = [name for name in layers if not (root / "src" / name).is_dir()]
    wrong += [f"KERF_LAYERS names {name}, which is not a folder of src/" for name in missing]
    if layers_of_docs(root) != layers:
        wrong.append("docs/flow.md: the block below \"## Layers\" is not KERF_LAYERS")
    print(*wrong, f"{len(layers)} layers, {len(wrong)} faults", sep="\n")
    return 1 if wrong or not layers else 0


if __name__ == "__main__":
    sys.exit(main())
