// brume fit and export.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "core/io/gaussians/gaussian_file.h"
#include "core/io/volume/volume_file.h"
#include "core/scene/lights/photometry.h"
#include "core/transport/optical_depth.h"
#include "tests/contains.h"
#include "tests/core/fit/matter.h"
#include "tests/core/io/volume/vdb_test_grid.h"
#include "tests/random.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

using Json = nlohmann::json;
using VolumeCommands = CommandLine;

TEST_F(VolumeCommands, FitsAVolumeAndASequence) {
  const std::string volume = std::string(BRUME_VOLUMES) + "/smoke_0025.vdb";
  const ProgramResult result =
      expect_done({"fit", volume, "--count", "20", "--up", "z", "-o", file("a.ply")});
  const Json line = Json::parse(result.out);
  EXPECT_EQ(line["gaussians"], 20);
  EXPECT_LT(line["density_error"], 0.6);
  EXPECT_LT(line["depth_error"], 0.3);
  EXPECT_NEAR(line["mass_ratio"].get<double>(), 1.0, 0.005);
  // z of the volume, from 0 to 2, has become y.
  for (const Gaussian& g : read_gaussians(file("a.ply"))) {
    EXPECT_GT(g.center.y, 0.0);
    EXPECT_LT(g.center.z, 0.0);
  }

  const ProgramResult both =
      expect_done({"fit", std::string(BRUME_VOLUMES) + "/smoke_%04d.vdb", "--frames", "25-26",
                   "--count", "8", "-o", file("s%d.csv")});
  EXPECT_EQ(std::count(both.out.begin(), both.out.end(), '\n'), 2);
  EXPECT_TRUE(std::filesystem::exists(file("s26.csv")));
  EXPECT_EQ(Json::parse(run_brume({"info", "--json", file("s26.csv")}).out)["medium"]["gaussians"],
            8);
  EXPECT_EQ(Json::parse(run_brume({"info", "--json", volume}).out)["grids"].size(), 5u);

  expect_refused({"fit", volume, "--grid", "smoke", "-o", file("b.ply")},
                 {"smoke_0025.vdb", "has no grid smoke", "density"});
  expect_refused({"fit", volume, "-o", file("b.obj")}, {"b.obj", ".ply, .csv"});
  expect_refused({"fit", volume, "--frames", "1-2", "-o", file("b.ply")}, {"--frames"});
  expect_refused({"fit", "a%d.vdb", "--frames", "2-1", "-o", file("b%d.ply")},
                 {"--frames: found 2-1"});
  expect_refused({"fit", volume, "--up", "x", "-o", file("b.ply")}, {"--up"});
  EXPECT_FALSE(std::filesystem::exists(file("b.ply")));
}

TEST_F(VolumeCommands, ExportsWhatEmittersHaveMade) {
  const std::string scene = folder_.write_scene(
      "e.brume", R"("medium": { "emitters": [ { "position": [0, 0, 0], "rate": 10 } ] })");
  const auto count = [&](const char* time) {
    expect_done({"export", scene, "--time", time, "-o", file("e.ply")});
    return read_gaussians(file("e.ply")).size();
  };
  EXPECT_GT(count("1"), 5u);
  EXPECT_LT(count("-1"), 1u);
}

