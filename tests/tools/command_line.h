#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/io/image/image_file.h"
#include "tests/contains.h"
#include "tests/tools/run_program.h"

namespace brume {

inline constexpr const char* scene_text = R"({
  "format": "brume-scene", "version": 1,
  "camera": { "eye": [0, 0, 5], "target": [0, 0, 0] }, "film": { "width": 24, "height": 18 },
  "medium": { "density": 0.02, "gaussians": [
    { "center": [0, 0, 0], "radius": 1, "density": 0.5 },
    { "center": [1, 0, 0], "radius": 0.5, "density": 2 } ] },
  "lights": [ { "type": "point", "position": [2, 2, 2], "intensity": [30, 20, 10] } ],
  "surfaces": [ { "mesh": "floor.obj" } ]
})";

// Arguments and some more.
inline std::vector<std::string> joined(std::vector<std::string> arguments,
                                       const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

// The words of a text as arguments.
inline std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

// Runs `brume`, which ends well.
inline ProgramResult expect_done(const std::vector<std::string>& arguments) {
  ProgramResult result = run_brume(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return result;
}

class CommandLine : public ::testing::Test {
 protected:
  CommandLine() {
    scene_ = folder_.write("a.brume", scene_text);
    folder_.write("floor.obj", "v -2 -1 -2\nv -2 -1 2\nv 2 -1 2\nv 2 -1 -2\nf 1 2 3 4\n");
  }

  [[nodiscard]] std::string file(const char* name) const { return (folder_ / name).string(); }

  // Exit code 2 and one line on standard error that holds all of `parts`.
  static void expect_refused(const std::vector<std::string>& arguments,
                             const std::vector<std::string>& parts) {
    const ProgramResult result = run_brume(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_TRUE(result.err.starts_with("brume: error: ")) << result.err;
    for (const std::string& part : parts) {
      EXPECT_TRUE(contains(result.err, part)) << part << " in " << result.err;
    }
  }

  // An image of one pixel and the channels given.
  void write_image(const char* name, const std::map<std::string, float>& channels) const {
    ImageLayers image;
    image.width = image.height = 1;
    for (const auto& [channel, value] : channels) image.channels[channel] = {value};
    write_exr(folder_ / name, image);
  }

  TemporaryFolder folder_;
  std::string scene_;
};

}  // namespace brume
