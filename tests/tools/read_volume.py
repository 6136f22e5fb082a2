"""Reads an exported volume with OpenVDB's Python module and compares it with the analytic density,
and with the analytic albedo and emission where Gaussians have them.

usage: read_volume.py VOLUME.vdb VOXEL half|float X,Y,Z,RADIUS,DENSITY[,R,G,B,R,G,B]...
"""

import math
import sys

try:
    import pyopenvdb as vdb
except ImportError:
    import openvdb as vdb


def read(path, name, voxel, half):
    grid = vdb.read(path, name)
    assert grid.gridClass == "fog volume", grid.gridClass
    assert grid.saveFloatAsHalf == half, name
    for k in range(3):
        assert math.isclose(grid.transform.voxelSize()[k], voxel, rel_tol=1e-12)
    return grid


def voxels(grid):
    for item in grid.iterOnValues():
        # Tiles have a box of voxels; here all are single.
        assert item.min == item.max, item.min
        yield grid.transform.indexToWorld(item.min), item.value


def densities(gaussians, point):
    return [g[4] * math.exp(-math.dist(point, g[:3]) ** 2 / g[3] ** 2) for g in gaussians]


def compare_density(grid, gaussians, half):
    # What is left out of each Gaussian beyond three radii, and rounding.
    left_out = 1e-4 * sum(g[4] for g in gaussians)
    relative = 2.0**-11 if half else 1e-6
    count = 0
    for point, value in voxels(grid):
        exact = sum(densities(gaussians, point))
        # A half below 6.1e-5 has a fixed step of 2^-24.
        bound = left_out + relative * exact + 2.0**-24
        assert abs(value - exact) <= bound, (point, value, exact)
        count += 1
    return count


def compare_colors(albedo, emission, gaussians, half):
    left_out = 1e-4 * sum(g[4] for g in gaussians)
    for grid, is_half in (albedo, half), (emission, False):
        rounding = 2.0**-11 if is_half else 1e-6
        for point, value in voxels(grid):
            found = densities(gaussians, point)
            if sum(found) < 100 * left_out:
                continue
            for k in range(3):
                extinction = sum(b / g[5 + k] for b, g in zip(found, gaussians))
                emitted = sum(b / g[5 + k] * g[8 + k] for b, g in zip(found, gaussians))
                exact = (sum(found) if grid is albedo else emitted) / extinction
                # What is left out, a hundredth of what is there, may have another colour.
                largest = 1.0 if grid is albedo else max(g[8 + k] for g in gaussians)
                bound = 0.05 * largest + rounding * exact
                assert abs(value[k] - exact) <= bound, (grid.name, point, value, exact)


def main():
    path, voxel, half = sys.argv[1], float(sys.argv[2]), sys.argv[3] == "half"
    gaussians = [[float(number) for number in text.split(",")] for text in sys.argv[4:]]
    print(compare_density(read(path, "density", voxel, half), gaussians, half))
    if len(gaussians[0]) > 5:
        # Emission may be more than the half precision's 65504.
        compare_colors(
            read(path, "albedo", voxel, half), read(path, "emission", voxel, False), gaussians, half
        )


main()
