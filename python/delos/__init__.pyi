import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

_Path = str | os.PathLike[str]
_Document = dict[str, Any]
_Done = Callable[[int, int], object] | None
_Found = Callable[[int, int, float], object] | None
_Class = TypeVar("_Class", bound=type)

__version__: str

class SceneError(ValueError):
    """A scene or a device that is at fault."""

    findings: list[_Document]

class Scene:
    """A scene that is in order. It doesn't change: set() gives another one."""

    @property
    def name(self) -> str: ...
    @property
    def metric(self) -> str: ...
    @property
    def devices(self) -> list[str]: ...
    def set(self, changes: Mapping[str, Any]) -> Scene: ...
    def text(self) -> str: ...
    def save(self, file: _Path) -> None: ...

class Field:
    """A metric over the samples of a scene; SI units."""

    @property
    def values(self) -> NDArray[np.float64]: ...
    @property
    def points(self) -> NDArray[np.float64]: ...
    @property
    def observable(self) -> NDArray[np.bool_]: ...
    @property
    def inside(self) -> NDArray[np.bool_]: ...
    @property
    def metric(self) -> str: ...
    @property
    def unit(self) -> str: ...
    @property
    def mean(self) -> float: ...
    @property
    def median(self) -> float: ...
    @property
    def p95(self) -> float: ...
    @property
    def samples(self) -> int: ...
    @property
    def best(self) -> tuple[float, tuple[float, float, float]]: ...
    @property
    def worst(self) -> tuple[float, tuple[float, float, float]]: ...
    def json(self) -> _Document: ...
    def meets(self, specs: Sequence[str]) -> list[_Document]: ...
    def save(
        self, file: _Path, *, log10: bool = False, slice: float | None = None
    ) -> None: ...
    def __len__(self) -> int: ...

class Study:
    """A search that is kept in a file: interrupted, resumed, steered."""

    def __init__(self, file: _Path) -> None: ...
    def json(self) -> _Document: ...
    def scene(self, round: int = -1) -> Scene: ...
    def act(self, verb: str, argument: str = "") -> None: ...
    def resume(self, *, threads: int = 0, progress: _Found = None) -> _Document: ...
    def dump(self) -> str: ...

def load(
    file: _Path,
    *,
    set: Mapping[str, Any] = ...,
    metric: str = "",
    fusion: str = "",
    covariance: str = "",
) -> Scene: ...
def parse(text: str | Mapping[str, Any], *, folder: _Path = ".") -> Scene: ...
def field(
    scene: Scene | _Path,
    *,
    threads: int = 0,
    solver: str = "auto",
    progress: _Done = None,
) -> Field: ...
def point(
    scene: Scene | _Path,
    at: Sequence[float],
    *,
    rpy: Sequence[float] | None = None,
    solver: str = "auto",
) -> _Document: ...
def compare(
    scenes: Sequence[Scene | _Path],
    *,
    specs: Sequence[str] = (),
    better_than: str = "",
    threads: int = 0,
    progress: _Done = None,
) -> _Document: ...
def check(file: _Path, *, set: Mapping[str, Any] = ...) -> _Document: ...
def simulate(
    scene: Scene | _Path,
    at: Sequence[float],
    *,
    rpy: Sequence[float] | None = None,
    runs: int = 1000,
    seed: int = 1,
    filter: str = "extended",
    seconds: float = 0.0,
    threads: int = 0,
    progress: _Done = None,
) -> _Document: ...
def optimize(
    scene: Scene | _Path,
    *,
    algorithm: str = "auto",
    starts: int = 0,
    evaluations: int = 0,
    seed: int = 1,
    samples: int = 1500,
    threads: int = 0,
    study: _Path | None = None,
    progress: _Found = None,
) -> _Document: ...
def select(
    scene: Scene | _Path,
    *,
    gap: float = 0.01,
    seconds: float = 60.0,
    samples: int = 1500,
    seed: int = 1,
    threads: int = 0,
    progress: _Found = None,
) -> _Document: ...
def front(
    scene: Scene | _Path,
    constraint: str,
    levels: Sequence[float],
    *,
    starts: int = 0,
    evaluations: int = 0,
    seed: int = 1,
    samples: int = 1500,
    threads: int = 0,
    progress: _Done = None,
) -> _Document: ...
def add_device(id: str, type: _Class, params: Mapping[str, Any] = ...) -> _Class: ...
def device(id: str, **params: Any) -> Callable[[_Class], _Class]: ...
