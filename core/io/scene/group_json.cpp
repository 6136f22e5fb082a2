#include "core/io/scene/group_json.h"

#include <algorithm>

#include "brume/limits.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"
#include "core/scene/group_effects.h"

namespace brume {
namespace {

std::string read_name(JsonObject& object, const std::vector<Group>& groups) {
  std::string name = object.name({});
  if (std::ranges::find(groups, name, &Group::name) != groups.end()) {
    object.fail("name",
                "found " + quoted_text(name) + " again; allowed: a name that no other group has");
  }
  return name;
}

}  // namespace

Group read_group(JsonObject& object, const std::vector<Group>& groups) {
  Group group;
  group.id = static_cast<GroupId>(groups.size() + 1);
  group.name = read_name(object, groups);
  group.color = object.vector("color", domain::unit, group.color);
  static_cast<void>(object.find("parent"));  // known, but read later
  group.visible = object.boolean("visible", group.visible);
  group.locked = object.boolean("locked", group.locked);
  group.density_factor =
      object.number("density_factor", domain::not_negative, group.density_factor);
  group.density_offset = object.number("density_offset", domain::coordinate, group.density_offset);
  group.radius_factor = object.number("radius_factor", domain::length, group.radius_factor);
  group.radius_offset = object.number("radius_offset", domain::coordinate, group.radius_offset);
  group.albedo_factor = object.vector("albedo_factor", domain::not_negative, group.albedo_factor);
  group.albedo_offset = object.vector("albedo_offset", domain::albedo_offset, group.albedo_offset);
  return group;
}

void read_parents(JsonContext& context, const Json::array_t& elements, const JsonPath& path,
                  std::vector<Group>& groups) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const JsonPath element = path.element(i);
    JsonObject object(context, elements[i], element);
    groups[i].parent = read_group_name(object, "parent", groups);
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Group* parent = find_group(groups, groups[i].parent);
    if (!parent || (parent != &groups[i] && parent->parent == 0)) continue;
    context.fail(path.element(i).member("parent"),
                 "found " + quoted_text(parent->name) +
                     "; allowed: another group that is in no group itself");
  }
}

GroupId read_group_name(JsonObject& object, const char* key, const std::vector<Group>& groups) {
  if (object.find(key) == nullptr) return 0;
  const std::string name = object.text(key, {});
  const auto found = std::ranges::find(groups, name, &Group::name);
  if (found == groups.end()) {
    object.fail(key, "found " + quoted_text(name) + "; allowed: the name of one of medium.groups");
  }
  return found->id;
}

Json group_to_json(const Group& group, const std::vector<Group>& groups) {
  const Group plain;
  Json json{{"name", group.name}, {"color", to_json(group.color)}};
  if (const Group* parent = find_group(groups, group.parent)) json["parent"] = parent->name;
  if (!group.visible) json["visible"] = false;
  if (group.locked) json["locked"] = true;
  const auto add = [&json](const char* key, const auto& value, const auto& usual) {
    if (value == usual) return;
    if constexpr (requires { value.x; }) {
      json[key] = to_json(value);
    } else {
      json[key] = value;
    }
  };
  add("density_factor", group.density_factor, plain.density_factor);
  add("density_offset", group.density_offset, plain.density_offset);
  add("radius_factor", group.radius_factor, plain.radius_factor);
  add("radius_offset", group.radius_offset, plain.radius_offset);
  add("albedo_factor", group.albedo_factor, plain.albedo_factor);
  add("albedo_offset", group.albedo_offset, plain.albedo_offset);
  return json;
}

}  // namespace brume
