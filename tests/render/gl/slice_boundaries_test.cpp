// Where slices begin and end: what is promised of them, on both backends.

#include "render/slices/slice_boundaries.h"
#include "core/scene/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/transport/optical_depth.h"
#include "render/cpu/film_slices.h"
#include "render/geometry/ray_range.h"
#include "render/gl/sliced_stage.h"
#include "tests/random.h"
#include "tests/render/gl/gl_frames.h"

namespace brume::gl {
namespace {

// A film of several tiles, the last ones not whole.
constexpr Film whole_film{90, 50};
constexpr int scale = 2;

struct Case {
  std::string name;
  Medium medium;
  std::vector<SlicedLight> lights;
  int slices = 24;
  double end = std::numeric_limits<double>::infinity();  // of all rays
  // Where it is about a single ray: the camera looks along -z from here.
  glm::dvec3 eye{0.0, 0.0, 5.0};
  FogBall fog{};
};

Case with(std::string name, std::initializer_list<Gaussian> gaussians, double b0 = 0.0) {
  Case result;
  result.name = std::move(name);
  for (const Gaussian& g : gaussians) result.medium.append(g);
  result.medium.set_homogeneous_density(b0);
  return result;
}

Case small_cloud(unsigned seed, double density) {
  Random random(seed);
  Case result;
  result.name = "cloud " + std::to_string(seed) + " of density " + std::to_string(density);
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 center = random.point(1.5);
    const double radius = random.power(-1.5, 0.0);
    result.medium.append({center, radius, density * random.power(-1.0, 0.0)});
  }
  return result;
}

SlicedLight light_at(const glm::dvec3& position) {
  SlicedLight light;
  light.position = position;
  light.intensity = glm::dvec3(1.0);
  light.h_min = 1e-3;
  return light;
}

// These are hard on careless arithmetic.
std::vector<Case> hard_cases() {
  std::vector<Case> cases;
  cases.push_back(with("empty", {}));
  cases.push_back(with("one", {{{0, 0, 0}, 1.0, 0.5}}));
  cases.push_back(with("eye inside", {{{0, 0, 4.9}, 1.0, 0.5}}));
  cases.push_back(with("behind the eye", {{{0, 0, 9.0}, 1.0, 0.5}}));
  cases.push_back(with("opaque", {{{0, 0, 0}, 1.0, 1e6}}));
  cases.push_back(with("opaque before thin", {{{0, 0, 2}, 0.3, 1e5}, {{0, 0, -3}, 1.0, 0.1}}));
  cases.push_back(with("radius 1e-12", {{{0, 0, 0}, 1e-12, 1e12}}));
  cases.push_back(with("radius 1e12", {{{0, 0, 0}, 1e12, 1e-12}}));
  cases.push_back(with("both", {{{0, 0, 0}, 1e-12, 1e12}, {{0, 0, 0}, 1e12, 1e-12}}));
  cases.push_back(with("thin", {{{0, 0, 0}, 1.0, 1e-9}}));
  Case many = with("thousands at one point", {});
  for (int i = 0; i < 3000; ++i) many.medium.append({{0, 0, 0}, 0.5, 1e-3});
  cases.push_back(many);
  cases.push_back(with("fog", {}, 0.1));
  cases.push_back(with("thin fog", {}, 1e-9));
  cases.push_back(with("opaque fog", {}, 1e6));
  for (unsigned seed = 1; seed <= 3; ++seed) {
    cases.push_back(small_cloud(seed, 1.0));
    cases.push_back(small_cloud(seed, 100.0));
    cases.push_back(small_cloud(seed, 1.0));
    cases.back().end = 5.0;
    cases.push_back(small_cloud(seed, 1.0));
    cases.back().medium.set_homogeneous_density(0.05);
    cases.back().lights = {light_at({0.1, 0.2, 0.3}), light_at({0, 0, 2}), light_at({50, 0, 0})};
    cases.push_back(cases.back());
    cases.back().slices = 5;
  }
  for (const double b0 : {0.1, 100.0}) {
    for (const glm::dvec3& center : {glm::dvec3(0), {0.3, 0, 4.8}, {0, 0, 6.1}, {1.2, 0.4, 1}}) {
      Case ball = small_cloud(5, 1.0);
      ball.medium.set_homogeneous_density(b0);
      ball.fog = {center, 1.0};
      ball.lights = {light_at({0.1, 0.2, 0.3})};
      ball.name = "ball of density " + std::to_string(b0) + " at " + std::to_string(center.z);
      cases.push_back(ball);
      ball.medium = {};
      ball.medium.set_homogeneous_density(b0);
      ball.name += ", alone";
      cases.push_back(ball);
    }
  }
  Case lights = small_cloud(4, 1.0);
  Random random(9);
  for (int i = 0; i < 40; ++i) lights.lights.push_back(light_at(random.point(1.0)));
  lights.slices = 100;
  cases.push_back(lights);
  return cases;
}

// The choice of a backend.
struct Slices {
  int columns = 0, rows = 0;  // of tiles
  std::vector<std::vector<float>> tiles;
  // 2 columns + 1 per row, padded to one length; empty where there is no medium.
  std::vector<std::vector<float>> nodes;
};

CameraRays rays_of(const Case& c) {
  Camera camera;
  camera.eye = c.eye;
  camera.target = c.eye - glm::dvec3(0, 0, 1);
  return {camera, whole_film};
}

Frame frame_of(const Case& c) {
  Frame frame;
  frame.film = whole_film;
  frame.depth.assign(static_cast<std::size_t>(whole_film.width * whole_film.height),
                     static_cast<float>(c.end));
  return frame;
}

FilmWindow window() {
  Settings settings;
  settings.airlight_scale = scale;
  return {whole_film, settings};
}

MediumIndex index_of(const Case& c) {
  MediumIndex index(c.medium, 1e-6);
  index.set_fog(c.fog);
  return index;
}

TileCone cone_of(const Case& c, std::size_t tile) {
  const Frame frame = frame_of(c);
  const CameraRays rays = rays_of(c);
  const Tiles tiles(sample_film(whole_film, scale));
  const Tiles::Lists lists;
  const RayEnds ends;
  return FilmTiles{tiles, lists, rays, ends, frame, window(), scale}.cone(tile);
}

Slices choose_on_cpu(const Case& c) {
  const MediumIndex medium = index_of(c);
  const Frame frame = frame_of(c);
  const CameraRays rays = rays_of(c);
  const Tiles tiles(sample_film(whole_film, scale));
  const Tiles::Lists lists = tiles.lists(medium, rays, scale);
  const RayEnds ends;
  const FilmWindow whole = window();
  const FilmTiles film_tiles{tiles, lists, rays, ends, frame, whole, scale};
  FilmSlices chosen;
  chosen.choose(film_tiles, medium, c.lights, c.slices, {});
  Slices slices{tiles.columns(), tiles.rows(), {}, {}};
  slices.nodes.resize(static_cast<std::size_t>((2 * slices.columns + 1) * (2 * slices.rows + 1)));
  const std::size_t stride =
      max_boundaries(c.slices, c.lights.size(), medium.homogeneous_density() > 0.0);
  for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
    const SliceNodes nodes = chosen.nodes(tile);
    const float* const own = nodes.count > 0 ? nodes.boundaries[4] : nullptr;
    // The node in the middle is the tile's alone: padded by its last boundary.
    std::size_t count = own ? stride : 0;
    while (count > 1 && own[count - 2] == own[count - 1]) --count;
    slices.tiles.emplace_back(own, own + count);
    for (std::size_t k = 0; own && k < 9; ++k) {
      const std::size_t column = 2 * (tile % static_cast<std::size_t>(slices.columns)) + k % 3;
      const std::size_t row = 2 * (tile / static_cast<std::size_t>(slices.columns)) + k / 3;
      slices.nodes[row * static_cast<std::size_t>(2 * slices.columns + 1) + column].assign(
          nodes.boundaries[k], nodes.boundaries[k] + stride);
    }
  }
  return slices;
}