TEST_F(VolumeCommands, ExportsATimeRange) {
  const std::string scene = folder_.write_scene(
      "e.brume", R"("medium": { "emitters": [ { "position": [0, 0, 0], "rate": 10 } ] })");
  expect_done({"export", scene, "--frames", "9-11", "--fps", "10", "-o", file("s_%04d.vdb"),
               "--voxel", "0.1"});
  for (const auto& [frame, time] :
       {std::pair("s_0009.vdb", "0.9"), std::pair("s_0011.vdb", "1.1")}) {
    expect_done({"export", scene, "--time", time, "-o", file("one.vdb"), "--voxel", "0.1"});
    const DensityGrid of_sequence = read_volume(file(frame), "density");
    const DensityGrid alone = read_volume(file("one.vdb"), "density");
    EXPECT_GT(alone.integral(), 0.0);
    EXPECT_DOUBLE_EQ(of_sequence.integral(), alone.integral());
  }
  EXPECT_NE(read_volume(file("s_0010.vdb"), "density").integral(),
            read_volume(file("s_0011.vdb"), "density").integral());

  // Files of Gaussians too, alone and as sequences.
  const std::vector<Gaussian> gaussians{{{0, 0, 0}, 1, 1}, {{1, 0, 0}, 0.5, 2}};
  write_gaussians(file("g_1.ply"), gaussians);
  write_gaussians(file("g_2.ply"), std::span(gaussians).first(1));
  expect_done({"export", file("g_%d.ply"), "--frames", "1-2", "-o", file("g_%d.csv")});
  EXPECT_EQ(read_gaussians(file("g_1.csv")), gaussians);
  EXPECT_EQ(read_gaussians(file("g_2.csv")).size(), 1u);
  expect_done({"export", file("g_1.csv"), "-o", file("g.vdb")});
  EXPECT_GT(read_volume(file("g.vdb"), "density").integral(), 0.0);

  expect_refused({"export", scene, "--frames", "1-2", "-o", file("b.vdb")}, {"%04d"});
  expect_refused({"export", scene, "-o", file("b%d.vdb")}, {"--frames"});
  expect_refused({"export", scene, "--frames", "1-2", "--time", "1", "-o", file("b%d.vdb")},
                 {"--time"});
}

TEST_F(VolumeCommands, ExportsTheMedium) {
  for (const char* name : {"m.ply", "m.csv"}) {
    expect_done({"export", scene_, "-o", file(name)});
    const Json info = Json::parse(run_brume({"info", "--json", file(name)}).out);
    EXPECT_EQ(info["medium"]["gaussians"], 2);
  }
  const ProgramResult result =
      expect_done({"export", scene_, "-o", file("m.vdb"), "--voxel", "0.1", "--half"});
  EXPECT_TRUE(contains(result.err, "the homogeneous density, 0.02", "voxels of 0.1"));
  const Json grids = Json::parse(run_brume({"info", "--json", file("m.vdb")}).out)["grids"];
  ASSERT_EQ(grids.size(), 1u);
  EXPECT_EQ(grids[0]["name"], "density");

  const ProgramResult fine =
      run_brume({"export", scene_, "-o", file("n.vdb"), "--voxel", "0.0001"});
  EXPECT_EQ(fine.exit_code, 2);
  EXPECT_TRUE(contains(fine.err, "a larger --voxel"));
  EXPECT_FALSE(std::filesystem::exists(file("n.vdb")));
  expect_refused({"export", scene_, "-o", file("m.obj")}, {".vdb, .ply, .csv"});
  expect_refused({"export", scene_, "-o", file("m.ply"), "--half"}, {"--half"});
}

// brume fit and export of volumes with colours, temperatures and flames.

using Json = nlohmann::json;
using VolumeColorCommands = CommandLine;

std::vector<Gaussian> colored_gaussians() {
  Random random(5);
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 12; ++i) {
    Gaussian g{random.point(1.0), random.uniform(0.3, 0.5), random.uniform(0.5, 2.0)};
    const glm::dvec3 t = 0.5 + 0.5 * glm::sin(2.0 * g.center);
    g.optics.albedo = 0.2 + 0.8 * t;
    g.optics.emission = {4.0 * t.x, 1.0, t.y};
    gaussians.push_back(g);
  }
  return gaussians;
}

double depth_between(std::span<const Gaussian> gaussians, const glm::dvec3& a,
                     const glm::dvec3& b) {
  double depth = 0.0;
  for (const Gaussian& g : gaussians) depth += optical_depth(g, a, b);
  return depth;
}

