#!/usr/bin/env python3
"""Values of the scenes in scenes/hiball by another way: tests/shipped_scenes/hiball.csv.

Every photodiode behind every lens is asked about every LED by intersecting a ray with a
plane, derivatives are complex steps through that intersection, and the steady state is
SciPy's solve_discrete_are of the six-state filter. Nothing is shared with the program.

    python3 hiball_oracle.py > hiball.csv        # needs numpy and scipy; about a minute
"""

import numpy as np
from scipy.linalg import block_diag, solve_discrete_are

FOCAL = 0.0382
RATE = 1000.0
Q = np.array([0.261782402027**2, 0.261782402027**2, 0.0815344167**2])
TILT = np.arctan(2.0)


def axes(layout):
    around = {"six": 5, "four": 3}[layout]
    turns = 2 * np.pi * np.arange(around) / around
    side = [[np.sin(TILT) * np.cos(a), np.sin(TILT) * np.sin(a), np.cos(TILT)] for a in turns]
    return np.array([[0, 0, 1], *side])


def views(n, rule):
    for i in range(len(n)):
        for j in range(len(n)):
            apart = np.degrees(np.arccos(np.clip(n[i] @ n[j], -1, 1)))
            if i == j or rule == "all_pairs" or (rule == "adjacent" and apart < 64):
                yield i, j


def ceiling(pattern):
    lit = {
        "full": lambda i, j: True,
        "half": lambda i, j: j % 2 == 0,
        "checkerboard": lambda i, j: (i + j) % 2 == 0,
    }[pattern]
    return np.array([[i / 10, j / 10, 2.8] for i in range(64) for j in range(91) if lit(i, j)])


def rotation(roll, pitch, yaw):
    c, s = np.cos, np.sin
    x = [[1, 0, 0], [0, c(roll), -s(roll)], [0, s(roll), c(roll)]]
    y = [[c(pitch), 0, s(pitch)], [0, 1, 0], [-s(pitch), 0, c(pitch)]]
    z = [[c(yaw), -s(yaw), 0], [s(yaw), c(yaw), 0], [0, 0, 1]]
    return np.array(z) @ np.array(y) @ np.array(x)


def image(leds, n, i, j, half):
    """Where light of LEDs (rows, in the sensor's frame) falls, and on which side it came."""
    lens, middle = FOCAL / 2 * n[j], -FOCAL / 2 * n[i]
    level = np.cross([0, 0, 1], n[i])
    e_u = level / np.linalg.norm(level) if i > 0 else np.array([1.0, 0, 0])
    e_v = np.cross(n[i], e_u)
    ray = lens - leds
    t = ((middle - lens) @ n[i]) / (ray @ n[i])
    spot = lens + t[:, None] * ray - middle
    return spot @ e_u / half, spot @ e_v / half, ray @ n[i] < 0


def mean_information(position, turn, leds, scene):
    """Mean over visible pairs of a sighting's information about the position."""
    n, half = axes(scene["layout"]), FOCAL * np.tan(np.radians(scene["field"]) / 2)
    local = (leds - position) @ turn
    total, pairs = np.zeros((3, 3)), 0
    for i, j in views(n, scene["views"]):
        u, v, front = image(local, n, i, j, half)
        seen = front & (abs(u) <= 1) & (abs(v) <= 1)
        if not seen.any():
            continue
        step = 1e-20
        slopes = []
        for axis in range(3):
            moved = local[seen] - 1j * step * turn[axis]  # the target moves, not the LED
            du, dv, _ = image(moved, n, i, j, half)
            slopes.append([du.imag / step, dv.imag / step])
        rows = np.array(slopes)  # axis, coordinate, LED
        total += np.einsum("acl,bcl->ab", rows, rows)
        pairs += seen.sum()
    return total / pairs / scene["r"]


def eigmax(information):
    """Root of the largest eigenvalue of the a-posteriori position covariance."""
    dt = 1 / RATE
    A = block_diag(*[[[1, dt], [0, 1]]] * 3)
    Qd = block_diag(*[q * np.array([[dt**3 / 3, dt**2 / 2], [dt**2 / 2, dt]]) for q in Q])
    H = np.linalg.cholesky(information).T @ np.kron(np.eye(3), [1, 0])
    # In units in which the states are about one: the solver squares them.
    scale = np.kron(np.ones(3), [1e-4, 1e-2])
    A, Qd, H = A * scale / scale[:, None], Qd / np.outer(scale, scale), H * scale
    P = solve_discrete_are(A.T, H.T, Qd, np.eye(3))
    P = P - P @ H.T @ np.linalg.solve(np.eye(3) + H @ P @ H.T, H @ P)
    P = P * np.outer(scale, scale)
    return np.sqrt(np.linalg.eigvalsh(P[::2, ::2])[-1])


BASE = {"layout": "six", "views": "adjacent", "field": 6.0, "pattern": "full", "r": 2.1e-5}
SCENES = [
    {},
    {"pattern": "half"},
    {"pattern": "checkerboard"},
    {"field": 12.0},
    {"views": "primary", "field": 12.0},
    {"layout": "four", "field": 12.0},
    {"layout": "four", "field": 12.0, "views": "all_pairs", "pattern": "half"},
]
POSES = [
    ([3, 6, 1.9], [0, 0, 0]),
    ([4.31, 7.77, 1.9], [0, 0, 0]),
    ([6, 9, 1.9], [0, 0, 0]),
    ([5.21, 8.02, 1.0], [0, 0, 0]),
    ([4.4, 7.1, 1.9], [-30, 0, 0]),
    ([4.4, 7.1, 1.9], [0, 20, 0]),
    ([3.9, 8.3, 1.5], [10, -5, 40]),
]

if __name__ == "__main__":
    print("layout,views,field,pattern,x,y,z,roll,pitch,yaw,eigmax")
    for change in SCENES:
        scene = {**BASE, **change}
        for at, degrees in POSES:
            S = mean_information(np.array(at), rotation(*np.radians(degrees)),
                                 ceiling(scene["pattern"]), scene)
            print(scene["layout"], scene["views"], scene["field"], scene["pattern"], *at,
                  *degrees, repr(float(eigmax(S))), sep=",")
