import copy
import json
import os
import signal
import threading
import time

import numpy as np
import pytest

import brume


def test_three_lines(bunny, tmp_path):
    frame = brume.render(bunny, size=(64, 48), max_error=0.05)
    frame.save(tmp_path / "frame.exr")
    assert (tmp_path / "frame.exr").stat().st_size > 10_000
    assert frame.size == (64, 48)
    assert frame.beauty.shape == (48, 64, 4)
    assert frame.airlight.shape == frame.transmittance.shape == (48, 64, 3)
    assert frame.depth.shape == (48, 64)
    assert np.isfinite(frame.beauty).all() and frame.beauty[..., :3].max() > 0
    assert 0 <= frame.error.low <= frame.error.rel_rmse <= frame.error.high < 0.06
    assert 0 <= frame.picture_error.low <= frame.picture_error.high < 1
    assert frame.milliseconds > 0 and frame.stages["airlight"] > 0
    assert frame.airlight_method.startswith("sliced:")


def test_arrays_do_not_copy_and_keep_the_frame(cloud):
    frame = brume.render(cloud, airlight="sliced", backend="cpu")
    beauty = frame.beauty
    assert np.shares_memory(beauty, frame.beauty)
    with pytest.raises(ValueError):
        beauty[0, 0, 0] = 1
    expected = beauty.copy()
    del frame
    np.empty(1 << 20).fill(7)
    assert np.array_equal(beauty, expected)


def test_shows_itself(cloud):
    frame = brume.render(cloud)
    assert frame._repr_png_().startswith(b"\x89PNG") and frame._repr_png_() == frame.png()
    assert frame.png(exposure=3) != frame.png()
    assert "48 x 36" in repr(frame)


@pytest.fixture
def keyed(cloud, tmp_path):
    """The cloud with keyframes of camera, light, albedo and density."""
    cloud.save(tmp_path / "cloud.brume")
    scene = json.loads((tmp_path / "cloud.brume").read_text())
    scene["camera"]["keys"] = {"eye": [{"time": 0, "value": [0, 0, 5]}, {"time": 1, "value": [5, 0, 0]}]}
    scene["lights"][0]["keys"] = {"intensity": [{"time": 0, "value": [1, 1, 1]}]}
    scene["medium"]["keys"] = {
        "albedo": [{"time": 0, "value": [0.5, 0.5, 0.5]}],
        "density": [{"time": 0, "value": 0.1}],
    }
    (tmp_path / "keyed.brume").write_text(json.dumps(scene))
    return brume.load(tmp_path / "keyed.brume")


def pictures_differ(one, other):
    def picture(scene):
        return brume.render(scene, airlight="sliced", scattering="single", backend="cpu").beauty

    return not np.array_equal(picture(one), picture(other))


@pytest.mark.parametrize(
    "part, name, value",
    [
        (lambda scene: scene.camera, "eye", (3, 0, 3)),
        (lambda scene: scene.lights[0], "intensity", (2, 3, 4)),
        (lambda scene: scene, "albedo", (0.9, 0.8, 0.7)),
        (lambda scene: scene.medium, "density", 0.3),
    ],
)
def test_values_with_keyframes_are_set_once_these_are_cleared(keyed, part, name, value):
    kept = copy.deepcopy(keyed)
    with pytest.raises(brume.DomainError, match=f"{name}: its keyframes .* clear_keys"):
        setattr(part(keyed), name, value)
    assert not pictures_differ(keyed, kept)
    part(keyed).clear_keys()
    setattr(part(keyed), name, value)
    assert pictures_differ(keyed, kept)


def test_a_camera_comes_with_its_keyframes(keyed, cloud):
    still = copy.deepcopy(keyed)
    still.camera = brume.Camera(eye=(0, 0, 4))
    still.camera.eye = (0, 3, 3)

    def beauty(scene, **options):
        options |= dict(airlight="sliced", scattering="single", backend="cpu", time=0.5)
        return brume.render(scene, **options).beauty

    for scene in [cloud, still]:
        expected = beauty(scene, camera=keyed.camera)
        changed = copy.deepcopy(scene)
        changed.camera = keyed.camera
        assert np.array_equal(beauty(changed), expected)
        assert not np.array_equal(beauty(scene), expected)


