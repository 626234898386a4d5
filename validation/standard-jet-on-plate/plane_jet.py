"""Computes the pressure on a flat plate that a plane jet of width b and speed V hits at a right angle: the exact
free-streamline solution. The script needs Python only: python3 plane_jet.py

With zeta = (u - i v) / V the flow fills the upper half of the unit disc: the plate is its diameter, the
free surfaces its arc (|velocity| = V where p = 0). The jet comes in at zeta = i and leaves at zeta = +-1,
each a logarithm of the potential, mirrored in the diameter:
    w = (V b / pi) [log(zeta^2 - 1) - log(zeta^2 + 1)]
(round i the angle is pi: flux V b; round +-1 it is pi / 2: V b / 2 each). dz = dw / (V zeta) gives
    |x| / b = (2 / pi) (artanh s + atan s),   s = u / V on the plate,   Cp = 1 - s^2.
Checked below: the force of this pressure is the momentum of the jet, and the free surface ends b / 2
above the plate."""
from cmath import atan, atanh, exp
from math import pi, sqrt


def place(s):
    return 2 / pi * (atanh(s) + atan(s))


def force(steps=200000):
    """Returns the integral of Cp over x / b, by parts in s: dx/ds = (2/pi) (1/(1-s^2) + 1/(1+s^2))."""
    total = 0.0
    for k in range(steps):
        s = (k + 0.5) / steps
        total += (1 - s * s) * 2 / pi * (1 / (1 - s * s) + 1 / (1 + s * s)) / steps
    return 2 * total


def surface(steps=400000):
    """Returns the height of the free surface at its end relative to the side of the jet: z along
    the arc from near zeta = i to near 1, whose real part starts at -b/2."""
    start, end = exp(1j * (pi / 2 - 1e-6)), exp(1j * 1e-6)
    return [2 / pi * (atanh(z) + atan(z)) for z in (start, end)]


if __name__ == "__main__":
    print(f"force / (rho V^2 b / 2) = {force():.6f}, momentum: 2")
    start, end = surface()
    print(f"side of the jet at x / b = {start.real:.4f}, film {end.imag:.4f} b thick")
    for cp in (0.9, 0.75, 0.5, 0.25, 0.1):
        print(f"Cp = {cp:4.2f} at x / b = {place(sqrt(1 - cp)).real:.4f}")
