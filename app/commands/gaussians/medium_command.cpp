#include "app/commands/gaussians/medium_command.h"

#include <algorithm>

#include "app/document/document.h"

namespace brume {

MediumCommand::MediumCommand(Document& document, MediumEdit edit, const QString& text,
                             MergeId merge_id, AfterAdding after_adding)
    : SceneCommand(document, text),
      edit_(std::move(edit)),
      merge_id_(merge_id),
      after_adding_(after_adding) {
  setObsolete(edit_.empty());
}

void MediumCommand::apply() {
  const bool was_selected = removes_selected();
  if (changes_ids()) selection_before_ = document_.selection();
  document_.apply(edit_);
  if (edit_.added().empty() || after_adding_ == AfterAdding::keep_selection) return;
  std::vector<GaussianId> ids;
  if (after_adding_ == AfterAdding::select_like_removed) {
    if (!was_selected) return;
    ids = selection_before_;
  }
  for (const MediumEdit::Entry& entry : edit_.added()) ids.push_back(entry.id);
  select(std::move(ids));
}

void MediumCommand::revert() {
  document_.apply(edit_.inverted());
  if (changes_ids()) select(selection_before_);
}

// Gaussians in place of others leave alone which object is selected.
void MediumCommand::select(std::vector<GaussianId> ids) {
  const std::optional<ObjectRef> object = document_.object();
  document_.select(std::move(ids));
  if (after_adding_ == AfterAdding::select_like_removed) document_.set_object(object);
}

bool MediumCommand::removes_selected() const {
  return std::ranges::any_of(edit_.removed(), [this](const MediumEdit::Entry& entry) {
    return document_.is_selected(entry.id);
  });
}

bool MediumCommand::changes_ids() const {
  return !edit_.added().empty() || !edit_.removed().empty();
}

bool MediumCommand::merge(const SceneCommand& later) {
  const auto* command = dynamic_cast<const MediumCommand*>(&later);
  if (!command) return false;
  edit_.merge(command->edit_);
  setObsolete(edit_.empty());
  return true;
}

}  // namespace brume
