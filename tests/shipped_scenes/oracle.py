#!/usr/bin/env python3
"""Eigmax at points of the scenes, by the general Riccati equations: writes oracle.csv.

Independent on purpose: it reads no scene, and solves the six-state equations with SciPy
instead of reducing them. Columns: scene, x, y, z [m], eigmax [m]; inf where unobservable.
Stacked scenes: a-priori discrete covariance; 03: continuous covariance.

Points nearer than 1e-6 (relative) to a frustum's side are left out: there the last bit
decides. Needs NumPy and SciPy.
"""
import csv
import math
import os

import numpy as np
from scipy.linalg import solve_continuous_are, solve_discrete_are

Q = np.diag([0.3951529079, 0.3951529079, 0.10745377401])
FOOT = 0.3048


class Edge(Exception):
    pass


def aim(at, to):
    """Rows: the sensor's x (right), y (down), z (forward) in the world."""
    z = np.subtract(to, at)
    z = z / np.linalg.norm(z)
    x = np.cross(z, [0.0, 0.0, 1.0])
    x /= np.linalg.norm(x)
    return np.array([x, np.cross(z, x), z])


def turn(q, v):
    """v rotated by the unit quaternion q = (x, y, z, w)."""
    u, w = np.array(q[:3]), q[3]
    return v + 2 * np.cross(u, np.cross(u, v) + w * np.asarray(v))


def speaker(at, r):
    def rows(p):
        d = np.subtract(p, at)
        z = np.linalg.norm(d)
        return [(d / z, r * z * z)]

    return rows


def camera(at, axes, lens, near, far, noise):
    """lens: (focal, pitch, columns, rows); noise: distance -> variance."""
    focal, pitch, columns, lines = lens
    limit = np.array([columns, lines]) * pitch / 2 / focal

    def rows(p):
        d = np.subtract(p, at)
        x, y, z = axes @ d
        if z <= 0:
            return []
        ratio = np.abs([x / z, y / z]) / limit
        if min(np.abs(ratio - 1)) < 1e-6 or min(abs(z / near - 1), abs(z / far - 1)) < 1e-6:
            raise Edge
        if max(ratio) > 1 or not near < z < far:
            return []
        variance = noise(np.linalg.norm(d))
        return [
            ((axes[0] * z - axes[2] * x) / z**2, variance),
            ((axes[1] * z - axes[2] * y) / z**2, variance),
        ]

    return rows


def acoustic():
    return [(speaker((x, y, 1.2141), 0.005), 50) for x in (-0.07, 0.47) for y in (-0.07, 0.47)]


def above_corners():
    return [(speaker((x, y, 1.0485), 0.005), 50) for x in (0, 0.4) for y in (0, 0.4)]


DRAGONFLY = (6e-3, 7.4e-6, 640, 480)


def rig():
    out = []
    for dx, dy, height, target in ((0.491, 0.724, 1.593, -1.282), (0.319, 0.986, 0.821, 0.373)):
        for sx in (-1, 1):
            for sy in (-1, 1):
                at = (0.2 + sx * dx, 0.2 + sy * dy, height)
                axes = aim(at, (0.2, 0.2, target))
                out.append((camera(at, axes, DRAGONFLY, 0.05, 5, lambda d: 5e-4 * d * d), 30))
    return out


def capture():
    out = []
    for x, y in ((0, 10), (20, 10), (10, 0), (10, 20)):
        for height in (5, 7):
            at = np.array([x, y, height]) * FOOT
            axes = aim(at, np.array([10, 10, 4.5]) * FOOT)
            out.append((camera(at, axes, DRAGONFLY, 0.1, 12, lambda d: 2e-7 * d * d), 60))
    return out


LABORATORY = """
-0.56 2.92 -3.90  0.01  0.94  0.35 -0.01
 2.05 2.91  4.63 -0.29  0.33  0.11  0.89
-3.51 2.94  1.85 -0.25 -0.67 -0.24  0.66
 2.00 2.88  0.50 -0.25  0.65  0.25  0.67
-3.52 2.92 -3.20  0.19  0.82  0.29 -0.46
-0.74 2.89  4.76 -0.33  0.03 -0.01  0.94
-3.47 2.93  4.68 -0.22 -0.41 -0.15  0.87
 1.99 2.86 -3.75 -0.12  0.86  0.24  0.44
"""


