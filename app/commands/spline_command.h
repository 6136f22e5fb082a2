#pragma once

#include <vector>

#include "app/commands/merge_id.h"
#include "app/commands/scene_command.h"
#include "brume/edits.h"
#include "brume/painted_spline.h"

namespace brume {

using Splines = std::vector<PaintedSpline>;

// A change of the scene's splines and of their fog at once, so that undo takes points back, too. No
// step if there is none.
class SplineCommand : public SceneCommand {
 public:
  SplineCommand(Document& document, Splines after, MediumEdit edit, const QString& text,
                MergeId merge_id);

  [[nodiscard]] int id() const override { return merge_id_; }

 protected:
  void apply() override;
  void revert() override;
  bool merge(const SceneCommand& later) override;

 private:
  Splines before_;
  Splines after_;
  MediumEdit edit_;
  MergeId merge_id_;
};

}  // namespace brume
