#include "core/io/gaussians/gaussian_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "core/io/gaussians/gaussian_csv.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/gaussians/random_ellipsoids.h"
#include "tests/core/io/input_error.h"
#include "tests/random.h"

namespace brume {
namespace {

constexpr const char* ply_header =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nproperty double radius\nproperty double density\nend_header\n";

template <typename Number>
void append(std::string& bytes, Number value, bool big_endian) {
  char raw[sizeof(Number)];
  std::memcpy(raw, &value, sizeof(Number));
  if (big_endian) std::reverse(std::begin(raw), std::end(raw));
  bytes.append(raw, sizeof(Number));
}

using GaussianFile = FolderTest;

TEST_F(GaussianFile, ReadsBackExactlyWhatWasWritten) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> coordinate(-1e3, 1e3);
  std::uniform_real_distribution<double> exponent(-9.0, 9.0);
  for (const std::size_t count : {0u, 1u, 1000u}) {
    std::vector<Gaussian> gaussians;
    for (std::size_t i = 0; i < count; ++i) {
      gaussians.push_back({{coordinate(random), coordinate(random), coordinate(random)},
                           std::pow(10.0, exponent(random)),
                           i % 7 == 0 ? 0.0 : std::pow(10.0, exponent(random))});
    }
    write_gaussians(folder_ / "a.ply", gaussians);
    EXPECT_EQ(read_gaussians(folder_ / "a.ply"), gaussians);
  }
}

// Also at the limit of elongation, where rounding must not make a file that is refused. Beside
// ellipsoids, balls are kept exactly, too.
TEST_F(GaussianFile, KeepsEllipsoids) {
  std::vector<Gaussian> gaussians = random_ellipsoids(1000);
  for (Gaussian g : random_ellipsoids(1000, 8)) {
    if (!g.is_ball()) g.set_radii(g.radii() * glm::dvec3(1.0, 1e-6, 1.0), g.shape.rotation);
    gaussians.push_back(g);
  }
  for (const char* name : {"a.ply", "a.csv"}) {
    write_gaussians(folder_ / name, gaussians);
    const std::vector<Gaussian> read = read_gaussians(folder_ / name);
    ASSERT_EQ(read.size(), gaussians.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      const Gaussian& expected = gaussians[i];
      EXPECT_EQ(read[i].center, expected.center) << i;
      EXPECT_EQ(read[i].radius, expected.radius) << i;
      EXPECT_EQ(read[i].density, expected.density) << i;
      EXPECT_EQ(read[i].is_ball(), expected.is_ball()) << i;
      EXPECT_EQ(read[i].shape.rotation, expected.shape.rotation) << i;
      for (int k = 0; k < 3; ++k) {
        const double stretch = expected.shape.stretch[k];
        EXPECT_NEAR(read[i].shape.stretch[k], stretch, 3e-16 * stretch) << i;
      }
    }
  }
}

TEST_F(GaussianFile, RefusesEllipsoidsThatContradictThemselves) {
  const auto refusal = [&](std::string_view text) {
    const auto file = folder_.write("a.csv", text);
    return error_of([&] { read_gaussians(file); });
  };
  EXPECT_TRUE(contains(refusal("x,y,z,radius,density,radius_x,radius_y\n"),
                       "line 1: there is no column radius_z"));
  const std::string header =
      "x,y,z,radius,density,radius_x,radius_y,radius_z,rotate_w,rotate_x,rotate_y,rotate_z\n";
  EXPECT_TRUE(contains(refusal(header + "0,0,0,5,1,1,.5,1,1,0,0,0\n"),
                       "line 2, radius_x: found radii of at most 1 beside the radius 5"));
  EXPECT_TRUE(contains(refusal(header + "0,0,0,1,1,1,.5,1,1,1,0,0\n"), "line 2, rotate_w"));
  std::string ply = ply_header;
  ply.replace(ply.find("end_header"), 0, "property double rotate_x\n");
  expect_error([&] { read_gaussians(folder_.write("a.ply", ply + "1 2 3 1 1 0 1 2 3 1 1 0")); },
               "there is no property radius_x");
}

TEST_F(GaussianFile, DetectsTheFormatByItsContent) {
  const std::vector<Gaussian> gaussians{{{1, 2, 3}, 0.1, 0.3}};
  write_gaussians(folder_ / "a.CSV", gaussians);
  EXPECT_TRUE(content_of(folder_ / "a.CSV").starts_with("x,y,z"));
  std::filesystem::rename(folder_ / "a.CSV", folder_ / "a.ply");
  EXPECT_EQ(read_gaussians(folder_ / "a.ply"), gaussians);
}

TEST_F(GaussianFile, AcceptsColumnNamesOfOtherPrograms) {
  std::string text = ply_header;
  text.replace(text.find("radius"), 6, "pscale");
  text.replace(text.find("density"), 7, "scalar_density");
  const std::vector<Gaussian> expected{{{1, 2, 3}, 0.5, 0.01}, {{-1, 2, 0}, 4, 5}};
  EXPECT_EQ(read_gaussians(folder_.write("a.ply", text + "1 2 3 .5 1e-2\n-1 +2 0 4 5")), expected);
  EXPECT_EQ(read_gaussians(
                folder_.write("a.csv", "x,y,z,scalar_radius,density\n1,2,3,.5,1e-2\n-1,2,0,4,5\n")),
            expected);
}

// Gaussian splatting stores ellipsoids; they become as opaque along their mean radius.
TEST_F(GaussianFile, SplatsBecomeEllipsoidsAsOpaque) {
  const std::string splats =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float f_dc_0\nproperty float opacity\n"
      "property float scale_0\nproperty float scale_1\nproperty float scale_2\n"
      "property float rot_0\nproperty float rot_1\nproperty float rot_2\nproperty float rot_3\n"
      "end_header\n";
  const auto file = folder_.write("a.ply", splats +
                                               "1 2 3 0 .5 0 -2.1 -2 -1.9 1 0 0 0\n"
                                               "0 0 0 0 0 2 0 0 0 1 0 0 0\n"
                                               "0 0 0 0 0 -40 0 0 0 1 0 0 0\n"
                                               "0 0 0 0 0 800 0 0 0 1 0 0 0\n");
  const std::vector<Gaussian> balls = read_gaussians(file);
  ASSERT_EQ(balls.size(), 4u);
  EXPECT_EQ(balls[0].center, glm::dvec3(1, 2, 3));
  EXPECT_NEAR(balls[0].mean_radius(), std::sqrt(2.0) * std::exp(-2.0), 1e-15);
  const auto opacity = [](const Gaussian& g) {
    return -std::expm1(-g.density * std::sqrt(std::acos(-1.0)) * g.mean_radius());
  };
  EXPECT_NEAR(opacity(balls[0]), 0.5, 1e-15);
  EXPECT_NEAR(opacity(balls[1]), 1.0 / (1.0 + std::exp(-2.0)), 1e-15);
  EXPECT_NEAR(opacity(balls[2]) / std::exp(-40.0), 1.0, 1e-12);
  EXPECT_NEAR(balls[3].density * std::sqrt(std::acos(-1.0)) * balls[3].radius, 800.0, 1e-9);

  for (const char* row : {"0 0 0 0 0 nan 0 0 0 1 0 0 0", "0 0 0 0 0 0 900 900 900 1 0 0 0",
                          "0 0 0 0 0 0 -90 -90 -90 1 0 0 0", "0 0 0 0 0 1e300 0 0 0 1 0 0 0",
                          "0 0 0 0 0 0 nan 0 0 1 0 0 0", "0 0 0 0 0 0 0 0 nan 1 0 0 0"}) {
    std::string one = splats;
    one.replace(one.find("vertex 4"), 8, "vertex 1");
    const auto bad = folder_.write("b.ply", one + row);
    for (const auto along : {OpacityAlong::shortest, OpacityAlong::mean, OpacityAlong::longest}) {
      const auto read = [&] { read_gaussians(bad, nullptr, limits::gaussians, {along}); };
      EXPECT_TRUE(contains(error_of(read), "vertex 0")) << row;
    }
  }

  // Turned from x to y.
  std::string one = splats;
  one.replace(one.find("vertex 4"), 8, "vertex 1");
  const auto turned = folder_.write("c.ply", one + "1 2 3 0 0 0 0 -1 -2 5 0 0 5");
  const std::vector<Gaussian> row = read_gaussians(turned);
  ASSERT_EQ(row.size(), 1u);
  const glm::dvec3 radii = std::sqrt(2.0) * glm::exp(glm::dvec3(0.0, -1.0, -2.0));
  EXPECT_LT(glm::length(row[0].radii() - radii), 1e-15);
  EXPECT_LT(glm::length(row[0].shape.rotation * glm::dvec3(1, 0, 0) - glm::dvec3(0, 1, 0)), 1e-15);
}

// Some programs leave out rotations, and scales of discs and of balls.
TEST_F(GaussianFile, SplatsMayLackScalesAndRotations) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nproperty float opacity\nproperty float scale_0\n";
  const auto read = [&](const std::string& rest) {
    return read_gaussians(folder_.write("a.ply", head + rest)).at(0);
  };
  const Gaussian ball = read("end_header\n1 2 3 0 -1\n");
  EXPECT_TRUE(ball.is_ball());
  EXPECT_NEAR(ball.radius, std::sqrt(2.0) * std::exp(-1.0), 1e-15);
  const Gaussian disc = read("property float scale_1\nend_header\n1 2 3 0 0 -1\n");
  EXPECT_LT(glm::length(disc.shape.stretch - glm::dvec3(1.0, std::exp(-1.0), limits::min_stretch)),
            1e-15);
  EXPECT_NEAR(disc.density * std::sqrt(std::acos(-1.0)) * disc.mean_radius(), std::log(2.0), 1e-14);
}

