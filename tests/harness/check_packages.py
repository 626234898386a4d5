#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the Debian packages of a build in a temporary folder. Every package must be free of errors and warnings of
lintian, and every link of the installed pages must lead to an installed file. Usage: check_packages.py BUILD
"""
import pathlib
import shutil
import sys
import tempfile

from calls import output_of

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from check_docs import names_in

PACKAGES = {"kerf", "libkerf0", "libkerf-dev", "python3-kerf"}
# Files of the source tree that Debian has elsewhere or not at all.
NOT_INSTALLED = {"CHANGELOG.md", "LICENSE", "web/README.md", "examples/library/faster_jet.cpp"}
SKIPPED = 77


def broken_links(folder: pathlib.Path) -> list[str]:
    """Returns the links of the pages to files that are not there, and that the package should have."""
    found = []
    for page in sorted(folder.rglob("*.md")):
        for target, is_link in names_in(page.read_text()):
            is_due = is_link and target.removeprefix("../") not in NOT_INSTALLED
            if is_due and not (page.parent / target).exists():
                found.append(f"{page.relative_to(folder)} of the package links to {target}, which it does not have")
    return found


def main() -> int:
    if not shutil.which("lintian") or not shutil.which("dpkg-deb"):
        print("lintian is not installed")
        return SKIPPED
    build = pathlib.Path(sys.argv[1])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        output_of("cpack", "-G", "DEB", "--config", build / "CPackConfig.cmake", "-B", folder, "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip",
                  "-D", "CPACK_DEBIAN_PACKAGE_MAINTAINER=A Packager <packager@example.org>")
        packages = sorted(folder.glob("*.deb"))
        names = {package.name.split("_")[0] for package in packages}
        problems = [f"there is no package {missing}" for missing in PACKAGES - names]
        problems += [f"lintian: {line}" for line in
                     output_of("lintian", "--allow-root", "--fail-on", "none", *packages).splitlines()
                     if line.startswith(("E:", "W:"))]
        output_of("dpkg-deb", "-x", next(folder.glob("kerf_*.deb")), folder / "root")
        problems += broken_links(folder / "root/usr/share/doc/kerf")
    for problem in problems:
        print(problem)
    print(f"{len(packages)} packages, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
