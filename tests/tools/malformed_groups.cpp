#include "core/scene/fields/group_fields.h"
#include "tests/tools/malformed_fields.h"

namespace brume {

std::vector<MalformedCase> malformed_groups() {
  std::vector<MalformedCase> all =
      malformed_fields<Group>("medium.groups[1]", [](const std::string& members) {
        return scene_with_groups(R"([{"name": "a"}, {"name": "b", )" + members + "}]");
      });
  const auto add = [&](const std::string& name, const std::string& members,
                       const std::string& place) {
    all.push_back({"group with " + name, scene_with_groups(R"([{"name": "a"}, {)" + members + "}]"),
                   "medium.groups[1]." + place});
  };
  add("no name", R"("visible": true)", "name");
  for (const std::string bad : {"1", "null", "\"\"", "[\"b\"]", "\"a\""}) {
    add("name " + bad, R"("name": )" + bad, "name");
  }
  add("a long name", R"("name": ")" + std::string(300, 'x') + '"', "name");
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
