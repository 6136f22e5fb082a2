import pathlib

import pytest

import brume

SCENES = pathlib.Path(__file__).resolve().parents[2] / "resources" / "scenes"


@pytest.fixture
def bunny():
    return brume.load(SCENES / "bunny_fog.brume")


@pytest.fixture
def cloud():
    """A small scene without surfaces: three Gaussians and a lamp."""
    scene = brume.Scene()
    scene.size = (48, 36)
    scene.medium.append([[0, 0, 0], [0.5, 0.2, 0], [-0.5, 0, 0.3]], 0.6, [0.8, 0.5, 0.6])
    scene.lights.append(brume.Light.point((1, 2, 1), (9, 8, 7)))
    return scene
