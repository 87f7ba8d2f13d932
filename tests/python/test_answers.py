"""Every document is the program's, of which other tests know the numbers."""
import delos
import numpy as np
import pytest
from conftest import without_times


def test_field_is_the_programs(scenes, program):
    scene = scenes / "01-acoustic.yaml"
    document = program("field", scene)
    document.pop("warnings", None)  # the program's own look at the scene
    assert without_times(delos.field(scene).json()) == document


def test_adaptive_field_is_the_programs(scenes, program):
    scene = scenes / "07-torso.yaml"
    document = program("field", scene)
    document.pop("warnings", None)
    assert without_times(delos.field(scene).json()) == document


def test_statistics_are_those_of_the_arrays(scenes):
    field = delos.field(scenes / "01-acoustic.yaml")
    finite = field.values[np.isfinite(field.values)]
    assert field.mean == pytest.approx(finite.mean(), rel=1e-12)
    assert field.median == pytest.approx(np.median(finite), rel=1e-12)
    value, at = field.worst
    assert value == finite.max()
    assert np.any(np.all(field.points == at, axis=1))


def test_point_is_the_programs(scenes, program):
    scene = scenes / "01-acoustic.yaml"
    assert without_times(delos.point(scene, (0.5, 0.4, 0.6))) == program(
        "point", scene, "--at", "0.5,0.4,0.6"
    )


def test_comparison_is_the_programs(scenes, program):
    both = [scenes / "02-eight-cameras.yaml", scenes / "03-hybrid.yaml"]
    assert without_times(delos.compare(both)) == program("compare", *both)


def test_comparison_answers_specifications(scenes):
    scene = delos.load(scenes / "01-acoustic.yaml")
    noisier = scene.set({"devices.s1.params.r": 0.02})
    document = delos.compare([scene, noisier], specs=["eigmax <= 3 cm"])
    for side, field in zip(document["scenes"], map(delos.field, (scene, noisier))):
        assert side["specs"][0]["share"] == np.mean(field.values <= 0.03)
        assert field.meets(["eigmax <= 3 cm"]) == side["specs"]


def test_check_is_the_programs(scenes, program):
    scene = scenes / "01-acoustic.yaml"
    assert without_times(delos.check(scene)) == program("check", scene)[0]


def test_simulation_is_the_programs(scenes, program):
    scene = scenes / "01-acoustic.yaml"
    document = delos.simulate(scene, (0.5, 0.4, 0.6), runs=50, seed=3)
    assert without_times(document) == program(
        "simulate", scene, "--at", "0.5,0.4,0.6", "--runs", 50, "--seed", 3
    )


def test_search_is_the_programs(scenes, program):
    scene = scenes / "09-camera-room.yaml"
    document = delos.optimize(scene, seed=1, starts=2, evaluations=40)
    best = document.pop("best_scene")
    of_program = program(
        "optimize", scene, "--seed", 1, "--starts", 2, "--evaluations", 40
    )
    of_program.pop("study")
    of_program.pop("warnings", None)
    assert without_times(document) == of_program
    assert delos.field(best).mean == document["best_field"]["mean"]


def test_selection_is_the_programs(scenes, program):
    scene = scenes / "12-ceiling-anchors.yaml"
    document = delos.select(scene, gap=0.05)
    best = document.pop("best_scene")
    assert without_times(document) == program("select", scene, "--gap", 0.05)
    assert len(best.devices) >= len(document["chosen"])


def test_study_is_resumed(scenes, tmp_path):
    file = tmp_path / "room.study"
    options = {"seed": 1, "starts": 1, "evaluations": 20}
    document = delos.optimize(scenes / "09-camera-room.yaml", study=file, **options)
    study = delos.Study(file)
    assert study.json()["rounds"][0]["ended"]
    study.act("extend", "10")
    assert study.resume()["best"] <= document["best"]
    assert [act["verb"] for act in study.json()["acts"]] == ["extend"]
    with pytest.raises(ValueError, match="no variable"):
        study.act("lock", "nobody.*")
