#include "tests/render/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "brume/mesh_arrays.h"
#include "core/scene/camera_rays.h"
#include "core/scene/lights/photometric_profile.h"
#include "core/scene/lights/radiance_map.h"
#include "core/transport/optical_depth.h"
#include "tests/random.h"

namespace brume {

Scene cloud_scene(int count, double depth, unsigned seed) {
  Random random(seed);
  std::vector<Gaussian> gaussians;
  while (static_cast<int>(gaussians.size()) < count) {
    const glm::dvec3 p = random.point(1.0);
    const double density = random.uniform(0.5, 1.5);
    if (glm::dot(p, p) <= 1.0) gaussians.push_back({p, 0.3, density});
  }
  double along_axis = 0.0;
  for (const Gaussian& g : gaussians) {
    along_axis += optical_depth(g, {0, 0, -10}, {0, 0, 10});
  }
  Scene scene;
  for (Gaussian& g : gaussians) {
    g.density *= depth / along_axis;
    scene.medium.append(g);
  }
  scene.camera = {{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40.0};
  scene.film = {32, 32};
  scene.lights.push_back({{1.5, 3.0, 2.0}, {10, 10, 10}, {}});
  return scene;
}

Scene ellipsoid_scene(int count, double depth, double elongation, unsigned seed) {
  Scene scene = cloud_scene(count, depth, seed);
  const Medium balls = scene.medium;
  scene.medium = {};
  Random random(seed + 1000);
  double along_axis = 0.0;
  std::vector<Gaussian> gaussians;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    Gaussian g = balls.gaussian(i);
    const glm::dvec3 q = random.point(1.0);
    const double w = random.uniform(-1.0, 1.0);
    const double half = 0.5 * std::log10(elongation);
    const double x = random.power(-half, half);
    const double y = random.power(-half, half);
    const double z = random.power(-half, half);
    if (i % 2 == 0) {
      g.set_radii(g.radius * glm::dvec3(x, y, z), glm::normalize(glm::dquat(w, q.x, q.y, q.z)));
    }
    along_axis += optical_depth(g, {0, 0, -10}, {0, 0, 10});
    gaussians.push_back(g);
  }
  for (Gaussian& g : gaussians) {
    g.density *= depth / along_axis;
    scene.medium.append(g);
  }
  return scene;
}

Scene in_fog(Scene scene, double b0) {
  scene.medium.set_homogeneous_density(b0);
  return scene;
}

Surface placed(Primitive::Shape shape, const glm::dvec3& size, const glm::dvec3& place,
               double reflectance) {
  Surface surface;
  surface.primitive = Primitive{shape, size};
  surface.mesh = mesh_of(*surface.primitive);
  surface.translate = place;
  surface.material.reflectance = glm::dvec3(reflectance);
  return surface;
}

Scene seen_by(const Camera& camera, const Film& film) {
  Scene scene;
  scene.camera = camera;
  scene.film = film;
  return scene;
}

Scene on_film(Scene scene, const Film& film) {
  scene.film = film;
  return scene;
}

Surface wall(double z, double half, double reflectance) {
  const auto h = static_cast<float>(half);
  const auto z_plane = static_cast<float>(z);
  const MeshArrays mesh{{{-h, -h, z_plane}, {h, -h, z_plane}, {h, h, z_plane}, {-h, h, z_plane}},
                        std::vector(4, glm::vec3(0, 0, 1)),
                        {{0, 1, 2}, {0, 2, 3}}};
  Surface surface;
  surface.mesh = to_mesh(mesh);
  surface.material.reflectance = glm::dvec3(reflectance);
  return surface;
}

Scene eye_inside() {
  Scene scene = cloud_scene(30, 2.0);
  scene.camera.eye = {0.1, 0.0, 0.3};
  return scene;
}

Scene cut_by_a_surface() {
  Scene scene = cloud_scene(30, 2.0);
  scene.surfaces.push_back(wall(0.05, 3.0));
  return scene;
}

std::shared_ptr<const TriangleMesh> ball_mesh(int rings) {
  MeshArrays mesh;
  const int segments = 2 * rings;
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j < segments; ++j) {
      const double theta = std::numbers::pi * i / rings;
      const double phi = 2.0 * std::numbers::pi * j / segments;
      const glm::vec3 p(static_cast<float>(std::sin(theta) * std::cos(phi)),
                        static_cast<float>(std::cos(theta)),
                        static_cast<float>(std::sin(theta) * std::sin(phi)));
      mesh.points.push_back(p);
      mesh.normals.push_back(p);
    }
  }
  const auto at = [&](int i, int j) { return static_cast<unsigned>(i * segments + j % segments); };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < segments; ++j) {
      mesh.triangles.emplace_back(at(i, j), at(i, j + 1), at(i + 1, j));
      mesh.triangles.emplace_back(at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    }
  }
  return to_mesh(mesh);
}

