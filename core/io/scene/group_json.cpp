#include "core/io/scene/group_json.h"

#include <algorithm>

#include "brume/limits.h"
#include "core/io/scene/fields_json.h"
#include "core/io/text_scanner.h"
#include "core/scene/fields/group_fields.h"
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
  static_cast<void>(object.find("parent"));  // known, but read later
  read_fields(object, group);
  return group;
}

void read_parents(JsonContext& context, const Json::array_t& elements, const JsonPath& path,
                  std::vector<Group>& groups) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    JsonObject object(context, elements[i], path.element(i));
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
  Json json{{"name", group.name}};
  if (const Group* parent = find_group(groups, group.parent)) json["parent"] = parent->name;
  write_fields(json, group, group.keys);
  return json;
}

}  // namespace brume
