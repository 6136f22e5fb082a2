#pragma once

#include <memory>
#include <vector>

#include "app/commands/merge_id.h"
#include "app/commands/scene_command.h"
#include "core/medium/medium_edit.h"

namespace brume {

// A spline that is being edited: its points, and the Gaussians painted along it.
struct PaintedSpline {
  std::vector<glm::dvec3> points;
  std::vector<GaussianId> ids;
  std::uint64_t seed = 1;

  bool operator==(const PaintedSpline&) const = default;
};

// A change of a spline and of its fog at once, so that undo takes the points back, too.
class SplineCommand : public SceneCommand {
 public:
  // `spline`: what is changed, to `after`.
  SplineCommand(Document& document, std::shared_ptr<PaintedSpline> spline, PaintedSpline after,
                MediumEdit edit, const QString& text, MergeId merge_id);

  [[nodiscard]] int id() const override { return merge_id_; }

 protected:
  void apply() override;
  void revert() override;
  bool merge(const SceneCommand& later) override;

 private:
  std::shared_ptr<PaintedSpline> spline_;
  PaintedSpline before_;
  PaintedSpline after_;
  MediumEdit edit_;
  MergeId merge_id_;
};

}  // namespace brume
