// The light that arrives at surfaces: what nodes of a grid hold, interpolated, and what diffuse
// surfaces make of it.

#include "render/scattering/incident_lookup.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

#include "render/geometry/medium_index.h"
#include "render/scattering/environment_light.h"
#include "render/scattering/source_function.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

class IncidentLookups : public testing::Test {
 protected:
  IncidentLookups() {
    Scene scene = cloud(30, 3.0);
    scene.environment.emplace().map = gradient_sky();
    environment_ = *scene.environment;
    const SourceGrid::Receivers receivers{{glm::dvec3(-1.0), glm::dvec3(1.0)}, {}};
    function_.update({&*scene.environment,
                      scene.medium,
                      0.0,
                      0.0,
                      {},
                      {},
                      receivers,
                      SourceGridSize{.nodes = 1000},
                      {}},
                     Job{});
  }
  const SourceGrid& grid() const { return function_.grid(); }
  SurfacePoints points_at(const std::vector<glm::dvec3>& places) const {
    SurfacePoints points{};
    points.origin = origin_;
    points.count = places.size();
    Random random(3);
    for (std::size_t k = 0; k < points.padded_size(); ++k) {
      points.position.set(k, glm::vec3(places[std::min(k, places.size() - 1)] - origin_));
      points.normal.set(k, glm::vec3(glm::normalize(random.point(1.0))));
    }
    return points;
  }

  const glm::dvec3 origin_{0.3, 0.2, 9.0};
  Environment environment_;
  SourceFunction function_;
};

TEST_F(IncidentLookups, AtNodesTheyAreWhatNodesHold) {
  const SourceGrid::Level& level = grid().levels()[0];
  std::vector<glm::dvec3> places;
  std::vector<std::size_t> nodes;
  for (std::size_t node = 7; node < level.nodes.size() && places.size() < 50; node += 17) {
    nodes.push_back(node);
    places.push_back(level.first + static_cast<double>(level.nodes.spacing) *
                                       glm::dvec3(node_coordinates(level.nodes, node)));
  }
  std::vector<NodeRadiance> light(places.size());
  IncidentLookup(grid(), origin_).incident(points_at(places), light);
  for (std::size_t k = 0; k < light.size(); ++k) {
    for (std::size_t i = 0; i < light[k].size(); ++i) {
      EXPECT_NEAR(light[k][i], level.incident[nodes[k] * light[k].size() + i], 1e-4f)
          << "node " << nodes[k] << ", float " << i;
    }
  }
}

TEST_F(IncidentLookups, DiffuseSurfacesAreThoseOfDoublePrecision) {
  const EnvironmentLight environment(environment_, ScatterTable::distant());
  Random random(8);
  std::vector<glm::dvec3> places;
  for (int i = 0; i < 50; ++i) places.push_back(random.point(1.5));  // some beyond the grid
  const SurfacePoints points = points_at(places);
  const IncidentLookup lookup(grid(), origin_);
  std::vector<NodeRadiance> light(places.size());
  lookup.incident(points, light);
  for (const EnvironmentLight* sky :
       {static_cast<const EnvironmentLight*>(nullptr), &environment}) {
    PointRadiance sent;
    lookup.diffuse(points, diffuse_factors(0.7, sky), sent);
    for (std::size_t k = 0; k < light.size(); ++k) {
      const glm::vec3 expected = diffuse_light(points.normal[k], light[k], 0.7, sky);
      const glm::vec3 got(sent.r[k], sent.g[k], sent.b[k]);
      EXPECT_LT(glm::length(got - expected), 1e-5f * glm::length(expected) + 1e-6f) << k;
    }
  }
}

}  // namespace
}  // namespace brume
