#!/usr/bin/env python3
# Copyright (C) 2026 the Delos authors. SPDX-License-Identifier: GPL-3.0-or-later
"""make_paths.py DELOS SCENE > paths.csv

28 ways of a HiBall along a rail, x from 3 to 6 m in 1.5 s at y from 5.5 to 10 m, 1.9 m up, as a
filter over simulated readings has them. The mean of two runs' errors, times √2, scatters as the
error of one. The rail gives way by up to 5.03 mm under the HiBall that rides along it:
F x² (l − x)² / (3 l E I).
"""
import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

PATHS, FIRST, LAST, HEIGHT = 28, 5.5, 10.0, 1.9
EVERY = 20  # instants of a millisecond
SAG = 5.03e-3


def way(delos: str, scene: str, y: float, seed: int, folder: Path) -> list[list[float]]:
    path, out = folder / "row.csv", folder / "instants.csv"
    path.write_text(f"t,x,y,z\n0,3,{y},{HEIGHT}\n1.5,6,{y},{HEIGHT}\n")
    subprocess.run(
        [delos, "simulate", scene, "--path", path, "--runs", "2", "--seed", str(seed), "--out", out],
        check=True, capture_output=True)
    rows = []
    with open(out) as file:
        for k, row in enumerate(csv.DictReader(file)):
            if k % EVERY:
                continue
            part = (float(row["x"]) - 3) / 3
            sag = -SAG * 16 * part**2 * (1 - part) ** 2
            rows.append([float(row[a]) + math.sqrt(2) * float(row["mean_" + a]) + (sag if a == "z" else 0)
                         for a in "xyz"])
    return rows


def main() -> None:
    ways = []
    with tempfile.TemporaryDirectory() as folder:
        for n in range(PATHS):
            y = FIRST + n * (LAST - FIRST) / (PATHS - 1)
            ways.append(way(sys.argv[1], sys.argv[2], y, n + 1, Path(folder)))
    names = [f"row{n + 1:02d}" for n in range(PATHS)]
    print("t [s]," + ",".join(f"{name}.{a} [m]" for name in names for a in "xyz"))
    for k in range(len(ways[0])):
        print(f"{k * EVERY / 1000:.3f}," + ",".join(f"{v:.6f}" for one in ways for v in one[k]))


main()
