#!/usr/bin/env python3
"""Run the cells of notebooks and write what they print: run.py [--check] FILE...

--check: write nothing; fail where a cell prints something else than is written.
Needs nothing but Python, unlike Jupyter, which shows the same files.
"""
import ast
import contextlib
import io
import json
import pathlib
import sys


def printed(source, names):
    """What a cell prints, and its last expression's value as Python shows it."""
    tree = ast.parse(source)
    shown = None
    if tree.body and isinstance(tree.body[-1], ast.Expr):
        shown = ast.Expression(tree.body.pop().value)
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(tree, "cell", "exec"), names)
        if shown is not None:
            value = eval(compile(shown, "cell", "eval"), names)
            if value is not None:
                print(repr(value))
    return out.getvalue()


def run(file, check):
    notebook = json.loads(file.read_text())
    names = {}
    for number, cell in enumerate(notebook["cells"]):
        if cell["cell_type"] != "code":
            continue
        text = printed("".join(cell["source"]), names)
        outputs = []
        if text:
            lines = text.splitlines(keepends=True)
            outputs = [{"name": "stdout", "output_type": "stream", "text": lines}]
        if check and outputs != cell["outputs"]:
            sys.exit(f"{file.name}, cell {number} prints\n{text}")
        cell["outputs"] = outputs
        cell["execution_count"] = number
    if not check:
        file.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    arguments = sys.argv[1:]
    check = "--check" in arguments
    for name in arguments:
        if name != "--check":
            run(pathlib.Path(name), check)