Material metallic_roughness(const glm::dvec3& base_color, double metallic, double roughness,
                            const glm::dvec3& emissive) {
  Material material;
  material.type = Material::Type::metallic_roughness;
  material.metallic_roughness.base_color = base_color;
  material.metallic_roughness.metallic = metallic;
  material.metallic_roughness.roughness = roughness;
  material.metallic_roughness.emissive = emissive;
  return material;
}

Surface ball_surface(int rings, double radius, const glm::dvec3& center) {
  Surface surface;
  surface.mesh = ball_mesh(rings);
  surface.scale = radius;
  surface.translate = center;
  return surface;
}

std::shared_ptr<const RadianceMap> constant_sky(float radiance) {
  return std::make_shared<const RadianceMap>(
      RadianceMap{16, 8, std::vector<glm::vec3>(16 * 8, glm::vec3(radiance))});
}

Environment even_sky(float radiance) {
  Environment environment;
  environment.map = constant_sky(radiance);
  return environment;
}

Difference difference(const std::vector<float>& a, const std::vector<float>& b) {
  EXPECT_EQ(a.size(), b.size());
  double square = 0.0;
  double square_b = 0.0;
  double sum = 0.0;
  double sum_b = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    square += d * d;
    square_b += static_cast<double>(b[i]) * static_cast<double>(b[i]);
    sum += d;
    sum_b += static_cast<double>(b[i]);
  }
  return {std::sqrt(square / square_b), sum / sum_b};
}

double mean_airlight(const Frame& frame) {
  double sum = 0.0;
  for (const float value : frame.airlight) sum += static_cast<double>(value);
  return sum / static_cast<double>(frame.airlight.size());
}

double mean_airlight(const Scene& scene, const Settings& settings) {
  return mean_airlight(render_frame(scene, settings));
}

double airlight_error(const Scene& scene, const Settings& settings, const Settings& truth) {
  return rel_rmse(render_frame(scene, settings).airlight, render_frame(scene, truth).airlight);
}

bool is_left_out(const Frame& frame, const std::string& why) {
  return std::ranges::any_of(frame.statistics.skipped, [&why](const SkippedStage& skipped) {
    return skipped.why.find(why) != std::string::npos;
  });
}

void expect_finite(const Frame& frame) {
  for (const float x : frame.beauty) ASSERT_TRUE(std::isfinite(x) && x >= 0.0f) << x;
  for (const float x : frame.airlight) ASSERT_TRUE(std::isfinite(x) && x >= 0.0f) << x;
  for (const float x : frame.transmittance) ASSERT_TRUE(x >= 0.0f && x <= 1.0f) << x;
  for (const float x : frame.depth) ASSERT_TRUE(x > 0.0f) << x;
}

Settings reference_settings(double tolerance) {
  Settings settings;
  settings.airlight = AirlightMethod::reference;
  settings.reference_tolerance = tolerance;
  return settings;
}

Settings sliced(int slices, Scattering scattering) {
  Settings settings;
  settings.airlight = AirlightMethod::sliced;
  settings.slices = slices;
  settings.scattering = scattering;
  return settings;
}

Settings all_orders(int slices, const SourceGridSize& grid) {
  Settings settings = sliced(slices, Scattering::multiple);
  settings.source_grid = grid;
  return settings;
}

