# SPDX-License-Identifier: Apache-2.0
"""Computes the Taylor bar by another method: finite elements of a body of revolution.

Quadrilaterals with one point of integration in the current configuration, von Mises flow with
linear hardening by radial return on Jaumann's rate of stress, viscous hourglass control of Flanagan
& Belytschko (Int. J. Numer. Methods Eng. 17 (1981) 679), explicit central differences, a smooth
rigid wall. The script shares no code with Kerf.

    python3 axisymmetric.py [elements over the radius, 16]

prints length, foot radius and largest plastic strain after 80 us.
"""
import sys

import numpy as np

RADIUS, LENGTH, SPEED, END = 3.2e-3, 32.4e-3, 227.0, 80e-6
DENSITY, YOUNG, POISSON, YIELD, HARDENING = 8930.0, 117e9, 0.35, 400e6, 100e6
G, K = YOUNG / (2 + 2 * POISSON), YOUNG / (3 - 6 * POISSON)
WAVE = np.sqrt((K + 4 / 3 * G) / DENSITY)
HOURGLASS = 0.05
GAMMA = np.array([1.0, -1.0, 1.0, -1.0])


class Mesh:
    def __init__(self, across):
        along = int(round(across * LENGTH / RADIUS * 0.7))  # the foot is squashed: start it long
        r, z = np.linspace(0, RADIUS, across + 1), np.linspace(0, LENGTH, along + 1)
        self.r, self.z = (a.ravel() for a in np.meshgrid(r, z))
        i, j = np.meshgrid(np.arange(across), np.arange(along))
        first = (j * (across + 1) + i).ravel()
        self.nodes = np.stack([first, first + 1, first + across + 2, first + across + 1], axis=1)
        self.axis = self.r == 0.0
        area, _, _, centre = self.shape()
        self.mass_of = DENSITY * area * centre  # per radian
        self.mass = self.gather(np.repeat(self.mass_of[:, None] / 4, 4, axis=1))

    def gather(self, per_corner):
        return np.bincount(self.nodes.ravel(), per_corner.ravel(), len(self.r))

    def shape(self):
        """Returns the area, the slopes of the shape functions at the centre and the radius of the centre."""
        r, z = self.r[self.nodes], self.z[self.nodes]
        dr, dz = np.roll(r, -2, axis=1) - r, np.roll(z, -2, axis=1) - z
        area = 0.5 * (dr[:, 0] * dz[:, 1] - dr[:, 1] * dz[:, 0])
        slope_r = -np.roll(dz, -1, axis=1) / (2 * area[:, None])
        slope_z = np.roll(dr, -1, axis=1) / (2 * area[:, None])
        return area, slope_r, slope_z, r.mean(axis=1)


def run(across):
    mesh = Mesh(across)
    velocity = np.stack([np.zeros_like(mesh.r), np.full_like(mesh.r, -SPEED)])
    stress = np.zeros((4, len(mesh.nodes)))  # rr, zz, tt, rz
    plastic = np.zeros(len(mesh.nodes))
    time = 0.0
    while time < END:
        area, slope_r, slope_z, centre = mesh.shape()
        side = area / np.sqrt(
            np.max((np.roll(mesh.r[mesh.nodes], -1, 1) - mesh.r[mesh.nodes]) ** 2 +
                   (np.roll(mesh.z[mesh.nodes], -1, 1) - mesh.z[mesh.nodes]) ** 2, axis=1))
        dt = 0.5 * np.min(side) / WAVE
        force = internal_force(mesh, velocity, stress, area, slope_r, slope_z, centre)
        velocity -= dt * force / mesh.mass
        velocity[0, mesh.axis] = 0.0
        blocked = (mesh.z + dt * velocity[1] < 0.0) & (velocity[1] < 0.0)
        velocity[1, blocked] = -mesh.z[blocked] / dt
        mesh.r += dt * velocity[0]
        mesh.z += dt * velocity[1]
        area, slope_r, slope_z, centre = mesh.shape()
        update_stress(velocity[:, mesh.nodes], slope_r, slope_z, centre, dt, stress, plastic)
        time += dt
    foot = mesh.z < 0.02 * LENGTH
    return mesh.z.max() - mesh.z.min(), mesh.r[foot].max(), plastic.max()


def internal_force(mesh, velocity, stress, area, slope_r, slope_z, centre):
    rr, zz, tt, rz = (s[:, None] for s in stress)
    volume = (area * centre)[:, None]
    in_r = volume * (slope_r * rr + slope_z * rz) + area[:, None] / 4 * tt
    in_z = volume * (slope_r * rz + slope_z * zz)
    # The hourglass shape without its linear part.
    r, z = mesh.r[mesh.nodes], mesh.z[mesh.nodes]
    shape = GAMMA - (r @ GAMMA)[:, None] * slope_r - (z @ GAMMA)[:, None] * slope_z
    damping = (HOURGLASS * DENSITY * WAVE * np.sqrt(area) * centre)[:, None] * shape
    v = velocity[:, mesh.nodes]
    in_r += damping * np.sum(shape * v[0], axis=1, keepdims=True)
    in_z += damping * np.sum(shape * v[1], axis=1, keepdims=True)
    return np.stack([mesh.gather(in_r), mesh.gather(in_z)])


def update_stress(v, slope_r, slope_z, centre, dt, stress, plastic):
    def rate(component, slope):
        return np.sum(v[component] * slope, axis=1)

    d_rr, d_zz = rate(0, slope_r), rate(1, slope_z)
    d_tt = v[0].mean(axis=1) / centre
    d_rz, spin = 0.5 * (rate(0, slope_z) + rate(1, slope_r)), 0.5 * (
        rate(0, slope_z) - rate(1, slope_r))
    growth = d_rr + d_zz + d_tt
    rr, zz, tt, rz = stress.copy()
    pressure = (K - 2 / 3 * G) * growth
    stress[0] += dt * (pressure + 2 * G * d_rr + 2 * spin * rz)
    stress[1] += dt * (pressure + 2 * G * d_zz - 2 * spin * rz)
    stress[2] += dt * (pressure + 2 * G * d_tt)
    stress[3] += dt * (2 * G * d_rz + spin * (zz - rr))
    mean = stress[:3].mean(axis=0)
    deviator = stress.copy()
    deviator[:3] -= mean
    q = np.sqrt(1.5 * (np.sum(deviator[:3] ** 2, axis=0) + 2 * deviator[3] ** 2))
    flow = np.maximum(0.0, (q - YIELD - HARDENING * plastic) / (3 * G + HARDENING))
    plastic += flow
    stress[:] = deviator * (1 - 3 * G * flow / np.maximum(q, 1.0))
    stress[:3] += mean


if __name__ == "__main__":
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 16
    length, radius, strain = run(number)
    print(f"{number} elements: length {length * 1e3:.3f} mm, foot radius {radius * 1e3:.3f} mm, "
          f"plastic strain {strain:.2f}")
