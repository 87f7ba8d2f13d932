"""mpirun against the same command without it: the same bytes, however many ranks."""
import json
import os
import pathlib
import signal
import subprocess
import time

import pytest

SCENES = pathlib.Path(os.environ["DELOS_SCENES"])
PROGRAM = os.environ["DELOS_PROGRAM"]
ROOM = ["--seed", "1", "--starts", "5", "--evaluations", "100", "--samples", "100"]


def environment():
    # Tests may run as root, and on fewer cores than ranks.
    return os.environ | {
        "OMPI_ALLOW_RUN_AS_ROOT": "1",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
        "OMPI_MCA_rmaps_base_oversubscribe": "1",
        "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
    }


def mpirun(ranks, *arguments):
    command = [os.environ["DELOS_MPIRUN"], "-n", str(ranks), PROGRAM, *map(str, arguments)]
    return subprocess.Popen(
        command,
        env=environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def output(process):
    out, err = process.communicate(timeout=300)
    assert process.returncode == 0, err
    return out


def alone(*arguments):
    return output(
        subprocess.Popen(
            [PROGRAM, *map(str, arguments)],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
    )


def without_seconds(text):
    document = json.loads(text)
    document.pop("seconds", None)
    return document


@pytest.mark.parametrize("ranks", [1, 2, 4])
def test_a_search_gives_the_same(ranks):
    search = ["optimize", SCENES / "09-camera-room.yaml", *ROOM, "--json"]
    assert without_seconds(output(mpirun(ranks, *search))) == without_seconds(
        alone(*search)
    )


def test_a_front_gives_the_same():
    front = [
        "tradeoff",
        SCENES / "10-better-speakers.yaml",
        *["--limit", "budget=4.0..4.4", "--levels", "2", "--starts", "3"],
        *["--evaluations", "30", "--json"],
    ]
    assert output(mpirun(2, *front)) == alone(*front)


@pytest.mark.parametrize("ranks", [2, 4])
def test_a_simulation_gives_the_same(ranks):
    runs = ["simulate", SCENES / "01-acoustic.yaml", "--runs", "1000", "--seconds", "0.4"]
    assert output(mpirun(ranks, *runs, "--json")) == alone(*runs, "--json")


def test_kept_runs_go_on_with_any_number_of_ranks(tmp_path):
    def runs(count):
        return [
            *["simulate", SCENES / "01-acoustic.yaml", "--at", "0.2,0.2,0.4", "--runs"],
            *[count, "--seconds", "0.4", "--json"],
        ]

    kept = ["--keep", tmp_path / "runs.bin"]
    output(mpirun(2, *runs(300), *kept))
    assert output(mpirun(3, *runs(900), *kept)) == alone(*runs(900))


def test_a_killed_rank_ends_the_run_and_the_study_goes_on(tmp_path):
    scene = SCENES / "09-camera-room.yaml"
    whole = tmp_path / "whole.study"
    alone("optimize", scene, *ROOM, "--study", whole)
    study = tmp_path / "crew.study"
    run = mpirun(2, "optimize", scene, *ROOM, "--study", study)
    while run.poll() is None and evaluations(study) < 10:
        time.sleep(0.02)
    assert run.poll() is None, "it ended before it could be killed"
    os.kill(ranks_of(run)[1], signal.SIGKILL)
    _, err = run.communicate(timeout=60)
    assert run.returncode != 0
    assert "exited on signal 9" in err  # mpirun's own sentence
    output(mpirun(3, "study", study, "resume"))
    assert alone("study", study, "export") == alone("study", whole, "export")


def evaluations(study):
    if not study.exists():
        return 0
    shown = json.loads(alone("study", study, "show", "--json"))
    return shown["rounds"][0]["evaluations"]


def ranks_of(run):
    children = pathlib.Path(f"/proc/{run.pid}/task/{run.pid}/children").read_text()
    found = {}
    for child in map(int, children.split()):
        variables = pathlib.Path(f"/proc/{child}/environ").read_bytes().split(b"\0")
        for variable in variables:
            if variable.startswith(b"OMPI_COMM_WORLD_RANK="):
                found[int(variable.split(b"=")[1])] = child
    return found


def test_three_shards_are_the_whole(tmp_path):
    scene = SCENES / "09-camera-room.yaml"
    parts = []
    for part in (1, 2, 3):
        parts.append(tmp_path / f"{part}.study")
        alone("optimize", scene, *ROOM, "--shard", f"{part}/3", "--study", parts[-1])
    merged = alone("merge", tmp_path / "room.study", *parts, "--json")
    whole = alone("optimize", scene, *ROOM, "--json")
    different = {"seconds", "study", "warnings"}
    document, expected = json.loads(merged), json.loads(whole)
    assert {k: v for k, v in document.items() if k not in different} == {
        k: v for k, v in expected.items() if k not in different
    }


def test_a_scene_that_isnt_in_order_is_told_once():
    run = mpirun(2, "optimize", "nowhere.yaml")
    _, err = run.communicate(timeout=60)
    assert run.returncode != 0
    assert err.count("nowhere.yaml") == 1


def test_other_plugins_are_named(tmp_path):
    command = [
        os.environ["DELOS_MPIRUN"],
        *["-n", "1", PROGRAM, "optimize", str(SCENES / "09-camera-room.yaml"), *ROOM],
        *[":", "-n", "1", "-x", f"DELOS_PLUGIN_PATH={tmp_path}", PROGRAM, "optimize"],
        *[str(SCENES / "09-camera-room.yaml"), *ROOM],
    ]
    camera = pathlib.Path(PROGRAM).parent.parent / "lib/delos/pinhole_camera.so"
    (tmp_path / camera.name).write_bytes(camera.read_bytes() + b"\0")
    run = subprocess.run(
        command, env=environment(), capture_output=True, text=True, timeout=120
    )
    assert run.returncode != 0
    assert "has another plugin 'pinhole_camera' than process 0" in run.stderr
