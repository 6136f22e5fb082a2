#pragma once

#include "app/commands/merge_id.h"
#include "app/commands/scene_command.h"
#include "app/document/scene_part.h"
#include "brume/edits.h"

namespace brume {

// Replaces parts of the scene, and edits Gaussians that belong to them, as one step. No step if
// nothing changes.
class ScenePartCommand : public SceneCommand {
 public:
  ScenePartCommand(Document& document, std::vector<ScenePart> parts, MediumEdit edit,
                   const QString& text, MergeId merge_id = no_merge);

  [[nodiscard]] int id() const override { return merge_id_; }

 protected:
  void apply() override;
  void revert() override;
  bool merge(const SceneCommand& later) override;

 private:
  std::vector<ScenePart> before_;
  std::vector<ScenePart> after_;
  MediumEdit edit_;
  MergeId merge_id_;
  std::vector<GaussianId> selection_before_;
};

// Replaces a part, or several of different kinds, as one undo step, if the Gaussian budget allows.
// Sets keyframes for changed values that have any.
void set_scene_part(Document& document, ScenePart part, const QString& text,
                    MergeId merge_id = no_merge);
void set_scene_parts(Document& document, std::vector<ScenePart> parts, const QString& text,
                     MergeId merge_id = no_merge);

}  // namespace brume
