// Ellipsoidal Gaussians, as every method sees them.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/sphere_rule.h"
#include "core/transport/average_depth.h"
#include "render/geometry/medium_index.h"
#include "render/geometry/tiles.h"
#include "render/grid/density_samples.h"
#include "render/paths/path_medium.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"
#include "tests/render/traced_truth.h"

namespace brume {
namespace {

// Ellipsoids that differ from balls by nothing that is seen, of code that only ellipsoids run.
Scene as_ellipsoids(Scene scene) {
  const Medium balls = scene.medium;
  const double b0 = balls.homogeneous_density();
  scene.medium = {};
  scene.medium.set_homogeneous_density(b0);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    Gaussian g = balls.gaussian(i);
    g.set_radii(g.radius * glm::dvec3(1.0, 1.0 - 1e-9, 1.0),
                glm::normalize(glm::dquat(0.3, 0.5, -0.2, 0.7)));
    scene.medium.append(g);
  }
  return scene;
}

void expect_same(const Scene& balls, const Settings& settings, const char* what, double bound) {
  const Frame expected = render_frame(balls, settings);
  const Frame frame = render_frame(as_ellipsoids(balls), settings);
  EXPECT_LT(rel_rmse(frame.airlight, expected.airlight), bound) << what;
  EXPECT_LT(rel_rmse(frame.beauty, expected.beauty), bound) << what;
}

TEST(Ellipsoids, ThatAreBallsRenderAsBalls) {
  Scene scene = on_film(in_fog(cloud_scene(20, 2.0), 0.03), {16, 12});
  scene.optics.anisotropy = 0.4;
  scene.surfaces.push_back(wall(-0.6, 1.2));
  expect_same(scene, brume::reference_settings(1e-4), "reference", 1e-6);
  expect_same(scene, paper_settings, "paper", 1e-5);
  // Slices begin and end a little elsewhere.
  expect_same(scene, sliced(24), "sliced", 1e-3);
  // And so do the nodes of a grid, whose boxes are rounded outwards.
  expect_same(scene, all_orders(24), "all orders", 3e-3);
  scene.optics.noise = {.amplitude = 0.4, .frequency = 2.0};
  expect_same(scene, sliced(24), "with noise", 1e-3);
  expect_same(scene, paper_settings, "paper with noise", 1e-5);
  scene.environment = even_sky(0.3f);
  expect_same(scene, paper_settings, "paper below a sky", 1e-3);
  expect_same(scene, sliced(24), "below a sky", 1e-3);
}

TEST(Ellipsoids, SlicedIsTheReference) {
  for (unsigned seed = 1; seed <= random_cases(6); ++seed) {
    Scene scene = on_film(ellipsoid_scene(30, 2.0, 12.0, seed), {24, 24});
    const Frame reference = render_frame(scene, brume::reference_settings(1e-5));
    const Frame frame = render_frame(scene, sliced(32));
    EXPECT_LT(rel_rmse(frame.airlight, reference.airlight), 0.01) << seed;
    const Frame finer = render_frame(scene, sliced(128));
    EXPECT_LT(rel_rmse(finer.airlight, reference.airlight), 0.004) << seed;
  }
}

// The light of every order, in media and on surfaces.
TEST(Ellipsoids, AllOrdersMatchPaths) {
  Scene scene = ellipsoid_scene(24, 2.5, 8.0);
  expect_all_orders_match_paths(scene, "ellipsoids");
  scene.surfaces.push_back(wall(-0.5, 1.2));
  expect_all_orders_match_paths(scene, "ellipsoids before a wall");
}

TEST(Ellipsoids, HardCasesAreFinite) {
  Scene scene = on_film(ellipsoid_scene(16, 3.0, 10000.0, 5), {8, 6});
  scene.camera.eye = scene.medium.centers()[0];
  scene.lights[0].position = scene.medium.centers()[2];
  scene.surfaces.push_back(wall(-0.2, 0.8));
  for (const Settings& settings :
       {sliced(12), all_orders(12, {.nodes = 1000, .directions = 32}), paper_settings,
        path_traced(2), brume::reference_settings(1e-2)}) {
    expect_finite(render_frame(scene, settings));
  }
}

TEST(Ellipsoids, AverageDepthInSinglePrecision) {
  Random random(9);
  for (const double stretch : {1e-1, 1e-2, 1e-3, 1e-4}) {
    for (const glm::dvec3& radii :
         {glm::dvec3(1.0, stretch, stretch), glm::dvec3(1.0, 1.0, stretch)}) {
      for (const double distance : {0.0, 0.3, 1.0, 5.0, 100.0}) {
        Gaussian g{random.point(0.5), 1.0, 1.3};
        const glm::dvec3 q = random.point(1.0);
        g.set_radii(radii, glm::dquat(random.uniform(-1.0, 1.0), q.x, q.y, q.z));
        GaussianTerms<float> terms;
        terms.add(g);
        const glm::vec3 p(g.center + distance * random.point(1.0));
        const StandaloneTerm term(g);
        const double exact = average_depth(*term, glm::dvec3(p));
        EXPECT_NEAR(average_depth(terms[0], p), exact, 1e-5 * exact) << stretch << ' ' << distance;
      }
    }
  }
}

TEST(Ellipsoids, AverageDepthIsThatOverAllDirections) {
  Random random(4);
  for (int n = 0; n < 20; ++n) {
    Gaussian g{random.point(0.5), 1.0, 1.3};
    const glm::dvec3 q = random.point(1.0);
    g.set_radii({random.uniform(0.4, 1.0), random.uniform(0.4, 1.0), random.uniform(0.4, 1.0)},
                glm::normalize(glm::dquat(random.uniform(-1.0, 1.0), q.x, q.y, q.z)));
    const glm::dvec3 p = random.point(2.0);
    const StandaloneTerm term(g);
    double mean = 0.0;
    for (const SphereNode& node : sphere_rule(120)) {
      mean += node.weight / (4 * std::numbers::pi) *
              optical_depth(*term, line_profile(*term, p, node.direction),
                            std::numeric_limits<double>::infinity());
    }
    EXPECT_NEAR(average_depth(*term, p), mean, 1e-11 * mean);
    GaussianTerms<float> terms;
    terms.add(g);
    EXPECT_NEAR(average_depth(terms[0], glm::vec3(p)), mean, 1e-5 * mean);
  }
}

// It is the closed form of a ball.
TEST(Ellipsoids, AverageDepthOfOneThatIsABall) {
  for (const double u : {0.0, 0.1, 1.0, 3.0, 10.0, 100.0}) {
    Gaussian g{{0, 0, 0}, 0.7, 2.0};
    const double ball = average_depth(*StandaloneTerm(g), {0.7 * u, 0, 0});
    g.set_radii(g.radius * glm::dvec3(1.0, 1.0 - 1e-14, 1.0), g.shape.rotation);
    EXPECT_NEAR(average_depth(*StandaloneTerm(g), {0.7 * u, 0, 0}), ball, 1e-12 * ball) << u;
  }
}

TEST(Ellipsoids, TilesListAllThatTheirRaysMeet) {
  Scene scene = ellipsoid_scene(60, 2.0, 50.0, 3);
  scene.camera.eye = {0.4, 0.3, 3.3};
  const Film film{160, 120};
  const CullingTolerance tolerance = culling_tolerance(scene.medium, 1e-3);
  const MediumIndex medium(scene.medium, tolerance);
  const CameraRays rays(scene.camera, film);
  const Tiles tiles(film);
  const Tiles::Lists lists = tiles.lists(medium, rays);
  std::size_t listed = 0;
  for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
    const auto list = lists.gaussians_of(tile);
    listed += list.size();
    const CameraRays::PixelRectangle r = tiles.rectangle(tile);
    for (std::uint32_t i = 0; i < medium.size(); ++i) {
      if (std::ranges::binary_search(list, i)) continue;
      const GaussianTerm<double>& g = medium.gaussians()[i];
      const double cutoff = g.a * medium.cutoff_radii()[i];
      for (int y = r.y0; y < r.y1; y += 3) {
        for (int x = r.x0; x < r.x1; x += 3) {
          const glm::dvec3 w = rays.direction(x + 0.5, y + 0.5);
          const LineProfile<double> line = line_profile(g, rays.eye(), w);
          const double seen = optical_depth(g, line, std::numeric_limits<double>::infinity());
          ASSERT_TRUE(line.e > 0.999 * cutoff * cutoff || seen < medium.tolerance())
              << "Gaussian " << i << " at " << x << ' ' << y;
        }
      }
    }
  }
  // The balls around them are in many more.
  Medium balls;
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    Gaussian ball = scene.medium.gaussian(i);
    ball.shape = {};
    balls.append(ball);
  }
  const MediumIndex around(balls, tolerance);
  EXPECT_LT(listed, 0.9 * static_cast<double>(tiles.lists(around, rays).gaussians.size()));
}

