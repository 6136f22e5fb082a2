#pragma once

#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <initializer_list>
#include <memory>
#include <string>

#include "brume/frame.h"
#include "brume/scene.h"
#include "render/settings.h"
#include "tools/bench/measure/frames.h"
#include "tools/bench/scenes/benchmark_meshes.h"

namespace brume {

// A ball of `count` random Gaussians of radius 0.3 around the origin, about 1 u large, whose
// densities are scaled so that the depth along the z axis is `depth`; seen from z = 4, lit from
// above. The same for the same seed everywhere.
Scene cloud_scene(int count, double depth, unsigned seed = 1);

// The same with every second Gaussian an ellipsoid, turned at random, of up to this many times its
// radius along its longest axis, and down to 1 / elongation across it.
Scene ellipsoid_scene(int count, double depth, double elongation, unsigned seed = 1);

// With homogeneous density `b0`, 1/u.
Scene in_fog(Scene scene, double b0);

// Nothing, seen by a camera.
Scene seen_by(const Camera& camera, const Film& film);
// The scene with a film of so many pixels.
Scene on_film(Scene scene, const Film& film);

// Two triangles across z = `z`, from -`half` to `half` in x and y, facing +z.
Surface wall(double z, double half, double reflectance = 0.5);

// Clouds of 30 at depth 2: with the eye among them, and with a wall through their middle.
Scene eye_inside();
Scene cut_by_a_surface();

// A primitive whose middle is at `place`.
Surface placed(Primitive::Shape shape, const glm::dvec3& size, const glm::dvec3& place,
               double reflectance = 0.5);

Material metallic_roughness(const glm::dvec3& base_color, double metallic, double roughness,
                            const glm::dvec3& emissive = glm::dvec3(0.0));

// A tessellated unit ball.
std::shared_ptr<const TriangleMesh> ball_mesh(int rings);
Surface ball_surface(int rings, double radius, const glm::dvec3& center = {});

// A sky that is the same everywhere.
std::shared_ptr<const RadianceMap> constant_sky(float radiance);
Environment even_sky(float radiance);

inline const Settings paper_settings{.airlight = AirlightMethod::paper};
Settings reference_settings(double tolerance = 1e-5);
Settings sliced(int slices, Scattering scattering = Scattering::single);
// The grid of all orders here is coarse beside what users get; the bounds of frames hold on it.
Settings all_orders(int slices, const SourceGridSize& grid = {.nodes = 6000, .directions = 48});
Settings path_traced(int paths);

struct Difference {
  double relative_rmse = 0.0;
  double bias = 0.0;  // mean(a - b) / mean(b)
};
Difference difference(const std::vector<float>& a, const std::vector<float>& b);

// The mean over pixels and channels.
double mean_airlight(const Frame& frame);
double mean_airlight(const Scene& scene, const Settings& settings);

// The relative RMSE of the airlight that a scene has by some settings, of that by others.
double airlight_error(const Scene& scene, const Settings& settings, const Settings& truth);

// True if the statistics say of something left out why, in words that include these.
bool is_left_out(const Frame& frame, const std::string& why);

// Expects that all is finite: radiance, alpha, transmittance in [0, 1]; distances > 0, +inf
// allowed.
void expect_finite(const Frame& frame);

// For integrals that share no code with those they test: the optical depth of the Gaussians from x
// on in the unit direction w, and the density at x with that of homogeneous fog [1/u].
double plain_depth(const Medium& medium, const glm::dvec3& x, const glm::dvec3& w, double length);
double plain_density(const Medium& medium, const glm::dvec3& x);
// The red airlight that a ray of the camera in a unit direction scatters between two distances, by
// the middles of so many steps; `incident` is the light that arrives at a point from all around.
double plain_airlight(const Scene& scene, const glm::dvec3& w, double begin, double end, int steps,
                      const std::function<double(const glm::dvec3& x)>& incident);
// Expects the red airlight of pixels within 0.1% of what is `expected` of their rays' directions.
void expect_airlight(const Scene& scene, const Frame& frame,
                     std::initializer_list<glm::ivec2> pixels,
                     const std::function<double(const glm::dvec3& w)>& expected);

// A copy turned by q about the origin.
std::shared_ptr<TriangleMesh> turned(const TriangleMesh& mesh, const glm::dquat& q);

// At every degree: the cosine of the polar angle below the luminaire, 0 above.
LightProfile cosine_profile();

// At every 5 degrees: two unlike lobes to the sides.
LightProfile lobed_profile(double rotation);

}  // namespace brume
