"""Computes the deflection of the clamped plate of case.toml by plane strain elasticity: finite elements of eight
nodes with 2 x 2 points, half of the plate, clamped end, symmetry at the middle. Pressure of the water
acts on the upper face and the weight of the plate inside it. The script needs Python only: python3 plate.py"""

LENGTH, HEIGHT, WATER = 0.2, 0.01, 0.01             # m
E, NU, RHO_PLATE, RHO_WATER, G = 35e6, 0.34, 1000.0, 1000.0, 9.81
PRESSURE, WEIGHT = RHO_WATER * G * WATER, RHO_PLATE * G * HEIGHT

NODES = [(-1, -1), (1, -1), (1, 1), (-1, 1), (0, -1), (1, 0), (0, 1), (-1, 0)]


def slopes(a, b):
    """Returns the derivatives of the eight shape functions by a and b, and their values."""
    value, by_a, by_b = [], [], []
    for p, q in NODES:
        if p and q:
            value.append(0.25 * (1 + p * a) * (1 + q * b) * (p * a + q * b - 1))
            by_a.append(0.25 * p * (1 + q * b) * (2 * p * a + q * b))
            by_b.append(0.25 * q * (1 + p * a) * (p * a + 2 * q * b))
        elif p == 0:
            value.append(0.5 * (1 - a * a) * (1 + q * b))
            by_a.append(-a * (1 + q * b))
            by_b.append(0.5 * q * (1 - a * a))
        else:
            value.append(0.5 * (1 + p * a) * (1 - b * b))
            by_a.append(0.5 * p * (1 - b * b))
            by_b.append(-b * (1 + p * a))
    return value, by_a, by_b


def deflection(nx, ny):
    number = {}
    for i in range(2 * nx + 1):                     # column by column: a narrow band
        for j in range(2 * ny + 1):
            if i % 2 == 0 or j % 2 == 0:
                number[i, j] = len(number)
    count, lx, ly = 2 * len(number), 0.5 * LENGTH / nx, HEIGHT / ny
    band = 2 * (4 * ny + 2 + 2 * ny + 3)
    rows = [[0.0] * (band + 1) for _ in range(count)]  # rows[r][c - r], upper half
    load = [0.0] * count
    lame, shear = E * NU / (1 + NU) / (1 - 2 * NU), E / 2 / (1 + NU)
    point = 3 ** -0.5
    for i in range(nx):
        for j in range(ny):
            ids = [number[2 * i + 1 + p, 2 * j + 1 + q] for p, q in NODES]
            for a in (-point, point):
                for b in (-point, point):
                    value, by_a, by_b = slopes(a, b)
                    dx, dy = [2 * s / lx for s in by_a], [2 * s / ly for s in by_b]
                    area = lx * ly / 4
                    for m in range(8):
                        load[2 * ids[m] + 1] -= WEIGHT / HEIGHT * area * value[m]
                        for n in range(8):
                            block = ((lame + 2 * shear) * dx[m] * dx[n] + shear * dy[m] * dy[n],
                                     lame * dx[m] * dy[n] + shear * dy[m] * dx[n],
                                     lame * dy[m] * dx[n] + shear * dx[m] * dy[n],
                                     (lame + 2 * shear) * dy[m] * dy[n] + shear * dx[m] * dx[n])
                            for k in range(4):
                                r, c = 2 * ids[m] + k // 2, 2 * ids[n] + k % 2
                                if c >= r:
                                    rows[r][c - r] += area * block[k]
            if j == ny - 1:                         # the face under water: 1/6, 4/6, 1/6
                for k, share in ((3, 1), (6, 4), (2, 1)):
                    load[2 * ids[k] + 1] -= PRESSURE * lx * share / 6
    for (i, j), n in number.items():                # clamped at x = 0, symmetric at the middle
        if i == 0:
            rows[2 * n][0] += 1e6 * E
            rows[2 * n + 1][0] += 1e6 * E
        if i == 2 * nx:
            rows[2 * n][0] += 1e6 * E
    for r in range(count):                          # Cholesky's way, on the band
        for s in range(1, band + 1):
            if r + s >= count or rows[r][s] == 0.0:
                continue
            f = rows[r][s] / rows[r][0]
            target = rows[r + s]
            for t in range(s, band + 1):
                target[t - s] -= f * rows[r][t]
            load[r + s] -= f * load[r]
    for r in range(count - 1, -1, -1):
        for s in range(1, band + 1):
            if r + s < count:
                load[r] -= rows[r][s] * load[r + s]
        load[r] /= rows[r][0]
    middle = [load[2 * number[2 * nx, j] + 1] for j in range(2 * ny + 1)]
    return sum(middle) / len(middle)


if __name__ == "__main__":
    stiffness = E * HEIGHT**3 / 12 / (1 - NU**2)
    total = PRESSURE + WEIGHT
    thin = total * LENGTH**4 / 384 / stiffness
    by_shear = total * LENGTH**2 / 8 / (5 / 6 * E / 2 / (1 + NU) * HEIGHT)
    print(f"thin plate        {1e6 * thin:.3f} um")
    print(f"with shear (5/6)  {1e6 * (thin + by_shear):.3f} um")
    for nx, ny in ((20, 2), (40, 4), (80, 8)):
        print(f"elements {nx:2d} x {ny}   {-1e6 * deflection(nx, ny):.3f} um")