// Medium, volume, Gaussians again: colours and optical depths stay.
TEST_F(VolumeColorCommands, ExportAndFitGiveBackTheMedium) {
  const std::vector<Gaussian> gaussians = colored_gaussians();
  write_gaussians(file("a.ply"), gaussians);
  expect_done({"export", file("a.ply"), "-o", file("a.vdb")});
  const ProgramResult fit =
      expect_done({"fit", file("a.vdb"), "--count", "40", "-o", file("b.csv")});
  const Json line = Json::parse(fit.out);
  // A density error of 1% is part of both.
  EXPECT_LT(line["extinction_error"], 0.03);
  EXPECT_LT(line["emission_error"], 0.05);
  EXPECT_FALSE(line.contains("flames"));
  const std::vector<Gaussian> back = read_gaussians(file("b.csv"));
  Random random(6);
  double albedo_squares = 0.0;
  double emission_squares = 0.0;
  double scale = 0.0;
  for (int i = 0; i < 500; ++i) {
    // Where most of the matter is.
    const Gaussian& g = gaussians[static_cast<std::size_t>(i) % gaussians.size()];
    const glm::dvec3 x = g.center + random.point(0.6 * g.radius);
    const Matter expected = matter_at(gaussians, x);
    const Matter found = matter_at(back, x);
    const glm::dvec3 albedo_error = found.albedo - expected.albedo;
    const glm::dvec3 emission_error = found.emission - expected.emission;
    albedo_squares += glm::dot(albedo_error, albedo_error) / 3.0;
    emission_squares += glm::dot(emission_error, emission_error);
    scale += glm::dot(expected.emission, expected.emission);
  }
  // Found: 0.006 and 0.016, by fits of 1% of densities that overlap.
  EXPECT_LT(std::sqrt(albedo_squares / 500.0), 0.02);
  EXPECT_LT(std::sqrt(emission_squares / scale), 0.05);
  double wrong = 0.0;
  double right = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 a = random.point(1.5);
    const glm::dvec3 b = random.point(1.5);
    const double depth = depth_between(gaussians, a, b);
    wrong += std::pow(depth_between(back, a, b) - depth, 2.0);
    right += depth * depth;
  }
  EXPECT_LT(std::sqrt(wrong / right), 0.02);

  // Declined, they are not there.
  const ProgramResult plain = expect_done({"fit", file("a.vdb"), "--count", "4", "--color", "none",
                                           "--emission", "none", "-o", file("c.csv")});
  EXPECT_FALSE(Json::parse(plain.out).contains("extinction_error"));
  for (const Gaussian& g : read_gaussians(file("c.csv"))) EXPECT_EQ(g.optics, GaussianOptics());
  EXPECT_FALSE(contains(content_of(file("c.csv")), "albedo"));
}

// Another program reads the analytic values at the voxels, to the last bit of what is stored.
TEST_F(VolumeColorCommands, ExportedVolumesAreReadByOpenVdbInPython) {
  const std::string scene =
      folder_.write_scene("colors.brume", R"("medium": { "albedo": [0.9, 0.8, 0.7], "gaussians": [
      { "center": [0, 0, 0], "radius": 1, "density": 0.5, "emission": [3, 2, 100000] },
      { "center": [1, 0, 0], "radius": 0.5, "density": 2, "albedo": [1, 0.5, 0.25] } ] })");
  for (const char* precision : {"float", "half"}) {
    std::vector<std::string> arguments{"export", scene, "-o", file("m.vdb"), "--voxel", "0.2"};
    if (precision == std::string("half")) arguments.push_back("--half");
    expect_done(arguments);
    const std::string command = quoted(BRUME_PYTHON) + " " + quoted(BRUME_READ_VOLUME) + " " +
                                quoted(file("m.vdb")) + " 0.2 " + precision +
                                " 0,0,0,1,0.5,0.9,0.8,0.7,3,2,100000" +
                                " 1,0,0,0.5,2,1,0.5,0.25,0,0,0 > " + quoted(file("voxels"));
    ASSERT_EQ(std::system(command.c_str()), 0) << "Debian's python3-openvdb is needed";
    EXPECT_GT(std::stoi(content_of(file("voxels"))), 10'000);
  }
  const Json info = Json::parse(run_brume({"info", "--json", file("m.vdb")}).out);
  ASSERT_EQ(info["grids"].size(), 3u);
  EXPECT_EQ(info["grids"][1]["name"], "albedo");
  EXPECT_EQ(info["grids"][2]["name"], "emission");
  // Seven channels count where one did.
  const ProgramResult fine = run_brume({"export", scene, "-o", file("n.vdb"), "--voxel", "0.01"});
  EXPECT_EQ(fine.exit_code, 2);
  EXPECT_TRUE(contains(fine.err, "a larger --voxel"));
}

