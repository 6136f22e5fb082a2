// Look-ups in a grid of the source function: what nodes hold, interpolated.

#include "render/scattering/source_lookup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "render/geometry/medium_index.h"
#include "render/scattering/node_visibility.h"
#include "render/scattering/source_view.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

// Isotropic, and with bands and clusters.
class SourceLookups : public testing::TestWithParam<int> {
 protected:
  SourceLookups() {
    for (const glm::dvec3& w : {glm::dvec3(0, 1, 0), glm::dvec3(0.6, 0, 0.8)}) {
      lights_.push_back({{w, {1.0, 2.0, 0.5}}, static_cast<int>(lights_.size()), 1.0});
    }
    const MediumIndex index(cloud(30, 3.0).medium, 1e-4, 0.0);
    // With fog there is a coarse level too.
    SourceGrid::Content content;
    content.bands = GetParam();
    content.fog_density = 0.1;
    grid_.emplace(index.gaussians(), lights_, content,
                  SourceGridSize{.nodes = 1000, .directions = 2}, Job{});
  }
  const SourceGrid::Level& level(int k) const {
    return grid_->levels()[static_cast<std::size_t>(k)];
  }
  static glm::dvec3 position(const SourceGrid::Level& level, const glm::ivec3& node) {
    return level.first + static_cast<double>(level.nodes.spacing) * glm::dvec3(node);
  }
  std::vector<float> values(const SourceGrid::Level& level, const glm::ivec3& node) const {
    const std::size_t size = SourceGrid::node_size(GetParam());
    const auto index = static_cast<std::size_t>(
        (node.z * level.nodes.count.y + node.y) * level.nodes.count.x + node.x);
    const auto begin = level.values.begin() + static_cast<std::ptrdiff_t>(size * index);
    return {begin, begin + static_cast<std::ptrdiff_t>(size)};
  }
  // What look-ups at these points with these weights sum.
  std::vector<float> sums(std::span<const glm::dvec3> points,
                          std::span<const float> weights) const {
    const SourceLookup lookup(*grid_, eye_, true);
    std::vector<glm::dvec3> directions;
    std::vector<double> lengths;
    for (const glm::dvec3& p : points) {
      lengths.push_back(glm::length(p - eye_));
      directions.push_back((p - eye_) / lengths.back());
    }
    PathBatch rays;
    rays.assign(directions, lengths);
    std::vector<float> padded_weights(weights.begin(), weights.end());
    padded_weights.resize(rays.padded_size(), 0.0f);
    std::vector<float> sums(rays.padded_size() * lookup.sums_size(), 0.0f);
    lookup.add(rays, rays.length.data(), padded_weights.data(), padded_weights.data(), sums.data());
    return sums;
  }

  const glm::dvec3 eye_{0.3, 0.2, 9.0};
  std::vector<SourceLight> lights_;
  std::optional<SourceGrid> grid_;
};

TEST_P(SourceLookups, AtNodesTheyAreWhatNodesHold) {
  const std::size_t size = SourceGrid::node_size(GetParam());
  const int last = static_cast<int>(grid_->levels().size()) - 1;
  ASSERT_GE(last, 2);
  for (int k = 0; k <= last; ++k) {
    // Near corners; those of coarse levels are outside the finer one.
    const glm::ivec3 low(k == last ? 0 : 1);
    const glm::ivec3 high = level(k).nodes.count - 1 - low;
    const std::vector<glm::ivec3> nodes{low, {high.x, low.y, low.z}, {low.x, high.y, high.z}, high};
    std::vector<glm::dvec3> points;
    std::vector<float> weights;
    for (const glm::ivec3& node : nodes) {
      points.push_back(position(level(k), node));
      weights.push_back(0.5f + static_cast<float>(weights.size()));
    }
    const std::vector<float> got = sums(points, weights);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const std::vector<float> expected = values(level(k), nodes[i]);
      for (std::size_t f = 0; f < size; ++f) {
        EXPECT_NEAR(got[i * size + f], weights[i] * expected[f], 2e-5f * weights[i])
            << "level " << k << ", node " << i << ", float " << f;
      }
    }
  }
}

