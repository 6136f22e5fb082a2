#include "core/io/gaussians/gaussian_csv.h"

#include <gtest/gtest.h>

#include "core/io/gaussians/gaussian_file.h"
#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/random.h"

namespace brume {
namespace {

TEST(GaussianCsv, ReadsBackExactlyWhatWasWritten) {
  const TemporaryFolder folder;
  Random random(1);
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 1000; ++i) {
    gaussians.push_back({random.point(1e3), random.power(-9, 9), random.power(-9, 9)});
  }
  write_gaussians_csv(folder / "a.csv", gaussians);
  EXPECT_EQ(read_gaussians_csv(folder / "a.csv"), gaussians);
}

TEST(GaussianCsv, FindsItsColumnsByName) {
  const TemporaryFolder folder;
  const auto file = folder.write(
      "a.csv", "id, density,radius ,z,y,x,note\r\n7,1,2,3,4,5,a b\r\n\r\n8, 0.5,2e-1,-3,4,5,");
  const std::vector<Gaussian> expected{{{5, 4, 3}, 2, 1}, {{5, 4, -3}, 0.2, 0.5}};
  EXPECT_EQ(read_gaussians_csv(file), expected);
}

TEST(GaussianCsv, ErrorsNameLineAndColumn) {
  const TemporaryFolder folder;
  const auto refusal = [&](std::string_view text) {
    const auto file = folder.write("a.csv", text);
    return error_of([&] { read_gaussians_csv(file); });
  };
  const std::string header = "x,y,z,radius,density\n";
  EXPECT_TRUE(contains(refusal(""), "empty"));
  EXPECT_TRUE(contains(refusal("x,y,z,radius\n"), "density"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,4\n"), "line 2, density: is missing"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,4,5\n1,2,abc,4,5\n"), "line 3, z: found abc"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,0,5\n"), "line 2, radius: found 0"));
  EXPECT_TRUE(contains(refusal(header + "1,nan,3,1,5\n"), "line 2, y: found nan"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,1,-5\n"), "line 2, density"));
}

TEST(GaussianIds, RoundTrip) {
  const TemporaryFolder folder;
  const std::vector<Gaussian> gaussians{{{1, 2, 3}, 0.5, 0.25}, {{4, 5, 6}, 1.5, 2.0}};
  const std::vector<GaussianNumber> ids{4294967295, 0};
  for (const char* name : {"a.csv", "a.ply"}) {
    write_gaussians(folder / name, gaussians, ids);
    std::vector<GaussianNumber> read;
    EXPECT_EQ(read_gaussians(folder / name, &read), gaussians);
    EXPECT_EQ(read, ids);
    EXPECT_EQ(read_gaussians(folder / name), gaussians);
  }
  std::vector<GaussianNumber> none;
  read_gaussians(folder.write("b.csv", "x,y,z,radius,density\n1,2,3,1,1\n"), &none);
  EXPECT_TRUE(none.empty());
  for (const char* id : {"-1", "0.5", "4294967296", "nan", "", "x"}) {
    const auto file =
        folder.write("c.csv", std::string("id,x,y,z,radius,density\n") + id + ",1,2,3,1,1\n");
    EXPECT_THROW(read_gaussians(file, &none), InputError) << id;
  }
}

}  // namespace
}  // namespace brume