TEST_F(GaussianFile, ReadsAscii) {
  const auto file =
      folder_.write("a.ply", std::string(ply_header) + "1 2 3 .5 1e-2\r\n-1 +2 0 4 5");
  const std::vector<Gaussian> expected{{{1, 2, 3}, 0.5, 0.01}, {{-1, 2, 0}, 4, 5}};
  EXPECT_EQ(read_gaussians(file), expected);
}

// Other elements, lists and properties of every type stand between and around the ones needed.
TEST_F(GaussianFile, SkipsWhatItDoesNotNeedInBothByteOrders) {
  for (const bool big : {false, true}) {
    std::string bytes = "ply\nformat binary_" + std::string(big ? "big" : "little") +
                        "_endian 1.0\ncomment made by hand\nobj_info nothing\n"
                        "element before 2\nproperty list uchar short tags\nproperty char c\n"
                        "element vertex 1\nproperty double density\nproperty uchar red\n"
                        "property float x\nproperty short y\nproperty int8 z\n"
                        "property list ushort double weights\nproperty uint radius\nend_header\n";
    for (const int length : {2, 0}) {
      append(bytes, static_cast<std::uint8_t>(length), big);
      for (int i = 0; i < length; ++i) append(bytes, std::int16_t{-7}, big);
      append(bytes, std::int8_t{1}, big);
    }
    append(bytes, 0.25, big);
    append(bytes, std::uint8_t{200}, big);
    append(bytes, 1.5f, big);
    append(bytes, std::int16_t{-300}, big);
    append(bytes, std::int8_t{-3}, big);
    append(bytes, std::uint16_t{1}, big);
    append(bytes, 9.0, big);
    append(bytes, std::uint32_t{70000}, big);
    const std::vector<Gaussian> expected{{{1.5, -300, -3}, 70000, 0.25}};
    EXPECT_EQ(read_gaussians(folder_.write("a.ply", bytes)), expected) << "big-endian: " << big;
  }
}