openvdb::FloatGrid::Ptr ball(const char* name, double x, double peak) {
  return vdb_cube<openvdb::FloatGrid>(name, 12, 0.1, [=](const glm::dvec3& p) {
    const glm::dvec3 d = (p - glm::dvec3(x, 0.0, 0.0)) / 0.3;
    return static_cast<float>(peak * std::exp(-glm::dot(d, d)));
  });
}

TEST_F(VolumeColorCommands, FireShinesFrameByFrame) {
  for (const int frame : {1, 2}) {
    const std::string name = "fire_" + std::to_string(frame) + ".vdb";
    write_vdb(file(name.c_str()),
              {ball("density", 0.5, 1.0), ball("flame", -0.5, 1.0), ball("temperature", 0.5, 1.5)});
  }
  const ProgramResult result =
      expect_done({"fit", file("fire_%d.vdb"), "--frames", "1-2", "--count", "12", "--flame-scale",
                   "0.5", "--emission-scale", "2", "--flame-temperature", "2000",
                   "--temperature-scale", "1000", "-o", file("fire_%d.ply")});
  const Json line = Json::parse(result.out.substr(0, result.out.find('\n')));
  EXPECT_EQ(line["gaussians"], 12);
  EXPECT_GT(line["flames"], 3);
  EXPECT_LT(line["flame_error"], 0.1);
  EXPECT_TRUE(line.contains("emission_error"));
  for (const char* name : {"fire_1.ply", "fire_2.ply"}) {
    double hottest = 0.0;
    int flames = 0;
    for (const Gaussian& g : read_gaussians(file(name))) {
      if (g.optics.albedo) {
        ++flames;
        const glm::dvec3 radiance = 2.0 * black_body_radiance(2000.0);
        EXPECT_LT(glm::length(g.optics.emission - radiance), 1e-4 * glm::length(radiance));
      } else {
        hottest = std::max(hottest, g.optics.emission.r);
      }
    }
    EXPECT_EQ(flames, line["flames"]);
    EXPECT_GT(hottest, 0.0);
  }
}

TEST_F(VolumeColorCommands, RefusesOtherGridsAndNumbers) {
  write_vdb(file("a.vdb"), {ball("density", 0.0, 1.0), ball("heat_of_day", 0.0, 9e4)});
  const auto refused = [&](const std::vector<std::string>& options,
                           const std::vector<std::string>& parts) {
    expect_refused(joined({"fit", file("a.vdb"), "-o", file("b.ply")}, options), parts);
    EXPECT_FALSE(std::filesystem::exists(file("b.ply")));
  };
  refused({"--color", "Cd"}, {"a.vdb", "has no grid Cd", "density, heat_of_day"});
  refused({"--color", "density"}, {"a.vdb: density", "float", "three numbers each"});
  refused({"--temperature", "heat_of_day"}, {"heat_of_day", "up to 40000 K"});
  refused({"--flame", "none", "--grid", "none"}, {"a.vdb", "has no flames"});
  refused({"--temperature-scale", "0"}, {"--temperature-scale"});
  refused({"--flame-temperature", "100"}, {"--flame-temperature"});
}

}  // namespace

}  // namespace brume
