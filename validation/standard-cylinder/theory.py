# SPDX-License-Identifier: Apache-2.0
"""A plane jet of finite width on a circular cylinder: free-streamline theory after Helmholtz, Kirchhoff and Levi-Civita.

Units: density rho = 1, speed of the jet V = 1, radius of the cylinder R = 1. The jet of width b comes along +x, without
gravity and viscosity; the pressure of the air is 0, so that the speed is 1 on every free streamline.

The flow is mapped to the upper half of the unit disc |zeta| < 1. The wetted arc of the body is the half circle zeta = exp(i s),
with the stagnation point at zeta = i. All free streamlines together are the diameter -1 < zeta < 1, with the coming jet at
zeta = 0 and the two leaving sheets at zeta = -c and +c. With T = -(zeta + 1/zeta) / 2, which makes it the upper half plane,

    dw/dT = (b/pi) T / (TJ^2 - T^2),                    TJ = (c + 1/c) / 2                                        (1)

(a source of strength b at infinity, a sink of b/2 at -TJ and one at +TJ). The logarithm of the complex velocity,

    omega = ln(dw/dz) = ln q - i theta = m ln[(1 + i zeta) / (1 - i zeta)] + i sum a_n zeta^n,  n = 1, 3, 5, ...    (2)

has q = 1 on the diameter and the stagnation point of a wall that leaves the axis at the angle m pi/2. A flat plate (m = 1)
and a wedge have a_n = 0. On the upper half of the body, pi/2 < s < pi, with the angle d = s - pi/2 from the stagnation point,

    q = tan(d/2)^m exp(-sum a_n sin n s),               theta = m pi/2 - sum a_n cos n s.                          (3)

The arc length l follows from dl = |dw| / q. A circle has d theta / dl = -1/R, which is, divided by sin s, with m = 1,

    sum n a_n sin(n s) / sin(s) = -(b / pi R) (1 + sin s) / (TJ^2 - cos^2 s) exp(sum a_n sin n s).                  (4)

The water leaves a smooth wall where its free streamline has the curvature of the wall (Villat's condition); a streamline that
left earlier would cut the wall, and before one that left later the pressure on the wall would be below that of the air. The
curvature is finite where d omega / d zeta = 0 at zeta = -1:

    1 + sum n a_n = 0.                                                                                            (5)

(4) at N points and (5) are solved for N coefficients a_n and TJ by Newton's method. Then

    detachment angle      arc length from zeta = i to zeta = -1, over R                                           (6)
    deflection            theta_J = theta(zeta = -c) = 2 m atan c + sum a_n c^n                                   (7)
    force                 F = 2 integral (1 - q^2)/2 sin(theta) dl  over the upper half of the arc, and           (8)
                          F = b (1 - cos theta_J)  by momentum, which checks the solution.                        (9)

References: T. Levi-Civita, Rend. Circ. Mat. Palermo 23 (1907) 1; H. Villat, Ann. Sci. Ec. Norm. Super. 28 (1911) 203;
S. Brodetsky, Proc. R. Soc. Lond. A 102 (1923) 542 (circular cylinder in an unbounded stream: 55 degrees, C_D = 0.50);
L. M. Milne-Thomson, Theoretical Hydrodynamics, 5th ed. (1968), ch. 11 (jet on a plate); G. Birkhoff & E. H. Zarantonello,
Jets, Wakes, and Cavities (1957), ch. 6.
"""
import numpy as np
from scipy.optimize import root


class Body:
    """Wetted arc of a body with the coefficients a, for a jet of width b."""

    def __init__(self, a, tj, b, m=1.0):
        self.a, self.tj, self.b, self.m = np.asarray(a, float), tj, b, m
        self.n = 2 * np.arange(len(self.a)) + 1
        x, w = np.polynomial.legendre.leggauss(300)
        u, w = (x + 1) / 2, w / 2        # graded towards both ends of the arc
        self.s = np.pi / 2 * (1 + u * u * (3 - 2 * u))
        weight = w * np.pi / 2 * 6 * u * (1 - u)
        d = self.s - np.pi / 2
        angle = np.outer(self.s, self.n)
        self.q = np.tan(d / 2) ** m * np.exp(-np.sin(angle) @ self.a)
        self.theta = m * np.pi / 2 - np.cos(angle) @ self.a
        t = np.sin(d)
        self.dl = b / np.pi * t * np.cos(d) / (tj * tj - t * t) / self.q * weight

    def length(self):
        return self.dl.sum()

    def force(self):
        return np.sum((1 - self.q ** 2) * np.sin(self.theta) * self.dl)

    def deflection(self):
        c = 1 / (self.tj + np.sqrt(self.tj ** 2 - 1))
        return 2 * self.m * np.arctan(c) + np.sum(self.a * c ** self.n)

    def shape_error(self):
        """Largest distance of a point of the arc from the circle with radius 1 that it begins on."""
        z = np.cumsum(np.exp(1j * self.theta) * self.dl) - np.exp(1j * self.theta) * self.dl / 2
        return np.max(np.abs(np.abs(z - 1) - 1))

    def least_pressure(self):
        return np.min(1 - self.q ** 2) / 2