struct BadFile {
  const char* name;
  std::string content;
  const char* place;
};

TEST_F(GaussianFile, RefusesBadFilesAndNamesThePlace) {
  const std::string h = ply_header;
  const auto replaced = [&](const std::string& what, const std::string& by) {
    std::string text = h;
    return text.replace(text.find(what), what.size(), by) + "1 2 3 1 1\n1 2 3 1 1\n";
  };
  const BadFile files[] = {
      {"empty", "", "empty"},
      {"neither PLY nor a table", "solid x\n", "line 1"},
      {"header without end", "ply\nformat ascii 1.0\n", "line 2"},
      {"no format", replaced("format ascii 1.0\n", ""), "header has no format"},
      {"unknown format", replaced("ascii", "ebcdic"), "ebcdic"},
      {"unknown type", replaced("float x", "quad x"), "quad"},
      {"no vertices", replaced("element vertex 2", "element point 2"), "element vertex"},
      {"no radius", replaced("double radius", "double size"), "radius"},
      {"density as a list", replaced("double density", "list uchar float density"), "density"},
      {"negative count", replaced("vertex 2", "vertex -2"), "-2"},
      {"count beyond the file", replaced("vertex 2", "vertex 9000000"), "too short"},
      {"count beyond the limit", replaced("vertex 2", "vertex 4000000000"), "10000000"},
      {"count beyond 64 bits", replaced("vertex 2", "vertex 99999999999999999999"), "line 3"},
      {"truncated", h + "1.25 2 3 1 1\n1 2 3 1", "vertex 1: density: the file ends"},
      {"a word", h + "1 2 3 1 1\n1 2 x 1 1\n", "vertex 1: z"},
      {"NaN", h + "1 2 3 1 1\n1 nan 3 1 1\n", "vertex 1: y"},
      {"infinite density", h + "1 2 3 1 inf\n1 2 3 1 1\n", "vertex 0: density"},
      {"radius 0", h + "1 2 3 1 1\n1 2 3 0 1\n", "vertex 1: radius: found 0; allowed"},
      {"negative density", h + "1 2 3 1 -1\n1 2 3 1 1\n", "vertex 0: density"},
  };
  const TemporaryFolder folder;
  for (const auto& [name, content, place] : files) {
    SCOPED_TRACE(name);
    const auto file = folder.write("bad.ply", content);
    expect_error([&] { read_gaussians(file); }, {file.string(), place});
  }
  expect_error([&] { read_gaussians(folder / "none.ply"); }, "no such file");
  expect_error([&] { read_gaussians(folder.path()); }, "folder");
}

