#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A second source for the values that reference.toml takes from Turek & Hron (2006).

The beam is a chain of extensible links with springs at their joints, a beam with finite rotations and
stretches but without shear. Plane strain: E' = E / (1 - nu^2). The script computes it at rest, by damping, and after release.
"""

import numpy as np

DENSITY, YOUNGS_MODULUS, POISSON_RATIO, GRAVITY = 1000.0, 1.4e6, 0.4, 2.0
LENGTH, HEIGHT = 0.35, 0.02  # m
MODULUS = YOUNGS_MODULUS / (1.0 - POISSON_RATIO**2)
STRETCHING, BENDING = MODULUS * HEIGHT, MODULUS * HEIGHT**3 / 12.0


def forces(place, link):
    """Returns the forces on the nodes behind the clamped one; place: positions of all nodes."""
    run = np.diff(place, axis=0)
    length = np.hypot(run[:, 0], run[:, 1])
    along = run / length[:, None]
    angle = np.arctan2(run[:, 1], run[:, 0])
    bend = np.diff(angle)
    moment = np.zeros(len(run))  # derivative of the energy by the angle of each link
    moment[1:] += BENDING / link * bend
    moment[:-1] -= BENDING / link * bend
    moment[0] += 2.0 * BENDING / link * angle[0]  # half a link to the clamp
    across = np.stack([-along[:, 1], along[:, 0]], axis=1)
    pull = STRETCHING * (length / link - 1.0)[:, None] * along + (moment / length)[:, None] * across
    result = -pull
    result[:-1] += pull[1:]
    return result


def motion(links, end, damping=0.0):
    """Returns the times and the displacements of the tip."""
    link = LENGTH / links
    mass = np.full((links, 1), DENSITY * HEIGHT * link)
    mass[-1] *= 0.5
    place = np.stack([np.linspace(0.0, LENGTH, links + 1), np.zeros(links + 1)], axis=1)
    start = place[-1].copy()
    speed = np.zeros((links, 2))
    step = 0.4 * link / np.sqrt(MODULUS / DENSITY)
    step = min(step, 0.2 * link**2 / np.sqrt(BENDING / (DENSITY * HEIGHT)))
    weight = np.array([0.0, -GRAVITY])
    times, tips = [], []
    for n in range(round(end / step)):
        place[1:] += 0.5 * step * speed
        speed += step * (forces(place, link) / mass + weight - damping * speed)
        place[1:] += 0.5 * step * speed
        times.append((n + 1) * step)
        tips.append(place[-1] - start)
    return np.array(times), np.array(tips)


if __name__ == "__main__":
    for links in (20, 40):
        tip = motion(links, 4.0, damping=8.0)[1][-1]
        print(f"{links} links: at rest ({1e3 * tip[0]:.3f}, {1e3 * tip[1]:.2f}) mm")
        times, tips = motion(links, 3.0)
        y = tips[:, 1]
        low = [n for n in range(1, len(y) - 1) if y[n] < -0.1 and y[n - 1] > y[n] <= y[n + 1]]
        rate = np.diff(y)
        turns = [times[n] for n in range(1, len(rate)) if rate[n - 1] < 0.0 <= rate[n] and y[n] < -0.1]
        high = [times[n] for n in range(1, len(rate)) if rate[n - 1] > 0.0 >= rate[n] and y[n] > -0.02]
        print(
            f"{links} links: released, y from {1e3 * y.min():.2f} to {1e3 * y.max():.2f} mm,"
            f" x from {1e3 * tips[:, 0].min():.2f}; lowest at {turns}, highest at {high} s"
        )
