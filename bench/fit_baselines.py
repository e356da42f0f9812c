"""Baselines of bench_fit: the same samples fitted as users of scipy and numpy would.

Called by `bench_fit --python bench/fit_baselines.py`: FILE holds nine columns of doubles (wi, wo, r, g, b),
SECONDS is our time, for the ratios.
"""

import sys
import time

import numpy as np
from scipy.optimize import least_squares


def lobes(alpha, wi, wo):
    """Returns the lobes: Lambert, V D and V D s of Cook-Torrance (GGX, correlated Smith, Schlick)."""
    a2 = alpha * alpha
    h = wi + wo
    h2 = np.sum(h * h, axis=0)
    q = (h[0] ** 2 + h[1] ** 2) / a2 + h[2] ** 2
    d = h2 * h2 / (np.pi * a2 * q * q)
    gi = np.sqrt(a2 * (wi[0] ** 2 + wi[1] ** 2) + wi[2] ** 2)
    go = np.sqrt(a2 * (wo[0] ** 2 + wo[1] ** 2) + wo[2] ** 2)
    vd = 0.5 * d / (wo[2] * gi + wi[2] * go)
    s = np.maximum(1 - 0.5 * np.sqrt(h2), 0) ** 5
    return vd, vd * s


def fit_scipy(wi, wo, y):
    """Fits with the defaults of least_squares: finite differences, trust region with bounds."""

    def residual(p):
        vd, vds = lobes(np.exp(p[0]), wi, wo)
        r = [((p[1 + 3 * c] / np.pi + p[2 + 3 * c] * vd + p[3 + 3 * c] * vds) - y[c]) * wi[2] for c in range(3)]
        return np.concatenate(r)

    start = np.concatenate([[np.log(0.3)], np.full(9, 0.3)])
    low = np.concatenate([[np.log(1e-4)], np.zeros(9)])
    high = np.concatenate([[0.0], np.full(9, 1000.0)])
    return np.exp(least_squares(residual, start, bounds=(low, high)).x[0])


def fit_numpy(wi, wo, y):
    """Fits by variable projection: weights by normal equations, golden section on log alpha."""
    weight = wi[2]
    target = y * weight

    def cost(u):
        vd, vds = lobes(np.exp(u), wi, wo)
        basis = np.stack([np.full_like(vd, 1 / np.pi), vd, vds]) * weight
        gram = basis @ basis.T
        right = basis @ target.T
        return -np.sum(right * np.linalg.solve(gram, right))

    # Every 16th sample first, then a narrow bracket on all of them.
    thin = slice(None, None, 16)
    full = wi, wo, weight, target
    wi, wo, weight, target = wi[:, thin], wo[:, thin], weight[thin], target[:, thin]
    middle = golden(cost, np.log(0.02), 0.0, 1e-3)
    wi, wo, weight, target = full
    # A parabola through three points of the full cost.
    x = np.array([middle - 4e-3, middle, middle + 4e-3])
    f = np.array([cost(u) for u in x])
    step = 0.5 * (f[0] - f[2]) / (f[0] - 2 * f[1] + f[2]) * 4e-3
    return np.exp(middle + step)


def golden(f, low, high, tolerance):
    ratio = (np.sqrt(5) - 1) / 2
    a, b = high - ratio * (high - low), low + ratio * (high - low)
    fa, fb = f(a), f(b)
    while high - low > tolerance:
        if fa < fb:
            high, b, fb = b, a, fa
            a = high - ratio * (high - low)
            fa = f(a)
        else:
            low, a, fa = a, b, fb
            b = low + ratio * (high - low)
            fb = f(b)
    return 0.5 * (low + high)


def main():
    columns = np.fromfile(sys.argv[1]).reshape(9, -1)
    ours = float(sys.argv[2])
    wi, wo, y = columns[0:3], columns[3:6], columns[6:9]
    for name, method, repeats in (("numpy variable projection", fit_numpy, 3), ("scipy least_squares", fit_scipy, 1)):
        best = np.inf
        for _ in range(repeats):
            begin = time.process_time()
            alpha = method(wi, wo, y)
            best = min(best, time.process_time() - begin)
        print(f"{name:38s} {best:9.4f} {best / ours:9.1f} {'-':>9s} {alpha:10.6f}", flush=True)


main()