TEST_F(GaussianFile, CarriesOptics) {
  const glm::dvec3 red(0.9, 0.3, 1e-6);
  const std::vector<Gaussian> gaussians{{{1, 2, 3}, 0.1, 0.3, {red, {1e20, 0.25, 0.0}}},
                                        {{1, 2, 4}, 0.1, 0.3},
                                        {{1, 2, 5}, 0.1, 0.3, {std::nullopt, {0.0, 0.0, 7.0}}}};
  for (const char* name : {"a.ply", "a.csv"}) {
    write_gaussians(folder_ / name, gaussians);
    EXPECT_EQ(read_gaussians(folder_ / name), gaussians) << name;
  }
  EXPECT_TRUE(content_of(folder_ / "a.csv")
                  .starts_with("x,y,z,radius,density,albedo_r,albedo_g,albedo_b,emission_r,"));
  // Those of none take no columns.
  write_gaussians(folder_ / "plain.csv", std::vector{gaussians[1]});
  EXPECT_TRUE(content_of(folder_ / "plain.csv").starts_with("x,y,z,radius,density\n"));

  const std::string header =
      "x,y,z,radius,density,emission_r,emission_g,emission_b,albedo_r,albedo_g,albedo_b\n";
  const auto error = [&](const std::string& optics) {
    return error_of(
        [&] { read_gaussians(folder_.write("bad.csv", header + "1,2,3,1,1," + optics + "\n")); });
  };
  EXPECT_TRUE(contains(error("1,1,1,0.5,0,0.5"), "line 2, albedo_g: found 0; allowed"));
  EXPECT_TRUE(contains(error("1,1,1,0.5,2,0.5"), "albedo_g: found 2; allowed"));
  EXPECT_TRUE(contains(error("1,-1,1,0.5,1,0.5"), "emission_g: found -1; allowed"));
  EXPECT_TRUE(contains(error("1,nan,1,0.5,1,0.5"), "emission_g"));
  EXPECT_TRUE(contains(error("1,1,1,x,1,0.5"), "albedo_r: found x; allowed"));
  EXPECT_TRUE(contains(error("1,1,1,0.5,1"), "albedo_b: is missing"));
}

TEST_F(GaussianFile, EveryTruncationOfABinaryFileIsRefused) {
  write_gaussians(folder_ / "a.ply", std::vector<Gaussian>(3, {{1, 2, 3}, 4, 5}));
  expect_truncations_refused(content_of(folder_ / "a.ply"), [&](const std::string& bytes) {
    read_gaussians(folder_.write("cut.ply", bytes));
  });
}

using GaussianCsv = FolderTest;

TEST_F(GaussianCsv, ReadsBackExactlyWhatWasWritten) {
  Random random(1);
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 1000; ++i) {
    gaussians.push_back({random.point(1e3), random.power(-9, 9), random.power(-9, 9)});
  }
  write_gaussians_csv(folder_ / "a.csv", gaussians);
  EXPECT_EQ(read_gaussians_csv(folder_ / "a.csv"), gaussians);
}

TEST_F(GaussianCsv, FindsItsColumnsByName) {
  const auto file = folder_.write(
      "a.csv", "id, density,radius ,z,y,x,note\r\n7,1,2,3,4,5,a b\r\n\r\n8, 0.5,2e-1,-3,4,5,");
  const std::vector<Gaussian> expected{{{5, 4, 3}, 2, 1}, {{5, 4, -3}, 0.2, 0.5}};
  EXPECT_EQ(read_gaussians_csv(file), expected);
}

// The two Gaussians that each of these tables holds.
const std::vector<Gaussian> tabled{{{1, 2, 3}, 0.25, 0.5}, {{-4, 5, 6}, 1, 2}};

