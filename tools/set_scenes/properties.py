"""What is far, tiny, below or hidden changes no sample scene: each is rendered with and without it."""

import copy
import json
import os
import pathlib
import tempfile

from pictures import difference, read, render
from shapes import gaussian, solid

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BOUND = 0.01
BLACK = (0.0, 0.0, 0.0)
FILES = ("mesh", "file", "profile")

# Place and size of a slab that surfaces hide: within a wall or a floor, or below a ground.
HIDDEN = {
    "scenes/candle": ((0.0, 2.3, -1.9), (4.0, 2.0, 0.05)),
    "scenes/forest": ((0.0, -0.4, -6.0), (10.0, 0.05, 10.0)),
    "scenes/ground_fog": ((0.0, -2.5, 0.0), (12.0, 0.05, 12.0)),
    "scenes/room": ((-2.1, 1.3, 0.0), (0.05, 2.0, 3.0)),
    "templates/landscape": ((0.0, -2.0, 0.0), (60.0, 0.05, 60.0)),
    "templates/room": ((0.0, 2.92, 0.0), (5.0, 0.05, 4.0)),
}
BELOW = ((0.0, -0.1, -1.0), (2.0, 0.05, 2.0))


def far_gaussian(scene, _):
    """Under a sun or a sky homogeneous fog ends farther away then, by paths, too."""
    eye, target = (scene["camera"][key] for key in ("eye", "target"))
    distance = sum((e - t) ** 2 for e, t in zip(eye, target)) ** 0.5
    behind = [e + 30.0 * (e - t) for e, t in zip(eye, target)]
    scene["medium"].setdefault("gaussians", []).append(gaussian(behind, 0.1 * distance, 0.002))


def tiny_cube(scene, _):
    target = scene["camera"]["target"]
    scene.setdefault("surfaces", []).append(solid("box", [0.001] * 3, target, [0.5] * 3))


def tiny_cube_on_floor(scene, _):
    if not scene.get("surfaces"):
        return False
    x, _, z = scene["camera"]["target"]
    scene["surfaces"].append(solid("box", [0.001] * 3, (x, 0.0006, z), [0.5] * 3))


def wide_floor(scene, _):
    """A black one far below, which keeps out only what shines from there."""
    if scene.get("environment") or any(light["type"] == "directional" for light in scene["lights"]):
        return False
    scene.setdefault("surfaces", []).append(solid("plane", (1000.0, 1.0, 1000.0), (0.0, -20.0, 0.0),
                                                  BLACK))


def hidden_wall(scene, name):
    if not scene.get("surfaces"):
        return False
    at, size = HIDDEN.get(name, BELOW)
    scene["surfaces"].append(solid("box", size, at, BLACK))


CHANGES = [far_gaussian, tiny_cube, tiny_cube_on_floor, wide_floor, hidden_wall]


def absolute(value, folder):
    """The scene with the places of its files."""
    if isinstance(value, dict):
        return {key: os.path.normpath(folder / v) if key in FILES else absolute(v, folder)
                for key, v in value.items()}
    return [absolute(v, folder) for v in value] if isinstance(value, list) else value


def check_properties(options, scenes):
    """Whether a property does not hold."""
    samples = sorted((ROOT / "resources").glob("scenes/*.brume"))
    samples += sorted((ROOT / "resources").glob("templates/*.brume"))
    files = [pathlib.Path(name).resolve() for name in options.names] or samples
    failed = False
    print(f"{'scene':>24} {'change':>20}  airlight  blocks   picture  blocks", flush=True)
    for file in files:
        name = f"{file.parent.name}/{file.stem}"
        scene = absolute(json.loads(file.read_text()), file.parent)
        with tempfile.TemporaryDirectory() as folder:
            before = pathlib.Path(folder) / "before.exr"
            render(options.brume, file, before, "--airlight", options.airlight, "--error", "none")
            for change in CHANGES:
                changed = copy.deepcopy(scene)
                if change(changed, name) is False:
                    continue
                place = scenes / f"{file.parent.name}_{file.stem}_{change.__name__}.brume"
                place.parent.mkdir(parents=True, exist_ok=True)
                place.write_text(json.dumps(changed))
                after = pathlib.Path(folder) / "after.exr"
                render(options.brume, place, after, "--airlight", options.airlight, "--error", "none")
                values = []
                for first in (5, 0):
                    right = read(before, first)
                    found = difference(read(after, first), right, right)
                    values += [found["error"], found["blocks"]]
                wrong = max(values) > BOUND
                failed = failed or wrong
                print(f"{name:>24} {change.__name__:>20}  " + "  ".join(f"{v:7.2%}" for v in values)
                      + ("  wrong" if wrong else ""), flush=True)
    return failed
