"""A device in Python beside the plugin of the same equation."""
import delos
import numpy as np
import pytest


@delos.device("python_range", sigma=(0.001, "m"))
class PythonRange:
    """z = |p|, H = pᵀ/|p|, R = σ²: the distance to a point."""

    def __init__(self, sigma):
        self.sigma = sigma

    def observe(self, p):
        distance = np.linalg.norm(p)
        if distance == 0:
            return None
        return [distance], [p / distance], [[self.sigma**2]]


def scene_of(scenes, type, params):
    scene = delos.load(scenes / "01-acoustic.yaml", set={"sample.volume.step": 0.2})
    names = scene.devices
    return scene.set(
        {f"devices.{name}.type": type for name in names}
        | {f"devices.{name}.params": params for name in names}
    )


def test_its_field_is_the_plugins(scenes):
    mine = scene_of(scenes, "python_range", {"sigma": 0.002})
    theirs = scene_of(scenes, "range", {"sigma": 0.002})
    a, b = delos.field(mine).values, delos.field(theirs).values
    assert len(a) > 10
    np.testing.assert_allclose(a, b, rtol=1e-12)


def test_what_it_raises_is_told(scenes):
    @delos.device("python_fault")
    class Fault:
        def observe(self, p):
            raise ZeroDivisionError("nothing to divide by")

    scene = scene_of(scenes, "python_fault", {})
    with pytest.raises(delos.SceneError, match="nothing to divide by"):
        delos.field(scene)


def test_shapes_are_checked(scenes):
    @delos.device("python_shapes")
    class Shapes:
        def observe(self, p):
            return [1.0], [[1.0, 0.0]], [[1.0]]

    with pytest.raises(delos.SceneError, match="m×3"):
        delos.field(scene_of(scenes, "python_shapes", {}))


def test_a_plugins_id_is_taken():
    with pytest.raises(ValueError, match="already"):
        delos.add_device("range", PythonRange)


def test_a_cell_can_be_run_again(scenes):
    with pytest.raises(delos.SceneError, match="no plugin 'python_again'"):
        scene_of(scenes, "python_again", {})
    fields = []
    for sigma in (0.001, 0.002):

        @delos.device("python_again")
        class Again(PythonRange):
            def __init__(self, sigma=sigma):
                super().__init__(sigma)

        fields.append(delos.field(scene_of(scenes, "python_again", {})).values)
    assert np.all(fields[1] > fields[0])
