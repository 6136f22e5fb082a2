#include "brume/shared_column.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/random.h"

namespace brume {
namespace {

// Copies that are written to in all ways, each beside a vector.
TEST(SharedColumn, CopiesAreAsIfTheirOwn) {
  struct Pair {
    SharedColumn<int> column;
    std::vector<int> plain;
  };
  Random random(3);
  const auto below = [&](std::size_t n) {
    return static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(n)));
  };
  std::vector<Pair> pairs(6);
  for (int step = 0; step < 20'000; ++step) {
    Pair& pair = pairs[below(pairs.size())];
    switch (below(6)) {
      case 0:
        pair = pairs[below(pairs.size())];
        break;
      case 1:
      case 2:
        pair.column.push_back(step);
        pair.plain.push_back(step);
        break;
      case 3:
        if (pair.plain.empty()) break;
        pair.column.set(0, step);
        pair.plain[0] = step;
        break;
      case 4: {
        const std::size_t size = below(pair.plain.size() + 4);
        pair.column.resize(size, step);
        pair.plain.resize(size, step);
        break;
      }
      default:
        for (int& each : pair.column.write()) ++each;
        for (int& each : pair.plain) ++each;
    }
    for (const Pair& each : pairs) {
      ASSERT_TRUE(std::ranges::equal(each.column.all(), each.plain)) << step;
    }
  }
}

TEST(SharedColumn, CopiesAreFreeUntilWritten) {
  SharedColumn<double> column;
  column.reserve(10);
  for (int i = 0; i < 5; ++i) column.push_back(i);
  SharedColumn<double> copy = column;
  EXPECT_TRUE(copy.is_shared_with(column));
  // The end belongs to the first that takes it.
  column.push_back(5.0);
  EXPECT_EQ(column.all().data(), copy.all().data());
  copy.push_back(6.0);
  EXPECT_NE(column.all().data(), copy.all().data());
  EXPECT_EQ(column[5], 5.0);
  EXPECT_EQ(copy[5], 6.0);
  // Writing what is there already is no change.
  copy = column;
  copy.set(2, 2.0);
  EXPECT_TRUE(copy.is_shared_with(column));
  copy.set(2, 3.0);
  EXPECT_FALSE(copy.is_shared_with(column));
  EXPECT_EQ(column[2], 2.0);
}

TEST(SharedColumn, MovedFromIsEmpty) {
  SharedColumn<int> column;
  column.push_back(1);
  const SharedColumn<int> moved = std::move(column);
  EXPECT_TRUE(column.empty());  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(moved.size(), 1u);
}

}  // namespace
}  // namespace brume