def cylinder(b, modes=80, start=None):
    """The solution for a jet of width b on a cylinder of radius 1."""
    n = 2 * np.arange(modes) + 1
    s = np.pi / 2 * (1 + (np.arange(modes) + 0.5) / modes)
    sine = np.sin(np.outer(s, n))
    left = n * sine / np.sin(s)[:, None]
    k = b / np.pi * (1 + np.sin(s))

    def equations(x):
        a, g = x[:-1], np.exp(x[-1])                # g = TJ^2 - 1
        return np.append(left @ a + k / (g + np.sin(s) ** 2) * np.exp(sine @ a), 1 + n @ a)

    def jacobian(x):
        a, g = x[:-1], np.exp(x[-1])
        right = k / (g + np.sin(s) ** 2) * np.exp(sine @ a)
        j = np.zeros((modes + 1, modes + 1))
        j[:-1, :-1] = left + right[:, None] * sine
        j[:-1, -1] = -right * g / (g + np.sin(s) ** 2)
        j[-1, :-1] = n
        return j

    x = np.zeros(modes + 1)
    if start is None:
        x[0], x[-1] = -1.0, np.log(max(b, 0.1))
    else:
        m = min(modes, len(start.a))
        x[:m], x[-1] = start.a[:m], np.log(start.tj ** 2 - 1)
    solution = root(equations, x, jac=jacobian, tol=1e-13)
    if np.max(np.abs(solution.fun)) > 1e-9:
        raise RuntimeError(f"no solution for b = {b}: {np.max(np.abs(solution.fun)):.1e}")
    return Body(solution.x[:-1], np.sqrt(1 + np.exp(solution.x[-1])), b)


def at_ratio(ratio, modes=80):
    """The solution for b / (2 R), reached in steps from b / R = 10."""
    body, target = cylinder(10.0, modes), 2 * ratio
    for b in np.geomspace(10.0, target, 2 + int(8 * abs(np.log(target / 10.0))))[1:]:
        body = cylinder(b, modes, body)
    return body


def check(name, value, reference, tolerance):
    ok = abs(value - reference) <= tolerance
    print(f"{'ok  ' if ok else 'FAIL'} {name}: {value:.6g}, must be {reference:.6g} within {tolerance:g}")
    return ok


def main():
    good = True
    print("b/(2R)  modes  detachment  deflection  F/(rho V^2 b)  by momentum      C_D  least pressure")
    for ratio in (0.25, 0.5, 1.0, 2.0, 1e4):
        for modes in (20, 40, 80, 160):
            p = at_ratio(ratio, modes)
            f, mom = p.force() / p.b, 1 - np.cos(p.deflection())
            print(f"{ratio:6g}  {modes:5d}  {np.degrees(p.length()):10.3f}  {np.degrees(p.deflection()):10.3f}  {f:13.5f}"
                  f"  {mom:11.5f}  {p.force():7.4f}  {p.least_pressure():.1e}")
            last = previous if modes == 160 else None
            previous = f
        good &= check("  momentum", f / mom, 1, 1e-3)
        good &= check("  80 modes over 160", last / f, 1, 1e-3)
        good &= check("  distance of the arc from the circle", p.shape_error(), 0, 1e-3)
    good &= check("unbounded stream, C_D of a cylinder (Brodetsky)", p.force(), 0.50, 0.005)
    good &= check("unbounded stream, detachment in degrees", np.degrees(p.length()), 55.0, 0.5)
    for alpha in (10.0, 45.0, 80.0):                # a flat plate deflects a jet by alpha if 2 l / b is as below
        a = np.radians(alpha)
        plate = Body([], 1 / np.sin(a), 1.0)
        good &= check(f"flat plate, {alpha:g} deg, its width over b", 2 * plate.length(),
                      1 - np.cos(a) + 2 / np.pi * np.sin(a) * np.arctanh(np.sin(a)), 1e-6)
        good &= check("  its force", plate.force(), 1 - np.cos(a), 1e-6)
    plate = Body([], 1e4, 1.0)
    good &= check("unbounded stream, C_D of a flat plate", plate.force() / plate.length(), 2 * np.pi / (np.pi + 4), 1e-5)
    wedge = Body([], 1.0 + 1e-4, 1.0, 1 / 3)
    good &= check("wedge of 60 deg, force by momentum", wedge.force(), 1 - np.cos(wedge.deflection()), 1e-5)
    return 0 if good else 1


if __name__ == "__main__":
    raise SystemExit(main())