def test_orthographic_cameras_have_a_height(tmp_path):
    scene = brume.Scene()
    scene.camera = brume.Camera(eye=(0, 1, 4), height=2.5)
    assert scene.camera.height == 2.5
    scene.save(tmp_path / "map.brume")
    assert "vertical_fov" not in (tmp_path / "map.brume").read_text()
    assert brume.load(tmp_path / "map.brume").camera.height == 2.5
    scene.camera.aperture = 0.1
    with pytest.raises(brume.DomainError, match="camera.height: found beside aperture"):
        scene.save(tmp_path / "lens.brume")
    scene.camera.height = None
    scene.save(tmp_path / "lens.brume")


def test_seeds(cloud):
    frames = [
        brume.render(cloud, airlight="path:4", backend="cpu", seed=seed) for seed in (0, 0, 1)
    ]
    assert np.array_equal(frames[0].airlight, frames[1].airlight)
    assert not np.array_equal(frames[0].airlight, frames[2].airlight)
    with pytest.raises(brume.DomainError, match="seed: found -1"):
        brume.render(cloud, seed=-1)


def test_frames_per_second(cloud, tmp_path):
    assert cloud.frames_per_second == 30
    cloud.frames_per_second = 24
    cloud.save(tmp_path / "scene.brume")
    assert brume.load(tmp_path / "scene.brume").frames_per_second == 24
    cloud.frames_per_second = 0
    with pytest.raises(brume.DomainError, match="timeline.frames_per_second"):
        brume.render(cloud)


@pytest.mark.parametrize(
    "options, message",
    [
        (dict(airlight="quick"), "airlight: found quick; allowed: auto, paper"),
        (dict(airlight="path:many"), "airlight: found path:many"),
        (dict(airlight="path:0"), "airlight: found path:0; allowed: .* path:N with N from 1 to"),
        (dict(scattering="twice"), "scattering: found twice; allowed: single, multiple"),
        (dict(layers=["glow"]), "layers: found glow; allowed: airlight, "),
        (dict(size=(0, 10)), "size: found 0x10; allowed: WIDTHxHEIGHT"),
        (dict(max_error=float("nan")), "max_error: found nan"),
        (dict(backend="vulkan"), "backend: found vulkan; allowed: auto, cpu, gl"),
    ],
)
def test_wrong_values(cloud, options, message):
    with pytest.raises(brume.DomainError, match=message):
        brume.render(cloud, **options)


@pytest.mark.parametrize(
    "options",
    [
        dict(colour=1),
        dict(size=3),
        dict(time="noon"),
        dict(samples="few"),
        dict(layers=3),
    ],
)
def test_wrong_types(cloud, options):
    with pytest.raises(TypeError):
        brume.render(cloud, **options)
    cloud.lights.append("sun")
    with pytest.raises(TypeError, match=r"lights\[1\]: found a str; allowed: a brume.Light"):
        brume.render(cloud)


def test_lists_and_parts_live_by_themselves(cloud):
    light = cloud.lights[0]
    cloud.lights.extend(brume.Light.point((0, 0, k), (1, 1, 1)) for k in range(100))
    light.intensity = (0, 0, 5)
    assert cloud.lights[0].intensity == (0, 0, 5)
    cloud.lights.clear()
    assert light.kind == "point"
    camera = cloud.camera
    camera.eye = (0, 1, 9)
    assert cloud.camera.eye == (0, 1, 9)
    del cloud
    assert camera.eye == (0, 1, 9)


