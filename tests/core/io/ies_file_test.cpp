#include "core/io/ies_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/trigonometric.hpp>
#include <string>

#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

// A file of three polar angles whose intensities at 45 degrees are those given, by azimuth.
std::string ies(const std::string& azimuths, const std::vector<double>& intensities,
                const std::string& keywords = "IESNA:LM-63-2002\n[TEST] none\n",
                const std::string& tilt = "TILT=NONE\n") {
  std::string text = keywords + tilt + "1 1000 2.5 3 " + std::to_string(intensities.size()) +
                     " 1 2 0 0 0\n1 1 60\n0 45 90\n" + azimuths + "\n";
  for (const double intensity : intensities) text += "1 " + std::to_string(intensity) + " 0\n";
  return text;
}

PhotometricProfile read(const std::string& text) {
  const TemporaryFolder folder;
  return *read_ies(folder.write("light.ies", text));
}

double at(const PhotometricProfile& profile, double azimuth, double polar = 45.0) {
  const double a = glm::radians(azimuth);
  const double p = glm::radians(polar);
  return profile.at({std::sin(p) * std::cos(a), std::sin(p) * std::sin(a), std::cos(p)});
}

TEST(IesFile, OneAzimuthIsAllOfThem) {
  const PhotometricProfile profile = read(ies("0", {10.0}));
  for (const double azimuth : {0.0, 77.0, 180.0, 300.0})
    EXPECT_NEAR(at(profile, azimuth), 1.0, 1e-9);
  EXPECT_NEAR(at(profile, 20.0, 0.0), 0.1, 1e-9);
  EXPECT_NEAR(at(profile, 20.0, 22.5), 0.55, 1e-9);
  EXPECT_EQ(at(profile, 20.0, 90.1), 0.0);
}

TEST(IesFile, AzimuthsAreMirroredAsTheirRangeSays) {
  const PhotometricProfile quadrant = read(ies("0 30 90", {10, 20, 40}));
  for (const double same : {30.0, 150.0, 210.0, 330.0}) {
    EXPECT_NEAR(at(quadrant, same), 0.5, 1e-9) << same;
    EXPECT_NEAR(at(quadrant, same > 180.0 ? 270.0 : 90.0), 1.0, 1e-9);
  }
  EXPECT_NEAR(at(quadrant, 180.0), 0.25, 1e-9);

  const PhotometricProfile half = read(ies("0 90 180", {10, 20, 40}));
  EXPECT_NEAR(at(half, 90.0), 0.5, 1e-9);
  EXPECT_NEAR(at(half, 270.0), 0.5, 1e-9);
  EXPECT_NEAR(at(half, 180.0), 1.0, 1e-9);
  EXPECT_NEAR(at(half, 225.0), 0.75, 1e-9);

  const PhotometricProfile other_half = read(ies("90 180 270", {10, 20, 40}));
  EXPECT_NEAR(at(other_half, 90.0), 0.25, 1e-9);
  EXPECT_NEAR(at(other_half, 180.0), 0.5, 1e-9);
  EXPECT_NEAR(at(other_half, 0.0), 0.5, 1e-9);
  EXPECT_NEAR(at(other_half, 315.0), 0.75, 1e-9);
  EXPECT_NEAR(at(other_half, 45.0), 0.375, 1e-9);
  // Without one in the plane of symmetry.
  const PhotometricProfile seam = read(ies("90 200 270", {10, 20, 40}));
  EXPECT_NEAR(at(seam, 0.0), 0.5 - 0.25 * 20.0 / 110.0, 1e-9);
  EXPECT_NEAR(at(seam, 340.0), 0.5, 1e-9);
  EXPECT_NEAR(at(seam, 359.99), at(seam, 0.01), 1e-4);

  const PhotometricProfile full = read(ies("0 90 180 270 360", {10, 20, 40, 30, 10}));
  EXPECT_NEAR(at(full, 270.0), 0.75, 1e-9);
  EXPECT_NEAR(at(full, 315.0), 0.5, 1e-9);
  // Some leave out the last.
  const PhotometricProfile open = read(ies("0 90 180 270", {10, 20, 40, 30}));
  EXPECT_NEAR(at(open, 315.0), 0.5, 1e-9);
}

