"""The hard cases: scenes that break careless arithmetic, each with what breaks and what is done.

A case is a scene of a few pixels. `bound` is how far `sliced` (24 slices) may be off the integral:
the relative RMSE of the airlight, 0.01 unless the case says otherwise and why.
"""

import math
import random

CASES = []


def gaussian(center, radius, density):
    return {"center": list(center), "radius": radius, "density": density}


def lamp(position=(2.0, 3.0, 2.0), intensity=(10.0, 10.0, 10.0)):
    return {"type": "point", "position": list(position), "intensity": list(intensity)}


def camera(eye=(0.0, 0.0, 4.0), target=(0.0, 0.0, 0.0), fov=40.0, up=(0.0, 1.0, 0.0)):
    return {"eye": list(eye), "target": list(target), "up": list(up), "vertical_fov": fov}


def square(z, scale=1.0, rotate=(1.0, 0.0, 0.0, 0.0), x=0.0, y=0.0):
    """The square of side 2 across z = `z`, scaled and turned."""
    return {"mesh": "square.off", "translate": [x, y, z], "rotate": list(rotate), "scale": scale}


def case(name, breaks, remedy, gaussians=(), lights=None, view=None, fog=0.0, surfaces=(),
         film=(4, 3), bound=0.01, why="", **optics):
    medium = {"density": fog, "gaussians": list(gaussians), **optics}
    scene = {
        "format": "brume-scene",
        "version": 1,
        "camera": view or camera(),
        "film": {"width": film[0], "height": film[1]},
        "medium": medium,
        "lights": [lamp()] if lights is None else list(lights),
        "surfaces": list(surfaces),
    }
    CASES.append({"name": name, "breaks": breaks, "remedy": remedy, "bound": bound, "why": why,
                  "scene": scene})


def ball(count, radius, density, seed=1, size=1.0):
    """Random Gaussians in a ball of radius `size`."""
    chance = random.Random(seed)
    result = []
    while len(result) < count:
        p = [chance.uniform(-1.0, 1.0) for _ in range(3)]
        if sum(x * x for x in p) > 1.0:
            continue
        result.append(gaussian([round(size * x, 6) for x in p], radius, density))
    return result


CLOUD = ball(8, 0.5, 0.8)
ERF = "differences of erf cancel"
ERFC = "erfc from the side of the smaller tail, in one exponent with the density"
LOCAL = "centres, lights and surfaces are moved to the eye in double before anything is float"
LEAST = "the distance of a light from a ray is at least a twentieth of a pixel"
EQUI = "equi-angular slices in addition to the others"
SMALL = "slices go where Gaussians are small and dense"
TAIL = "slices follow the tail of what is opaque"
NOTHING = "no constant has a unit of length"
ENDS = "the ray ends at the wall, exactly"
ALBEDO = "one medium per distinct albedo, with densities divided by it"

# Tails and cancellation.
case("tail_ahead", "a ray passes a dense Gaussian at 4 radii: its optical depth underflows or is a rounding error",
     "the density on the ray is factored out before the erf", [gaussian([0, 1.4, 0], 0.3, 1e6)],
     view=camera(fov=10.0), bound=0.2,
     why="light crosses the tail too, whose optical depth changes by a factor of e within 0.03 u")
case("tail_behind_eye", f"the eye in the tail looks away: {ERF}, and the remainder is multiplied by 1e7",
     ERFC, [gaussian([0, 0, 5.5], 0.4, 2e7)], bound=0.1,
     why="density and the optical depth towards the light drop by a factor of e within 0.05 u, less than a cell of the table")
case("tail_towards_light", f"the shadow ray lies in the tail of a dense Gaussian: {ERF}",
     ERFC, [gaussian([3.1, 4.65, 2.6], 0.4, 1e6), gaussian([0, 0, 0], 0.5, 1.0)])
case("tail_before_wall", "a wall stands in the tail before a dense Gaussian", TAIL,
     [gaussian([0, 0, -1.5], 0.5, 1e4)], surfaces=[square(0.0, 3.0)])
case("gaussian_behind_wall", "a dense Gaussian behind a wall leaks through it", ENDS,
     CLOUD + [gaussian([0, 0, -3.0], 0.5, 1e3)], surfaces=[square(-0.9, 3.0)])
