#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Computes the periods of the clamped plate that reference.toml compares with.

The continuum: Timoshenko's equations in plane strain, by ../plate/strip.py.

Rows of particles: the energy of the total Lagrangian scheme for small displacements,

    sum_i V psi(H_i) + mu / 2 sum_ij w_ij |H_i R - u_ij|^2,    H_i = (sum_j w_ij u_ij (x) R) M_i^-1,
    M_i = sum_j w_ij R (x) R,    w_ij = V^2 |W'(R)| / R,    W: Wendland C2, h = 1.3 spacings,

written here independently as a matrix, for a wave u(y) exp(i k x) in an infinite strip of N rows and for the
plate with its clamp. The lowest eigenvalue is the square of the frequency. The largest eigenvalue of all waves
determines the stable time step of a leap-frog method.
"""

import pathlib
import sys
from math import hypot, pi, sqrt

import numpy as np

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "plate"))
import strip as plate

YOUNGS_MODULUS, POISSON_RATIO, DENSITY = plate.YOUNGS_MODULUS, plate.POISSON_RATIO, plate.DENSITY
RATIO, ZETA = 1.3, 0.5  # h / spacing; hourglass control


def weight(distance):
    """Returns |W'(r)| / r up to a factor that cancels in every sum or is part of CONTROL; r in spacings."""
    q = distance / RATIO
    return 7.0 / (4.0 * pi * RATIO**4) * 5.0 * (1.0 - 0.5 * q) ** 3 if q < 2.0 else 0.0


NEAR = [
    (a, b, weight(hypot(a, b)))
    for a in range(-3, 4)
    for b in range(-3, 4)
    if (a, b) != (0, 0) and hypot(a, b) < 2.0 * RATIO
]


def energy(bonds, modulus=YOUNGS_MODULUS, ratio=POISSON_RATIO):
    """Returns the degrees of freedom and the matrix of one particle. bonds: (a, b, w, u_ij as {dof: factor} for x, y)."""
    shear = modulus / (2.0 * (1.0 + ratio))
    lame = 2.0 * shear * ratio / (1.0 - 2.0 * ratio)
    dofs = sorted({dof for bond in bonds for row in bond[3] for dof in row})
    place = {dof: n for n, dof in enumerate(dofs)}
    spread = np.zeros((len(bonds), 2, len(dofs)), complex)
    for n, bond in enumerate(bonds):
        for c in (0, 1):
            for dof, factor in bond[3][c].items():
                spread[n, c, place[dof]] += factor
    lengths = np.array([bond[:2] for bond in bonds], float)
    weights = np.array([bond[2] for bond in bonds])
    inverse = np.linalg.inv(np.einsum("n,na,nb->ab", weights, lengths, lengths))
    gradient = np.einsum("n,ncd,na,ab->cbd", weights, spread, lengths, inverse)  # H[c, b] per dof
    xx, yy, xy = gradient[0, 0], gradient[1, 1], gradient[0, 1] + gradient[1, 0]
    gap = np.einsum("cbd,nb->ncd", gradient, lengths) - spread
    own = (lame + 2.0 * shear) * (np.outer(xx.conj(), xx) + np.outer(yy.conj(), yy))
    own += lame * (np.outer(xx.conj(), yy) + np.outer(yy.conj(), xx)) + shear * np.outer(xy.conj(), xy)
    own += ZETA * modulus * np.einsum("n,ncd,nce->de", weights, gap.conj(), gap)
    return dofs, own


def strip_matrix(rows, wave, modulus=YOUNGS_MODULUS, ratio=POISSON_RATIO, periodic=False):
    """Returns the stiffness over density and spacing squared; wave: wave number times spacing."""
    matrix = np.zeros((2 * rows, 2 * rows), complex)
    for row in range(rows):
        bonds = []
        for a, b, w in NEAR:
            other = row + b
            if periodic:
                other %= rows
            elif not 0 <= other < rows:
                continue
            phase = np.exp(1j * wave * a)
            u = [{}, {}]
            for c in (0, 1):
                u[c][2 * other + c] = u[c].get(2 * other + c, 0.0) + phase
                u[c][2 * row + c] = u[c].get(2 * row + c, 0.0) - 1.0
            bonds.append((a, b, w, u))
        dofs, own = energy(bonds, modulus, ratio)
        matrix[np.ix_(dofs, dofs)] += own
    return matrix / DENSITY


def strip_frequency(rows, wave_number=plate.WAVE_NUMBER, height=plate.HEIGHT):
    spacing = height / rows
    values = np.linalg.eigvalsh(strip_matrix(rows, wave_number * spacing))
    return sqrt(values[0]) / spacing


def plate_frequency(rows, length=plate.LENGTH, height=plate.HEIGHT, clamp=0.02, **material):
    """Returns the matrix of the plate with a clamp whose particles do not move."""
    spacing = height / rows
    free, held = round(length / spacing), round(clamp / spacing)
    matrix = np.zeros((2 * free * rows, 2 * free * rows))
    for column in range(-min(held, 3), free):
        for row in range(rows):
            bonds = []
            for a, b, w in NEAR:
                if not (-held <= column + a < free and 0 <= row + b < rows):
                    continue
                u = [{}, {}]
                for c in (0, 1):
                    if column + a >= 0:
                        u[c][2 * ((column + a) * rows + row + b) + c] = 1.0
                    if column >= 0:
                        u[c][2 * (column * rows + row) + c] = -1.0
                bonds.append((a, b, w, u))
            if any(factors for bond in bonds for factors in bond[3]):
                dofs, own = energy(bonds, **material)
                matrix[np.ix_(dofs, dofs)] += own.real
    return sqrt(lowest(matrix / DENSITY)) / spacing


def lowest(matrix):
    """Returns the smallest eigenvalue, by inverse iteration."""
    factor = np.linalg.inv(matrix)
    shape = np.ones(len(matrix))
    for _ in range(60):
        shape = factor @ shape
        shape /= np.linalg.norm(shape)
    return shape @ matrix @ shape


def largest_step(modulus=YOUNGS_MODULUS, ratio=POISSON_RATIO):
    """Returns the stable time step of a leap-frog method, times the longitudinal speed over the spacing."""
    top = 0.0
    for wave in np.linspace(0.0, pi, 13):
        top = max(top, np.linalg.eigvalsh(strip_matrix(16, wave, modulus, ratio))[-1])
        top = max(top, np.linalg.eigvalsh(strip_matrix(16, wave, modulus, ratio, True))[-1])
    speed = sqrt(modulus * (1.0 - ratio) / ((1.0 + ratio) * (1.0 - 2.0 * ratio)) / DENSITY)
    return 2.0 / sqrt(top) * speed


if __name__ == "__main__":
    period, wave = plate.timoshenko_period(), plate.timoshenko_wave()
    print(f"with shear and turning  {period:.4f} s")
    for rows in (5, 10, 20, 40):
        print(f"{rows:2} rows, strip          {period * wave / strip_frequency(rows):.4f} s")
    for rows in (5, 10):
        print(f"{rows:2} rows, plate and clamp {2.0 * pi / plate_frequency(rows):.4f} s")
    print(f"largest time step       {largest_step():.3f} spacing / c_p")
