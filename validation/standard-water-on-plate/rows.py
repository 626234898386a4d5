#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Computes the deflection of the clamped plate of case.toml for N rows of particles.

The energy of the total Lagrangian scheme for small displacements, by ../standard-plate/lattice.py, of half
of the plate with its clamp; the water's weight on the uppermost row.  Needs numpy: python3 rows.py
"""

import pathlib
import sys

import numpy as np

import plate

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "standard-plate"))
import lattice


def bonds_of(column, row, rows, half):
    """Returns the bonds of one particle; columns below 0 are clamped, those from `half` on are mirror images."""
    bonds = []
    for a, b, weight in lattice.NEAR:
        if not 0 <= row + b < rows:
            continue
        u = [{}, {}]
        for x, y, sign in ((column + a, row + b, 1.0), (column, row, -1.0)):
            if x < 0:
                continue
            place = (x if x < half else 2 * half - 1 - x) * rows + y
            for c in (0, 1):
                factor = -sign if c == 0 and x >= half else sign
                u[c][2 * place + c] = u[c].get(2 * place + c, 0.0) + factor
        bonds.append((a, b, weight, u))
    return bonds


def deflection(rows):
    spacing = plate.HEIGHT / rows
    half = round(0.5 * plate.LENGTH / spacing)
    matrix, load = np.zeros((2 * half * rows, 2 * half * rows)), np.zeros(2 * half * rows)
    for column in range(-3, half):
        for row in range(rows):
            bonds = bonds_of(column, row, rows, half)
            if any(factors for bond in bonds for factors in bond[3]):
                dofs, own = lattice.energy(bonds, plate.E, plate.NU)
                matrix[np.ix_(dofs, dofs)] += own.real
            if column >= 0:
                load[2 * (column * rows + row) + 1] -= plate.RHO_PLATE * plate.G * spacing**2
        if column >= 0:
            load[2 * (column * rows + rows - 1) + 1] -= plate.PRESSURE * spacing
    return -np.linalg.solve(matrix, load)[1::2][-rows:].mean()


if __name__ == "__main__":
    for rows in (4, 8, 16):
        print(f"{rows:2} rows  {1e6 * deflection(rows):.2f} um")
