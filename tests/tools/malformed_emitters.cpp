#include "tests/tools/malformed_scenes.h"

namespace brume {

std::vector<MalformedCase> malformed_emitters() {
  using Values = std::vector<const char*>;
  const Values no_number{"\"1\"", "null", "true", "[1]", "{}", "-1", "1e300"};
  const Values no_pair{"1",          "null", "[1]",     "[1, 2, 3]",
                       "[1, \"2\"]", "{}",   "[-1, 1]", "[1, 1e300]"};
  const Values no_vector{
      "1", "\"1 2 3\"", "null", "[1, 2]", "[1, 2, 3, 4]", "[1, null, 3]", "[1e300, 0, 0]"};
  const Values no_emission{"1", "null", "\"red\"", "[1, 2]", "[1, 2, -1e-300]", "[1, 1e21, 1]"};
  const Values no_albedo{"1", "null", "\"red\"", "[1, 1]", "[1, 1, 0]", "[1, 1, 1.0001]"};
  const std::vector<std::pair<std::string, const Values&>> keys{{"position", no_vector},
                                                                {"rate", no_number},
                                                                {"lifetime", no_number},
                                                                {"velocity", no_vector},
                                                                {"spread", no_number},
                                                                {"acceleration", no_vector},
                                                                {"radius", no_pair},
                                                                {"density", no_pair},
                                                                {"albedo", no_albedo},
                                                                {"emission", no_emission},
                                                                {"emission_at_death", no_emission}};
  std::vector<MalformedCase> all;
  const auto add = [&](const std::string& name, const std::string& members,
                       const std::string& place) {
    all.push_back({name, scene_with_emitter(members), "medium.emitters[0]." + place, {"allowed"}});
  };
  for (const auto& [key, bad_values] : keys) {
    const std::string position = key == "position" ? "" : R"("position": [0, 0, 0], )";
    for (const std::string bad : bad_values) {
      add("emitter with " + key + " " + bad, position + '"' + key + "\": " + bad, key);
      // Only one with an albedo has keyframes of it.
      const std::string albedo = key == "albedo" ? R"("albedo": [1, 1, 1], )" : "";
      add("emitter with a keyframe of " + key + " " + bad,
          R"("position": [0, 0, 0], )" + albedo + R"("keys": {")" + key +
              R"(": [{"time": 0, "value": )" + bad + "}]}",
          "keys." + key + "[0].value");
    }
  }
  return all;
}

}  // namespace brume
