"""Reads an exported volume with OpenVDB's Python module and compares it with the analytic density.

usage: read_volume.py VOLUME.vdb VOXEL half|float X,Y,Z,RADIUS,DENSITY...
"""

import math
import sys

try:
    import pyopenvdb as vdb
except ImportError:
    import openvdb as vdb


def main():
    path, voxel, precision = sys.argv[1], float(sys.argv[2]), sys.argv[3]
    gaussians = [[float(number) for number in text.split(",")] for text in sys.argv[4:]]
    grid = vdb.read(path, "density")
    assert grid.gridClass == "fog volume", grid.gridClass
    assert grid.saveFloatAsHalf == (precision == "half")
    for k in range(3):
        assert math.isclose(grid.transform.voxelSize()[k], voxel, rel_tol=1e-12)

    # What is left out of each Gaussian beyond three radii, and rounding.
    left_out = 1e-4 * sum(g[4] for g in gaussians)
    relative = 2.0**-11 if precision == "half" else 1e-6
    voxels = 0
    for item in grid.iterOnValues():
        # Tiles have a box of voxels; here all are single.
        assert item.min == item.max, item.min
        point = grid.transform.indexToWorld(item.min)
        exact = sum(
            density * math.exp(-math.dist(point, (x, y, z)) ** 2 / radius**2)
            for x, y, z, radius, density in gaussians
        )
        # A half below 6.1e-5 has a fixed step of 2^-24.
        bound = left_out + relative * exact + 2.0**-24
        assert abs(item.value - exact) <= bound, (point, item.value, exact)
        voxels += 1
    print(voxels)


main()