def laboratory():
    def z_up(v):
        return np.array([v[0], -v[2], v[1]])

    lens = (6.8e-3, 5.5e-6, 2048, 1088)
    sigma = 0.1 * 5.5e-6 / 6.8e-3
    out = []
    for line in LABORATORY.split("\n"):
        if not line:
            continue
        value = [float(s) for s in line.split()]
        q = np.array(value[3:]) / np.linalg.norm(value[3:])
        axes = np.array([z_up(turn(q, a)) for a in ([1, 0, 0], [0, -1, 0], [0, 0, -1])])
        out.append((camera(z_up(value[:3]), axes, lens, 0.3, 15, lambda d: sigma**2), 120))
    return out


def eigmax(devices, p, continuous):
    h, r = [], []
    for rows, rate in devices:
        for row, variance in rows(p):
            h.append(row)
            r.append(variance / rate if continuous else variance)
    whitened = np.array([a / math.sqrt(b) for a, b in zip(h, r)])
    if len(whitened) < 3 or np.linalg.matrix_rank(whitened) < 3:
        return math.inf
    zero, one = np.zeros((3, 3)), np.eye(3)
    # Whitened rows compressed to three: the same information, a better conditioned problem.
    row3 = np.linalg.qr(whitened, mode="r")
    out = np.hstack([row3, zero])
    if continuous:
        a = np.block([[zero, one], [zero, zero]])
        q = np.block([[zero, zero], [zero, Q]])
        cov = solve_continuous_are(a.T, out.T, q, np.eye(3))
        residual = a @ cov + cov @ a.T + q - cov @ out.T @ out @ cov
    else:
        dt = 1 / devices[0][1]
        a = np.block([[one, dt * one], [zero, one]])
        q = np.block([[Q * dt**3 / 3, Q * dt**2 / 2], [Q * dt**2 / 2, Q * dt]])
        cov = solve_discrete_are(a.T, out.T, q, np.eye(3))
        gain = cov @ out.T @ np.linalg.inv(np.eye(3) + out @ cov @ out.T)
        residual = a @ (cov - gain @ out @ cov) @ a.T + q - cov
    assert np.abs(residual).max() < 1e-8 * np.abs(cov).max()
    return math.sqrt(np.linalg.eigvalsh(cov[:3, :3])[-1])


SMALL = ((0, 0, 0), (0.4, 0.4, 0.8))
SCENES = [
    ("01-acoustic", acoustic(), False, ((0, 0, 0), (0.4, 0.4, 1.14)), 1,
     [(0, 0, 0), (0.4, 0.4, 0), (0.2, 0.2, 1.0), (0.2, 0.2, 1.02), (0.2, 0.2, 1.04),
      (0.2, 0.2, 1.06), (0.2, 0.2, 1.14), (0.2, 0.2, 0.4), (0, 0.4, 1.14)]),
    ("02-eight-cameras", rig(), False, SMALL, 1,
     [(0.2, 0.2, 0.24), (0, 0, 0), (0.4, 0, 0), (0.2, 0, 0.48), (0, 0, 0.68), (0.4, 0.4, 0.68),
      (0.2, 0.2, 0.68), (0, 0, 0.72), (0.2, 0.2, 0.28)]),
    ("03-hybrid", above_corners() + rig(), True, SMALL, 1,
     [(0, 0, 0.68), (0.4, 0.4, 0.68), (0.04, 0, 0.64), (0.2, 0.2, 0.8), (0.2, 0.2, 0.24),
      (0.2, 0, 0.04), (0, 0, 0)]),
    ("04-motion-capture", capture(), False, ((0, 0, 0), (20, 20, 8)), FOOT,
     [(2.5, 10, 5.6), (10, 17.5, 5.6), (10, 10, 5.6), (3, 10, 5.6), (0, 0, 5.6), (10, 10, 4),
      (10, 10, 7.2), (2.5, 0, 0)]),
    ("05-optitrack-lab", laboratory(), False, ((-3, -4.2, 0), (1.6, 3.4, 2)), 1,
     [(-0.6, -4.2, 2), (-3, -4.2, 0.6), (-0.6, 0, 0), (-0.6, 0, 1), (-0.6, 0, 2)]),
]


def main():
    random = np.random.default_rng(2005)
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "oracle.csv")
    with open(path, "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["scene", "x", "y", "z", "eigmax"])
        for name, devices, continuous, (low, high), unit, chosen in SCENES:
            drawn = [np.round(random.uniform(low, high) * unit, 4) for _ in range(34)]
            for p in [np.array(c) * unit for c in chosen] + drawn:
                try:
                    value = eigmax(devices, p, continuous)
                except Edge:
                    continue
                out.writerow([name] + ["%.10g" % c for c in p] + ["%.10g" % value])


if __name__ == "__main__":
    main()
