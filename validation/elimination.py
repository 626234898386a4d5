# SPDX-License-Identifier: Apache-2.0
"""Solves small dense systems of linear equations for the scripts of the neighbouring folders."""


def solved(matrix, vector):
    """Returns the solution by Gaussian elimination with pivots."""
    rows = [line[:] + [value] for line, value in zip(matrix, vector)]
    size = len(rows)
    for c in range(size):
        pivot = max(range(c, size), key=lambda r: abs(rows[r][c]))
        rows[c], rows[pivot] = rows[pivot], rows[c]
        for r in range(c + 1, size):
            factor = rows[r][c] / rows[c][c]
            if factor:
                rows[r] = [x - factor * y for x, y in zip(rows[r], rows[c])]
    result = [0.0] * size
    for r in reversed(range(size)):
        known = sum(rows[r][c] * result[c] for c in range(r + 1, size))
        result[r] = (rows[r][size] - known) / rows[r][r]
    return result
