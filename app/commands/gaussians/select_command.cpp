#include "app/commands/gaussians/select_command.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "core/authoring/neighbours.h"
#include "core/math/infinity.h"

namespace brume {
namespace {

std::vector<GaussianId> without(const std::vector<GaussianId>& ids,
                                const std::vector<GaussianId>& others) {
  std::vector<GaussianId> rest;
  std::set_difference(ids.begin(), ids.end(), others.begin(), others.end(),
                      std::back_inserter(rest));
  return rest;
}

// Selects those of the medium, by their index, that `is_chosen`.
template <class IsChosen>
void select_if(Document& document, IsChosen is_chosen) {
  std::vector<GaussianId> ids;
  for (std::size_t i = 0; i < document.medium().size(); ++i) {
    if (is_chosen(i)) ids.push_back(document.medium().ids()[i]);
  }
  select_gaussians(document, std::move(ids));
}

std::vector<std::size_t> selected_indices(const Document& document) {
  std::vector<std::size_t> indices;
  for (const GaussianId id : document.selection()) {
    indices.push_back(*document.medium().index_of(id));
  }
  return indices;
}

}  // namespace

SelectCommand::SelectCommand(Document& document, std::vector<GaussianId> ids, MergeId merge_id)
    : document_(document),
      before_(document.selection()),
      after_(std::move(ids)),
      merge_id_(merge_id) {
  setText(after_.empty() ? undo_text("Deselect all")
                         : undo_text("Select %1").arg(gaussians_text(after_.size())));
}

void SelectCommand::undo() {
  document_.select(before_);
}

void SelectCommand::redo() {
  document_.select(after_);
}

bool SelectCommand::mergeWith(const QUndoCommand* later) {
  const auto* command = dynamic_cast<const SelectCommand*>(later);
  if (!command) return false;
  after_ = command->after_;
  setText(command->text());
  setObsolete(before_ == after_);
  return true;
}

std::vector<GaussianId> combined(const std::vector<GaussianId>& selection,
                                 const std::vector<GaussianId>& chosen, SelectMode mode) {
  std::vector<GaussianId> result;
  const auto combine = [&](auto set_operation) {
    set_operation(selection.begin(), selection.end(), chosen.begin(), chosen.end(),
                  std::back_inserter(result));
  };
  switch (mode) {
    case SelectMode::set:
      return chosen;
    case SelectMode::add:
      combine([](auto... a) { std::set_union(a...); });
      break;
    case SelectMode::remove:
      combine([](auto... a) { std::set_difference(a...); });
      break;
    case SelectMode::intersect:
      combine([](auto... a) { std::set_intersection(a...); });
      break;
    case SelectMode::toggle:
      combine([](auto... a) { std::set_symmetric_difference(a...); });
      break;
  }
  return result;
}

void select_gaussians(Document& document, std::vector<GaussianId> ids, MergeId merge_id) {
  ids = document.selectable(std::move(ids));
  if (ids == document.selection()) return;
  document.undo_stack().push(new SelectCommand(document, std::move(ids), merge_id));
}

void select_all(Document& document) {
  const auto all = document.medium().ids();
  select_gaussians(document, {all.begin(), all.end()});
}

void invert_selection(Document& document) {
  const auto all = document.medium().ids();
  select_gaussians(document, without({all.begin(), all.end()}, document.selection()));
}

void grow_selection(Document& document) {
  select_gaussians(document, touching(document.medium(), document.selection()));
}

void shrink_selection(Document& document) {
  const auto all = document.medium().ids();
  const auto rest = without({all.begin(), all.end()}, document.selection());
  select_gaussians(document, without(document.selection(), touching(document.medium(), rest)));
}

void select_similar(Document& document, GaussianAttribute field) {
  double low = infinity;
  double high = -infinity;
  for (const std::size_t i : selected_indices(document)) {
    const double value = document.value(i, field);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  low -= similar_by * std::abs(low);
  high += similar_by * std::abs(high);
  if (!(low <= high)) return;
  select_if(document, [&](std::size_t i) {
    const double value = document.value(i, field);
    return value >= low && value <= high;
  });
}

void select_same_groups(Document& document) {
  std::set<GroupId> groups;
  for (const std::size_t i : selected_indices(document)) {
    groups.insert(document.medium().group(i));
  }
  select_if(document, [&](std::size_t i) { return groups.contains(document.medium().group(i)); });
}

}  // namespace brume
