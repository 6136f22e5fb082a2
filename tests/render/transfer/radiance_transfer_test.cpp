// Radiance transfer against what is known in closed form, against counting, and against the
// reference of surfaces.

#include "render/transfer/radiance_transfer.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <thread>

#include "core/scene/lights/environment.h"
#include "core/scene/lights/radiance_map.h"
#include "core/scene/placement.h"
#include "render/reference/surface_reference.h"
#include "render/transfer/sh_material.h"
#include "tests/core/math/sh_convolve.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

using std::numbers::pi;
const double everywhere = std::sqrt(4.0 * pi);  // the coefficient of the function that is 1

RadianceTransfer transfer_of(const std::shared_ptr<const TriangleMesh>& mesh,
                             const TransferSettings& settings) {
  return *radiance_transfer(mesh, settings);
}

ShVector<glm::dvec3> constant_light(int order, double radiance = 1.0) {
  ShVector<glm::dvec3> light(order);
  light[0] = glm::dvec3(radiance * everywhere);
  return light;
}

// The clamped cosine around n over pi.
ShVector<double> cosine_lobe(int order, const glm::dvec3& n) {
  ShVector<double> lobe = sh_convolve(sh_basis(order, n), clamped_cosine_sh());
  for (std::size_t i = 0; i < lobe.size(); ++i) lobe[i] /= pi;
  return lobe;
}

// The light that transfer makes of distant light.
glm::dvec3 transferred(const ShMaterial& material, const ShVector<glm::dvec3>& light,
                       const RadianceTransfer& transfer, MeshSide side, const MeshPoint& point,
                       const glm::dvec3& n, const glm::dvec3& wo) {
  const ShVector<glm::dvec3> nothing(light.order());
  return material.reflected(material.received(light, nothing, transfer, side, point), n, wo);
}

// The distance of two functions, relative to that which is 1 everywhere.
double distance(const ShVector<double>& f, const ShVector<double>& g) {
  double squares = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) squares += std::pow(f[i] - g[i], 2);
  return std::sqrt(squares) / everywhere;
}

ShVector<double> fully_visible(int order) {
  ShVector<double> f(order);
  f[0] = everywhere;
  return f;
}

TEST(EnclosedSides, AreInsideClosedParts) {
  const auto sides = [](const TriangleMesh& mesh, std::size_t vertex) {
    return enclosed_sides(mesh)[vertex];
  };
  EXPECT_EQ(sides(*ball_mesh(8), 20), Enclosed::back);
  MeshArrays mesh;
  const std::size_t outward = add_ball(mesh, 8, {5, 0, 0}, 1.0, pi, false);
  const std::size_t inward = add_ball(mesh, 8, {0, 5, 0}, 1.0, pi, true);
  const std::size_t bowl = add_ball(mesh, 8, {0, 0, 5}, 1.0, 2.0, true);
  const std::size_t floor = add_floor(mesh, 4, 1.0);
  const std::vector<Enclosed> all = enclosed_sides(*to_mesh(mesh));
  ASSERT_EQ(all.size(), mesh.points.size());
  for (std::size_t v = 0; v < all.size(); ++v) {
    EXPECT_EQ(all[v], v < inward ? Enclosed::back : v < bowl ? Enclosed::front : Enclosed::none);
  }
  EXPECT_EQ(outward, 0u);
  EXPECT_LT(bowl, floor);

  // One triangle less opens a part, and no other.
  mesh.triangles.erase(mesh.triangles.begin() + 40);
  const auto open = to_mesh(mesh);
  EXPECT_EQ(sides(*open, outward + 30), Enclosed::none);
  EXPECT_EQ(sides(*open, inward + 30), Enclosed::front);
}

// Its volume is only roundings.
TEST(EnclosedSides, AreNotBetweenTwoSheetsInOnePlace) {
  MeshArrays mesh;
  add_ball(mesh, 8, {1, 2, 3}, 1.0, 2.0, false);
  add_ball(mesh, 8, {1, 2, 3}, 1.0, 2.0, true);
  for (const Enclosed enclosed : enclosed_sides(*to_mesh(mesh))) {
    EXPECT_EQ(enclosed, Enclosed::none);
  }
}

