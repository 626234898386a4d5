#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Computes the pressure of a column of perfect rows of particles at rest by the sums of the scheme.

Row i sinks by u_i. Continuity gives p_i = - rho c^2 sum_k w_k (u_k - u_i) over the existing rows, where
w_k is the slope of the kernel summed along a row, and the pressure forces are its transpose: B^T p = rho g.
The repulsion holds the lowest row, whatever its strength, so every u except that of the lowest row
follows from the others; neither c nor D changes p.
"""

import pathlib
import sys
from math import hypot, pi, sqrt

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from elimination import solved

RATIO = 1.5  # h / d
WEIGHT, HEIGHT = 1000.0 * 9.81, 0.05  # rho g in N/m3, m


def kernel_slope(s):
    """Returns h^3 dW/dr of the cubic spline in 2D."""
    return 15.0 / (7.0 * pi) * (2.0 * max(1.0 - s, 0.0) ** 2 - max(2.0 - s, 0.0) ** 2 / 2.0)


def row_slope(k):
    """Returns the spacing times the vertical slope of the kernel, summed along a row k rows away."""
    distances = [hypot(a, k) for a in range(-3, 4)]
    return -sum(kernel_slope(r / RATIO) * k / r for r in distances) / RATIO**3


def divergence(rows):
    """Returns B, which gives the divergence in each row from the displacements of the rows, in 1/spacing."""
    result = [[0.0] * rows for _ in range(rows)]
    for i in range(rows):
        for k in (-2, -1, 1, 2):
            if 0 <= i + k < rows:
                result[i][i + k] += row_slope(k)
                result[i][i] -= row_slope(k)
    return result


def pressures(rows):
    b = divergence(rows)
    sunk = range(1, rows)  # against the lowest row
    stiffness = [[sum(b[i][m] * b[i][n] for i in range(rows)) for n in sunk] for m in sunk]
    u = [0.0] + solved(stiffness, [-1.0] * (rows - 1))
    scale = WEIGHT * HEIGHT / rows
    return [-scale * sum(x * y for x, y in zip(line, u)) for line in b]


def distance(rows, first, layer):
    """Returns the relative L2 distance from rho g (H - y), from row `first` up, in layers of several rows."""
    p = pressures(rows)
    error = scale = 0.0
    for lowest in range(first, rows, layer):
        inside = range(lowest, min(lowest + layer, rows))
        expected = WEIGHT * HEIGHT * (1.0 - (inside[0] + inside[-1] + 1) / 2.0 / rows)
        error += (sum(p[i] for i in inside) / len(inside) - expected) ** 2
        scale += expected**2
    return sqrt(error / scale)


if __name__ == "__main__":
    for rows in (10, 25, 50):
        lowest = ", ".join(f"{p / (WEIGHT * HEIGHT):.2f}" for p in pressures(rows)[:4])
        print(f"{rows} rows: lowest rows {lowest} rho g H; distance from rho g (H - y):")
        for layer in (1, 2):
            whole, off = (100.0 * distance(rows, first, layer) for first in (0, 4))
            print(f"  layers of {layer}: {whole:.1f}% to the floor, {off:.1f}% from the fifth row up")
