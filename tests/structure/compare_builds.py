#!/usr/bin/env python3
"""Whether two builds of Delos give the same answers.

    tests/structure/compare_builds.py OLD/build/release/bin/delos build/release/bin/delos

Runs both on every scene of scenes/: its field with values, lost directions and
statistics, what can be said of one point, and its selection where it has one. Numbers
are compared entry by entry; with the default tolerance 0 they must be equal to the last
bit. What differs is listed; the exit status is 1 then.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Of the run, or rounding itself: not of the answer.
NO_ANSWERS = {"seconds", "threads", "residual"}


def run(program, arguments, work):
    """What a command says: its exit status, JSON and the files that it wrote."""
    done = subprocess.run([program, *arguments], capture_output=True, text=True, cwd=work)
    answer = {"exit": done.returncode}
    if done.stdout.strip():
        answer["json"] = json.loads(done.stdout)
    elif done.returncode:
        answer["refusal"] = done.stderr
    for file in sorted(work.glob("*.csv")):
        rows = [line.split(",") for line in file.read_text().splitlines()]
        answer[file.name] = [[number(cell) for cell in row] for row in rows]
        file.unlink()
    return answer


def number(cell):
    try:
        return float(cell)
    except ValueError:
        return cell


def differences(old, new, tolerance, path=""):
    """Where two answers differ by more than the tolerance, relative to the larger."""
    if isinstance(old, dict) and isinstance(new, dict):
        for key in sorted(old.keys() - NO_ANSWERS):  # the new one may say more
            if key not in new:
                yield f"{path}.{key}: no longer there"
            else:
                yield from differences(old[key], new[key], tolerance, f"{path}.{key}")
    elif isinstance(old, list) and isinstance(new, list):
        if len(old) != len(new):
            yield f"{path}: {len(old)} and {len(new)} entries"
        for i, (a, b) in enumerate(zip(old, new)):
            yield from differences(a, b, tolerance, f"{path}[{i}]")
    elif isinstance(old, float) and isinstance(new, float):
        if old != new and not abs(old - new) <= tolerance * max(abs(old), abs(new)):
            yield f"{path}: {old!r} and {new!r}"
    elif old != new:
        yield f"{path}: {old!r} and {new!r}"


def commands(scene, text):
    yield ["field", scene, "--json", "--out", "field.csv"]
    yield ["point", scene, "--at", "0.31,0.27,0.73", "--json"]
    if "\nselection:" in text:
        yield ["select", scene, "--json", "--samples", "150", "--gap", "0.05"]


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("old", type=pathlib.Path)
    arguments.add_argument("new", type=pathlib.Path)
    arguments.add_argument("--tolerance", type=float, default=0.0)
    arguments.add_argument("scenes", nargs="*", type=pathlib.Path)
    options = arguments.parse_args()
    scenes = options.scenes or sorted((ROOT / "scenes").rglob("*.yaml"))
    differing = compared = 0
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        for scene in scenes:
            for command in commands(str(scene.resolve()), scene.read_text()):
                answers = [run(str(p.resolve()), command, work)
                           for p in (options.old, options.new)]
                found = list(differences(*answers, options.tolerance))
                compared += 1
                differing += bool(found)
                print(f"{'DIFFERS' if found else 'same':8}{command[0]} {scene.name}", flush=True)
                for line in found[:5]:
                    print("    " + line)
    print(f"{compared} answers compared, {differing} differ")
    sys.exit(differing > 0)


if __name__ == "__main__":
    main()