// Objects of a context, which it must outlive.
struct DeviceState {
  Programs programs;
  DeviceClock clock;
  MediumBuffers medium;
  TileLists lists;
  OpticalDepthTables lights;
  FilmTextures textures;
  SliceTexture slices;
};

Slices choose_on_device(DeviceState& device, const Case& c) {
  const MediumIndex medium = index_of(c);
  const CameraRays rays = rays_of(c);
  std::vector<float> depths = frame_of(c).depth;
  // Shaders know no infinity.
  for (float& depth : depths) depth = std::isfinite(depth) ? depth : -1.0f;
  device.textures.reserve(whole_film);
  device.textures.depth.upload(std::span<const float>(depths));
  device.medium.update(medium);
  device.lists.build(device.programs, device.medium, medium, rays, whole_film, scale, 1 << 28);
  device.lights.upload(c.lights, nullptr, rays.eye());
  Settings settings;
  settings.airlight_scale = scale;
  const RenderPlan plan(Scene(), whole_film, settings);
  const FilmView view{whole_film,
                      rays,
                      std::numeric_limits<double>::infinity(),
                      BatchFog(medium, rays.eye()),
                      plan,
                      std::nullopt};
  device.slices.choose(device.programs, device.clock, device.lights, c.lights.size(), c.slices,
                       device.lists, view, device.textures);
  const glm::ivec2 tiles = device.lists.tiles();
  return {tiles.x, tiles.y, device.slices.download_tiles(), device.slices.download_nodes()};
}