// A ball sees all, since its own lower hemispheres are mirrored from the upper ones.
TEST(RadianceTransfer, ABallHasNoShadows) {
  const auto ball = ball_mesh(16);
  const MeshArrays arrays = to_arrays(*ball);
  for (int order = 1; order <= sh_max_bands; ++order) {
    const RadianceTransfer t = transfer_of(ball, {.order = order, .bounces = 1});
    EXPECT_TRUE(t.side(MeshSide::back).visibility.empty());
    EXPECT_TRUE(t.side(MeshSide::back).reflected.empty());
    for (std::uint32_t v = 0; v < t.vertices; v += 7) {
      const MeshPoint point = at_vertex(v);
      // Roundings of float.
      EXPECT_LT(distance(t.visibility(MeshSide::front, point), fully_visible(order)), 2e-6);
      const glm::dvec3 n = glm::dvec3(arrays.normals[v]);
      EXPECT_LT(distance(t.reflected(MeshSide::front, 0, point), cosine_lobe(order, n)), 2e-6);
      EXPECT_EQ(distance(t.reflected(MeshSide::front, 1, point), ShVector<double>(order)), 0.0);
      EXPECT_EQ(distance(t.visibility(MeshSide::back, point), ShVector<double>(order)), 0.0);
    }
  }
}

TEST(RadianceTransfer, UnshadowedVertexReflectsAWhiteSkyFully) {
  Material white;
  white.reflectance = {1.0, 0.5, 0.0};
  const ShMaterial material(white, 6);
  const RadianceTransfer t = transfer_of(ball_mesh(8), {.bounces = 2});
  const glm::dvec3 up(0, 1, 0);
  const glm::dvec3 front =
      transferred(material, constant_light(6, 3.0), t, MeshSide::front, at_vertex(0), up, up);
  EXPECT_NEAR(front.x, 3.0, 1e-5);
  EXPECT_NEAR(front.y, 1.5, 1e-5);
  EXPECT_EQ(front.z, 0.0);
  const glm::dvec3 back =
      transferred(material, constant_light(6, 3.0), t, MeshSide::back, at_vertex(0), -up, -up);
  EXPECT_EQ(back, glm::dvec3(0.0));
}

struct Ball {
  glm::dvec3 center{0.3, 0.1, 0.9};
  double radius = 0.5;

  [[nodiscard]] bool blocks(const glm::dvec3& from, const glm::dvec3& w) const {
    const glm::dvec3 q = center - from;
    const double along = glm::dot(q, w);
    return along > 0.0 && glm::dot(q, q) - along * along < radius * radius;
  }
};

// A floor with a ball above it.
std::shared_ptr<TriangleMesh> floor_and_ball(int n) {
  MeshArrays mesh;
  add_floor(mesh, n, 1.0);
  const Ball ball;
  add_ball(mesh, 48, ball.center, ball.radius, pi, false);
  return to_mesh(mesh);
}

struct Counted {
  ShVector<double> visibility;
  ShVector<double> reflected;
};

// By counting which of many directions over the floor meet the ball.
Counted counted(int order, const glm::dvec3& p) {
  constexpr int side = 500;
  Random random(7);
  Counted sum{ShVector<double>(order), ShVector<double>(order)};
  for (int k = 0; k < side * side; ++k) {
    const double z = (k / side + random.uniform(0, 1)) / side;
    const double phi = 2.0 * pi * (k % side + random.uniform(0, 1)) / side;
    const double r = std::sqrt(1.0 - z * z);
    const glm::dvec3 w(r * std::cos(phi), r * std::sin(phi), z);
    if (Ball().blocks(p, w)) continue;
    const ShVector<double> above = sh_basis(order, w);
    const ShVector<double> below = sh_basis(order, glm::dvec3(w.x, w.y, -w.z));
    const double weight = 2.0 * pi / (side * side);
    for (std::size_t i = 0; i < above.size(); ++i) {
      sum.visibility[i] += weight * (above[i] + below[i]);
      sum.reflected[i] += weight * z / pi * above[i];
    }
  }
  return sum;
}

