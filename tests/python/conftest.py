"""The program beside the package: each number must be the other's."""
import json
import os
import pathlib
import subprocess

import pytest

SCENES = pathlib.Path(os.environ["DELOS_SCENES"])


def without_times(document):
    """Seconds and threads differ from run to run."""
    if isinstance(document, dict):
        return {
            key: without_times(value)
            for key, value in document.items()
            if key not in ("seconds", "threads")
        }
    if isinstance(document, list):
        return [without_times(value) for value in document]
    return document


@pytest.fixture
def scenes():
    return SCENES


@pytest.fixture
def program():
    """program("field", scene, …) gives the document of --json."""

    def run(*arguments):
        command = [os.environ["DELOS_PROGRAM"], *map(str, arguments), "--json"]
        done = subprocess.run(command, capture_output=True, text=True, timeout=300)
        assert done.returncode == 0, done.stderr
        return without_times(json.loads(done.stdout))

    return run