class SliceBoundaries : public BothBackends<DeviceState>,
                        public testing::WithParamInterface<TestedBackend> {
 protected:
  Slices choose(const Case& c) {
    return GetParam() == TestedBackend::cpu ? choose_on_cpu(c) : choose_on_device(device(), c);
  }
};

TEST_P(SliceBoundaries, AscendWithinTheRay) {
  for (const Case& c : hard_cases()) {
    SCOPED_TRACE(c.name);
    const double b0 = c.medium.homogeneous_density();
    for (const std::vector<float>& tile : choose(c).tiles) {
      if (tile.empty()) continue;
      EXPECT_GE(tile.size(), 2U);
      EXPECT_LE(tile.size(), max_boundaries(c.slices, c.lights.size(), b0 > 0.0));
      EXPECT_GE(tile.front(), 0.0f);
      EXPECT_LE(tile.back(), std::min(c.end, endless));
      for (std::size_t k = 0; k + 1 < tile.size(); ++k) ASSERT_LT(tile[k], tile[k + 1]) << k;
    }
  }
}

TEST_P(SliceBoundaries, CoverTheMedium) {
  for (const Case& c : hard_cases()) {
    SCOPED_TRACE(c.name);
    const MediumIndex medium = index_of(c);
    const Slices slices = choose(c);
    const double b0 = medium.homogeneous_density();
    for (std::size_t i = 0; i < slices.tiles.size(); ++i) {
      const TileCone cone = cone_of(c, i);
      const std::vector<float>& tile = slices.tiles[i];
      const FogInterval fog = c.fog.interval(cone.eye, cone.center);
      if (b0 > 0.0 && fog.begin < std::min(fog.end, c.end)) {
        ASSERT_FALSE(tile.empty());
        EXPECT_LE(tile.front(), fog.begin * (1.0 + 1e-6));
        // All of it that is not hidden by the fog itself.
        EXPECT_GE(tile.back(),
                  std::min({c.end, fog.end, fog.begin + opaque_fog_depth / b0}) * (1.0 - 1e-6));
      }
      // The part of the central ray within the core of each Gaussian. Single precision misses the
      // ends by roundings of the distance and of what is far away.
      for (std::size_t k = 0; k < medium.size(); ++k) {
        const GaussianTerm<double>& g = medium.gaussians()[k];
        const double t = glm::dot(g.b - cone.eye, cone.center);
        const double h = glm::length(g.b - cone.eye - t * cone.center);
        const double r = medium.cutoff_radii()[k];
        const double half = 0.9 * std::sqrt(std::max(r * r - h * h, 0.0));
        const double begin = std::clamp(t - half, 0.0, c.end);
        const double end = std::clamp(t + half, 0.0, c.end);
        const double rounding = 1e-6 * (std::abs(t) + r);
        if (end - begin <= rounding) continue;
        ASSERT_FALSE(tile.empty());
        EXPECT_LE(tile.front(), begin + rounding);
        if (b0 > 0.0) continue;
        EXPECT_GE(tile.back(), std::min(end, endless) - rounding);
      }
    }
  }
}

// Without fog and lights: slices of the core, and the two of the tails.
TEST_P(SliceBoundaries, AreAsManyAsAskedFor) {
  for (const int slices : {4, 12, 24, 100, 256}) {
    for (Case c : {with("one", {{{0, 0, 0}, 1.0, 0.5}}), small_cloud(1, 1.0)}) {
      SCOPED_TRACE(c.name + " in " + std::to_string(slices));
      c.slices = slices;
      const Slices chosen = choose(c);
      const std::vector<float>& tile = chosen.tiles[static_cast<std::size_t>(
          chosen.rows / 2 * chosen.columns + chosen.columns / 2)];
      EXPECT_EQ(tile.size(), static_cast<std::size_t>(slices + 1));
    }
  }
}

// Optical depth of a medium on the central ray of a tile, between two distances.
double depth_between(const MediumIndex& medium, const TileCone& cone, double t0, double t1) {
  double sum = 0.0;
  for (const GaussianTerm<double>& g : medium.gaussians()) {
    const glm::dvec3 from = cone.eye + t0 * cone.center;
    sum += optical_depth(g, line_profile(g, from, cone.center), t1 - t0);
  }
  return sum;
}