case("short_segment", "a wall 0.001 u before the eye: a difference of nearly equal depths",
     "erf of offsets from the nearest point, not of positions", CLOUD + [gaussian([0, 0, 4.0], 0.5, 2.0)],
     [lamp((2.0, 3.0, 6.0))], surfaces=[square(3.999, 1.0)])
case("far_from_origin", "everything 1e6 u away: float has 0.06 u left", LOCAL,
     [gaussian([1e6 + g["center"][0], g["center"][1] - 1e6, 1e6 + g["center"][2]], g["radius"],
               g["density"]) for g in CLOUD],
     [lamp((1e6 + 2.0, 3.0 - 1e6, 1e6 + 2.0))],
     camera((1e6, -1e6, 1e6 + 4.0), (1e6, -1e6, 1e6)))
case("far_eye", "a cloud of 2 u seen from 10,000 u: squares of distances cancel",
     "the gap between centre and ray is taken as a vector, then squared", CLOUD,
     view=camera((0, 0, 1e4), fov=0.016), film=(5, 4))
case("far_light", "a light at 100,000 u: all directions to the medium coincide",
     "its table covers a window around the medium, not a sphere", CLOUD, [lamp((6e4, 7e4, 4e4), (1e11,) * 3)])
case("grazing_wall", "rays nearly along a wall", ENDS,
     CLOUD, surfaces=[square(-0.1, 3.0, (0.70356, -0.71063, 0.0, 0.0), y=-0.1)])

# Scales.
case("huge_radius", "a radius of 10,000 u around a cloud of 1 u: it takes up all of the tables and slices",
     "the table's radii widen with distance; slices near the light match its scale",
     [gaussian([0, 0, 0.5], 1e4, 0.02)] + CLOUD)
case("huge_radius_alone", "a radius of 10,000 u, lit by a light at 4 u", EQUI,
     [gaussian([0, 0, -2e4], 1e4, 1.0)], bound=0.03,
     why="the medium is 1,000 times as large as what is lit")
case("tiny_radius", "a radius of 0.0001 u among large ones: no slice meets it", SMALL,
     CLOUD + [gaussian([0, 0, 0.5], 1e-4, 1e4)], film=(5, 3), bound=0.35,
     why="on the one pixel that meets it, its own shadow is far below a cell of the table")
case("tiny_alone", "a Gaussian of 0.0001 u fills the view", NOTHING,
     [gaussian([0, 0, 0], 1e-4, 1e4)], [lamp((2e-4, 3e-4, 2e-4), (1e-7,) * 3)],
     camera((0, 0, 4e-4)))
case("small_world", "a scene of a micrometre", NOTHING,
     [gaussian([1e-6 * x for x in g["center"]], 1e-6 * g["radius"], 1e6 * g["density"])
      for g in CLOUD], [lamp((2e-6, 3e-6, 2e-6), (1e-11,) * 3)], camera((0, 0, 4e-6)))
case("large_world", "a scene of a million u", NOTHING,
     [gaussian([1e6 * x for x in g["center"]], 1e6 * g["radius"], 1e-6 * g["density"])
      for g in CLOUD], [lamp((2e6, 3e6, 2e6), (1e13,) * 3)], camera((0, 0, 4e6)))
case("all_scales", "radii from 0.001 to 1,000 u in one sum",
     "optical depths are exact whatever the radius; the table's radii widen with distance",
     [gaussian([0.1 * k - 0.35, 0.05 * k, 0.2 - 0.1 * k], 10.0 ** (k - 3), 0.3 * 10.0 ** (3 - k) / 4)
      for k in range(7)], film=(5, 3))
case("thinnest", "an optical depth of 1e-8: 1 - exp(-T) is 0 in float",
     "its series where T is small", [gaussian([0, 0, 0], 0.5, 1e-8)])
case("pinprick_view", "an angle of view of 0.001 degrees: rays nearly coincide in float",
     "rays are made and normalised in double", CLOUD, view=camera(fov=1e-3))
case("widest_view", "an angle of view of 179 degrees: rays of one tile point in all directions",
     "optical depths are computed per ray; only slices are shared", CLOUD,
     view=camera((0, 0, 1.5), fov=179.0), bound=0.02,
     why="rays of neighbouring pixels share slices and are up to 60 degrees apart")
case("up_along_view", "the camera's up is its view: there is no right vector",
     "any axis perpendicular to the view is used", CLOUD, view=camera(up=(0, 0, 1)))

# Density.
case("density_zero", "a Gaussian of density 0 divides by its optical depth", "it is left out",
     CLOUD + [gaussian([0, 0, 0.5], 0.5, 0.0)])