TEST_F(GaussianCsv, ReadsWhatSpreadsheetsAndOtherProgramsWrite) {
  const std::pair<const char*, std::string> tables[] = {
      {"a byte order mark", "\xef\xbb\xbfx,y,z,radius,density\r\n1,2,3,.25,.5\r\n-4,5,6,1,2\r\n"},
      {"semicolons and decimal commas", "x;y;z;radius;density\n1,0;2;3;0,25;5E-1\n-4;5;6;1;2\n"},
      {"a line that names the separator",
       "sep=;\nx;y;z;radius;density;a,b,c,d,e,f\n1;2;3;,25;,5\n-4;5;6;1;2\n"},
      {"tabs", "x\ty\tz\tradius\tdensity\n1\t2\t3\t0,25\t0,5\n-4\t5\t6\t1\t2\n"},
      {"blanks", "x y  z radius density \n1 2 3 .25 .5\n -4 5  6 1 2 \n"},
      {"quotes", "\"x\",\"y\",\"z\",\"radius\",\"density\"\n\"1\",2,3,\"0.25\",.5\n-4,5,6,1,2\n"},
      {"quoted separators and lines",
       "note,x,y,z,radius,density\n\"a, \"\"b\"\"\nc\",1,2,3,.25,.5\n5\" d,-4,5,6,1,2\n"},
      {"names of rows",
       "\"x\",\"y\",\"z\",\"radius\",\"density\"\n\"1\",1,2,3,.25,.5\n\"2\",-4,5,6,1,2"},
      {"names of rows under no name",
       "\"\",\"x\",\"y\",\"z\",\"radius\",\"density\"\n\"1\",1,2,3,.25,.5\n\"2\",-4,5,6,1,2"},
      {"names of ParaView",
       "\"radius\",\"density\",\"Points:0\",\"Points:1\",\"Points:2\"\n.25,.5,1,2,3\n1,2,-4,5,6\n"},
      {"capitals and blanks", " X , Y,Z ,Radius,DENSITY\n1 , 2,3,.25,.5\n-4,5,6,1,2\n"},
      {"comments",
       "# by \"hand\n\nx,y,z,radius,density\n#9,9,9,9,9\n1,2,3,.25,.5\n,,,,\n  # x\n-4,5,6,1,2\n"},
      {"a heading in a comment", "# of numpy\n# x,y,z,radius,density\n1,2,3,.25,.5\n-4,5,6,1,2\n"},
      {"line ends of the Macintosh", "x,y,z,radius,density\r1,2,3,.25,.5\r-4,5,6,1,2\r"},
      {"separators at the ends", "x,y,z,radius,density,\n1,2,3,.25,.5,\n-4,5,6,1,2,,\n"},
  };
  for (const auto& [what, text] : tables) {
    const auto file = folder_.write("a.csv", text);
    EXPECT_EQ(read_gaussians(file), tabled) << what;
    EXPECT_GE(max_gaussian_count(file), tabled.size()) << what;
  }
}

TEST_F(GaussianCsv, ReadsUtf16) {
  const std::string text = "x\ty\tz\tradius\tdensity\r\n1\t2\t3\t0,25\t0,5\r\n-4\t5\t6\t1\t2\r\n";
  std::string little = "\xff\xfe";
  std::string big = "\xfe\xff";
  for (const char c : text) {
    little += {c, '\0'};
    big += {'\0', c};
  }
  EXPECT_EQ(read_gaussians(folder_.write("little.csv", little)), tabled);
  EXPECT_EQ(read_gaussians(folder_.write("big.csv", big)), tabled);
}

TEST_F(GaussianCsv, ErrorsNameLineAndColumn) {
  const auto refusal = [&](std::string_view text) {
    const auto file = folder_.write("a.csv", text);
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
  EXPECT_TRUE(
      contains(refusal("lon,lat,alt\n1,2,3\n"), "line 1: there is no column x; found lon,lat"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,4,5\n1,2,3,4,5,6\n"), "line 3: found 6 cells"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,4,\"5,5\"\n"), "line 2, density: found 5,5"));
  EXPECT_TRUE(contains(refusal(header + "1,2,3,4,\"5\n1,2,3,4,5\n"), "line 2, density: found \"5"));
  EXPECT_TRUE(contains(refusal("x;y;z;radius;density\n1.5;2;3;4;1,234\n"), "one decimal sign"));
  EXPECT_TRUE(contains(refusal(std::string("\0\1x,y", 5)), "is no text"));
  EXPECT_TRUE(contains(refusal("# nothing else\n"), "empty"));
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
