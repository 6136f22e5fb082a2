// Increments of slices and their moments against the double formulas, for every instruction set.

#include "render/optical_depth/increment_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/transport/optical_depth.h"
#include "tests/random.h"
#include "tests/render/for_each_target.h"

namespace brume {
namespace {

constexpr double culled = 1e-5;  // optical depth

// A bundle of rays, some of which end at a surface, and boundaries that differ from ray to ray.
struct Bundle {
  glm::dvec3 eye{0.0, 0.0, -4.0};
  std::vector<glm::dvec3> directions;
  std::vector<double> lengths;
  std::vector<glm::vec2> positions;
  std::vector<std::vector<float>> nodes;
  PathBatch rays;
  RaySlices slices;

  Bundle(Random& random, std::size_t count, double width, std::size_t boundaries) {
    for (std::size_t i = 0; i < count; ++i) {
      positions.emplace_back(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0));
      const glm::dvec2 offset = width * (glm::dvec2(positions.back()) - 0.5);
      directions.push_back(glm::normalize(glm::dvec3(offset, 1.0)));
      lengths.push_back(i % 3 == 0 ? random.uniform(2.0, 7.0)
                                   : std::numeric_limits<double>::infinity());
    }
    SliceNodes at;
    at.count = boundaries;
    for (std::size_t node = 0; node < at.boundaries.size(); ++node) {
      std::vector<float>& values = nodes.emplace_back();
      for (std::size_t k = 0; k < boundaries; ++k) {
        values.push_back(static_cast<float>(random.uniform(1.0, 8.0)));
      }
      std::ranges::sort(values);
    }
    for (std::size_t node = 0; node < nodes.size(); ++node) {
      at.boundaries[node] = nodes[node].data();
    }
    rays.assign(directions, lengths);
    slices.interpolate(at, positions, rays);
  }
};

struct Case {
  const char* name;
  double radius_low, radius_high, density_low, density_high;  // powers of ten
  std::size_t boundaries;
};
const Case cases[] = {
    {"large, cut often", -0.5, 0.3, -1, 1, 24}, {"small, on a slice or two", -2.2, -1.5, -1, 2, 8},
    {"all sizes", -2.0, 0.0, -1, 1, 40},        {"opaque", -1.0, 0.0, 2, 4, 16},
    {"one slice", -1.5, 0.0, -1, 1, 2},
};

TEST(Increments, AgreeWithDouble) {
  for_each_target([] {
    for (const Case& c : cases) {
      SCOPED_TRACE(c.name);
      Random random(21);
      for (const std::size_t count : {std::size_t{1}, std::size_t{16}, std::size_t{53}}) {
        Medium medium;
        for (int i = 0; i < 60; ++i) {
          medium.append({random.point(1.5), random.power(c.radius_low, c.radius_high),
                         random.power(c.density_low, c.density_high)});
        }
        const MediumIndex index(medium, culled);
        const Bundle bundle(random, count, 0.4, c.boundaries);
        std::vector<std::uint32_t> all(medium.size());
        for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
        GaussianBatch batch;
        batch.assign(index, bundle.eye, all);
        const std::size_t stride = bundle.rays.padded_size();
        std::vector<float> increments((c.boundaries - 1) * stride, 0.0f);
        std::vector<float> moments(increments.size(), 0.0f);
        accumulate_increments(batch, bundle.rays, bundle.slices, increments.data(), moments.data());
        for (std::size_t i = 0; i < count; ++i) {
          for (std::size_t k = 0; k + 1 < c.boundaries; ++k) {
            const double begin = *bundle.slices.at(i, k);
            const double end = *bundle.slices.at(i, k + 1);
            double depth = 0.0;
            double moment = 0.0;
            double opaque = 0.0;
            for (const GaussianTerm<double>& g : index.gaussians()) {
              const glm::dvec3 start = bundle.eye + begin * bundle.directions[i];
              const LineProfile<double> line = line_profile(g, start, bundle.directions[i]);
              const double part = optical_depth(g, line, end - begin);
              depth += part;
              if (part > 0.0) moment += part * (begin + truncated_mean(line, end - begin));
              if (0.5 * std::sqrt(M_PI) * g.c / g.a > double{exact_above}) opaque += part;
            }
            const auto at = k * stride + i;
            // For each Gaussian erf_fast may err by 3e-4 of its depth, and the cutoff by as much as
            // it tolerates.
            const double allowed = 6e-4 * depth + 60 * 3e-4 * 0.05 + 60 * culled;
            ASSERT_NEAR(increments[at], depth, allowed) << "ray " << i << " slice " << k;
            // A small Gaussian's part may lie off by a fiftieth of a radius. Opaque Gaussians lie
            // in the middle of slices.
            const double moment_room = end * allowed + 0.02 * depth + (end - begin) * opaque;
            ASSERT_NEAR(moments[at], moment, moment_room) << "ray " << i << " slice " << k;
          }
        }
      }
    }
  });
}

// Without moments the increments are the same.
TEST(Increments, MomentsChangeNothing) {
  Random random(22);
  Medium medium;
  for (int i = 0; i < 40; ++i) {
    medium.append({random.point(1.5), random.power(-2, 0), random.power(-1, 1)});
  }
  const MediumIndex index(medium, culled);
  const Bundle bundle(random, 33, 0.4, 12);
  std::vector<std::uint32_t> all(medium.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  GaussianBatch batch;
  batch.assign(index, bundle.eye, all);
  std::vector<float> with(11 * bundle.rays.padded_size(), 0.0f);
  std::vector<float> moments(with.size(), 0.0f);
  std::vector<float> without(with.size(), 0.0f);
  const auto pairs =
      accumulate_increments(batch, bundle.rays, bundle.slices, with.data(), moments.data());
  EXPECT_EQ(accumulate_increments(batch, bundle.rays, bundle.slices, without.data()), pairs);
  for (std::size_t i = 0; i < with.size(); ++i) EXPECT_NEAR(with[i], without[i], 1e-6f);
  EXPECT_GT(pairs, 0u);
}

}  // namespace
}  // namespace brume
