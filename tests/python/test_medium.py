import gc
import warnings

import numpy as np
import pytest

import brume

ONCE = dict(airlight="sliced", scattering="single", backend="cpu")


def test_arrays_are_the_medium_itself(cloud):
    centers = cloud.medium.centers
    assert centers.shape == (3, 3) and centers.dtype == np.float64
    assert centers.flags.writeable and not centers.flags.owndata
    centers[0] = (1, 2, 3)
    cloud.medium.radii[:] = 0.25
    assert tuple(cloud.medium.centers[0]) == (1, 2, 3)
    assert (cloud.medium.radii == 0.25).all()
    assert np.shares_memory(centers, cloud.medium.centers)


def test_what_is_written_later_is_rendered_next(cloud):
    renderer = brume.Renderer()
    densities = cloud.medium.densities
    before = renderer.render(cloud, **ONCE).airlight.copy()
    densities *= 2  # an array that was there before the first frame
    after = renderer.render(cloud, **ONCE).airlight
    assert not np.array_equal(before, after)
    assert np.array_equal(after, brume.render(cloud, **ONCE).airlight)


def test_what_was_written_counts_when_the_array_is_gone(cloud):
    renderer = brume.Renderer()
    densities = cloud.medium.densities
    renderer.render(cloud, **ONCE)
    densities *= 2
    del densities
    after = renderer.render(cloud, **ONCE).airlight
    assert np.array_equal(after, brume.render(cloud, **ONCE).airlight)


def test_arrays_can_be_assigned(cloud):
    centers = cloud.medium.centers
    cloud.medium.radii *= 2
    assert (cloud.medium.radii == 1.2).all()
    cloud.medium.densities = 0.5
    assert (cloud.medium.densities == 0.5).all()
    cloud.medium.centers = np.zeros((3, 3))
    assert (centers == 0).all()
    with pytest.raises(brume.DomainError, match="centers: found 2 rows; allowed: 3"):
        cloud.medium.centers = np.zeros((2, 3))
    with pytest.raises(brume.DomainError, match=r"radii: found the shape \(2,\)"):
        cloud.medium.radii = [1, 2]


def test_arrays_outlive_medium_and_scene(cloud):
    part = cloud.medium.centers[1:, 0]
    expected = part.copy()
    del cloud
    gc.collect()
    np.empty(1 << 20).fill(7)  # what could lie where they were
    assert np.array_equal(part, expected)


def test_no_resize_while_arrays_exist(cloud):
    row = cloud.medium.centers[0]
    with pytest.raises(BufferError, match="arrays of this medium exist"):
        cloud.medium.append([[0, 0, 0]], 1, 1)
    with pytest.raises(BufferError):
        cloud.medium.remove([0])
    assert len(cloud.medium) == 3
    del row
    cloud.medium.append([[0, 0, 0]], 1, 1)
    cloud.medium.remove([0, 3, 3])
    assert len(cloud.medium) == 2
    with pytest.raises(IndexError, match="there is no Gaussian 2"):
        cloud.medium.remove([2])


def test_remove_takes_indices_and_masks(cloud):
    cloud.medium.densities[:] = (1, 2, 3)
    with pytest.raises(TypeError):
        cloud.medium.remove([0.5])
    with pytest.raises(brume.DomainError, match="mask of another shape"):
        cloud.medium.remove([True])
    mask = cloud.medium.densities > 1.5
    mask[2] = False
    cloud.medium.remove(mask)
    assert list(cloud.medium.densities) == [1, 3]
    cloud.medium.remove([-1])
    cloud.medium.remove([])
    assert list(cloud.medium.densities) == [1]


def test_a_scene_takes_a_medium(cloud):
    other = brume.Medium()
    other.append([[1, 2, 3]], 0.5, 0.25)
    other.emissions = [[3, 2, 1]]
    other.density = 0.01
    cloud.medium = other
    assert cloud.medium.centers.tolist() == [[1, 2, 3]] and cloud.medium.density == 0.01
    assert cloud.medium.emissions.tolist() == [[3, 2, 1]]
    other.centers[:] = 0  # which was copied
    assert cloud.medium.centers.tolist() == [[1, 2, 3]]


@pytest.mark.parametrize(
    "arguments, message",
    [
        (([0, 0, 0], 1, 1), r"centers: found the shape \(3,\); allowed: \(n, 3\)"),
        (([[0, 0]], 1, 1), r"centers: found the shape \(1, 2\)"),
        (([[0, 0, 0]], [1, 1], 1), r"radii: found the shape \(2,\); allowed: a number, or \(1,\)"),
        (([[0, 0, 0]], 0, 1), r"medium.gaussians\[0\].radius: found 0; allowed: a number > 0"),
        (([[0, 0, 0]] * 2, 1, [1, np.nan]), r"medium.gaussians\[1\].density: found nan"),
        (([[0, np.inf, 0]], 1, 1), r"medium.gaussians\[0\].center\[1\]: found inf"),
    ],
)
def test_wrong_shapes_and_values(cloud, arguments, message):
    with pytest.raises(brume.DomainError, match=message):
        cloud.medium.append(*arguments)
    assert len(cloud.medium) == 3


