#include "tests/tools/malformed_scenes.h"

namespace brume {

std::vector<MalformedCase> malformed_primitives() {
  std::vector<MalformedCase> all;
  const auto add = [&all](const std::string& members, const std::string& place,
                          const std::string& said) {
    all.push_back(
        {"surface of " + members, scene_with_surface(members), "surfaces[1]." + place, {said}});
  };
  const auto primitive = [](const std::string& members) {
    return R"("primitive": {)" + members + "}";
  };
  add(R"("mesh": "good.obj", "primitive": {"type": "box"})", "mesh", "one of both");
  for (const char* value : {"3", "null", "[]", "\"box\""}) {
    add(R"("primitive": )" + std::string(value), "primitive", "an object");
  }
  add(primitive(""), "primitive.type", "missing");
  for (const char* value : {"1", "null", "\"cone\"", "\"Box\""}) {
    add(primitive(R"("type": )" + std::string(value)), "primitive.type", "\"cylinder\"");
  }
  for (const char* value : {"[0, 1, 1]", "[-1, 1, 1]", "[1e13, 1, 1]"}) {
    add(primitive(R"("type": "box", "size": )" + std::string(value)), "primitive.size[0]", "> 0");
  }
  for (const char* value : {"1", "[1, 1]", "\"1 1 1\"", "null"}) {
    add(primitive(R"("type": "box", "size": )" + std::string(value)), "primitive.size",
        "3 numbers");
  }
  const std::string mesh = R"("mesh": "good.obj", )";
  for (const char* value : {"3", "null", "[\"a\"]"}) {
    add(mesh + R"("name": )" + value, "name", "a string");
  }
  add(mesh + R"("name": ")" + std::string(257, 'x') + '"', "name", "0 to 256");
  add(mesh + R"("name": "a\nb")", "name", "control characters");
  for (const char* value : {"1", "null", "\"yes\""}) {
    add(mesh + R"("locked": )" + value, "locked", "true or false");
  }
  return all;
}

}  // namespace brume