TEST(Ellipsoids, DensityOnAGridIsTheirDensity) {
  const Scene scene = ellipsoid_scene(30, 2.0, 6.0);
  const GridNodes nodes{glm::ivec3(24), 0.1f};
  const glm::dvec3 first(-1.15);
  GaussianTerms<double> terms;
  GaussianTerms<double> widened;  // thin ones, to the spacing
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    Gaussian g = scene.medium.gaussian(i);
    terms.add(g);
    const glm::dvec3 radii = g.radii();
    const glm::dvec3 wide = glm::max(radii, 0.1);
    g.density *= radii.x * radii.y * radii.z / (wide.x * wide.y * wide.z);
    g.set_radii(wide, g.shape.rotation);
    widened.add(g);
  }
  const std::vector<float> density = density_on_grid(terms.all(), first, nodes, {});
  double largest = 0.0;
  for (int z = 0; z < 24; z += 2) {
    for (int y = 0; y < 24; y += 2) {
      for (int x = 0; x < 24; x += 2) {
        const glm::dvec3 p = first + 0.1 * glm::dvec3(x, y, z);
        double sum = 0.0;
        for (const GaussianTerm<double>& g : widened.all()) {
          const glm::dvec3 q = g.scaled(p);
          sum += g.c * std::exp(-glm::dot(q, q));
        }
        largest = std::max(largest, sum);
        const double got = density[static_cast<std::size_t>((z * 24 + y) * 24 + x)];
        EXPECT_NEAR(got, sum, 2e-3) << x << ' ' << y << ' ' << z;
      }
    }
  }
  EXPECT_GT(largest, 0.3);
}

TEST(Ellipsoids, PathsMeetTheirDensity) {
  const Scene scene = ellipsoid_scene(40, 2.0, 30.0, 2);
  const MediumIndex index(scene.medium, culling_tolerance(scene.medium, 1e-8));
  const PathMedium medium(index);
  Random random(8);
  for (int n = 0; n < 200; ++n) {
    const glm::dvec3 x = random.point(1.2);
    EXPECT_NEAR(medium.density(x), index.density(x), 1e-6);
    const glm::dvec3 w = glm::normalize(random.point(1.0));
    const double length = random.uniform(0.1, 4.0);
    double exact = 0.0;
    for (const GaussianTerm<double>& g : index.gaussians()) {
      exact += optical_depth(g, line_profile(g, x, w), length);
    }
    EXPECT_NEAR(medium.depth(x, w, length), exact, 1e-6);
    // No cell is denser than its majorant.
    MajorantGrid::Walk walk(medium.grid(), x, w, length);
    for (; walk.in_cell(); walk.next()) {
      const double t = 0.5 * (walk.enter() + walk.exit());
      EXPECT_LE(medium.density(x + t * w), walk.majorant() * (1.0 + 1e-12));
    }
  }
}

}  // namespace
}  // namespace brume
