"""Scenes as values, their mistakes as exceptions with places."""
import delos
import pytest


def test_a_scene_is_a_value(scenes):
    scene = delos.load(scenes / "01-acoustic.yaml")
    before = scene.text()
    higher = scene.set({"devices.s1.at.z": 1.2})
    assert scene.text() == before
    assert higher.text() != before
    assert higher.set({"devices.s1.at.z": 1.2141}).text() == before


def test_a_scene_can_be_a_dict():
    """p² − q p − q r = 0 of each axis' prior, with q = 1 m²/s a second, r = 2 m²."""
    scene = delos.parse(
        {
            "delos": 1,
            "metric": "sigma_x",
            "motion": {"type": "position", "q": [1, 1, 1]},
            "sample": {"points": [[0, 0, 0]]},
            "devices": [
                {
                    "name": f"r{axis}",
                    "type": "range",
                    "rate": "1 Hz",
                    "at": [-10.0 if k == axis else 0.0 for k in range(3)],
                    "params": {"sigma": 2**0.5},
                }
                for axis in range(3)
            ],
        }
    )
    assert delos.field(scene).mean == pytest.approx(2**0.5, rel=1e-12)


def test_a_mistake_has_its_place(tmp_path, scenes):
    file = tmp_path / "wrong.yaml"
    text = (scenes / "01-acoustic.yaml").read_text()
    file.write_text(text.replace("rate:", "rat:", 1))
    with pytest.raises(delos.SceneError) as raised:
        delos.load(file)
    finding = raised.value.findings[0]
    line = next(i for i, l in enumerate(text.splitlines(), 1) if "rate:" in l)
    assert finding["file"] == str(file) and finding["line"] == line
    assert "did you mean 'rate'?" in str(raised.value)


def test_a_file_that_isnt_there():
    with pytest.raises(delos.SceneError, match="nowhere.yaml"):
        delos.load("nowhere.yaml")


def test_a_wrong_question(scenes):
    with pytest.raises(ValueError, match="choose auto, spectral"):
        delos.field(scenes / "01-acoustic.yaml", solver="best")
    with pytest.raises(ValueError, match="three numbers"):
        delos.point(scenes / "01-acoustic.yaml", (1, 2))


def test_a_scene_is_saved(tmp_path, scenes):
    scene = delos.load(scenes / "01-acoustic.yaml", metric="sigma_z")
    scene.save(tmp_path / "copy.yaml")
    assert delos.field(tmp_path / "copy.yaml").mean == delos.field(scene).mean


def test_help_says_what_is_what():
    for thing in (delos.field, delos.load, delos.optimize, delos.Field.values):
        assert thing.__doc__