case("density_1e6", "a density of 1e6: what is seen is its tail, at 3.5 radii", TAIL,
     [gaussian([0.1, 0.0, 0.0], 0.3, 1e6)], bound=0.03,
     why="light and eye see the same layer, 0.05 u thin")
case("density_1e6_in_cloud", "the same behind thin Gaussians", TAIL,
     [gaussian([0, 0, 0], 0.5, 1e6)] + CLOUD, bound=0.15,
     why="a layer of 0.05 u and eight Gaussians in front of it share 24 slices")
case("opaque_fog", "homogeneous fog of density 10,000: all airlight comes from the first 0.0001 u",
     "slices of equal transmittance loss, and the mean of exp(-T) over each", fog=1e4, film=(3, 3))
case("thin_fog", "unbounded homogeneous fog of density 1e-7: every slice near the light is negligible",
     "slices of homogeneous fog are never skipped", fog=1e-7)
case("fog_and_lamp_inside", "unbounded fog with its light in view", EQUI,
     fog=0.1, lights=[lamp((0.3, 0.2, 1.0))])
case("depth_100", "a cloud of depth 100 lit from behind: light passes only at its rim",
     "the optical-depth table ends at 30; beyond it the fog is black, not a rounding error",
     [gaussian(g["center"], 0.5, 20.0) for g in CLOUD], [lamp((0.5, 1.0, -4.0))], bound=0.03,
     why="only a thin layer at the cloud's rim is visible")
case("density_step", "a wall of 25 small dense Gaussians: the density steps within 0.1 u", SMALL,
     [gaussian([0.25 * i - 0.5, 0.25 * j - 0.5, 0.0], 0.15, 6.0) for i in range(5)
      for j in range(5)])
case("needle", "40 small Gaussians in a row along the view: one pixel sees all of them", SMALL,
     [gaussian([0.0, 0.0, 0.1 * k - 2.0], 0.04, 1.5) for k in range(40)], film=(5, 3))
case("overlapping_dense", "two dense Gaussians, one half in the other",
     "optical depths add, transmittances multiply",
     [gaussian([-0.3, 0.1, 0], 0.6, 2.0), gaussian([0.4, -0.1, 0.2], 0.5, 2.5)])

# Coincidence and singularities.
case("same_twice", "two equal Gaussians: they cannot be ordered", "nothing is sorted by position",
     CLOUD + 2 * [gaussian([0.1, 0.2, 0.3], 0.5, 1.0)])
case("thousands_at_one_point", "2,000 Gaussians at one point: no plane separates them",
     "the bounding-volume hierarchy splits by count", 2000 * [gaussian([0.1, 0.0, 0.0], 0.5, 0.001)])
case("concentric", "40 radii around one point", "the bounding-volume hierarchy splits by count",
     [gaussian([0.1, 0.1, 0.0], 0.02 * (k + 1), 0.05) for k in range(40)])
case("eye_at_centre", "the eye at the centre of a Gaussian: 0 / 0 in a direction",
     "nothing is divided by a distance to a ray", CLOUD + [gaussian([0, 0, 4], 0.5, 1.0)])
case("light_at_centre", "the light at the centre of a Gaussian",
     "the table's first radius is 0", CLOUD + [gaussian([2, 3, 2], 0.5, 1.0)])
case("lamp_in_dense_needle", "the light in a Gaussian of 0.02 u, which attenuates all of it",
     "the table's radii widen with distance", [gaussian([0.2, 0.1, 0.0], 0.02, 100.0)] + CLOUD,
     [lamp((0.2, 0.1, 0.0), (1.0,) * 3)], film=(5, 3))
case("eye_and_light_at_centre", "eye and light at one dense centre: 1 / d^2 at the ray's start",
     LEAST, [gaussian([0, 0, 4], 0.5, 5.0)], [lamp((0, 0, 4))])
case("ray_through_light", "the middle ray meets the light: 1 / d^2 on it is infinite", LEAST,
     CLOUD, [lamp((0, 0, 1))], fog=0.1, film=(5, 3))
case("ray_beside_light", "a ray passes the light at a millionth of a u", LEAST, CLOUD,
     [lamp((1e-6, 0, 1))], fog=0.1, film=(5, 3))
case("light_behind_eye", "the light behind the eye, on its axis",
     "the mean of 1 / d^2 over a slice is an angle, whatever its sign", CLOUD, [lamp((0, 0, 6))])
