#include "app/commands/select_command.h"

#include <algorithm>
#include <iterator>

#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "core/authoring/neighbours.h"

namespace brume {
namespace {

std::vector<GaussianId> without(const std::vector<GaussianId>& ids,
                                const std::vector<GaussianId>& others) {
  std::vector<GaussianId> rest;
  std::set_difference(ids.begin(), ids.end(), others.begin(), others.end(),
                      std::back_inserter(rest));
  return rest;
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

}  // namespace brume
