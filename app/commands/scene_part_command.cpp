#include "app/commands/scene_part_command.h"

#include "app/commands/gaussian_budget.h"
#include "app/document/document.h"
#include "app/document/keyframe_tracks.h"

namespace brume {

ScenePartCommand::ScenePartCommand(Document& document, ScenePart part, const QString& text,
                                   MergeId merge_id)
    : SceneCommand(document, text),
      before_(scene_part(document.scene(), part.index())),
      after_(std::move(part)),
      merge_id_(merge_id) {
  setObsolete(before_ == after_);
}

void ScenePartCommand::apply() {
  document_.set_part(after_);
}

void ScenePartCommand::revert() {
  document_.set_part(before_);
}

bool ScenePartCommand::merge(const SceneCommand& later) {
  const auto* command = dynamic_cast<const ScenePartCommand*>(&later);
  if (!command || command->after_.index() != after_.index()) return false;
  after_ = command->after_;
  setObsolete(before_ == after_);
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
  document.undo_stack().push(new ScenePartCommand(document, std::move(part), text, merge_id));
}

}  // namespace brume