// A box of three radii holds the Gaussian, so a slice has at most 3 / sqrt(pi) / slices of it; a
// third of the slices are spread out evenly over four radii. 2.5 is what that makes, with the
// roughness of four bins per slice.
TEST_P(SliceBoundaries, ShareTheDepthOfAGaussianEvenly) {
  for (const double radius : {1e-3, 0.1, 0.7}) {
    for (const int slices : {12, 24, 100}) {
      Case c = with("one", {{{0, 0, 0}, radius, 0.3 / radius}});
      c.slices = slices;
      SCOPED_TRACE(std::to_string(radius) + " in " + std::to_string(slices));
      const MediumIndex medium = index_of(c);
      const Slices chosen = choose(c);
      for (std::size_t i = 0; i < chosen.tiles.size(); ++i) {
        const std::vector<float>& tile = chosen.tiles[i];
        if (tile.empty()) continue;
        const TileCone cone = cone_of(c, i);
        const double whole = depth_between(medium, cone, 0.0, 100.0);
        if (whole < 1e-3) continue;
        for (std::size_t k = 0; k + 1 < tile.size(); ++k) {
          const double share = depth_between(medium, cone, static_cast<double>(tile[k]),
                                             static_cast<double>(tile[k + 1])) /
                               whole;
          EXPECT_LT(share, 2.5 / slices) << k;
        }
      }
    }
  }
}

// An opaque Gaussian shows its front alone, a few of its slices deep.
TEST_P(SliceBoundaries, LieWhereAnOpaqueGaussianIsVisible) {
  for (const double density : {1e3, 1e6}) {
    Case c = with("opaque", {{{0, 0, 0}, 1.0, density}});
    SCOPED_TRACE(density);
    const MediumIndex medium = index_of(c);
    const Slices chosen = choose(c);
    const std::size_t center =
        static_cast<std::size_t>(chosen.rows / 2 * chosen.columns + chosen.columns / 2);
    const TileCone cone = cone_of(c, center);
    int visible = 0;
    double widest = 0.0;  // of optical depths within what is visible
    for (std::size_t k = 1; k + 1 < chosen.tiles[center].size(); ++k) {
      const double t = chosen.tiles[center][k];
      const double before = depth_between(medium, cone, 0.0, t);
      if (before < 0.01 || before > 5.0) continue;
      ++visible;
      widest = std::max(
          widest, depth_between(medium, cone, t, static_cast<double>(chosen.tiles[center][k + 1])));
    }
    EXPECT_GE(visible, 3);
    EXPECT_LT(widest, 20.0);
  }
}

// Between tiles nothing changes at once: a node has the boundaries of all tiles around it, merged,
// and beyond its own number repeats the last, so that rays on both sides of a border meet there.
TEST_P(SliceBoundaries, MergeAtNodes) {
  for (const Case& c : hard_cases()) {
    SCOPED_TRACE(c.name);
    const Slices slices = choose(c);
    for (int row = 0; row <= 2 * slices.rows; ++row) {
      for (int column = 0; column <= 2 * slices.columns; ++column) {
        std::vector<std::span<const float>> around;
        for (int y = std::max(row - 1, 0) / 2; y <= std::min(row / 2, slices.rows - 1); ++y) {
          for (int x = std::max(column - 1, 0) / 2; x <= std::min(column / 2, slices.columns - 1);
               ++x) {
            const auto& tile = slices.tiles[static_cast<std::size_t>(y * slices.columns + x)];
            if (!tile.empty()) around.emplace_back(tile);
          }
        }
        const auto& node =
            slices.nodes[static_cast<std::size_t>(row * (2 * slices.columns + 1) + column)];
        ASSERT_EQ(node.empty(), around.empty());
        if (node.empty()) continue;
        std::vector<float> merged(4 * max_slice_boundaries);
        const std::size_t count = merge_slices(around, merged.data());
        ASSERT_LE(count, node.size());
        float last = 0.0f;
        for (std::size_t k = 0; k < node.size(); ++k) {
          // Sums of four, in another order.
          const float expected = merged[std::min(k, count - 1)];
          ASSERT_NEAR(node[k], expected, 1e-6f * expected) << k;
          ASSERT_GE(node[k], last * (1.0f - 1e-6f)) << k;
          last = node[k];
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, SliceBoundaries,
                         testing::Values(TestedBackend::cpu, TestedBackend::device),
                         [](const auto& backend) {
                           return backend.param == TestedBackend::cpu ? "Cpu" : "Device";
                         });

}  // namespace
}  // namespace brume::gl