TEST(RadianceTransfer, AFloorUnderABallMatchesCountedRays) {
  const auto mesh = floor_and_ball(6);
  const MeshArrays arrays = to_arrays(*mesh);
  constexpr std::size_t floor = 7 * 7;
  std::vector<Counted> reference;
  for (std::size_t v = 0; v < floor; v += 6)
    reference.push_back(counted(6, glm::dvec3(arrays.points[v])));
  double min_seen = 1.0;
  std::array<double, 3> error{};
  const std::array<std::size_t, 3> directions = {64, 256, 1024};
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const RadianceTransfer t = transfer_of(mesh, {.order = 6, .directions = directions[k]});
    for (std::uint32_t v = 0; v < floor; v += 6) {
      const Counted& expected = reference[v / 6];
      min_seen = std::min(min_seen, expected.visibility[0] / everywhere);
      const double V = distance(t.visibility(MeshSide::front, at_vertex(v)), expected.visibility);
      const double P = distance(t.reflected(MeshSide::front, 0, at_vertex(v)), expected.reflected);
      error[k] += (V * V + P * P) / static_cast<double>(reference.size());
      // Nothing is in the way below.
      EXPECT_LT(distance(t.visibility(MeshSide::back, at_vertex(v)), fully_visible(6)), 2e-6);
      EXPECT_LT(distance(t.reflected(MeshSide::back, 0, at_vertex(v)), cosine_lobe(6, {0, 0, -1})),
                2e-6);
    }
    error[k] = std::sqrt(error[k]);
  }
  EXPECT_LT(min_seen, 0.9) << "the ball is in the way";
  EXPECT_LT(error[0], 0.1);
  EXPECT_LT(error[1], 0.03);
  // Like directions^-3/4.
  EXPECT_LT(error[2], 0.5 * error[1]);
}

// In a hollow ball that is open at the top every place sees each other under the same share of its
// irradiance, f = the share of the ball that is there (the integrating sphere). So a constant light
// of 1 arrives from outside as 1 - f everywhere, and after b reflections as (1 - f) f^b.
TEST(RadianceTransfer, AnIntegratingSphereIsAGeometricSeries) {
  for (const double to : {0.5 * pi, 2.4}) {
    const double f = 0.5 * (1.0 - std::cos(to));
    MeshArrays bowl;
    add_ball(bowl, 40, {0, 0, 0}, 2.0, to, true);
    constexpr int bounces = 6;
    const RadianceTransfer t =
        transfer_of(to_mesh(bowl), {.order = 4, .directions = 1024, .bounces = bounces});
    for (int bounce = 0; bounce <= bounces; ++bounce) {
      double mean = 0.0;
      double worst = 0.0;
      int count = 0;
      const double expected = (1.0 - f) * std::pow(f, bounce);
      for (std::uint32_t v = 0; v < t.vertices; v += 3) {
        const double got = t.reflected(MeshSide::front, bounce, at_vertex(v))[0] * everywhere;
        mean += got;
        worst = std::max(worst, std::abs(got - expected));
        ++count;
        EXPECT_EQ(t.reflected(MeshSide::back, bounce, at_vertex(v))[0] > 0.0, bounce == 0);
      }
      mean /= count;
      // The rays' steps, and facets instead of the ball; of light from outside.
      EXPECT_NEAR(mean, expected, 0.002) << f << " " << bounce;
      EXPECT_LT(worst, 0.012) << f << " " << bounce;
    }

    // The furnace: with all that is reflected, a white bowl is as bright as the sky.
    Material white;
    white.reflectance = {1.0, 0.5, 0.25};
    const ShMaterial material(white, 4);
    const MeshPoint point = at_vertex(837);
    const glm::dvec3 n = glm::dvec3(bowl.normals[837]);
    const glm::dvec3 got =
        transferred(material, constant_light(4), t, MeshSide::front, point, n, n);
    for (int c = 0; c < 3; ++c) {
      const double rho = white.reflectance[c];
      const double full = rho * (1.0 - f) / (1.0 - rho * f);
      const double remainder = full * std::pow(rho * f, bounces + 1);
      EXPECT_NEAR(got[c], full - remainder, 0.012 * rho) << f;  // as of the light from outside
    }

    // A surface that is not diffuse gets the first reflection by eq. 23 and the others diffusely.
    Material glossy;
    glossy.type = Material::Type::phong;
    glossy.reflectance = glm::dvec3(0.3);
    glossy.specular = glm::dvec3(0.4);
    glossy.exponent = 3.0;
    const ShMaterial phong(glossy, 4);
    const double albedo = phong.albedo().x;
    EXPECT_NEAR(albedo, 0.7, 1e-4);
    const double first =
        phong.unshadowed(sh_product(constant_light(4), t.visibility(MeshSide::front, point)), n, n)
            .x;
    const double all = transferred(phong, constant_light(4), t, MeshSide::front, point, n, n).x;
    double others = 0.0;
    for (int b = 1; b <= bounces; ++b)
      others += (1.0 - f) * std::pow(f, b) * std::pow(albedo, b + 1);
    EXPECT_NEAR(all - first, others, 0.02);
  }
}