Settings path_traced(int paths) {
  Settings settings;
  settings.airlight = AirlightMethod::path;
  settings.paths = paths;
  return settings;
}

double plain_depth(const Medium& medium, const glm::dvec3& x, const glm::dvec3& w, double length) {
  double sum = 0.0;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const StandaloneTerm term(medium.gaussian(i));
    const GaussianTerm<double>& g = *term;
    const double t0 = glm::dot(g.b - x, w);
    const glm::dvec3 off = g.b - x - t0 * w;
    sum += g.c * std::exp(-g.a * g.a * glm::dot(off, off)) * std::sqrt(std::numbers::pi) /
           (2.0 * g.a) * (std::erf(g.a * (length - t0)) + std::erf(g.a * t0));
  }
  return sum;
}

double plain_density(const Medium& medium, const glm::dvec3& x) {
  double sum = medium.homogeneous_density();
  for (std::size_t k = 0; k < medium.size(); ++k) {
    const StandaloneTerm term(medium.gaussian(k));
    const GaussianTerm<double>& g = *term;
    const glm::dvec3 off = x - g.b;
    sum += g.c * std::exp(-g.a * g.a * glm::dot(off, off));
  }
  return sum;
}

double plain_airlight(const Scene& scene, const glm::dvec3& w, double begin, double end, int steps,
                      const std::function<double(const glm::dvec3& x)>& incident) {
  const double step = (end - begin) / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double t = begin + step * (i + 0.5);
    const glm::dvec3 x = scene.camera.eye + t * w;
    const double density = plain_density(scene.medium, x);
    if (density < 1e-7) continue;
    const double depth =
        plain_depth(scene.medium, scene.camera.eye, w, t) + scene.medium.homogeneous_density() * t;
    sum += density * std::exp(-depth) * incident(x);
  }
  return sum * step / (4.0 * std::numbers::pi);
}

void expect_airlight(const Scene& scene, const Frame& frame,
                     std::initializer_list<glm::ivec2> pixels,
                     const std::function<double(const glm::dvec3& w)>& expected) {
  const CameraRays rays(scene.camera, scene.film);
  for (const glm::ivec2& pixel : pixels) {
    const double value = expected(glm::normalize(rays.direction(pixel.x + 0.5, pixel.y + 0.5)));
    const auto i = static_cast<std::size_t>(3 * (pixel.y * scene.film.width + pixel.x));
    EXPECT_NEAR(frame.airlight[i], value, 1e-3 * value + 1e-7) << pixel.x << ", " << pixel.y;
  }
}

std::shared_ptr<TriangleMesh> turned(const TriangleMesh& mesh, const glm::dquat& q) {
  MeshArrays arrays = to_arrays(mesh);
  for (glm::vec3& p : arrays.points) p = glm::vec3(q * glm::dvec3(p));
  for (glm::vec3& n : arrays.normals) n = glm::vec3(q * glm::dvec3(n));
  return to_mesh(arrays);
}

namespace {

// `intensity`: of the polar angle and the azimuth in radians.
template <class Intensity>
LightProfile profile(double step, double rotation, Intensity&& intensity) {
  std::vector<double> polar;
  std::vector<double> azimuths;
  std::vector<double> values;
  for (double p = 0.0; p <= 180.0; p += step) polar.push_back(p);
  for (double a = 0.0; a <= 360.0; a += step) {
    azimuths.push_back(a);
    for (const double p : polar) values.push_back(intensity(glm::radians(p), glm::radians(a)));
  }
  return {"profile.ies", std::make_shared<const PhotometricProfile>(polar, azimuths, values),
          rotation};
}

}  // namespace

LightProfile cosine_profile() {
  return profile(1.0, 0.0, [](double p, double) { return std::max(std::cos(p), 0.0); });
}

LightProfile lobed_profile(double rotation) {
  return profile(5.0, rotation, [](double p, double a) {
    return std::exp(-8.0 * std::pow(p - 0.7, 2)) * (1.3 + std::cos(a)) *
           (1.0 + std::pow(std::sin(a), 2));
  });
}

}  // namespace brume
