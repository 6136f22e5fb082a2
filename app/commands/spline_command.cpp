#include "app/commands/spline_command.h"

#include "app/document/document.h"

namespace brume {

SplineCommand::SplineCommand(Document& document, std::shared_ptr<PaintedSpline> spline,
                             PaintedSpline after, MediumEdit edit, const QString& text,
                             MergeId merge_id)
    : SceneCommand(document, text),
      spline_(std::move(spline)),
      before_(*spline_),
      after_(std::move(after)),
      edit_(std::move(edit)),
      merge_id_(merge_id) {}

// The spline first: who hears of the medium looks at it.
void SplineCommand::apply() {
  *spline_ = after_;
  document_.apply(edit_);
}

void SplineCommand::revert() {
  *spline_ = before_;
  document_.apply(edit_.inverted());
}

bool SplineCommand::merge(const SceneCommand& later) {
  const auto* command = dynamic_cast<const SplineCommand*>(&later);
  if (!command || command->spline_ != spline_) return false;
  after_ = command->after_;
  edit_.merge(command->edit_);
  setObsolete(edit_.empty() && after_ == before_);
  return true;
}

}  // namespace brume