TEST_P(SourceLookups, InCellsTheyAreLinearAlongEachAxis) {
  const std::size_t size = SourceGrid::node_size(GetParam());
  Random random(3);
  for (int axis = 0; axis < 3; ++axis) {
    const glm::ivec3 node = level(0).nodes.count / 2 - 1;
    glm::ivec3 next = node;
    ++next[axis];
    std::vector<double> places;
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 20; ++i) {
      places.push_back(random.uniform(0.0, 1.0));
      points.push_back(glm::mix(position(level(0), node), position(level(0), next), places.back()));
    }
    const std::vector<float> got = sums(points, std::vector<float>(points.size(), 1.0f));
    const std::vector<float> a = values(level(0), node);
    const std::vector<float> b = values(level(0), next);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t f = 0; f < size; ++f) {
        const double expected =
            glm::mix(static_cast<double>(a[f]), static_cast<double>(b[f]), places[i]);
        EXPECT_NEAR(got[i * size + f], expected, 2e-5) << "axis " << axis << ", float " << f;
      }
    }
  }
}

TEST_P(SourceLookups, RaysWithoutWeightAreLeftAlone) {
  const std::size_t size = SourceGrid::node_size(GetParam());
  const std::vector<glm::dvec3> points(20, glm::dvec3(0.0));
  std::vector<float> weights(20, 0.0f);
  weights[17] = 1.0f;
  const std::vector<float> got = sums(points, weights);
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (i / size == 17) continue;
    EXPECT_EQ(got[i], 0.0f) << i;
  }
  EXPECT_GT(got[17 * size], 0.0f);
}

INSTANTIATE_TEST_SUITE_P(Bands, SourceLookups, testing::Values(1, PhaseBands::max_bands),
                         testing::PrintToStringParamName());

// Against the sum of all that nodes hold, from afar and from within: near a sun's forward lobe it
// is off most.
TEST(SourceView, HoldsWhatNodesSumTo) {
  Scene scene = cloud(30, 3.0);
  scene.environment.emplace().map = sunny_sky();
  scene.environment->rotation = 40.0;
  SourceFunction function;
  ASSERT_TRUE(function.update(
      {&*scene.environment, scene.medium, 0.6, 0.0, {}, {}, {}, SourceGridSize{}, {}}, Job{}));
  for (const glm::dvec3& eye : {glm::dvec3(0.3, 0.2, 9.0), glm::dvec3(0.2, 0.1, 0.9)}) {
    std::vector<glm::dvec3> directions;
    std::vector<double> lengths;
    Random random(5);
    for (int i = 0; i < 64; ++i) {
      const glm::dvec3 q = random.point(1.0) - eye;
      lengths.push_back(glm::length(q));
      directions.push_back(q / lengths.back());
    }
    PathBatch rays;
    rays.assign(directions, lengths);
    const std::vector<float> weights(rays.padded_size(), 1.0f);
    const auto looked_up = [&](const SourceLookup& lookup) {
      std::vector<float> sums(rays.padded_size() * lookup.sums_size(), 0.0f);
      lookup.add(rays, rays.length.data(), weights.data(), weights.data(), sums.data());
      std::vector<glm::vec3> result;
      for (std::size_t i = 0; i < directions.size(); ++i) {
        result.push_back(
            lookup.source(std::span(sums).subspan(i * lookup.sums_size(), lookup.sums_size()),
                          function.weights(directions[i])));
      }
      return result;
    };
    SourceView view;
    view.update(function, CameraRays(Camera{.eye = eye}, Film{}), Job{});
    const std::vector<glm::vec3> got = looked_up(view.lookup(function));
    const std::vector<glm::vec3> expected = looked_up(function.from_eye(eye));
    float sum = 0.0f;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      sum += glm::length(got[i] - expected[i]) / glm::length(expected[i]);
      EXPECT_LT(glm::length(got[i] - expected[i]), 0.02f * glm::length(expected[i])) << i;
    }
    EXPECT_LT(sum, 0.002f * static_cast<float>(expected.size()));
  }
}

// A ball around the origin; no ray meets a vertex.
std::vector<Surface> solid_ball(double radius) {
  Surface surface;
  surface.mesh = ball_mesh(16);
  surface.scale = radius;
  surface.translate = {0.03, 0.02, 0.05};
  return {surface};
}