// The foot of a wall: its edge lies in the plane of the wall and must not see behind it.
TEST(RadianceTransfer, AFloorIsShadowedByTheWall) {
  MeshArrays mesh;
  const std::size_t floor = add_floor(mesh, 8, 1.0);
  add_patch(mesh, 8, [](double u, double v) {
    return MeshVertex{{-1.0, 200.0 * u - 100.0, 100.0 * v}, {1.0, 0.0, 0.0}};
  });
  const RadianceTransfer t = transfer_of(to_mesh(mesh), {.order = 3});
  for (std::uint32_t j = 0; j <= 8; ++j) {
    const auto v = static_cast<std::uint32_t>(floor) + j;
    ASSERT_EQ(mesh.points[v].x, -1.0f);
    const double seen = t.reflected(MeshSide::front, 0, at_vertex(v))[0] * everywhere;
    EXPECT_NEAR(seen, 0.5, 0.02);
  }
}

TEST(RadianceTransfer, RotatesWithTheObject) {
  const auto mesh = floor_and_ball(6);
  const glm::dquat q = glm::normalize(glm::dquat(0.5, 0.3, -0.7, 0.2));
  const TransferSettings settings{.order = 5, .directions = 1024, .bounces = 1};
  const RadianceTransfer t = transfer_of(mesh, settings);
  const RadianceTransfer of_turned = transfer_of(turned(*mesh, q), settings);
  double max_distance = 0.0;
  for (std::uint32_t v = 0; v < t.vertices; v += 11) {
    const auto compare = [&](const ShVector<double>& a, const ShVector<double>& b) {
      // Only the rays' azimuths differ.
      EXPECT_LT(distance(sh_rotate(a, q), b), 0.03);
      max_distance = std::max(max_distance, distance(a, b));
    };
    const MeshPoint point = at_vertex(v);
    compare(t.visibility(MeshSide::front, point), of_turned.visibility(MeshSide::front, point));
    compare(t.reflected(MeshSide::front, 0, point), of_turned.reflected(MeshSide::front, 0, point));
    compare(t.reflected(MeshSide::front, 1, point), of_turned.reflected(MeshSide::front, 1, point));
  }
  EXPECT_GT(max_distance, 0.2);
}