def test_lights_and_surfaces(cloud, tmp_path):
    Light, Surface = brume.Light, brume.Surface
    cloud.lights += [
        Light.spot((0, 3, 0), (0, -1, 0), (5, 5, 5), outer_angle=30),
        Light.directional((1, -1, 0), (1, 1, 1), angular_diameter=0.53),
        Light.rectangle((0, 3, 0), (0, -1, 0), (2, 2, 2), 1, 2),
        Light.disk((0, 3, 0), (0, -1, 0), (2, 2, 2), 0.5),
        Light.sphere((0, 3, 0), (2, 2, 2), 0.5),
    ]
    kinds = ["point", "spot", "directional", "rectangle", "disk", "sphere"]
    assert [light.kind for light in cloud.lights] == kinds
    assert cloud.lights[1].outer_angle == 30
    with pytest.raises(AttributeError, match="a point light has no outer_angle"):
        cloud.lights[0].outer_angle
    floor = Surface.primitive("plane", (10, 1, 10))
    floor.translate = (0, -1, 0)
    floor.set_metallic_roughness((0.8, 0.4, 0.2), metallic=1, roughness=0.9)
    cloud.surfaces.append(floor)
    pane = Surface.primitive("plane", (1, 1, 1))
    pane.set_metallic_roughness((1, 1, 1), alpha="blend", opacity=0.5, transmission=(1, 0.5, 0))
    cloud.surfaces.append(pane)
    with pytest.raises(brume.DomainError, match="alpha: found 'mask'; allowed: opaque, cutout, blend"):
        pane.set_metallic_roughness((1, 1, 1), alpha="mask")
    options = dict(size=(12, 9), airlight="paper")
    frame = brume.render(cloud, **options)
    assert np.isfinite(frame.depth).any()
    cloud.save(tmp_path / "s.brume")
    again = brume.load(tmp_path / "s.brume")
    again.save(tmp_path / "again.brume")
    assert (tmp_path / "again.brume").read_text() == (tmp_path / "s.brume").read_text()
    assert np.array_equal(brume.render(again, **options).beauty, frame.beauty)
    cloud.surfaces.append(Surface.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    with pytest.raises(brume.DomainError, match=r"surfaces\[2\].mesh: it is in memory alone"):
        cloud.save(tmp_path / "t.brume")
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    for triangles, index in (([[0, 1, 3]], "3"), ([[0, 1, -1]], "-1"), ([[0, 1, 2**32]], "4294967296")):
        with pytest.raises(brume.DomainError, match="there is no point " + index):
            Surface.mesh(points, triangles)
    with pytest.raises(TypeError):
        Surface.mesh(points, [[0, 1, 1.9]])
    with pytest.raises(brume.DomainError, match="size"):
        Surface.primitive("box", (1e300, 1, 1))


def test_copies(tmp_path):
    scene = brume.Scene()
    floor = brume.Surface.primitive("plane", (10, 1, 10))
    floor.name = "floor"
    post = brume.Surface.primitive("cylinder", (0.4, 1, 0.4))
    scene.surfaces = [floor, post]
    scene.camera.eye = (0, 3, 9)
    scene.lights.append(brume.Light.point((3, 5, 2), intensity=(50, 50, 50)))

    once = dict(airlight="sliced", scattering="single", backend="cpu")

    def beauty(of):
        return brume.render(of, size=(32, 24), **once).beauty

    alone = beauty(scene)
    post.scatter("floor", density=0.5, scale=(0.5, 1.5), turn=90)
    scene.save(tmp_path / "scattered.brume")
    scattered = beauty(scene)
    assert not np.array_equal(scattered, alone)
    again = brume.load(tmp_path / "scattered.brume")
    assert np.array_equal(beauty(again), scattered)
    (tmp_path / "one.csv").write_text("x,y,z\n2,0,0\n")
    post.load_copies(tmp_path / "one.csv")
    assert not np.array_equal(beauty(scene), scattered)
    post.clear_copies()
    assert np.array_equal(beauty(scene), alone)


def test_ctrl_c_stops_a_render(bunny):
    # A shell has what it runs in the background ignore the signal.
    signal.signal(signal.SIGINT, signal.default_int_handler)

    def interrupt():
        time.sleep(0.5)
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=interrupt).start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        brume.render(bunny, size=(1600, 1200), airlight="path:100000")
    assert time.monotonic() - start < 60  # the frame takes hours


def test_progress_may_stop_a_render(bunny):
    seen = []

    def progress(fraction):
        seen.append(fraction)
        if len(seen) == 3:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        brume.render(bunny, size=(1600, 1200), airlight="path:100000", progress=progress)
    assert len(seen) == 3 and all(0 <= fraction <= 1 for fraction in seen)


