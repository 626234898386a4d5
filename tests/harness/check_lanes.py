#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Functions in the object files of src/lanes/ that the linker could take for those of other files.

What one of these files compiles for AVX2 or AVX-512 must run from its own walks only: a function of
the same name in a file for any processor may be dropped in favour of it, and the program would end
with an illegal instruction elsewhere. Usage: check_lanes.py NM LIBRARY
"""
import re
import subprocess
import sys


def shared_symbols(nm: str, library: str) -> tuple[int, list[str]]:
    """How many symbols the walks define, and those that are not theirs alone."""
    listing = subprocess.run([nm, "-C", "-A", "--defined-only", library], check=True,
                             capture_output=True, text=True).stdout
    found, shared = 0, []
    for line in listing.splitlines():
        place = re.search(r"walks_(avx2|avx512)\.cpp\.o:\S* (\w) (.*)$", line)
        if not place:
            continue
        variant, kind, name = place.groups()
        found += 1
        if kind not in "TWuV" or name.startswith("DW.ref."):
            continue
        if f"kerf::lanes::{variant}::" not in name:
            shared.append(f"{variant}: {kind} {name}")
    return found, shared


def main() -> int:
    found, shared = shared_symbols(sys.argv[1], sys.argv[2])
    for line in shared:
        print(line)
    print(f"{found} symbols, {len(shared)} of them not of their own")
    return 1 if shared or found == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