def test_wrong_types(cloud):
    with pytest.raises((TypeError, ValueError)):
        cloud.medium.append([["a", "b", "c"]], 1, 1)
    with pytest.raises(TypeError):
        cloud.medium.density = "thick"
    with pytest.raises(brume.DomainError, match="medium.density: found -1"):
        cloud.medium.density = -1


def test_nan_that_was_written_is_refused_where_it_counts(cloud, tmp_path):
    cloud.medium.centers[2, 1] = np.nan
    for use in (
        lambda: brume.render(cloud),
        lambda: cloud.save(tmp_path / "s.brume"),
        lambda: cloud.medium.save(tmp_path / "m.ply"),
        lambda: cloud.medium.save(tmp_path / "m.vdb"),
    ):
        with pytest.raises(brume.DomainError, match=r"medium.gaussians\[2\].center\[1\]: found nan"):
            use()
    assert list(tmp_path.iterdir()) == []


def test_optics_are_copies_that_are_assigned(cloud):
    assert np.isnan(cloud.medium.albedos).all()
    assert (cloud.medium.emissions == 0).all()
    centers = cloud.medium.centers
    emissions = cloud.medium.emissions
    emissions[1] = (3, 2, 1)
    cloud.medium.emissions = emissions
    albedos = np.full((3, 3), np.nan)
    albedos[2] = 0.5
    cloud.medium.albedos = albedos
    assert tuple(cloud.medium.emissions[1]) == (3, 2, 1)
    assert np.isnan(cloud.medium.albedos[0]).all() and (cloud.medium.albedos[2] == 0.5).all()
    assert np.shares_memory(centers, cloud.medium.centers)
    with pytest.raises(brume.DomainError, match="albedo"):
        cloud.medium.albedos = np.full((3, 3), 2.0)
    with pytest.raises(brume.DomainError, match="emissions: found 2 rows; allowed: 3"):
        cloud.medium.emissions = np.zeros((2, 3))


def test_ellipsoids_are_added_and_read_back(cloud):
    quarter = np.sqrt(0.5)
    cloud.medium.append([[0, 1, 0]], [[0.3, 0.6, 0.15]], 2, [[quarter, 0, 0, quarter]])
    cloud.medium.append([[0, 2, 0]], [[0.1, 0.2, 0.3]], 1)
    assert cloud.medium.radii.tolist() == [0.6, 0.6, 0.6, 0.6, 0.3]
    radii = cloud.medium.axis_radii
    assert radii[0].tolist() == [0.6] * 3
    assert np.allclose(radii[3:], [[0.3, 0.6, 0.15], [0.1, 0.2, 0.3]], rtol=1e-15)
    assert np.allclose(cloud.medium.rotations[3], [quarter, 0, 0, quarter])
    assert cloud.medium.rotations[[0, 4]].tolist() == [[1, 0, 0, 0]] * 2


def test_ellipsoids_are_rendered(cloud):
    balls = brume.render(cloud, **ONCE).airlight.copy()
    centers = cloud.medium.centers
    assert np.array_equal(brume.render(cloud, **ONCE).airlight, balls)
    cloud.medium.set_ellipsoids([[0.6, 0.1, 0.6]] * 3, [[1, 0, 0, 0]] * 3)
    flat = brume.render(cloud, **ONCE).airlight
    assert flat.sum() < 0.5 * balls.sum()
    assert np.shares_memory(centers, cloud.medium.centers)
    cloud.medium.set_ellipsoids([[0.6] * 3] * 3, [[1, 0, 0, 0]] * 3)
    assert np.array_equal(brume.render(cloud, **ONCE).airlight, balls)


@pytest.mark.parametrize(
    "arguments, message",
    [
        (([[1, 1, 1]], [[1, 0, 0, 0]] * 3), "radii: found 1 rows; allowed: 3"),
        (([1, 1, 1], [[1, 0, 0, 0]] * 3), r"radii: found the shape \(3,\); allowed: \(n, 3\)"),
        (([[1, 1, 1e-5]] * 3, [[1, 0, 0, 0]] * 3), r"radii\[0\]: allowed: radii > 0, each at least"),
        (([[1, 1, np.nan]] * 3, [[1, 0, 0, 0]] * 3), r"radii\[0\]: allowed"),
        (([[1, 1, 1]] * 3, [[1, 0, 0]] * 3), r"rotations: found the shape \(3, 3\); allowed: \(3, 4\)"),
        (([[1, 1, 1]] * 3, [[1, 0, 0, 0], [0, 0, 0, 0], [1, 0, 0, 0]]), r"rotations\[1\]: found a quat"),
    ],
)
def test_wrong_ellipsoids(cloud, arguments, message):
    with pytest.raises(brume.DomainError, match=message):
        cloud.medium.set_ellipsoids(*arguments)
    assert (cloud.medium.axis_radii == 0.6).all()


