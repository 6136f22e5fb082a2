#include "app/commands/scene_part_command.h"

#include "app/commands/gaussian_budget.h"
#include "app/document/document.h"
#include "app/document/keyframe_tracks.h"

namespace brume {

ScenePartCommand::ScenePartCommand(Document& document, ScenePart part, MediumEdit edit,
                                   const QString& text, MergeId merge_id)
    : SceneCommand(document, text),
      before_(scene_part(document.scene(), part.index())),
      after_(std::move(part)),
      edit_(std::move(edit)),
      merge_id_(merge_id) {
  setObsolete(before_ == after_ && edit_.empty());
}

// The part first: listeners to the medium look at it.
void ScenePartCommand::apply() {
  selection_before_ = document_.selection();
  if (before_ != after_) document_.set_part(after_);
  if (!edit_.empty()) document_.apply(edit_);
}

void ScenePartCommand::revert() {
  if (before_ != after_) document_.set_part(before_);
  if (edit_.empty()) return;
  document_.apply(edit_.inverted());
  document_.select(selection_before_);
}

bool ScenePartCommand::merge(const SceneCommand& later) {
  const auto* command = dynamic_cast<const ScenePartCommand*>(&later);
  if (!command || command->after_.index() != after_.index()) return false;
  after_ = command->after_;
  edit_.merge(command->edit_);
  setObsolete(before_ == after_ && edit_.empty());
  return true;
}

void set_scene_part(Document& document, ScenePart part, const QString& text, MergeId merge_id) {
  const ScenePart before = scene_part(document.scene(), part.index());
  if (part == before) return;
  if (!has_room(document, gaussian_count(part), gaussian_count(before))) {
    document.announce(Change::part);  // fields show what is, not what was wanted
    return;
  }
  key_changes(before, part, document.time());
  document.undo_stack().push(new ScenePartCommand(document, std::move(part), {}, text, merge_id));
}

}  // namespace brume
