#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds functions in the SIMD libraries that the linker could use in place of those of other files.

Only kernels of the same instruction set may call code that is compiled for AVX2 or AVX-512. The
linker could otherwise replace a function of the same name that was compiled for any processor, and
the program would stop with an illegal instruction on other processors. Usage: check_simd.py NM LIBRARY...
"""
import re
import subprocess
import sys


def shared_symbols(nm: str, library: str) -> tuple[int, list[str]]:
    """Returns the number of symbols that a library defines, and those that other files may share."""
    variant = re.search(r"kerf_simd_(\w+)\.a$", library).group(1)
    listing = subprocess.run([nm, "-C", "-A", "--defined-only", library], check=True,
                             capture_output=True, text=True).stdout
    found, shared = 0, []
    for line in listing.splitlines():
        place = re.search(r"\.cpp\.o:\S* (\w) (.*)$", line)
        if not place:
            continue
        kind, name = place.groups()
        found += 1
        if kind not in "TWuV" or name.startswith("DW.ref."):
            continue
        if f"kerf::simd::{variant}::" not in name:
            shared.append(f"{variant}: {kind} {name}")
    return found, shared


def main() -> int:
    failed = len(sys.argv) < 3
    for library in sys.argv[2:]:
        found, shared = shared_symbols(sys.argv[1], library)
        print(*shared, f"{library}: {found} symbols, {len(shared)} of them not its own", sep="\n")
        failed = failed or bool(shared) or found == 0
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
