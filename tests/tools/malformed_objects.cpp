#include "core/scene/fields/group_fields.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/fields/material_fields.h"
#include "tests/tools/malformed_fields.h"
#include "tests/tools/malformed_scenes.h"

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

std::vector<MalformedCase> malformed_keys() {
  using Values = std::vector<const char*>;
  std::vector<MalformedCase> all;
  const auto add = [&all](const std::string& value, const std::string& key,
                          const std::string& place) {
    all.push_back({"a surface's keyframe of " + value + " " + key,
                   scene_with_surface(R"("mesh": "good.obj", "material": {"type": "phong"},
                     "keys": {")" + value +
                                      R"(": [{"time": 0, )" + key + "}]}"),
                   "surfaces[1].keys." + value + "[0]." + place});
  };
  const Values no_numbers{"null", "1", "\"1\"", "[1, 2]", "[1, 2, \"3\"]", "[1, 2, 1e300]"};
  const Values no_rotation{
      "null", "1", "[1, 0, 0]", "[0, 0, 0, 0]", "[2, 0, 0, 0]", "[1, 0, 0, 1e300]"};
  const Values no_length{"null", "[1]", "0", "-1", "1e300"};
  const std::vector<std::pair<std::string, const Values&>> values{
      {"translate", no_numbers}, {"rotate", no_rotation}, {"scale", no_length}};
  for (const auto& [name, bad_values] : values) {
    add(name, R"("interpolation": "linear")", "value");
    for (const std::string bad : bad_values) add(name, R"("value": )" + bad, "value");
  }
  visit_fields<Material>([&](const auto& field) {
    for (const std::string& bad : malformed_values(field)) {
      add(field.info.name, R"("value": )" + bad, "value");
      all.push_back({"a material with " + std::string(field.info.name) + " " + bad,
                     scene_with_surface(R"("mesh": "good.obj", "material": {"type": "phong", ")" +
                                        std::string(field.info.name) + "\": " + bad + "}"),
                     "surfaces[1].material." + std::string(field.info.name),
                     {"; allowed: "}});
    }
  });
  for (const std::string tangent : {"in", "out"}) {
    for (const std::string bad : {"null", "[1]", "\"0\"", "true", "1e31", "-1e300"}) {
      add("scale", R"("value": 1, ")" + tangent + "\": " + bad, tangent);
    }
    for (const std::string bad : no_numbers) {
      add("translate", R"("value": [0, 0, 0], ")" + tangent + "\": " + bad, tangent);
    }
  }
  for (const std::string bad : {"null", "1", "\"yes\""}) {
    add("scale", R"("value": 1, "aligned": )" + bad, "aligned");
  }
  add("scale", R"("value": 1, "interpolation": "free")", "interpolation");
  all.back().said = {"\"smooth\", \"linear\", \"constant\""};
  for (const std::string bad : {"null", "1", "[]", "\"none\""}) {
    all.push_back({"a surface with keys " + bad,
                   scene_with_surface(R"("mesh": "good.obj", "keys": )" + bad),
                   "surfaces[1].keys"});
  }
  all.push_back({"a surface's keyframes in no order",
                 scene_with_surface(R"("mesh": "good.obj", "keys": {"rotate": [
                   {"time": 1, "value": [1, 0, 0, 0]}, {"time": 1, "value": [0, 1, 0, 0]}]})"),
                 "surfaces[1].keys.rotate[1].time",
                 {"1 after 1"}});
  return all;
}

std::vector<MalformedCase> malformed_lights() {
  std::vector<MalformedCase> all;
  const auto add_values = [&all]<class Owner>(const std::string& type, const Owner&) {
    const std::vector<MalformedCase> cases =
        malformed_fields<Owner>("lights[0]", [&type](const std::string& members) {
          return scene_with_light("\"type\": " + type + ", " + members);
        });
    all.insert(all.end(), cases.begin(), cases.end());
  };
  visit_light_kinds([&](const LightKindInfo& info, const auto& kind) {
    add_values('"' + std::string(info.name) + '"', kind);
  });
  const std::string point = R"("point", "position": [0, 1, 0])";
  add_values(point, Light());
  add_values(point + R"(, "profile": "good.ies")", LightProfile());
  for (const char* type : {"point", "spot"}) {
    for (const char* bad : {"1", "null", "[]", "{}", "\"\"", "\"none.ies\"", "\"..\"", "true"}) {
      const std::string members =
          std::string(R"("type": ")") + type +
          R"(", "position": [0, 1, 0], "direction": [0, -1, 0], "profile": )";
      all.push_back({std::string(type) + " with profile " + bad, scene_with_light(members + bad),
                     "lights[0].profile"});
    }
  }
  for (const char* type : {"\"area\"", "\"Point\"", "\"\"", "1", "null", "[\"point\"]"}) {
    all.push_back({std::string("a light of type ") + type,
                   scene_with_light(std::string(R"("position": [0, 0, 0], "type": )") + type),
                   "lights[0].type",
                   {"allowed"}});
  }
  return all;
}

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
