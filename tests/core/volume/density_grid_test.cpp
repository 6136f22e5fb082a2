#include "brume/density_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "brume/error.h"

namespace brume {
namespace {

TEST(DensityGrid, OfAnArrayHasItsValuesWhereTheyWere) {
  // No side is a multiple of a block's, and one block is empty.
  const glm::ivec3 size(9, 5, 20);
  std::vector<float> values(9 * 5 * 20);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = i % 20 < 16 ? static_cast<float>(i) : 0.0f;
  }
  const DensityGrid grid = grid_of(values, size, 0.5, {1.0, 2.0, 3.0});
  EXPECT_EQ(grid.blocks.size(), 4u);
  for (int x = 0; x < size.x; ++x) {
    for (int y = 0; y < size.y; ++y) {
      for (int z = 0; z < size.z; ++z) {
        const auto i = static_cast<std::size_t>((x * size.y + y) * size.z + z);
        EXPECT_EQ(grid.at({x, y, z}), static_cast<double>(values[i]));
      }
    }
  }
  EXPECT_EQ(grid.at({-1, 0, 0}), 0.0);
  EXPECT_EQ(grid.to_world({2, 0, 4}), glm::dvec3(2.0, 2.0, 5.0));
}

TEST(DensityGrid, OfAnArrayRefusesWhatIsNoDensity) {
  const auto refused = [](std::vector<float> values, const glm::ivec3& size, double spacing) {
    try {
      static_cast<void>(grid_of(values, size, spacing));
    } catch (const DomainError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused({0, 1, 2, -3}, {1, 2, 2}, 1.0),
            "values[0][1][1]: found -3; allowed: a number >= 0 (up to 1e12)");
  EXPECT_TRUE(refused({0, std::numeric_limits<float>::quiet_NaN()}, {2, 1, 1}, 1.0)
                  .starts_with("values[1][0][0]: found nan"));
  EXPECT_TRUE(refused({0, 1, 2}, {1, 2, 2}, 1.0).starts_with("values: found 3;"));
  EXPECT_TRUE(refused({}, {0, 0, 0}, 1.0).starts_with("values: found 0;"));
  EXPECT_TRUE(refused({}, {1 << 30, 1 << 30, 16}, 1.0).starts_with("values: found 0;"));
  EXPECT_TRUE(refused({0}, {1, 1, 1}, 0.0).starts_with("spacing: found 0;"));
  EXPECT_THROW(static_cast<void>(grid_of({{0.0f}}, {1, 1, 1}, 1.0, glm::dvec3(NAN))), DomainError);
}

}  // namespace
}  // namespace brume
