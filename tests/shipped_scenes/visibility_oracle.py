#!/usr/bin/env python3
"""How many cameras see a point, in the scenes 06 to 08: writes visibility.csv.

Independent on purpose: it reads no scene, tries every triangle (Moeller and Trumbore, J. Graphics
Tools 2(1), 1997), and builds the bodies itself; only torso.off is read. Columns: scene, x, y, z
of the target [m], its yaw [degrees], coverage.

Points at which a number within 1e-6 of its limit decides (a barycentric coordinate, a part of the
segment, a frustum's side) are left out: there the last bit decides. Python's standard library only.
"""
import csv
import math
import os
import random

HERE = os.path.dirname(os.path.abspath(__file__))
EPS = 1e-6
SKIN = 1e-3


class Edge(Exception):
    pass


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def scaled(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def norm(a):
    return math.sqrt(dot(a, a))


def unit(a):
    return scaled(a, 1 / norm(a))


# Bodies are lists of triangles, three corners each.

def prism(corners, z0, z1, caps):
    """Upright walls over a polygon; caps: triangles that fill it, as indices."""
    out = []
    for i, (x, y) in enumerate(corners):
        u, v = corners[(i + 1) % len(corners)]
        out += [((x, y, z0), (u, v, z0), (u, v, z1)), ((x, y, z0), (u, v, z1), (x, y, z1))]
    for t in caps:
        for z in (z0, z1):
            out.append(tuple(corners[i] + (z,) for i in t))
    return out


def box(x0, y0, z0, x1, y1, z1):
    return prism([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], z0, z1, [(0, 1, 2), (0, 2, 3)])


def cylinder(x, y, z0, radius, height, sides=32):
    ring = [(x + radius * math.cos(2 * math.pi * i / sides),
             y + radius * math.sin(2 * math.pi * i / sides)) for i in range(sides)]
    return prism(ring, z0, z0 + height, [(0, i, i + 1) for i in range(1, sides - 1)])


def torso(place):
    with open(os.path.join(HERE, "../../scenes/data/torso/torso.off"), encoding="ascii") as file:
        lines = file.read().split("\n")
    count, faces, _ = (int(s) for s in lines[1].split())
    points = [tuple(float(s) * 0.001 for s in line.split()) for line in lines[2:2 + count]]
    placed = [place(p) for p in points]
    triangles = [tuple(placed[int(s)] for s in line.split()[1:])
                 for line in lines[2 + count:2 + count + faces]]
    return points, triangles


def prepared(triangles):
    return [(a, sub(b, a), sub(c, a)) for a, b, c in triangles]


def meets(origin, way, triangle):
    """1: the segment meets the triangle; 0: it doesn't; None: too near to say."""
    a, e1, e2 = triangle
    p = cross(way, e2)
    det = dot(e1, p)
    s = sub(origin, a)
    if abs(det) < 1e-12 * norm(way) * norm(cross(e1, e2)):
        # Along the plane: it misses where it isn't in it.
        return 0 if abs(dot(s, unit(cross(e1, e2)))) > EPS else None
    u = dot(s, p) / det
    if u < -EPS or u > 1 + EPS:
        return 0
    q = cross(s, e1)
    v = dot(way, q) / det
    if v < -EPS or u + v > 1 + EPS:
        return 0
    t = dot(e2, q) / det
    if t < -EPS or t > 1 + EPS:
        return 0
    sure = u > EPS and v > EPS and u + v < 1 - EPS and EPS < t < 1 - EPS
    return 1 if sure else None


def ball(origin, way, middle, radius):
    """The same for a sphere of flat triangles, which lies between 0.99 and 1 of its radius."""
    s = sub(middle, origin)
    t = min(1, max(0, dot(s, way) / dot(way, way)))
    nearest = norm(sub(s, scaled(way, t)))
    if nearest > radius * (1 + EPS):
        return 0
    # An end inside of the sphere is none of these scenes' cases.
    return 1 if nearest < 0.99 * radius and 0 < t < 1 else None


def blocked(start, end, triangles, balls=()):
    length = norm(sub(end, start))
    margin = scaled(sub(end, start), SKIN / length)
    origin = add(start, margin)
    way = sub(sub(end, margin), origin)
    doubt = False
    for t in triangles:
        hit = meets(origin, way, t)
        if hit:
            return True
        doubt = doubt or hit is None
    for middle, radius in balls:
        hit = ball(origin, way, middle, radius)
        if hit:
            return True
        doubt = doubt or hit is None
    if doubt:
        raise Edge
    return False


class Camera:
    """axes: the sensor's x (right), y (down), z (forward) in the world."""

    def __init__(self, at, axes, focal, pitch, columns, lines, near, far):
        self.at, self.axes = at, axes
        self.limits = (columns * pitch / 2 / focal, lines * pitch / 2 / focal)
        self.near, self.far = near, far

    def has_in_view(self, p):
        x, y, z = (dot(axis, sub(p, self.at)) for axis in self.axes)
        if z <= 0:
            return False
        ratios = (abs(x / z) / self.limits[0], abs(y / z) / self.limits[1],
                  z / self.far, self.near / z)
        if any(abs(r - 1) < EPS for r in ratios):
            raise Edge
        return max(ratios) < 1


def aimed(at, to, *lens):
    z = unit(sub(to, at))
    x = unit(cross(z, (0.0, 0.0, 1.0)))
    return Camera(at, (x, cross(z, x), z), *lens)


def laboratory_cameras():
    """data/optitrack-room/cameras.csv: y up, a camera looks along its -z with y up."""
    out = []
    path = os.path.join(HERE, "../../scenes/data/optitrack-room/cameras.csv")
    with open(path, encoding="ascii") as file:
        table = [line.split(",") for line in file.read().split("\n") if line and line[0] != "#"]
    for row in table:
        try:
            x, y, z, qx, qy, qz, qw = (float(s) for s in row[-7:])
        except ValueError:
            continue  # the header
        n = math.sqrt(qx * qx + qy * qy + qz * qz + qw * qw)
        u, w = (qx / n, qy / n, qz / n), qw / n

        def turned(v):
            c = cross(u, add(cross(u, v), scaled(v, w)))
            t = add(v, scaled(c, 2))
            return (t[0], -t[2], t[1])

        axes = tuple(turned(a) for a in ((1, 0, 0), (0, -1, 0), (0, 0, -1)))
        out.append(Camera((x, -z, y), axes, 6.8e-3, 5.5e-6, 2048, 1088, 0.3, 15))
    assert len(out) == 8
    return out


def furniture():
    boxes = [
        # gallery, posts
        (-3.60, 0.203, 2.207, -2.253, 2.897, 2.353),
        (-2.347, 0.253, 0, -2.253, 0.347, 2.207),
        (-2.347, 2.753, 0, -2.253, 2.847, 2.207),
        # railing: rails to the east, south and north; posts
        (-2.297, 0.203, 3.30, -2.253, 2.897, 3.35),
        (-2.297, 0.203, 2.82, -2.253, 2.897, 2.86),
        (-3.60, 0.203, 3.30, -2.297, 0.247, 3.35),
        (-3.60, 0.203, 2.82, -2.297, 0.247, 2.86),
        (-3.60, 2.853, 3.30, -2.297, 2.897, 3.35),
        (-3.60, 2.853, 2.82, -2.297, 2.897, 2.86),
        (-2.297, 0.203, 2.353, -2.253, 0.247, 3.30),
        (-2.297, 1.523, 2.353, -2.253, 1.567, 3.30),
        (-2.297, 2.853, 2.353, -2.253, 2.897, 3.30),
        # desks
        (0.95, 0.30, 0.71, 1.75, 1.90, 0.74),
        (1.053, 0.303, 0, 1.647, 0.327, 0.71),
        (1.053, 1.873, 0, 1.647, 1.897, 0.71),
        (0.95, 2.05, 0.71, 1.75, 3.60, 0.74),
        (1.053, 2.053, 0, 1.647, 2.077, 0.71),
        (1.053, 3.573, 0, 1.647, 3.597, 0.71),
        # shelf: back, sides, boards
        (-1.703, 3.023, 0, 0.103, 3.043, 1.90),
        (-1.703, 2.643, 0, -1.673, 3.023, 1.90),
        (0.073, 2.643, 0, 0.103, 3.023, 1.90),
        (-1.673, 2.643, 0.10, 0.073, 3.023, 0.13),
        (-1.673, 2.643, 0.54, 0.073, 3.023, 0.57),
        (-1.673, 2.643, 0.98, 0.073, 3.023, 1.01),
        (-1.673, 2.643, 1.42, 0.073, 3.023, 1.45),
        (-1.673, 2.643, 1.87, 0.073, 3.023, 1.90),
        # cupboard
        (-3.60, -4.10, 0, -2.90, -2.90, 1.95),
    ]
    out = [t for b in boxes for t in box(*b)]
    out += cylinder(-1.95, -1.70, 0, 0.18, 3.6) + cylinder(0.55, -1.70, 0, 0.18, 3.6)
    counter = [(0.15, -4.05), (1.75, -4.05), (1.75, -2.55), (1.15, -2.55), (1.15, -3.45),
               (0.15, -3.45)]
    out += prism(counter, 0, 1.05, [(0, 1, 4), (0, 4, 5), (1, 2, 4), (2, 3, 4)])
    return out


def drawn(dice, count, low, high):
    return [tuple(round(a + (b - a) * dice.random(), 3) for a, b in zip(low, high))
            for _ in range(count)]


def laboratory():
    cameras, triangles, dice = laboratory_cameras(), prepared(furniture()), random.Random(6)
    points = drawn(dice, 240, (-3.0, -4.2, 0), (1.6, 3.4, 2.0))
    for low, high in (
        ((-3.0, 0.3, 0), (-2.3, 2.8, 2.0)),    # beneath the gallery
        ((0.95, 0.3, 0), (1.6, 3.4, 0.7)),     # beneath the desks
        ((-1.7, 2.6, 0), (0.1, 3.0, 1.9)),     # in the shelf
        ((-1.7, 3.05, 0), (0.1, 3.4, 1.9)),    # behind it
        ((0.2, -4.2, 0), (1.6, -2.4, 1.2)),    # about the counter
        ((-3.0, -4.2, 0), (-2.7, -2.8, 2.0)),  # at the cupboard
        ((0.2, -2.1, 0), (0.9, -1.3, 2.0)),    # about a pillar
    ):
        points += drawn(dice, 30, low, high)
    for p in points:
        yield "06-furnished-lab", p, 0, lambda: sum(
            c.has_in_view(p) and not blocked(c.at, p, triangles) for c in cameras)


def patient():
    lens = (12e-3, 7.4e-6, 640, 480, 0.2, 5)
    cameras = [aimed((0.95, 0.85, 1.25), (0.15, 0.02, 0.15), *lens),
               aimed((0.85, -0.95, 1.15), (0.1, -0.03, 0.15), *lens),
               aimed((-1.0, 0.25, 1.3), (0.0, 0.0, 0.17), *lens)]
    vertices, triangles = torso(lambda p: p)
    triangles = prepared(triangles + box(-0.95, -0.32, -0.08, 0.95, 0.32, 0))
    points = vertices[::5] + drawn(random.Random(7), 60, (-0.5, -0.4, -0.3), (0.6, 0.4, 0.5))
    for p in points:
        yield "07-torso", p, 0, lambda: sum(
            c.has_in_view(p) and not blocked(c.at, p, triangles) for c in cameras)


def chest():
    lens = (4e-3, 7.4e-6, 640, 480, 0.1, 12)
    cameras = [aimed((x, y, 2.4), (0, 0, 1.2), *lens)
               for x, y in ((2, 2), (-2, 2), (-2, -2), (2, -2))]
    # Upright, the chest to the front: the mesh's z is forward, its x up, its y to the right.
    _, triangles = torso(lambda p: (p[2] - 0.11, -p[1], p[0] + 1.05))
    for y in (0.25, -0.25):
        triangles += cylinder(0, y, 0.75, 0.045, 0.65)
    triangles = prepared(triangles)
    balls = [((0.02, 0, 1.66), 0.1)]
    marker = (0.14, 0, 1.3)
    dice = random.Random(8)
    for heading in range(0, 360, 30):
        c, s = math.cos(math.radians(heading)), math.sin(math.radians(heading))

        def to_world(v):
            return (c * v[0] - s * v[1], s * v[0] + c * v[1], v[2])

        def to_target(v):
            return (c * v[0] + s * v[1], c * v[1] - s * v[0], v[2])

        for p in drawn(dice, 25, (-1.5, -1.5, 0), (1.5, 1.5, 0)):
            yield "08-self-occlusion", p, heading, lambda: sum(
                k.has_in_view(add(p, to_world(marker)))
                and not blocked(to_target(sub(k.at, p)), marker, triangles, balls)
                for k in cameras)


def main():
    written, left_out = {}, {}
    with open(os.path.join(HERE, "visibility.csv"), "w", encoding="ascii", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["scene", "x", "y", "z", "yaw", "coverage"])
        for scene in (laboratory, patient, chest):
            for name, p, heading, coverage in scene():
                try:
                    count = coverage()
                except Edge:
                    left_out[name] = left_out.get(name, 0) + 1
                    continue
                out.writerow([name, *(f"{x:.12g}" for x in p), heading, count])
                counts = written.setdefault(name, {})
                counts[count] = counts.get(count, 0) + 1
    for name, counts in written.items():
        print(name, dict(sorted(counts.items())), "left out:", left_out.get(name, 0))


if __name__ == "__main__":
    main()
