from os import PathLike
from typing import Callable, Iterable, Optional, Sequence, Tuple, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

_Path = Union[str, PathLike[str]]
_Vec3 = Sequence[float]
_Progress = Optional[Callable[[float], object]]

__version__: str

class InputError(ValueError): ...
class DomainError(ValueError): ...

class Medium:
    density: float
    centers: NDArray[np.float64]
    radii: NDArray[np.float64]
    densities: NDArray[np.float64]
    albedos: NDArray[np.float64]
    emissions: NDArray[np.float64]
    def __init__(self) -> None: ...
    def __len__(self) -> int: ...
    @property
    def axis_radii(self) -> NDArray[np.float64]: ...
    @property
    def rotations(self) -> NDArray[np.float64]: ...
    def set_ellipsoids(self, radii: ArrayLike, rotations: ArrayLike) -> None: ...
    def append(
        self,
        centers: ArrayLike,
        radii: ArrayLike,
        densities: ArrayLike,
        rotations: Optional[ArrayLike] = None,
    ) -> None: ...
    def remove(self, indices: ArrayLike) -> None: ...
    def save(self, file: _Path, voxel: float = 0.1) -> None: ...
    def clear_keys(self) -> None: ...

class Camera:
    eye: _Vec3
    target: _Vec3
    up: _Vec3
    vertical_fov: float
    height: Optional[float]
    aperture: float
    focus_distance: Optional[float]
    roll: float
    def __init__(
        self,
        eye: _Vec3 = (0.0, 0.0, 5.0),
        target: _Vec3 = (0.0, 0.0, 0.0),
        up: _Vec3 = (0.0, 1.0, 0.0),
        vertical_fov: float = 45.0,
        height: Optional[float] = None,
        aperture: float = 0.0,
        focus_distance: Optional[float] = None,
        roll: float = 0.0,
    ) -> None: ...
    def clear_keys(self) -> None: ...

class Sky:
    elevation: float
    azimuth: float
    turbidity: float
    ground_albedo: _Vec3
    sun: bool
    def __init__(
        self,
        elevation: float = 30.0,
        azimuth: float = 0.0,
        turbidity: float = 3.0,
        ground_albedo: _Vec3 = (0.3, 0.3, 0.3),
        sun: bool = True,
    ) -> None: ...
    def clear_keys(self) -> None: ...

class Environment:
    intensity: float
    rotation: float
    @overload
    def __init__(self, map: _Path) -> None: ...
    @overload
    def __init__(self, sky: Sky) -> None: ...
    @property
    def sky(self) -> Optional[Sky]: ...
    def clear_keys(self) -> None: ...

class Light:
    name: str
    position: _Vec3
    intensity: _Vec3
    direction: _Vec3
    inner_angle: float
    outer_angle: float
    angular_diameter: float
    width: float
    height: float
    up: _Vec3
    two_sided: bool
    visible: bool
    radius: float
    texture_rotation: float
    texture_focus: float
    profile_rotation: float
    on: bool
    locked: bool
    @property
    def kind(self) -> str: ...
    @staticmethod
    def point(
        position: _Vec3,
        intensity: _Vec3 = (1.0, 1.0, 1.0),
    ) -> Light: ...
    @staticmethod
    def spot(
        position: _Vec3,
        direction: _Vec3,
        intensity: _Vec3 = (1.0, 1.0, 1.0),
        inner_angle: float = 0.0,
        outer_angle: float = 45.0,
    ) -> Light: ...
    @staticmethod
    def directional(
        direction: _Vec3,
        irradiance: _Vec3,
        angular_diameter: float = 0.0,
    ) -> Light: ...
    @staticmethod
    def rectangle(
        position: _Vec3,
        direction: _Vec3,
        radiance: _Vec3,
        width: float,
        height: float,
        up: _Vec3 = (0.0, 1.0, 0.0),
        two_sided: bool = False,
        visible: bool = False,
    ) -> Light: ...
    @staticmethod
    def disk(
        position: _Vec3,
        direction: _Vec3,
        radiance: _Vec3,
        radius: float,
        two_sided: bool = False,
        visible: bool = False,
    ) -> Light: ...
    @staticmethod
    def sphere(
        position: _Vec3,
        radiance: _Vec3,
        radius: float,
        two_sided: bool = False,
        visible: bool = False,
    ) -> Light: ...
    def clear_keys(self) -> None: ...

