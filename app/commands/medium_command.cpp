#include "app/commands/medium_command.h"

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
  if (changes_ids()) selection_before_ = document_.selection();
  document_.apply(edit_);
  if (after_adding_ != AfterAdding::keep_selection && !edit_.added().empty()) {
    std::vector<GaussianId> ids;
    if (after_adding_ == AfterAdding::add_to_selection) ids = document_.selection();
    for (const MediumEdit::Entry& entry : edit_.added()) ids.push_back(entry.id);
    document_.select(std::move(ids));
  }
}

void MediumCommand::revert() {
  document_.apply(edit_.inverted());
  if (changes_ids()) document_.select(selection_before_);
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
