#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the part of cases/machine/stl-part.toml, a lug with a bore, as a text STL.

    scripts/make_lug.py > cases/machine/lug.stl

Units are millimetres. The outline in x and y is a strip with round ends, 40 long and 20 high. A bore of
diameter 10 passes through its middle along z, 24 deep. The corners of outline and bore are on the same rays from
the middle, so four triangles for each pair of rays and each side close the surface.
"""
import math

RAYS = 48
HALF_STRAIGHT, END_RADIUS, BORE_RADIUS, HALF_DEPTH = 10.0, 10.0, 5.0, 12.0


def outline(angle):
    """Returns the point where the ray at this angle leaves the strip."""
    c, s = math.cos(angle), math.sin(angle)
    if abs(c) * END_RADIUS <= HALF_STRAIGHT * abs(s):
        reach = END_RADIUS / abs(s)
    else:
        m = HALF_STRAIGHT * abs(c)
        reach = m + math.sqrt(m * m - HALF_STRAIGHT**2 + END_RADIUS**2)
    return reach * c, reach * s


def bore(angle):
    return BORE_RADIUS * math.cos(angle), BORE_RADIUS * math.sin(angle)


def quadrilateral(a, b, c, d):
    return [(a, b, c), (a, c, d)]


def triangles():
    angles = [2.0 * math.pi * k / RAYS for k in range(RAYS)]
    for k, angle in enumerate(angles):
        following = angles[(k + 1) % RAYS]
        corner = {}
        for name, loop in (("out", outline), ("in", bore)):
            for end, at in (("a", angle), ("b", following)):
                x, y = loop(at)
                corner[name + end + "-"] = (x, y, -HALF_DEPTH)
                corner[name + end + "+"] = (x, y, HALF_DEPTH)
        for names in ("ina+ outa+ outb+ inb+", "ina- inb- outb- outa-",
                      "outa- outb- outb+ outa+", "ina- ina+ inb+ inb-"):
            yield from quadrilateral(*(corner[name] for name in names.split()))


def number(value):
    return f"{round(value, 4) + 0.0:g}"


def main():
    print("solid lug")
    for triangle in triangles():
        print("facet normal 0 0 0\nouter loop")
        for corner in triangle:
            print("vertex", *(number(value) for value in corner))
        print("endloop\nendfacet")
    print("endsolid lug")


if __name__ == "__main__":
    main()
