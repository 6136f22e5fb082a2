#pragma once

#include "app/commands/merge_id.h"
#include "app/commands/scene_command.h"
#include "app/document/scene_part.h"

namespace brume {

// Gives a part of the scene another value. One that is the same leaves no step.
class ScenePartCommand : public SceneCommand {
 public:
  ScenePartCommand(Document& document, ScenePart part, const QString& text, MergeId merge_id);

  [[nodiscard]] int id() const override { return merge_id_; }

 protected:
  void apply() override;
  void revert() override;
  bool take(const SceneCommand& later) override;

 private:
  ScenePart before_;
  ScenePart after_;
  MergeId merge_id_;
};

// One step; none where there is no room for the Gaussians of emitters and sequences. Where the part
// has values with keys that it changes, keys of now are set for them.
void set_scene_part(Document& document, ScenePart part, const QString& text,
                    MergeId merge_id = no_merge);

}  // namespace brume