class Surface:
    name: str
    visible: bool
    locked: bool
    holdout: bool
    translate: _Vec3
    scale: float
    rotate: Sequence[float]
    reflectance: _Vec3
    @staticmethod
    def load(mesh: _Path) -> Surface: ...
    @staticmethod
    def primitive(shape: str, size: _Vec3 = (1.0, 1.0, 1.0)) -> Surface: ...
    @staticmethod
    def mesh(points: ArrayLike, triangles: ArrayLike) -> Surface: ...
    def scatter(
        self,
        over: str,
        density: float,
        seed: int = 0,
        scale: Sequence[float] = (1.0, 1.0),
        turn: float = 0.0,
    ) -> None: ...
    def load_copies(self, file: _Path) -> None: ...
    def clear_copies(self) -> None: ...
    def set_diffuse(self, reflectance: _Vec3) -> None: ...
    def set_phong(self, reflectance: _Vec3, specular: _Vec3, exponent: float) -> None: ...
    def set_metallic_roughness(
        self,
        base_color: _Vec3,
        metallic: float = 0.0,
        roughness: float = 0.5,
        emissive: _Vec3 = (0.0, 0.0, 0.0),
        alpha: str = "opaque",
        opacity: float = 1.0,
        alpha_cutoff: float = 0.5,
        transmission: _Vec3 = (0.0, 0.0, 0.0),
    ) -> None: ...
    def clear_keys(self) -> None: ...

class Scene:
    medium: Medium
    camera: Camera
    environment: Optional[Environment]
    lights: list[Light]
    surfaces: list[Surface]
    size: Tuple[int, int]
    frames_per_second: float
    albedo: _Vec3
    anisotropy: float
    extent: Optional[float]
    def __init__(self) -> None: ...
    @property
    def is_animated(self) -> bool: ...
    @property
    def last_moment(self) -> float: ...
    def save(self, file: _Path) -> None: ...
    def clear_keys(self) -> None: ...

class ErrorEstimate:
    def __float__(self) -> float: ...
    @property
    def rel_rmse(self) -> float: ...
    @property
    def low(self) -> float: ...
    @property
    def high(self) -> float: ...
    @property
    def pixels(self) -> int: ...
    @property
    def block_median(self) -> float: ...
    @property
    def block_low(self) -> float: ...
    @property
    def block_high(self) -> float: ...

class Frame:
    @property
    def beauty(self) -> NDArray[np.float32]: ...
    @property
    def airlight(self) -> NDArray[np.float32]: ...
    @property
    def transmittance(self) -> NDArray[np.float32]: ...
    @property
    def depth(self) -> NDArray[np.float32]: ...
    @property
    def layers(self) -> dict[str, NDArray[np.float32]]: ...
    @property
    def size(self) -> Tuple[int, int]: ...
    @property
    def error(self) -> Optional[ErrorEstimate]: ...
    @property
    def picture_error(self) -> Optional[ErrorEstimate]: ...
    @property
    def airlight_method(self) -> str: ...
    @property
    def milliseconds(self) -> float: ...
    @property
    def request_milliseconds(self) -> float: ...
    @property
    def stages(self) -> dict[str, float]: ...
    @property
    def backend(self) -> str: ...
    def save(self, file: _Path, exposure: float = 0.0) -> None: ...
    def png(self, exposure: float = 0.0) -> bytes: ...

class Renderer:
    def __init__(self) -> None: ...
    def render(
        self,
        scene: Scene,
        *,
        size: Optional[Tuple[int, int]] = None,
        region: Optional[Tuple[float, float, float, float]] = None,
        time: float = 0,
        slices: int = 24,
        airlight: str = "auto",
        scattering: str = "multiple",
        seed: int = 0,
        denoise: str = "none",
        airlight_scale: Optional[int] = None,
        paper_mean: bool = False,
        paper_energy: bool = False,
        paper_spread: bool = False,
        max_error: float = 0.02,
        error: Optional[str] = None,
        tolerance: float = 0.0001,
        samples: Optional[int] = None,
        shutter: Optional[Union[str, Tuple[float, float]]] = None,
        layers: Optional[Iterable[str]] = None,
        backend: str = "auto",
        threads: Optional[int] = None,
        camera: Optional[Camera] = None,
        progress: _Progress = None,
    ) -> Frame: ...

def load(file: _Path) -> Scene: ...
def load_medium(file: _Path) -> Medium: ...
def render(
    scene: Scene,
    *,
    size: Optional[Tuple[int, int]] = None,
    region: Optional[Tuple[float, float, float, float]] = None,
    time: float = 0,
    slices: int = 24,
    airlight: str = "auto",
    scattering: str = "multiple",
    seed: int = 0,
    denoise: str = "none",
    airlight_scale: Optional[int] = None,
    paper_mean: bool = False,
    paper_energy: bool = False,
    paper_spread: bool = False,
    max_error: float = 0.02,
    error: Optional[str] = None,
    tolerance: float = 0.0001,
    samples: Optional[int] = None,
    shutter: Optional[Union[str, Tuple[float, float]]] = None,
    layers: Optional[Iterable[str]] = None,
    backend: str = "auto",
    threads: Optional[int] = None,
    camera: Optional[Camera] = None,
    progress: _Progress = None,
) -> Frame: ...
def fit(
    densities: ArrayLike,
    voxel: float,
    origin: _Vec3 = (0.0, 0.0, 0.0),
    count: int = 500,
    max_error: float = 0.0,
    shape: str = "ellipsoid",
    progress: _Progress = None,
) -> Tuple[Medium, float]: ...
