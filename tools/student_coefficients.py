#!/usr/bin/env python3
"""Prints the coefficients of kStudentMasking in libbrdf/brdf/forms/cook_torrance_student.h, in 30 digits.

Needs mpmath. The function is the term that masking adds to the cosine for Student's t slopes, without its singular factors:

  R(m, gamma) = 2F1(1, gamma - 3/2; gamma; 1 - m^2) Gamma(gamma + 3/2)/(2 sqrt(pi) Gamma(gamma) (gamma + 2)^2),

m in [0, 1] the cosine after stretching, interpolated at the Chebyshev nodes of x = (3 m - 1)/(m + 1) and
y = K (gamma - P)/(gamma + Q). Rows: powers of x; columns: powers of y. The last line is the largest error of the masked
length relative to it, on a grid between the nodes. Usage: tools/student_coefficients.py
"""
from mpmath import mp, mpf, cos, exp, gamma, hyp2f1, log, matrix, lu_solve, nstr, pi, sqrt

mp.dps = 30
LOW, HIGH = mpf("1.6"), mpf(10)  # of gamma
P, Q, K = mpf("4.5"), mpf("7.4"), mpf("3.1")
ROWS, COLUMNS = 10, 13


def rest(m, g):
    return hyp2f1(1, g - mpf(3) / 2, g, 1 - m * m) * gamma(g + mpf(3) / 2) / (2 * sqrt(pi) * gamma(g) * (g + 2) ** 2)


def nodes(n):
    return [cos(pi * (2 * k + 1) / (2 * n)) for k in range(n)]


def monomials(x, values):
    n = len(x)
    a = matrix(n, n)
    for i in range(n):
        for j in range(n):
            a[i, j] = x[i] ** j
    return list(lu_solve(a, matrix(values)))


def horner(c, x):
    y = mpf(0)
    for a in reversed(c):
        y = y * x + a
    return y


def longer(m, g, r):
    """Returns m + (1 - m^2)^(gamma - 1) r: the stretched length that masking sees, relative to the length."""
    factor = (g + 2) ** 2 / ((g - mpf(3) / 2) * (g - mpf(1) / 2) * (g + mpf(1) / 2))
    return m + (1 - m * m) ** (g - 1) * r * factor


def main():
    low, high = K * (LOW - P) / (LOW + Q), K * (HIGH - P) / (HIGH + Q)
    xs = nodes(ROWS)
    ys = [(low + high) / 2 + (high - low) / 2 * y for y in nodes(COLUMNS)]
    by_y = []
    for y in ys:
        g = (P * K + Q * y) / (K - y)
        by_y.append(monomials(xs, [rest((1 + x) / (3 - x), g) for x in xs]))
    table = [monomials(ys, [row[k] for row in by_y]) for k in range(ROWS)]
    print(f"// y in {nstr(low, 5)} .. {nstr(high, 5)}")
    for row in table:
        print("    {" + ", ".join(nstr(c, 17, min_fixed=-1, max_fixed=1) for c in row) + "},")
    worst = 0
    for i in range(0, 41):
        g = LOW * (HIGH / LOW) ** (mpf(i) / 40)
        y = K * (g - P) / (g + Q)
        for j in range(0, 40):
            m = mpf(j) / 40
            x = (3 * m - 1) / (m + 1)
            r = horner([horner(row, y) for row in table], x)
            worst = max(worst, abs(longer(m, g, r) / longer(m, g, rest(m, g)) - 1))
    print("// largest relative error", nstr(worst, 3))


main()
