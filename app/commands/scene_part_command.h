#pragma once

#include "app/commands/merge_id.h"
#include "app/commands/scene_command.h"
#include "app/document/scene_part.h"

namespace brume {

// Replaces a part of the scene. No step if equal.
class ScenePartCommand : public SceneCommand {
 public:
  ScenePartCommand(Document& document, ScenePart part, const QString& text, MergeId merge_id);

  [[nodiscard]] int id() const override { return merge_id_; }

 protected:
  void apply() override;
  void revert() override;
  bool merge(const SceneCommand& later) override;

 private:
  ScenePart before_;
  ScenePart after_;
  MergeId merge_id_;
};

// Replaces a part as one undo step, if the Gaussian budget allows. Sets keyframes for changed
// values that have any.
void set_scene_part(Document& document, ScenePart part, const QString& text,
                    MergeId merge_id = no_merge);

}  // namespace brume
