"""How well anything could be tracked with a given rig of sensors, from Python.

    import delos
    field = delos.field("scenes/01-acoustic.yaml")
    print(field.mean, field.values.shape)

Quantities are SI. Scenes are values: set() gives another one. Documents are those of the
program's --json, as dicts.
"""
from ._delos import (
    Field,
    Scene,
    SceneError,
    Study,
    __version__,
    add_device,
    check,
    compare,
    field,
    front,
    load,
    optimize,
    parse,
    point,
    select,
    simulate,
)

__all__ = [
    "Field",
    "Scene",
    "SceneError",
    "Study",
    "add_device",
    "check",
    "compare",
    "device",
    "field",
    "front",
    "load",
    "optimize",
    "parse",
    "point",
    "select",
    "simulate",
]


def device(id, **params):
    """Decorate a class whose observe(p) is a device: see add_device().

    @delos.device("my_range", sigma=(0.01, "m"))
    class MyRange:
        def __init__(self, sigma): ...
    """
    return lambda type: add_device(id, type, params)