TEST(IesFile, ReadsWhatProgramsWrite) {
  const double expected = at(read(ies("0 90", {10, 20})), 45.0);
  const std::string old = ies("0, 90", {10, 20}, "");
  EXPECT_NEAR(at(read(old), 45.0), expected, 1e-9);
  const std::string tilted =
      ies("0 90", {10, 20}, "IESNA91\n", "TILT=INCLUDE\n1\n3\n0 45 90\n1 .9 .8\n");
  EXPECT_NEAR(at(read(tilted), 45.0), expected, 1e-9);
  const std::string in_file = ies("0 90", {10, 20}, "IESNA:LM-63-1995\n", "TILT=other.tlt\n");
  EXPECT_NEAR(at(read(in_file), 45.0), expected, 1e-9);
  std::string windows;
  for (const char c : ies("0 90", {10, 20})) windows += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_NEAR(at(read(windows), 45.0), expected, 1e-9);
}

TEST(IesFile, RefusesInOneLineThatNamesThePlace) {
  const TemporaryFolder folder;
  const auto numbers = [](const std::string& counts, const std::string& rest) {
    return "IESNA:LM-63-2002\nTILT=NONE\n" + counts + "\n1 1 60\n" + rest;
  };
  const auto good = [&](const std::string& counts) { return numbers(counts, "0 90\n0\n1 2\n"); };
  const struct {
    std::string text, place, found;
  } cases[] = {
      {"", "", "no line that begins with TILT="},
      {"IESNA:LM-63-2002\n1 2 3\n", "", "TILT="},
      {"TILT=NONE\n", "line", "the end of the file as number of lamps"},
      {"TILT=INCLUDE\n1\n1e9\n", "line 3", "number of tilt angles; allowed: a whole number from 1"},
      {good("1 1 1 0 1 1 2 0 0 0"), "line 3", "number of vertical angles"},
      {good("1 1 1 2.5 1 1 2 0 0 0"), "line 3", "2.5"},
      {good("1 1 1 2000000000 1 1 2 0 0 0"), "line 3", "from 1 to 1024"},
      {good("1 1 1 2 nan 1 2 0 0 0"), "line 3", "nan"},
      {good("1 1 1 2 1 2 2 0 0 0"), "line 3", "allowed: 1, type C"},
      {good("1 1 1 2 1 3 2 0 0 0"), "line 3", "photometric type"},
      {good("1 inf 1 2 1 1 2 0 0 0"), "line 3", "finite"},
      {good("one 1 1 2 1 1 2 0 0 0"), "line 3", "one"},
      {numbers("1 1 1 2 1 1 2 0 0 0", "90 0\n0\n1 2\n"), "line 5",
       "ascending angles from 0 to 180"},
      {numbers("1 1 1 2 1 1 2 0 0 0", "0 181\n0\n1 2\n"), "line 5", "181"},
      {numbers("1 1 1 2 1 1 2 0 0 0", "-5 90\n0\n1 2\n"), "line 5", "-5"},
      {numbers("1 1 1 2 2 1 2 0 0 0", "0 90\n0 45\n1 2\n1 2\n"), "line 6", "from 0 to 45"},
      {numbers("1 1 1 2 2 1 2 0 0 0", "0 90\n10 90\n1 2\n1 2\n"), "line 6", "from 10 to 90"},
      {numbers("1 1 1 2 2 1 2 0 0 0", "0 90\n0 361\n1 2\n1 2\n"), "line 6", "361"},
      {numbers("1 1 1 2 1 1 2 0 0 0", "0 90\n0\n1 -2\n"), "line 7", "-2"},
      {numbers("1 1 1 2 1 1 2 0 0 0", "0 90\n0\n1 1e300\n"), "line 7", "1e20"},
      {numbers("1 1 1 2 1 1 2 0 0 0", "0 90\n0\n0 0\n"), "line 7", "no candela value above 0"},
      {numbers("1 1 1 2 1 1 2 0 0 0", "0 90\n0\n1\n"), "line", "the end of the file"},
  };
  for (const auto& c : cases) {
    const auto file = folder.write("light.ies", c.text);
    const std::string error = error_of([&] { read_ies(file); });
    EXPECT_TRUE(contains(error, "light.ies") && contains(error, c.place) &&
                contains(error, c.found));
    EXPECT_EQ(error.find('\n'), std::string::npos);
    EXPECT_TRUE(contains(error, "allowed"));
  }
  expect_error([&] { read_ies(folder.path() / "none.ies"); }, "none.ies");
}

}  // namespace
}  // namespace brume