// Look-ups take no light from nodes in columns and pedestals.
TEST(GridOcclusion, NodesWithinSolidsAreEnclosed) {
  const GridNodes nodes{glm::ivec3(7), 1.0f};
  const auto enclosed = [&](double radius) {
    const std::vector<Surface> surfaces = solid_ball(radius);
    const RayCaster ray_caster(surfaces);
    const GridOcclusion occlusion(ray_caster, surfaces, {}, glm::dvec3(-3.0), nodes, Job{});
    return std::ranges::count_if(occlusion.hidden(), [](std::uint32_t bits) {
      return (bits & GridOcclusion::enclosed_bit) != 0;
    });
  };
  EXPECT_EQ(enclosed(0.4), 1);
  EXPECT_EQ(enclosed(1.3), 7);
  EXPECT_EQ(enclosed(1.9), 27);
  EXPECT_EQ(enclosed(3.4), 0);  // it reaches beyond the grid
}

// The grid of a cloud around surfaces.
SourceGrid grid_around(const std::vector<Surface>& surfaces, const Job& job = {}) {
  const RayCaster ray_caster(surfaces);
  LevelOcclusion occlusion;
  occlusion.set(ray_caster, surfaces);
  SourceGrid::Content content;
  content.surfaces = &occlusion;
  const MediumIndex index(cloud(30, 3.0).medium, 1e-4, 0.0);
  return {index.gaussians(), {}, content, SourceGridSize{.nodes = 8000}, job};
}

// But for an eye in there they are a room.
TEST(GridOcclusion, NodesAroundTheEyeAreNotEnclosed) {
  const SourceGrid grid = grid_around(solid_ball(1.5));
  constexpr std::uint32_t enclosed = GridOcclusion::enclosed_bit;
  EXPECT_EQ(NodeVisibility(grid, {0.1, 0.2, 0.0}).occlusion_bits,
            GridOcclusion::all_bits & ~enclosed);
  EXPECT_EQ(NodeVisibility(grid, {2.2, 0.0, 0.0}).occlusion_bits, GridOcclusion::all_bits);
  EXPECT_EQ(NodeVisibility(grid, {1e12, -1e12, 0.0}).occlusion_bits, GridOcclusion::all_bits);
}

// The occlusion of a level is missing then.
TEST(SourceGrid, IsMadeByAStoppedJob) {
  std::stop_source stop;
  stop.request_stop();
  Job job;
  job.stop = stop.get_token();
  const SourceGrid grid =
      grid_around({placed(Primitive::Shape::plane, {40.0, 1.0, 40.0}, {0.0, 0.0, 0.0})}, job);
  ASSERT_GT(grid.levels().size(), 1u);
  EXPECT_FALSE(grid.levels()[1].surfaces);
}

// Nodes on the eye's side of a floor count in the layer of cells that holds both.
TEST(NodeVisibility, IsOnTheEyesSideOfSurfacesInItsOwnLayer) {
  const SourceGrid grid =
      grid_around({placed(Primitive::Shape::plane, {40.0, 1.0, 40.0}, {0.0, 0.0, 0.0})});
  const SourceGrid::Level& level = grid.levels()[0];
  const double cell_side = static_cast<double>(level.nodes.spacing);
  const int floor_cell = static_cast<int>(std::floor(-level.first.y / cell_side));
  const double low = level.first.y + cell_side * floor_cell;  // the layer below the floor
  const auto seen_from = [&](double y) { return NodeVisibility(grid, {0.1, y, 0.2}).layers[0]; };
  for (const double above : {0.01, 0.9}) {
    const NodeVisibility::Layers layers = seen_from(above * (low + cell_side));
    EXPECT_EQ(layers.cell, glm::ivec3(-1, floor_cell, -1)) << above;
    EXPECT_EQ(layers.is_high.y, 1) << above;
  }
  EXPECT_EQ(seen_from(0.5 * low).cell.y, floor_cell);
  EXPECT_EQ(seen_from(0.5 * low).is_high.y, 0);
  EXPECT_EQ(seen_from(low + 1.5 * cell_side).cell, glm::ivec3(-1));
}

}  // namespace
}  // namespace brume
