#!/usr/bin/env python3
"""Prints the polynomial coefficients of libbrdf/brdf/math.h, least-squares fits at Chebyshev nodes in 40 digits.

Needs mpmath. Each line: name, degree, largest relative error of the polynomial in exact arithmetic, coefficients
from the constant term up. Usage: tools/kernel_coefficients.py
"""
from mpmath import mp, mpf, cos, pi, exp, log, atan, sqrt, erfc, matrix, lu_solve

mp.dps = 40


def interpolate(f, lo, hi, degree):
    """Returns coefficients of the polynomial through f at the Chebyshev nodes of [lo, hi], within a factor of about two of minimax."""
    n = degree + 1
    nodes = [(lo + hi) / 2 + (hi - lo) / 2 * cos(pi * (2 * k + 1) / (2 * n)) for k in range(n)]
    a = matrix(n, n)
    b = matrix(n, 1)
    for i, x in enumerate(nodes):
        for j in range(n):
            a[i, j] = x**j
        b[i] = f(x)
    return list(lu_solve(a, b))


def horner(c, x):
    y = mpf(0)
    for a in reversed(c):
        y = y * x + a
    return y


def report(name, f, lo, hi, degree, whole, exact):
    c = interpolate(f, lo, hi, degree)
    worst = 0
    for k in range(1, 400):
        x = lo + (hi - lo) * mpf(k) / 400
        worst = max(worst, abs(whole(c, x) / exact(x) - 1))
    print(f"{name} degree {degree} error {mp.nstr(worst, 3)}")
    print("    {" + ", ".join(mp.nstr(a, 19, min_fixed=-1, max_fixed=1) for a in c) + "}")


def exp_tail(r):
    if abs(r) < mpf("1e-8"):
        return mpf(1) / 2 + r / 6 + r * r / 24
    return (exp(r) - 1 - r) / r**2


half_ln2 = log(2) / 2 * mpf("1.0001")
for name, degree in (("exp float", 4), ("exp double", 9)):
    report(name, exp_tail, -half_ln2, half_ln2, degree, lambda c, r: 1 + r + r * r * horner(c, r), exp)

s_max = (sqrt(mpf(2)) - 1) / (sqrt(mpf(2)) + 1) * mpf("1.0001")


def log_tail(z):  # (log((1+s)/(1-s)) - 2 s) / s^3 with z = s^2
    if z < mpf("1e-12"):
        return mpf(2) / 3 + 2 * z / 5 + 2 * z * z / 7
    s = sqrt(z)
    return (log((1 + s) / (1 - s)) - 2 * s) / s**3


for name, degree in (("log float", 2), ("log double", 7)):
    report(name, log_tail, mpf(0), s_max**2, degree, lambda c, z: 2 + z * horner(c, z),
           lambda z: log((1 + sqrt(z)) / (1 - sqrt(z))) / sqrt(z))

t_max = (sqrt(mpf(2)) - 1) * mpf("1.0001")


def atan_tail(z):  # (atan(t) - t) / t^3 with z = t^2
    if z < mpf("1e-12"):
        return -mpf(1) / 3 + z / 5
    t = sqrt(z)
    return (atan(t) - t) / t**3


for name, degree in (("atan float", 4), ("atan double", 11)):
    report(name, atan_tail, mpf(0), t_max**2, degree, lambda c, z: 1 + z * horner(c, z), lambda z: atan(sqrt(z)) / sqrt(z))


def erfcx_scaled(q):  # (x + 3) erfcx(x), x = 3 (1 + q) / (1 - q)
    x = 3 * (1 + q) / (1 - q)
    return (x + 3) * exp(x * x) * erfc(x)


q_max = mpf("7.5") / mpf("13.5")
for name, degree in (("erfcx float", 9), ("erfcx double", 20)):
    report(name, erfcx_scaled, mpf(-1), q_max, degree, lambda c, q: horner(c, q), erfcx_scaled)