def test_progress_stops_a_fit():
    grid = np.random.default_rng(1).uniform(0, 1, (64, 64, 64))

    def progress(fraction):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        brume.fit(grid, 0.1, count=2000, progress=progress)


def test_other_threads_run_meanwhile(bunny):
    counts = []
    done = threading.Event()

    def count():
        n = 0
        while not done.is_set():
            n += 1
            time.sleep(0.001)
        counts.append(n)

    thread = threading.Thread(target=count)
    thread.start()
    brume.render(bunny, size=(160, 120), airlight="path:8")
    done.set()
    thread.join()
    assert counts[0] > 10


def test_writing_while_a_frame_is_rendered_changes_nothing(cloud):
    renderer = brume.Renderer()
    expected = brume.render(cloud, airlight="path:64", backend="cpu").beauty
    centers = cloud.medium.centers
    kept = centers.copy()
    done = threading.Event()

    def disturb():
        while not done.is_set():
            centers[:] = np.nan
        centers[:] = kept

    results = []

    def start(fraction):
        if not results:
            results.append(threading.Thread(target=disturb))
            results[0].start()

    try:
        frame = renderer.render(cloud, airlight="path:64", backend="cpu", progress=start)
    finally:
        done.set()
        for thread in results:
            thread.join()
    assert results and np.array_equal(frame.beauty, expected)


def test_a_renderer_renders_one_frame_at_a_time(cloud):
    renderer = brume.Renderer()
    refused = []

    def again(fraction):
        with pytest.raises(RuntimeError, match="this renderer is rendering"):
            renderer.render(cloud)
        refused.append(fraction)

    renderer.render(cloud, airlight="path:64", backend="cpu", progress=again)
    assert refused[-1] == 1
    renderer.render(cloud, airlight="sliced", scattering="single")


def test_copies_are_apart(cloud):
    light = copy.copy(cloud.lights[0])
    light.intensity = (1, 1, 1)
    assert cloud.lights[0].intensity == (9, 8, 7)
    other = copy.deepcopy(cloud)
    other.medium.radii[:] = 9
    other.camera.eye = (0, 0, 1)
    other.lights[0].on = False
    assert (cloud.medium.radii != 9).all() and cloud.lights[0].on
    assert cloud.camera.eye == brume.Camera().eye
    cloud.lights = (light,)
    assert cloud.lights == [light]


def test_rotations_are_unit(cloud):
    box = brume.Surface.primitive("box")
    box.rotate = (0.7071, 0, 0.7071, 0)  # rounded, as one types it
    cloud.surfaces = [box]
    brume.render(cloud, airlight="sliced", scattering="single")
    with pytest.raises(brume.DomainError, match="unit quaternion"):
        box.rotate = (1, 1, 0, 0)


def test_animation(bunny):
    scene = brume.load(os.path.join(os.path.dirname(__file__), "../../resources/scenes/stage.brume"))
    assert scene.is_animated and scene.last_moment > 1
    options = dict(size=(48, 36), airlight="sliced", scattering="single")
    assert not np.array_equal(
        brume.render(scene, time=0, **options).beauty, brume.render(scene, time=2, **options).beauty
    )
    assert not bunny.is_animated


def test_missing_file():
    with pytest.raises(brume.InputError, match="nowhere.brume"):
        brume.load("nowhere.brume")


def test_skies_light_what_is_under_them(cloud):
    cloud.lights.clear()
    cloud.environment = brume.Environment(brume.Sky(elevation=40, sun=False))
    noon = brume.render(cloud, airlight="sliced:8", scattering="single", size=(16, 12)).beauty.sum()
    cloud.environment.sky.elevation = -3
    dusk = brume.render(cloud, airlight="sliced:8", scattering="single", size=(16, 12)).beauty.sum()
    assert noon > 10 * dusk > 0
    with pytest.raises(brume.DomainError, match="environment.sky.turbidity"):
        cloud.environment.sky.turbidity = 11
        brume.render(cloud, airlight="sliced:8", size=(16, 12))
