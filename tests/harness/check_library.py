#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Installs the C++ library into a temporary folder, builds examples/library/ with it, and compares a run of the
example with one of the command bit for bit. Usage: check_library.py ROOT BUILD KERF
"""
import pathlib
import sys
import tempfile

from calls import output_of


def main() -> int:
    root, build, kerf = map(pathlib.Path, sys.argv[1:])
    case = root / "tests/web/small_2d.toml"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for component in ("library", "development"):
            output_of("cmake", "--install", build, "--prefix", folder / "usr", "--component", component)
        output_of("cmake", "-S", root / "examples/library", "-B", folder / "example", "-G", "Ninja",
                  f"-DCMAKE_PREFIX_PATH={folder / 'usr'}", "-DCMAKE_BUILD_TYPE=Debug")
        output_of("cmake", "--build", folder / "example")
        output_of(folder / "example/faster_jet", case, "1", folder / "by_example")
        output_of(kerf, "run", case, "--out", folder / "by_command", "--quiet")
        wrong = [file for file in ("series.csv", "case.used.toml")
                 if (folder / "by_example" / file).read_bytes() != (folder / "by_command" / file).read_bytes()]
    for file in wrong:
        print(f"{file} of the example differs from that of the command")
    print(f"the example was built and run, {len(wrong)} of 2 files differ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
