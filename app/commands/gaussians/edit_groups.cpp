#include "app/commands/gaussians/edit_groups.h"

#include <algorithm>
#include <array>
#include <set>

#include "app/commands/allowed_name.h"
#include "app/commands/gaussians/select_command.h"
#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "brume/limits.h"

namespace brume {
namespace {

// New groups take these in turn, linear RGB: apart in hue, alike in lightness.
constexpr std::array colors{glm::dvec3(0.10, 0.52, 0.90), glm::dvec3(0.95, 0.38, 0.08),
                            glm::dvec3(0.20, 0.68, 0.16), glm::dvec3(0.85, 0.16, 0.45),
                            glm::dvec3(0.85, 0.62, 0.06), glm::dvec3(0.42, 0.24, 0.90),
                            glm::dvec3(0.06, 0.62, 0.52), glm::dvec3(0.60, 0.30, 0.15)};

QString name_of(const Group& group) {
  return QString::fromStdString(group.name);
}

Group* find(Groups& groups, GroupId id) {
  const auto found = std::ranges::find(groups, id, &Group::id);
  return found == groups.end() ? nullptr : &*found;
}

void push(Document& document, Groups groups, MediumEdit edit, const QString& text) {
  if (groups == document.scene().groups && edit.empty()) return;
  document.undo_stack().push(
      new ScenePartCommand(document, {std::move(groups)}, std::move(edit), text));
}

// Puts Gaussians into the groups that `group_of` gives.
MediumEdit regrouped(const Document& document, const std::vector<GaussianId>& ids,
                     const std::function<GroupId(const Gaussian&)>& group_of) {
  std::vector<Gaussian> after = document.gaussians(ids);
  for (Gaussian& gaussian : after) gaussian.group = group_of(gaussian);
  return MediumEdit::change(document.medium(), ids, after);
}

// The group one level up.
GroupId outer_group(const Document& document, GroupId group) {
  const Group* found = find_group(document.scene().groups, group);
  return found ? found->parent : 0;
}

// The top-level group that all of the selection is in.
GroupId common_outer_group(const Document& document) {
  std::set<GroupId> found;
  for (const GaussianId id : document.selection()) {
    const GroupId group = document.medium().group(*document.medium().index_of(id));
    const GroupId outer = outer_group(document, group);
    found.insert(outer != 0 ? outer : group);
    if (found.size() > 1) return 0;
  }
  return found.empty() ? 0 : *found.begin();
}

bool has_member(const Medium& medium, GroupId group) {
  for (std::size_t i = 0; i < medium.size(); ++i) {
    if (medium.group(i) == group) return true;
  }
  return false;
}

}  // namespace

void select_group(Document& document, GroupId group) {
  document.set_active_group(group);
  select_gaussians(document, members_of(document.scene(), group));
}

void group_selection(Document& document, const QString& name) {
  Groups groups = document.scene().groups;
  if (groups.size() >= limits::groups) return;
  Group group;
  group.id = new_id(groups);
  const QString wanted = allowed_name(name, 10);  // with room for a number
  group.name = free_name(groups, wanted.isEmpty() ? undo_text("Group") : wanted, group.id);
  group.color = colors[groups.size() % colors.size()];
  group.parent = common_outer_group(document);
  groups.push_back(group);
  const std::vector<GaussianId> ids = document.selection();
  push(
      document, std::move(groups),
      regrouped(document, ids, [&](const Gaussian&) { return group.id; }),
      ids.empty() ? undo_text("Add group") : undo_text("Group %1").arg(gaussians_text(ids.size())));
  document.set_active_group(group.id);
}

bool can_ungroup_selection(const Document& document) {
  return std::ranges::any_of(document.selection(), [&](GaussianId id) {
    return document.medium().group(*document.medium().index_of(id)) != 0;
  });
}

void ungroup_selection(Document& document) {
  if (!can_ungroup_selection(document)) return;
  const std::vector<GaussianId> ids = document.selection();
  MediumEdit edit = regrouped(document, ids, [&](const Gaussian& gaussian) {
    return outer_group(document, gaussian.group);
  });
  Medium after = document.medium();
  edit.apply(after);
  std::set<GroupId> left;
  for (const auto& change : edit.changed()) left.insert(change.before.group);
  Groups groups = document.scene().groups;
  for (const GroupId group : left) {
    const bool has_groups =
        std::ranges::any_of(groups, [&](const Group& other) { return other.parent == group; });
    if (has_groups || has_member(after, group)) continue;
    std::erase_if(groups, [&](const Group& other) { return other.id == group; });
  }
  push(document, std::move(groups), std::move(edit),
       undo_text("Ungroup %1").arg(gaussians_text(ids.size())));
}

void move_selection_to_group(Document& document, GroupId group) {
  const Groups& groups = document.scene().groups;
  const Group* target = find_group(groups, group);
  if (!target && group != 0) return;
  const std::vector<GaussianId> ids = document.selection();
  const QString gaussians = gaussians_text(ids.size());
  push(document, groups, regrouped(document, ids, [&](const Gaussian&) { return group; }),
       target ? undo_text("Move %1 to %2").arg(gaussians, name_of(*target))
              : undo_text("Move %1 out of groups").arg(gaussians));
}

void dissolve_group(Document& document, GroupId group) {
  Groups groups = document.scene().groups;
  const Group* found = find(groups, group);
  if (!found) return;
  const QString text = undo_text("Ungroup %1").arg(name_of(*found));
  const GroupId outer = found->parent;
  std::vector<GaussianId> ids;
  const Medium& medium = document.medium();
  for (std::size_t i = 0; i < medium.size(); ++i) {
    if (medium.group(i) == group) ids.push_back(medium.ids()[i]);
  }
  std::erase_if(groups, [&](const Group& other) { return other.id == group; });
  for (Group& other : groups) {
    if (other.parent == group) other.parent = outer;
  }
  push(document, std::move(groups),
       regrouped(document, ids, [&](const Gaussian&) { return outer; }), text);
}

void delete_group(Document& document, GroupId group) {
  Groups groups = document.scene().groups;
  const Group* found = find(groups, group);
  if (!found) return;
  const QString text = undo_text("Delete %1").arg(name_of(*found));
  std::erase_if(groups,
                [&](const Group& other) { return other.id == group || other.parent == group; });
  push(document, std::move(groups),
       MediumEdit::remove(document.medium(), members_of(document.scene(), group)), text);
}

void rename_group(Document& document, GroupId group, const QString& name) {
  rename_one(document, document.scene().groups, group, name);
}

bool can_nest(const Document& document, GroupId group, GroupId parent) {
  const Groups& groups = document.scene().groups;
  const Group* inner = find_group(groups, group);
  if (!inner || inner->parent == parent) return false;
  if (parent == 0) return true;
  const Group* outer = find_group(groups, parent);
  const bool has_groups =
      std::ranges::any_of(groups, [&](const Group& other) { return other.parent == group; });
  return outer && outer->parent == 0 && parent != group && !has_groups;
}

void nest_group(Document& document, GroupId group, GroupId parent) {
  if (!can_nest(document, group, parent)) return;
  Groups groups = document.scene().groups;
  Group* inner = find(groups, group);
  const Group* outer = find(groups, parent);
  inner->parent = parent;
  const QString text = outer ? undo_text("Move %1 into %2").arg(name_of(*inner), name_of(*outer))
                             : undo_text("Move %1 out of its group").arg(name_of(*inner));
  set_scene_part(document, std::move(groups), text);
}

void change_group(Document& document, GroupId group, const QString& verb, MergeId merge_id,
                  const std::function<void(Group&)>& change) {
  Groups groups = document.scene().groups;
  Group* found = find(groups, group);
  if (!found) return;
  const QString text = verb.arg(name_of(*found));
  change(*found);
  set_scene_part(document, std::move(groups), text, merge_id);
}

GroupId group_of_new(const Document& document) {
  const Group* group = document.active_group();
  return group ? group->id : 0;
}

QString adding_problem(const Document& document) {
  const Group* group = document.active_group();
  if (!group) return {};
  const GroupEffect& effect = document.group_effects().of(group->id);
  if (effect.visible && !effect.locked) return {};
  const QString text = effect.visible
                           ? undo_text(
                                 "The active group “%1” is locked: nothing is added to it. "
                                 "Unlock it or choose another in the outliner.")
                           : undo_text(
                                 "The active group “%1” is hidden: nothing is added to it. "
                                 "Show it or choose another in the outliner.");
  return text.arg(name_of(*group));
}

}  // namespace brume