case("light_in_wall", "a light on a ceiling: whether it is occluded depends on rounding",
     "shadow rays stay a few ulps away from the light", CLOUD,
     [lamp((0.1, 0.1, -0.5))], surfaces=[square(-0.5, 1.0)])
case("light_before_wall", "the light 0.001 u before a wall",
     "shadow rays start at an offset of 1e-5 of their length", CLOUD,
     [lamp((0.1, 0.1, -0.499))], surfaces=[square(-0.5, 1.0)])
case("lights_at_one_place", "eight lights at one position", "each has its own table", CLOUD,
     8 * [lamp((2, 3, 2), (1.25,) * 3)])
case("light_of_1e20", "1e20 W/sr, the maximum in a scene file: squares overflow",
     "sums are per unit intensity, which is multiplied last", CLOUD, [lamp(intensity=(1e20,) * 3)])
case("light_of_1e_minus_20", "1e-20 W/sr: squares are subnormal",
     "sums are per unit intensity, which is multiplied last", CLOUD, [lamp(intensity=(1e-20,) * 3)])
case("no_light", "no light: a mean over nothing", "stages without work are skipped", CLOUD, [])
case("no_medium", "no medium: the fog on a ray has no start", "stages without work are skipped")
case("buried", "a density of 1e6 over 10,000 u: optical depths of 1e10, exp(-T) underflows",
     "light beyond an optical depth of 30 is dropped", [gaussian([0, 0, -3e4], 1e4, 1e6)])
case("one_colour", "a light of one channel", "channels are independent", CLOUD,
     [lamp(intensity=(0.0, 0.0, 10.0))])

# Phase function and albedo.
case("forward", "g = 0.95, the light behind the cloud: a forward lobe of 3,000 to 1",
     "each slice uses the phase function at its midpoint", CLOUD, [lamp((0.3, 0.2, -4.0))],
     anisotropy=0.95)
case("backward", "g = -0.95, the light behind the eye",
     "each slice uses the phase function at its midpoint", CLOUD, [lamp((0.05, 0.05, 6.0))],
     anisotropy=-0.95)
case("forward_lamp_inside", "g = 0.9 with the light in the fog: the forward lobe is 0.1 rad wide",
     EQUI + "; homogeneous fog of `paper` in panels that double in size from the lobe",
     CLOUD, [lamp((0.2, 0.1, 0.1))], fog=0.05, anisotropy=0.9, bound=0.02,
     why="the lobe is where the light is closest")
case("albedo_0.001", "an albedo of 0.001: extinction is 1,000 times scattering",
     ALBEDO, CLOUD, albedo=[1e-3, 1e-3, 1e-3], bound=0.05,
     why="the optical depth is 1,000 times the cloud's")
case("albedo_colours", "three albedos", ALBEDO, CLOUD, albedo=[1.0, 0.5, 0.05])

# Surfaces in the fog.
case("wall_through_centre", "a wall through the centres: half of each Gaussian counts",
     ENDS, CLOUD + [gaussian([0, 0, -0.5], 0.4, 2.0)], surfaces=[square(-0.5, 1.0)])
case("near_plane", "a dense flank cut by the eye: the optical depth starts at the eye",
     "the segment begins at the eye, exactly", [gaussian([0, 0, 3.6], 0.5, 4.0)] + CLOUD,
     bound=0.02, why="the eye stands where the density is greatest")
case("shaft", "light through a gap of 0.1 u between two walls",
     "a shadow map finer than the film", CLOUD, [lamp((0.0, 3.0, 0.0))], fog=0.05,
     surfaces=[square(0.0, 1.0, (math.sqrt(0.5), -math.sqrt(0.5), 0.0, 0.0), x=1.05, y=1.2),
               square(0.0, 1.0, (math.sqrt(0.5), -math.sqrt(0.5), 0.0, 0.0), x=-1.05, y=1.2)],
     film=(9, 6), bound=0.05, why="the shaft is one cell of the shadow map wide at the wall")
case("all_in_shadow", "a wall before the light but for its rim: what leaks is the error",
     "a shadow map filtered over four cells", CLOUD, [lamp((0.0, 3.0, 0.0))],
     surfaces=[square(0.0, 1.0, (math.sqrt(0.5), -math.sqrt(0.5), 0.0, 0.0), y=1.5)], bound=0.2,
     why="all light falls in cells of the shadow map that the edge of the wall crosses")
