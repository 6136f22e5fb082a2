#include "app/commands/scene_part_command.h"

#include <algorithm>

#include "app/commands/gaussian_budget.h"
#include "app/document/document.h"
#include "app/document/time/keyframe_tracks.h"

namespace brume {
namespace {

// The scene's own parts in the place of others.
std::vector<ScenePart> present_parts(const Scene& scene, const std::vector<ScenePart>& parts) {
  std::vector<ScenePart> present;
  for (const ScenePart& part : parts) present.push_back(scene_part(scene, part.index()));
  return present;
}

// Whether parts are the same but for the time of their keyframed values, which goes on in playback.
bool are_same_at(double time, const std::vector<ScenePart>& parts,
                 const std::vector<ScenePart>& others) {
  return std::ranges::equal(parts, others, [time](ScenePart part, ScenePart other) {
    if (part == other) return true;
    apply_keys(part, time);
    apply_keys(other, time);
    return part == other;
  });
}

// Sets those parts that differ from others of the same kinds.
void set_changed(Document& document, const std::vector<ScenePart>& parts,
                 const std::vector<ScenePart>& others) {
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k] != others[k]) document.set_part(parts[k]);
  }
}

}  // namespace

ScenePartCommand::ScenePartCommand(Document& document, std::vector<ScenePart> parts,
                                   MediumEdit edit, const QString& text, MergeId merge_id)
    : SceneCommand(document, text),
      before_(present_parts(document.scene(), parts)),
      after_(std::move(parts)),
      edit_(std::move(edit)),
      merge_id_(merge_id) {
  setObsolete(before_ == after_ && edit_.empty());
}

// The part first: listeners to the medium look at it.
void ScenePartCommand::apply() {
  selection_before_ = document_.selection();
  set_changed(document_, after_, before_);
  if (!edit_.empty()) document_.apply(edit_);
}

void ScenePartCommand::revert() {
  set_changed(document_, before_, after_);
  if (edit_.empty()) return;
  document_.apply(edit_.inverted());
  document_.select(selection_before_);
}

bool ScenePartCommand::merge(const SceneCommand& later) {
  const auto* command = dynamic_cast<const ScenePartCommand*>(&later);
  const auto index = [](const ScenePart& part) { return part.index(); };
  if (!command || !std::ranges::equal(command->after_, after_, {}, index, index)) {
    return false;
  }
  after_ = command->after_;
  edit_.merge(command->edit_);
  setObsolete(edit_.empty() && are_same_at(document_.time(), before_, after_));
  return true;
}

void set_scene_part(Document& document, ScenePart part, const QString& text, MergeId merge_id) {
  set_scene_parts(document, {std::move(part)}, text, merge_id);
}

void set_scene_parts(Document& document, std::vector<ScenePart> parts, const QString& text,
                     MergeId merge_id) {
  const std::vector<ScenePart> before = present_parts(document.scene(), parts);
  if (parts == before) return;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (!has_room(document, gaussian_count(parts[k]), gaussian_count(before[k]))) {
      document.announce(Change::part);  // fields show what is, not what was wanted
      return;
    }
    key_changes(before[k], parts[k], document.time());
  }
  document.undo_stack().push(new ScenePartCommand(document, std::move(parts), {}, text, merge_id));
}

}  // namespace brume
