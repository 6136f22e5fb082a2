#pragma once

#include "app/commands/merge_id.h"
#include "app/commands/scene_command.h"
#include "brume/edits.h"

namespace brume {

// Whether added Gaussians (pasted, restored by undo) become the selection, or a part of it if some
// of the removed ones were.
enum class AfterAdding { select, select_like_removed, keep_selection };

// A medium edit as a command. Empty edits, and gestures that return to the start, leave no step.
class MediumCommand : public SceneCommand {
 public:
  MediumCommand(Document& document, MediumEdit edit, const QString& text,
                MergeId merge_id = no_merge, AfterAdding after_adding = AfterAdding::select);

  [[nodiscard]] int id() const override { return merge_id_; }

 protected:
  void apply() override;
  void revert() override;
  bool merge(const SceneCommand& later) override;

 private:
  [[nodiscard]] bool changes_ids() const;
  [[nodiscard]] bool removes_selected() const;
  void select(std::vector<GaussianId> ids);

  MediumEdit edit_;
  MergeId merge_id_;
  AfterAdding after_adding_;
  std::vector<GaussianId> selection_before_;  // if Gaussians are added or removed
};

}  // namespace brume
