#!/usr/bin/env python3
"""The polynomials of src/gauss/scalar/xsimd_sincos.hpp: sin r = r + r z P(z), cos r = 1 - z/2 + z^2 Q(z), z = r^2, |r| <= pi/4.

Interpolation at Chebyshev points, where the error that is left is spread nearly evenly. Needs mpmath (python3-sympy brings it).
"""

from mpmath import cos, lu_solve, matrix, mp, mpf, nstr, pi, polyval, sin, sqrt

mp.dps = 60
LAST = (pi / 4) ** 2


def sine(z):
    return (sin(sqrt(z)) / sqrt(z) - 1) / z


def cosine(z):
    return (cos(sqrt(z)) - 1 + z / 2) / z**2


def interpolated(function, count):
    points = [LAST * (1 + cos(pi * (2 * k + 1) / (2 * count))) / 2 for k in range(count)]
    system = matrix([[z**i for i in range(count)] for z in points])
    return [float(c) for c in lu_solve(system, matrix([function(z) for z in points]))]


def main():
    for name, function, weight in (("k_sine", sine, lambda z: z), ("k_cosine", cosine, lambda z: z**2)):
        coefficients = interpolated(function, 6)
        exact = [mpf(c) for c in reversed(coefficients)]
        worst = max(abs(polyval(exact, z) - function(z)) * weight(z) for z in (LAST * k / 1000 for k in range(1, 1001)))
        print(f"{name}[] = {{{', '.join(map(repr, coefficients))}}};  // errs by {nstr(worst, 2)}")


main()
