#include "tests/tools/malformed_scenes.h"

namespace brume {

std::vector<MalformedCase> malformed_groups() {
  using Values = std::vector<const char*>;
  const Values no_factor{"\"1\"", "null", "true", "[1]", "{}", "-1", "1e300"};
  const Values no_length{"\"1\"", "null", "0", "-1", "1e300"};
  const Values no_number{"\"1\"", "null", "true", "[1]", "1e300"};
  const Values no_factors{"1", "null", "[1, 2]", "[1, 2, -1]", "[1, 1e300, 1]"};
  const Values no_offsets{"0", "null", "[0, 0]", "[0, 0, -1.5]", "[1.5, 0, 0]"};
  const std::vector<std::pair<std::string, const Values&>> keyed{
      {"density_factor", no_factor}, {"density_offset", no_number}, {"radius_factor", no_length},
      {"radius_offset", no_number},  {"albedo_factor", no_factors}, {"albedo_offset", no_offsets}};
  std::vector<MalformedCase> all;
  const auto add = [&](const std::string& name, const std::string& members,
                       const std::string& place) {
    all.push_back({"group with " + name, scene_with_groups(R"([{"name": "a"}, {)" + members + "}]"),
                   "medium.groups[1]." + place});
  };
  for (const auto& [key, bad_values] : keyed) {
    for (const std::string bad : bad_values) {
      add(key + " " + bad, R"("name": "b", ")" + key + "\": " + bad, key);
      add("a keyframe of " + key + " " + bad,
          R"("name": "b", "keys": {")" + key + R"(": [{"time": 0, "value": )" + bad + "}]}",
          "keys." + key + "[0].value");
    }
  }
  add("no name", R"("visible": true)", "name");
  for (const std::string bad : {"1", "null", "\"\"", "[\"b\"]", "\"a\""}) {
    add("name " + bad, R"("name": )" + bad, "name");
  }
  add("a long name", R"("name": ")" + std::string(300, 'x') + '"', "name");
  for (const std::string bad : {"1", "null", "\"red\"", "[0, 0]", "[0, 0, 2]", "[-1, 0, 0]"}) {
    add("color " + bad, R"("name": "b", "color": )" + bad, "color");
  }
  for (const std::string key : {"visible", "locked"}) {
    for (const std::string bad : {"1", "null", "\"no\"", "[]"}) {
      add(key + " " + bad, R"("name": "b", ")" + key + "\": " + bad, key);
    }
  }
  for (const std::string bad : {"1", "null", "\"c\"", "\"\"", "\"b\""}) {
    add("parent " + bad, R"("name": "b", "parent": )" + bad, "parent");
  }
  add("a parent that is in a group", R"("name": "b", "parent": "a"}, {"name": "c", "parent": "b")",
      "");
  all.back().place = "medium.groups[2].parent";
  for (const std::string bad : {"1", "null", "\"b\"", "\"\"", "[\"a\"]"}) {
    all.push_back({"a Gaussian in group " + bad,
                   scene_with_groups(R"([{"name": "a"}], "gaussians": [{"center": [0, 0, 0],
                     "radius": 1, "density": 1, "group": )" +
                                     bad + "}]"),
                   "medium.gaussians[0].group"});
  }
  for (const std::string bad : {"1", "null", "{}", "\"a\"", "[1]", "[null]"}) {
    all.push_back({"groups " + bad, scene_with_groups(bad), "medium.groups"});
  }
  return all;
}

}  // namespace brume
