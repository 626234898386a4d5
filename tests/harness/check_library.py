#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Installs the C++ library into a temporary folder, builds examples/library/ with it, and compares a run of the
example with one of the command bit for bit. Usage: check_library.py ROOT BUILD KERF
"""
import pathlib
import subprocess
import sys
import tempfile


def call(*command: object) -> None:
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{result.stdout}{result.stderr}")


def main() -> int:
    root, build, kerf = map(pathlib.Path, sys.argv[1:])
    case = root / "tests/web/small_2d.toml"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for component in ("library", "development"):
            call("cmake", "--install", build, "--prefix", folder / "usr", "--component", component)
        call("cmake", "-S", root / "examples/library", "-B", folder / "example", "-G", "Ninja",
             f"-DCMAKE_PREFIX_PATH={folder / 'usr'}", "-DCMAKE_BUILD_TYPE=Debug")
        call("cmake", "--build", folder / "example")
        call(folder / "example/faster_jet", case, "1", folder / "by_example")
        call(kerf, "run", case, "--out", folder / "by_command", "--quiet")
        wrong = [file for file in ("series.csv", "case.used.toml")
                 if (folder / "by_example" / file).read_bytes() != (folder / "by_command" / file).read_bytes()]
    for file in wrong:
        print(f"{file} of the example differs from that of the command")
    print(f"the example was built and run, {len(wrong)} of 2 files differ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
