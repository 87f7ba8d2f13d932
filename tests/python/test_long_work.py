"""Progress, Ctrl-C, threads and memory."""
import gc
import os
import resource
import signal
import threading
import time

import delos
import pytest


@pytest.fixture
def long_scene(scenes):
    """Enough samples for some tenths of a second."""
    return delos.load(scenes / "01-acoustic.yaml", set={"sample.volume.step": 0.004})


def test_progress_is_told(long_scene):
    told = []
    field = delos.field(long_scene, progress=lambda done, of: told.append((done, of)))
    assert told and told[-1][1] == len(field)
    assert [done for done, _ in told] == sorted(done for done, _ in told)


def test_a_callback_that_raises_stops_the_work(long_scene):
    def stop(done, of):
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        delos.field(long_scene, progress=stop)


def test_control_c_stops_the_work(scenes):
    scene = scenes / "09-camera-room.yaml"
    timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        delos.optimize(scene, starts=10000, evaluations=1000000)
    assert time.monotonic() - begin < 60


def test_other_threads_run_meanwhile(long_scene):
    counted = 0
    done = threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    other = threading.Thread(target=count)
    other.start()
    before = counted
    delos.field(long_scene, threads=1)
    during = counted - before
    done.set()
    other.join()
    assert during > 10


def test_memory_is_freed(scenes):
    scene = delos.load(scenes / "01-acoustic.yaml", set={"sample.volume.step": 0.1})

    def evaluate(times):
        for _ in range(times):
            delos.field(scene)
        gc.collect()
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    before = evaluate(50)
    assert evaluate(400) < before + 4096  # KiB; 400 fields have 8,000


def test_arrays_are_the_fields_own_memory(scenes):
    field = delos.field(scenes / "01-acoustic.yaml")
    values = field.values
    assert values.__array_interface__["data"] == field.values.__array_interface__["data"]
    with pytest.raises(ValueError, match="read-only"):
        values[0] = 1
    mean = values.mean()
    del field
    gc.collect()
    assert values.mean() == mean  # the array keeps the field alive
