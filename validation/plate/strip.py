#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Computes the periods of the clamped plate that reference.toml compares with.

The continuum: the first mode of a clamped beam by Timoshenko's equations, in plane strain.

N rows of particles: small waves in an infinite strip of particles on a square lattice, with the strain and
the force of the scheme, whose sums are truncated at the two faces. The strain of particle i is
sum_j V (u_j - u_i) grad_i W_ij; the force (sigma_i + sigma_j) / (rho_i rho_j) is the derivative of
the energy of these strains, so a wave u(y) exp(i k x) is an eigenvector of a matrix of 2 N rows. The
period of the continuum is scaled by the frequency of that wave over the continuum's, at the wave
number of the mode.
"""

from cmath import exp
import pathlib
import sys
from math import hypot, pi, sqrt

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from elimination import solved

DENSITY = 1000.0  # kg/m3
YOUNGS_MODULUS = 2.0e6  # Pa
POISSON_RATIO = 0.3975
LENGTH, HEIGHT = 0.2, 0.02  # m
WAVE_NUMBER = 1.875104 / LENGTH  # 1/m, of the first mode
SHEAR_FACTOR = 5.0 / 6.0

SHEAR_MODULUS = YOUNGS_MODULUS / (2.0 * (1.0 + POISSON_RATIO))
LAME = 2.0 * SHEAR_MODULUS * POISSON_RATIO / (1.0 - 2.0 * POISSON_RATIO)
BENDING = YOUNGS_MODULUS / (1.0 - POISSON_RATIO**2) * HEIGHT**3 / 12.0  # N m, per depth
SHEAR = SHEAR_FACTOR * SHEAR_MODULUS * HEIGHT  # N/m
MASS, INERTIA = DENSITY * HEIGHT, DENSITY * HEIGHT**3 / 12.0  # of a unit of length


def thin_period():
    return 2.0 * pi / (WAVE_NUMBER**2 * sqrt(BENDING / MASS))


def tip_determinant(omega, steps=400):
    """Returns 0 if a clamped start (deflection = rotation = 0) can end without moment and shear force."""

    def rates(state):
        deflection, turn, moment, force = state
        return (
            turn + force / SHEAR,
            moment / BENDING,
            -force - INERTIA * omega**2 * turn,
            -MASS * omega**2 * deflection,
        )

    def shifted(state, rate, step):
        return [s + step * r for s, r in zip(state, rate)]

    ends = []
    for state in ([0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]):
        dx = LENGTH / steps
        for _ in range(steps):
            first = rates(state)
            second = rates(shifted(state, first, dx / 2.0))
            third = rates(shifted(state, second, dx / 2.0))
            fourth = rates(shifted(state, third, dx))
            mean = [(a + 2.0 * b + 2.0 * c + d) / 6.0 for a, b, c, d in zip(first, second, third, fourth)]
            state = shifted(state, mean, dx)
        ends.append(state)
    return ends[0][2] * ends[1][3] - ends[0][3] * ends[1][2]


def timoshenko_period():
    low, high = 0.5 * 2.0 * pi / thin_period(), 1.2 * 2.0 * pi / thin_period()
    assert tip_determinant(low) * tip_determinant(high) < 0.0
    for _ in range(50):
        middle = 0.5 * (low + high)
        if tip_determinant(low) * tip_determinant(middle) > 0.0:
            low = middle
        else:
            high = middle
    return 2.0 * pi / low


def timoshenko_wave():
    """Returns the frequency of a wave in an infinite beam, 1/s."""
    k2 = WAVE_NUMBER**2
    a = INERTIA * MASS / SHEAR
    b = MASS + k2 * (INERTIA + BENDING * MASS / SHEAR)
    c = BENDING * k2**2
    return sqrt((b - sqrt(b * b - 4.0 * a * c)) / (2.0 * a))


def kernel_slope(s):
    """Returns h^3 dW/dr of the cubic spline in 2D."""
    return 15.0 / (7.0 * pi) * (2.0 * max(1.0 - s, 0.0) ** 2 - max(2.0 - s, 0.0) ** 2 / 2.0)


def strain_of_row(row, rows, ratio=1.5):
    """Returns the strains (xx, yy, xy twice) of a particle as sums over (i u_x, u_y) of all rows, which are real."""
    spacing = HEIGHT / rows
    strain = [[0.0] * (2 * rows) for _ in range(3)]
    reach = int(2.0 * ratio)
    for a in range(-reach, reach + 1):
        for b in range(-reach, reach + 1):
            distance = hypot(a, b)
            if distance == 0.0 or not 0 <= row + b < rows:
                continue
            slope = kernel_slope(distance / ratio) / (ratio**3 * spacing * distance)
            phase = exp(1j * WAVE_NUMBER * a * spacing)
            for other, factor in ((row + b, phase), (row, -1.0 + 0.0j)):
                # In the sum over a and -a only the odd part of an x-slope and the even part of a y-slope remain.
                strain[0][2 * other] += a * slope * factor.imag
                strain[1][2 * other + 1] += b * slope * factor.real
                strain[2][2 * other] += b * slope * factor.real
                strain[2][2 * other + 1] -= a * slope * factor.imag
    return strain


def stiffness(rows):
    """Returns the matrix K of K u = rho omega^2 u."""
    size = 2 * rows
    result = [[0.0] * size for _ in range(size)]
    for row in range(rows):
        xx, yy, xy = strain_of_row(row, rows)
        for m in range(size):
            stress_xx = (LAME + 2.0 * SHEAR_MODULUS) * xx[m] + LAME * yy[m]
            stress_yy = LAME * xx[m] + (LAME + 2.0 * SHEAR_MODULUS) * yy[m]
            stress_xy = SHEAR_MODULUS * xy[m]
            for n in range(size):
                result[m][n] += stress_xx * xx[n] + stress_yy * yy[n] + stress_xy * xy[n]
    return result


def strip_wave(rows):
    """Returns the frequency of the bending wave of a strip of particles, 1/s, by Rayleigh quotient iteration."""
    matrix = stiffness(rows)
    shape = []
    for row in range(rows):
        y = ((row + 0.5) / rows - 0.5) * HEIGHT
        shape += [WAVE_NUMBER * y, 1.0]  # plane sections, at right angles to the axis
    for _ in range(6):
        product = [sum(k * u for k, u in zip(line, shape)) for line in matrix]
        quotient = sum(u * f for u, f in zip(shape, product)) / sum(u * u for u in shape)
        shifted = [line[:] for line in matrix]
        for r in range(2 * rows):
            shifted[r][r] -= quotient * (1.0 - 1e-9)
        shape = solved(shifted, shape)
        size = sqrt(sum(u * u for u in shape))
        shape = [u / size for u in shape]
    bending = sum(u * u for u in shape[1::2])
    assert bending > 0.9, "this is no bending wave"
    return sqrt(quotient / DENSITY)


if __name__ == "__main__":
    period = timoshenko_period()
    print(f"thin plate              {thin_period():.4f} s")
    print(f"with shear and turning  {period:.4f} s")
    for rows in (5, 10, 20, 40):
        print(f"{rows:2} rows of particles    {period * timoshenko_wave() / strip_wave(rows):.4f} s")
