"""What Python lets go is freed."""

import os

import numpy as np

import brume


def resident_bytes():
    with open("/proc/self/statm") as statm:
        return int(statm.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def growth(work, repetitions):
    # As often before, to fill what is kept once, such as a sanitizer's memory of what was freed.
    for k in range(2 * repetitions):
        if k == repetitions:
            before = resident_bytes()
        work()
    return resident_bytes() - before


def test_views(cloud):
    def look():
        for _ in range(1000):
            cloud.medium.centers[0], cloud.medium.radii, cloud.medium.densities

    assert growth(look, 50) < 4 << 20  # 150,000 views


def test_media():
    def make():
        medium = brume.Medium()
        medium.append(np.zeros((20_000, 3)), 1, 1)
        return medium.centers[5:].mean()

    assert growth(make, 100) < 8 << 20  # 100 MB in all


def test_frames(cloud):
    def render():
        frame = brume.render(
            cloud, size=(200, 200), airlight="paper", scattering="single", backend="cpu"
        )
        return frame.beauty[0], frame.layers

    assert growth(render, 40) < 16 << 20  # 70 MB in all
