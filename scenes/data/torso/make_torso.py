#!/usr/bin/env python3
# Copyright (C) 2026 the Delos authors. SPDX-License-Identifier: GPL-3.0-or-later
"""A human torso as a closed mesh: writes torso.off beside this file, in millimetres.

The patient lies on the back: x towards the head, y to the patient's right, z up, the table's top
at z = 0. Ellipses across x, through stations whose sizes are round figures of an adult, joined
by smooth curves; flat caps at the thighs and at the neck. Our own geometry, measured from nobody.
Python's standard library only; the same bytes each time.
"""
import math
import os

AROUND = 48   # vertices of a ring
ALONG = 36    # rings

# Along the body, half the breadth, half the depth, height of the back above the table: mm.
STATIONS = [
    (-330, 165, 95, 6),    # thighs' roots
    (-250, 178, 110, 2),   # hips
    (-120, 150, 95, 12),   # between
    (0, 140, 92, 24),      # waist
    (120, 155, 104, 10),   # lower ribs
    (230, 172, 116, 3),    # chest
    (310, 190, 104, 4),    # armpits
    (365, 196, 82, 10),    # shoulders
    (400, 140, 64, 24),    # slope of the shoulders
    (425, 78, 55, 36),     # root of the neck
    (470, 58, 56, 44),     # neck's stump
]


def smooth(x):
    """The stations at x, by monotone cubics: no bulge that the stations don't have."""
    xs = [s[0] for s in STATIONS]
    i = max(k for k in range(len(xs) - 1) if xs[k] <= x)
    h = xs[i + 1] - xs[i]
    t = (x - xs[i]) / h
    out = []
    for c in (1, 2, 3):
        def slope(k):
            if k in (0, len(xs) - 1):
                return 0.0
            a = (STATIONS[k][c] - STATIONS[k - 1][c]) / (xs[k] - xs[k - 1])
            b = (STATIONS[k + 1][c] - STATIONS[k][c]) / (xs[k + 1] - xs[k])
            return 2 * a * b / (a + b) if a * b > 0 else 0.0

        p, q = STATIONS[i][c], STATIONS[i + 1][c]
        out.append((2 * t**3 - 3 * t**2 + 1) * p + (t**3 - 2 * t**2 + t) * h * slope(i)
                   + (3 * t**2 - 2 * t**3) * q + (t**3 - t**2) * h * slope(i + 1))
    return out


def torso():
    first, last = STATIONS[0][0], STATIONS[-1][0]
    vertices, triangles = [], []
    for k in range(ALONG):
        x = first + (last - first) * k / (ALONG - 1)
        breadth, depth, back = smooth(x)
        for j in range(AROUND):
            # Half a step off the axes, so that no vertex lies on the plane of symmetry.
            angle = 2 * math.pi * (j + 0.5) / AROUND
            vertices.append((x, breadth * math.cos(angle), back + depth * (1 + math.sin(angle))))
    for k in range(ALONG - 1):
        for j in range(AROUND):
            a, b = k * AROUND + j, k * AROUND + (j + 1) % AROUND
            c, d = a + AROUND, b + AROUND
            triangles += [(a, b, d), (a, d, c)]
    for x, k, flip in ((first, 0, False), (last, ALONG - 1, True)):
        _, depth, back = smooth(x)
        middle = len(vertices)
        vertices.append((x, 0.0, back + depth))
        for j in range(AROUND):
            a, b = k * AROUND + j, k * AROUND + (j + 1) % AROUND
            triangles.append((middle, a, b) if flip else (middle, b, a))
    return vertices, triangles


def check(vertices, triangles):
    """Closed, each edge once either way, facing outward."""
    edges = set()
    for t in triangles:
        for e in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0])):
            assert e not in edges
            edges.add(e)
    assert all((b, a) in edges for a, b in edges)
    assert len(vertices) - len(edges) // 2 + len(triangles) == 2
    volume = 0.0
    for i, j, k in triangles:
        (a, b, c), (d, e, f), (g, h, i) = vertices[i], vertices[j], vertices[k]
        volume += (a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)) / 6
    assert volume > 0
    return volume


def main():
    vertices, triangles = torso()
    vertices = [tuple(round(c, 2) + 0.0 for c in v) for v in vertices]
    volume = check(vertices, triangles)
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "torso.off")
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(f"OFF\n{len(vertices)} {len(triangles)} 0\n")
        for v in vertices:
            file.write("%.2f %.2f %.2f\n" % v)
        for t in triangles:
            file.write("3 %d %d %d\n" % t)
    print(f"{len(vertices)} vertices, {len(triangles)} triangles, {volume * 1e-6:.1f} litres")


if __name__ == "__main__":
    main()
