#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The falling cube of water of water.toml in PySPH (Debian's python3-pysph), on one thread.

Usage: water_pysph.py STEPS

It has the same particles, support (2 h = 2.6 mm), kernel, sound speed and time step, and uses the scheme of PySPH
for weakly compressible water with one pair loop per step. It prints the figures of the last STEPS
steps as JSON; the time excludes compilation and the first steps.
"""
import importlib.metadata
import json
import sys
import tempfile
import time

import numpy
from pysph.base.kernels import WendlandQuintic
from pysph.base.utils import get_particle_array_wcsph
from pysph.solver.application import Application
from pysph.sph.scheme import WCSPHScheme

SIDE = 57  # particles
SPACING = 1e-3  # m
SMOOTHING = 1.3  # of a spacing
DENSITY = 1000.0  # kg/m3
TIME_STEP = 1.547619e-5  # s
WARM_UP = 3  # steps


class Cube(Application):
    """A cube of water at 1 m/s that records the end of each step."""

    def __init__(self, steps: int, folder: str):
        self.steps = steps
        self.ends = []
        super().__init__(output_dir=folder)

    def create_scheme(self) -> WCSPHScheme:
        return WCSPHScheme(["water"], [], dim=3, rho0=DENSITY, c0=20.0, h0=SMOOTHING * SPACING,
                           hdx=SMOOTHING, gamma=7.0, alpha=0.1, beta=0.0)

    def configure_scheme(self):
        self.scheme.configure_solver(kernel=WendlandQuintic(dim=3), dt=TIME_STEP,
                                     tf=(self.steps + 0.5) * TIME_STEP)

    def create_particles(self) -> list:
        along = (numpy.arange(SIDE) + 0.5) * SPACING
        x, y, z = (grid.ravel() for grid in numpy.meshgrid(along, along, along, indexing="ij"))
        water = get_particle_array_wcsph(name="water", x=x, y=y, z=z, m=DENSITY * SPACING**3,
                                         h=SMOOTHING * SPACING, rho=DENSITY)
        water.v[:] = -1.0
        self.scheme.setup_properties([water])
        return [water]

    def post_step(self, solver):
        self.ends.append(time.perf_counter())

    def neighbours(self) -> float:
        """Returns the neighbours per particle without itself: the mean over every 50th particle."""
        from cyarray.api import UIntArray
        found = UIntArray()
        counts = []
        for index in range(0, SIDE**3, 50):
            self.nnps.get_nearest_particles(0, 0, index, found)
            counts.append(found.length - 1)
        return float(numpy.mean(counts))


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__)
        return 2
    steps = int(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        cube = Cube(WARM_UP + steps, folder)
        cube.run(["--no-openmp", "--disable-output", "--quiet", f"--max-steps={WARM_UP + steps}"])
        seconds = cube.ends[-1] - cube.ends[-1 - steps]
        print(json.dumps({"version": importlib.metadata.version("pysph"), "particles": SIDE**3,
                          "steps": steps, "particle_steps_per_second": steps * SIDE**3 / seconds,
                          "neighbours_per_particle": cube.neighbours()}))
    return 0


if __name__ == "__main__":
    sys.exit(main())
