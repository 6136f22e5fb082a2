#include "tests/tools/malformed_scenes.h"

namespace brume {

std::vector<MalformedCase> malformed_splines() {
  using Values = std::vector<const char*>;
  const Values no_length{"\"1\"", "null", "0", "-1", "1e300"};
  const Values no_share{"\"1\"", "null", "true", "-0.1", "1.1"};
  const Values no_boolean{"1", "null", "\"no\"", "[]"};
  const Values no_albedo{"1", "null", "[1, 2]", "[0, 1, 1]", "[1, 1, 2]"};
  const Values no_place{"1", "null", "[1, 2]", "[1, 1e300, 1]"};
  const std::vector<std::pair<std::string, Values>> bad_values{
      {"name", {"1", "null", "\"\"", "\"a\"", "[\"b\"]"}},
      {"radius", no_length},
      {"density", {"\"1\"", "null", "-1", "1e300"}},
      {"spacing", {"\"1\"", "0", "101"}},
      {"scatter", {"\"1\"", "-1", "11"}},
      {"falloff", no_share},
      {"flow", no_share},
      {"jitter", no_share},
      {"seed", {"\"1\"", "null", "0.5", "1e300"}},
      {"mirror_x", no_boolean},
      {"mirror_y", no_boolean},
      {"mirror_z", no_boolean},
      {"mirror_center", no_place},
      {"albedo", no_albedo},
      {"emission", {"1", "null", "[1, 2]", "[0, -1, 0]"}},
      {"points", {"1", "null", "{}", "[]"}}};
  const std::vector<std::pair<std::string, std::string>> good{
      {"name", "\"b\""}, {"points", "[[0, 0, 0]]"}, {"radius", "1"}, {"density", "1"}};
  const std::string first =
      R"([{"name": "a", "points": [[0, 0, 0]], "radius": 1, "density": 1}, {)";
  std::vector<MalformedCase> all;
  // One with a value in place of a good one, or without it.
  const auto add = [&](const std::string& key, const std::string& bad, const std::string& place) {
    std::string members;
    const auto append = [&members](const std::string& name, const std::string& value) {
      members += (members.empty() ? "\"" : ", \"") + name + "\": " + value;
    };
    for (const auto& [name, value] : good) {
      if (name != key) append(name, value);
    }
    if (!bad.empty()) append(key, bad);
    all.push_back({"spline with " + key + " " + bad, scene_with_splines(first + members + "}]"),
                   "medium.splines[1]." + place});
  };
  for (const auto& [key, values] : bad_values) {
    for (const std::string bad : values) {
      const bool is_vector =
          bad == "[0, 1, 1]" || bad == "[1, 1, 2]" || bad == "[0, -1, 0]" || bad == "[1, 1e300, 1]";
      const std::string element = bad == "[0, 1, 1]" ? "[0]" : bad == "[1, 1, 2]" ? "[2]" : "[1]";
      add(key, bad, key + (is_vector ? element : ""));
    }
  }
  for (const auto& [key, value] : good) add(key, "", key);
  for (const std::string bad : {"1", "null", "[0, 0]", "\"0 0 0\""}) {
    add("points", "[[0, 0, 0], " + bad + "]", "points[1]");
  }
  add("points", "[[0, 0, \"0\"]]", "points[0][2]");
  std::string many = "[[0, 0, 0]";
  for (int k = 0; k < 1024; ++k) many += ", [0, 0, 0]";
  add("points", many + "]", "points");
  for (const std::string bad : {"1", "null", "\"b\"", "\"\"", "[\"a\"]"}) {
    all.push_back({"a Gaussian of spline " + bad,
                   scene_with_splines(R"([], "gaussians": [{"center": [0, 0, 0], "radius": 1,
                     "density": 1, "spline": )" +
                                      bad + "}]"),
                   "medium.gaussians[0].spline"});
  }
  for (const std::string bad : {"1", "null", "{}", "\"a\""}) {
    all.push_back({"splines " + bad, scene_with_splines(bad), "medium.splines"});
  }
  return all;
}

}  // namespace brume