def test_rotations_need_three_radii(cloud):
    with pytest.raises(brume.DomainError, match=r"rotations: allowed: with radii of the shape"):
        cloud.medium.append([[0, 1, 0]], 1, 1, [[1, 0, 0, 0]])


def test_files(cloud, tmp_path):
    cloud.medium.append([[0, 1, 0]], [[0.3, 0.6, 0.15]], 2)
    for name in ("m.ply", "m.csv"):
        cloud.medium.save(tmp_path / name)
        again = brume.load_medium(tmp_path / name)
        assert np.array_equal(again.centers, cloud.medium.centers)
        assert np.array_equal(again.densities, cloud.medium.densities)
        assert np.allclose(again.axis_radii, cloud.medium.axis_radii, rtol=1e-15)
    with pytest.raises(brume.InputError, match="nothing.ply"):
        brume.load_medium(tmp_path / "nothing.ply")


def test_warns_of_splats_that_are_left_out(tmp_path):
    names = ("x", "y", "z", "opacity", "scale_0")
    header = ["ply", "format ascii 1.0", "element vertex 3"]
    header += [f"property float {name}" for name in names] + ["end_header"]
    rows = ["0 0 0 0 -1", "0 0 0 nan -1", "1 0 0 0 -1"]
    (tmp_path / "capture.ply").write_text("\n".join(header + rows) + "\n")
    with pytest.warns(UserWarning, match="1 of 3 splats left out"):
        medium = brume.load_medium(tmp_path / "capture.ply")
    assert np.array_equal(medium.centers, [[0, 0, 0], [1, 0, 0]])


def test_says_what_a_file_of_no_gaussians_is(tmp_path):
    (tmp_path / "smoke.vdb").write_bytes(b" BDV" + bytes(60))
    with pytest.raises(brume.InputError, match="is a volume .*brume fit smoke.vdb"):
        brume.load_medium(tmp_path / "smoke.vdb")
    (tmp_path / "scan.spz").write_bytes(b"\x1f\x8b" + bytes(60))
    with pytest.raises(brume.InputError, match="splat-transform scan.spz scan.ply"):
        brume.load_medium(tmp_path / "scan.spz")


def test_the_extension_says_what_is_written(cloud, tmp_path):
    cloud.medium.save(tmp_path / "m.VDB", voxel=0.2)
    assert b"density" in (tmp_path / "m.VDB").read_bytes()
    with pytest.raises(brume.DomainError, match="found the extension '.xyz'"):
        cloud.medium.save(tmp_path / "m.xyz")


def test_fit_finds_what_made_the_grid():
    i = np.arange(24)
    x, y, z = np.meshgrid(i, i, i, indexing="ij")
    grid = 2 * np.exp(-((x - 10) ** 2 + (y - 12) ** 2 + (z - 14) ** 2) * 0.01 / 0.3**2)
    medium, error = brume.fit(grid, 0.1, origin=(1, 0, 0), count=1)
    assert error < 0.02
    assert np.allclose(medium.centers, [[2.0, 1.2, 1.4]], atol=0.01)
    assert np.allclose(medium.axis_radii, 0.3, rtol=0.02)
    balls, _ = brume.fit(grid, 0.1, count=2, shape="ball")
    assert np.ptp(balls.axis_radii, axis=1).max() == 0
    with pytest.raises(brume.DomainError, match="shape: found 'cube'; allowed: 'ball', 'ellipsoid'"):
        brume.fit(grid, 0.1, shape="cube")
    with pytest.raises(brume.DomainError, match="densities: found 2 dimensions"):
        brume.fit(grid[0], 0.1)
    with pytest.raises(brume.DomainError, match="found nan"):
        brume.fit(np.full((2, 2, 2), np.nan), 0.1)
    with pytest.raises(brume.DomainError, match="origin: found nan"):
        brume.fit(grid, 0.1, origin=(0, np.nan, 0))


def test_warns_of_faces_that_are_left_out(tmp_path):
    file = tmp_path / "m.obj"
    file.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n")
    with pytest.warns(UserWarning, match="m.obj: line 5: found a face"):
        brume.Surface.load(file)


def test_warnings_are_pythons(tmp_path):
    file = tmp_path / "s.brume"
    file.write_text('{"format": "brume-scene", "version": 1, "gobo": 1}')
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        brume.load(file)
    assert len(caught) == 1 and "gobo" in str(caught[0].message)
