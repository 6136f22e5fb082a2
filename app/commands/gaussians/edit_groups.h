#pragma once

#include <QString>
#include <functional>

#include "app/commands/merge_id.h"
#include "brume/group.h"

namespace brume {

class Document;

// Edits of groups of Gaussians, each one undo step. Ids of groups that are not there change
// nothing.

// Selects those that can be selected, and makes the group the active one.
void select_group(Document& document, GroupId group);

// Makes a group of the selection, which becomes the active one. It is in the group that all of the
// selection is in, if that is in none itself. `name`: as of rename_group(); empty: "Group".
void group_selection(Document& document, const QString& name = {});
// Takes the selection out of its groups, one level each; groups that this empties go.
void ungroup_selection(Document& document);
// Whether that would do anything.
bool can_ungroup_selection(const Document& document);
// 0: out of all groups.
void move_selection_to_group(Document& document, GroupId group);

// Removes a group, its Gaussians and groups go one level up.
void dissolve_group(Document& document, GroupId group);
// Removes a group with its Gaussians and the groups in it.
void delete_group(Document& document, GroupId group);

// Without blanks at its ends; numbered if another group has the name. An empty one changes nothing.
void rename_group(Document& document, GroupId group, const QString& name);
// 0: into none. Only where groups stay nested once, see can_nest().
void nest_group(Document& document, GroupId group, GroupId parent);
bool can_nest(const Document& document, GroupId group, GroupId parent);
// `verb` is the text of the step, with %1 for the group's name.
void change_group(Document& document, GroupId group, const QString& verb, MergeId merge_id,
                  const std::function<void(Group&)>& change);

// The group of what is painted, pasted and added: the active one; 0: none.
GroupId group_of_new(const Document& document);
// Why nothing can be added to it; empty: it can.
QString adding_problem(const Document& document);

}  // namespace brume
