// brume export to and from the files of programs of Gaussian splatting.

#include <gtest/gtest.h>

#include <numbers>

#include "core/io/gaussians/gaussian_file.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

class SplatExport : public CommandLine {
 protected:
  SplatExport() {
    Gaussian g{{1.0, 2.0, 3.0}, 1.0, 0.5};
    g.set_radii({1.0, 0.5, 0.25}, {0.8, 0.6, 0.0, 0.0});
    write_gaussians(file("a.ply"), std::vector{g, Gaussian{{0.0, 0.0, 0.0}, 2.0, 0.25}});
  }

  void expect_done(const std::vector<std::string>& arguments) {
    const ProgramResult result = run_brume(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }

  void expect_same(const char* name, double tolerance) {
    const std::vector<Gaussian> expected = read_gaussians(file("a.ply"));
    const std::vector<Gaussian> found = read_gaussians(file(name));
    ASSERT_EQ(found.size(), expected.size()) << name;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_LT(glm::length(found[i].center - expected[i].center), tolerance) << name;
      EXPECT_LT(glm::length(found[i].radii() - expected[i].radii()), tolerance) << name;
      EXPECT_NEAR(found[i].density, expected[i].density, tolerance) << name;
    }
  }
};

TEST_F(SplatExport, PlyThereAndBack) {
  expect_done({"export", file("a.ply"), "-o", file("b.ply"), "--splats"});
  expect_same("b.ply", 1e-6);
  for (const char* along : {"shortest", "mean", "longest"}) {
    expect_done(
        {"export", file("a.ply"), "-o", file("c.ply"), "--splats", "--opacity-along", along});
    expect_done({"export", file("c.ply"), "-o", file("d.ply"), "--opacity-along", along});
    expect_same("d.ply", 1e-6);
  }
  // As opaque along its longest radius, and so denser by longest over mean along the others.
  expect_done({"export", file("c.ply"), "-o", file("e.ply"), "--opacity-along", "mean"});
  EXPECT_NEAR(read_gaussians(file("e.ply")).at(0).density, 1.0, 1e-6);
}

TEST_F(SplatExport, RefusesWhatHasNoEffect) {
  const std::string ply = file("a.ply");
  expect_refused({"export", ply, "-o", file("b.csv"), "--splats"}, {"--splats: only for .ply"});
  expect_refused({"export", ply, "-o", file("b.ply"), "--opacity-along", "x"},
                 {"--opacity-along", "shortest"});
  expect_refused({"export", scene_, "-o", file("b.ply"), "--opacity-along", "mean"},
                 {"--opacity-along"});
}

}  // namespace
}  // namespace brume
