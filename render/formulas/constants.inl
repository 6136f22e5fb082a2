// Limits that kernels and shaders share.

CONSTANT pi = 3.14159265358979324;
CONSTANT sqrt_pi = 1.77245385090551603;
CONSTANT inv_sqrt_pi = 0.564189583547756287;
// Isotropic scattering per solid angle: 1 / (4 pi).
CONSTANT isotropic_phase = 0.0795774715459476679;
// Divisors are at least this: the quotient is finite, and no value of a picture is as small.
CONSTANT tiny = 1e-30;
// Squared lengths up to this are too short to define a direction.
CONSTANT tiny_square = 1e-37;
// The same of the sine of an angle, where directions are unit.
CONSTANT tiny_sine_square = 1e-14;

// What a point of an area light sends at least to a surface, of what it sends straight ahead: where
// all of a sphere's points are turned away, the nearest tell whether it is hidden. A light's only
// point sends nothing below it: in its plane is the surface that emits, which does not light itself.
CONSTANT least_of_area = 1e-3;

// Sides of the polygon that stands for a disk that shines: at its edge 1% of the radius off.
CONSTANT disk_corners = 16.0;
// An area light lights surfaces by its points alone where the square of their distance is so many
// times its area, as it is seen from ahead.
CONSTANT far_areas = 400.0;
// Rays over the highlight of a smooth surface that look for area lights.
CONSTANT highlight_rays = 64.0;

// A slice's part of a Gaussian lies in its middle where it is shorter than this [radii]: to a
// twentieth of the slice.
CONSTANT short_slice = 0.25;
// Slices behind this optical depth are invisible.
CONSTANT visible_depth = 20.0;
// Below these, 1 - exp(-x) and its mean over [0, x] are taken by two terms of their series.
CONSTANT small_increment = 1e-3;
CONSTANT small_exponent = 1e-2;

// The angle that the rule for homogeneous fog takes at once next to the peak of an isotropic phase
// function; a narrow peak's is smaller in proportion to 1 - |g|.
CONSTANT fog_panel = 4.0;
// Fog is left out where the path is longer than the shortest one by this optical depth.
CONSTANT fog_detour_depth = 10.0;
// Minimum distance of a light from a view ray that float resolves: relative to the distance along
// the ray, and absolute [u].
CONSTANT light_rounding = 1e-6;
CONSTANT min_light_gap = 1e-15;

// The last sample of a table is reached from below: a look-up reads the next one too.
CONSTANT table_end = 1.001;
// See ScatterTable.
CONSTANT scatter_scale = 2.4;
// Float cannot distinguish cells of a lattice beyond this.
CONSTANT max_lattice_distance = 1e9;