// A floor under a ball, turned, shrunk and moved, under a smooth sky: what eq. 23 and its case of
// diffuse materials make of it, against the reference.
TEST(RadianceTransfer, ShadowsASkyAsTheReferenceDoes) {
  auto sky = std::make_shared<RadianceMap>(RadianceMap{64, 32, {}});
  for (int i = 0; i < 64 * 32; ++i) {
    const glm::dvec3 d = map_direction(*sky, {i % 64 + 0.5, i / 64 + 0.5});
    const double lobe = std::exp(3.0 * (glm::dot(d, glm::normalize(glm::dvec3(1, 2, 0.5))) - 1.0));
    sky->pixels.emplace_back(glm::dvec3(lobe, 0.2 + 0.1 * d.x, 1.0));
  }
  Scene scene;
  scene.environment.emplace().map = sky;
  Surface surface;
  const auto mesh = floor_and_ball(6);
  const MeshArrays arrays = to_arrays(*mesh);
  surface.mesh = mesh;
  surface.rotate = glm::normalize(glm::dquat(0.8, -0.6, 0.2, 0.1));
  surface.translate = {3, -2, 1};
  surface.scale = 0.2;
  const Placement placement(surface);
  const ShVector<glm::dvec3> in_world = environment_sh(*scene.environment, 6);
  const ShVector<glm::dvec3> light = sh_rotate(in_world, glm::conjugate(surface.rotate));
  const RadianceTransfer t = transfer_of(mesh, {.order = 6, .directions = 1024});

  struct Row {
    Material::Type type;
    double error, unshadowed_error;  // relative rms, error a bound
  };
  for (const Row& row :
       {Row{Material::Type::diffuse, 0.006, 0.20}, Row{Material::Type::phong, 0.008, 0.18}}) {
    surface.material.type = row.type;
    surface.material.reflectance = {0.8, 0.5, 0.3};
    surface.material.specular = glm::dvec3(0.3);
    surface.material.exponent = 8.0;
    scene.surfaces = {surface};
    const RayCaster visibility(scene.surfaces);
    const ShMaterial material(surface.material, 6);
    double squares = 0.0;
    double error = 0.0;
    double unshadowed = 0.0;
    for (std::uint32_t v = 0; v < 49; v += 4) {
      const glm::dvec3 normal(arrays.normals[v]);
      const glm::dvec3 to_eye = glm::normalize(glm::dvec3(0.5, -0.6, 0.5));
      SurfacePoint point;
      point.position = placement.point_to_world(glm::dvec3(arrays.points[v]));
      point.normal = placement.normal_to_world(normal);
      point.to_eye = placement.normal_to_world(to_eye);
      point.shadow_origin = point.position + 1e-4 * point.normal;
      point.surface = &scene.surfaces[0];
      const glm::dvec3 reference =
          reflected_light(scene, visibility, point, {.samples = 40'000}).attenuated;
      const glm::dvec3 got =
          transferred(material, light, t, MeshSide::front, at_vertex(v), normal, to_eye);
      const glm::dvec3 without = material.unshadowed(light, normal, to_eye);
      squares += glm::dot(reference, reference);
      error += glm::dot(got - reference, got - reference);
      unshadowed += glm::dot(without - reference, without - reference);
    }
    EXPECT_LT(std::sqrt(error / squares), row.error);
    EXPECT_NEAR(std::sqrt(unshadowed / squares), row.unshadowed_error, 0.01);
  }
}

TEST(RadianceTransfer, WithoutNormalsIsThatOfTheTriangles) {
  MeshArrays mesh;
  add_floor(mesh, 3, 1.0);
  const std::size_t upper = add_floor(mesh, 3, 1.0);
  for (std::size_t i = upper; i < mesh.points.size(); ++i) mesh.points[i].z = 0.5f;
  const TransferSettings settings{.order = 3, .directions = 64, .bounces = 2};
  const RadianceTransfer with = transfer_of(to_mesh(mesh), settings);
  mesh.normals.assign(mesh.points.size(), glm::vec3(0.0f));
  const RadianceTransfer without = transfer_of(to_mesh(mesh), settings);
  for (const MeshSide side : {MeshSide::front, MeshSide::back}) {
    EXPECT_EQ(with.side(side).visibility, without.side(side).visibility);
    EXPECT_EQ(with.side(side).reflected, without.side(side).reflected);
  }
}

TEST(RadianceTransfer, IsIndependentOfThreads) {
  const auto mesh = floor_and_ball(6);
  const TransferSettings settings{.order = 3, .directions = 64, .bounces = 2};
  const RadianceTransfer many = transfer_of(mesh, settings);
  std::optional<RadianceTransfer> one;
  tbb::task_arena(1).execute([&] { one = radiance_transfer(mesh, settings); });
  for (const MeshSide side : {MeshSide::front, MeshSide::back}) {
    EXPECT_EQ(many.side(side).visibility, one->side(side).visibility);
    EXPECT_EQ(many.side(side).reflected, one->side(side).reflected);
  }
}

TEST(RadianceTransfer, ReportsProgressAndStops) {
  const auto mesh = floor_and_ball(40);
  const TransferSettings settings{.order = 2, .directions = 64, .bounces = 1};
  double last = 0.0;
  int calls = 0;
  const auto report = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    ++calls;
  };
  ASSERT_TRUE(radiance_transfer(mesh, settings, {{}, report}));
  EXPECT_EQ(last, 1.0);
  EXPECT_GT(calls, 100);

  std::stop_source source;
  std::atomic<int> after = 0;
  const auto stop = [&](double) {
    ++after;
    source.request_stop();
  };
  EXPECT_FALSE(radiance_transfer(mesh, settings, {source.get_token(), stop}));
  EXPECT_LE(after, static_cast<int>(std::thread::hardware_concurrency()));
  after = 0;
  EXPECT_FALSE(radiance_transfer(mesh, settings, {source.get_token(), stop}));
  EXPECT_EQ(after, 0);
}

}  // namespace
}  // namespace brume
