#pragma once

#include <QUndoCommand>

#include "core/medium/medium_edit.h"

namespace brume {

class Document;

// Commands of one gesture (a drag, a scrub) carry one merge id and become one step; ids are never
// used twice, so that the next drag is a step of its own.
using MergeId = int;
inline constexpr MergeId no_merge = -1;
MergeId new_merge_id();

// Whether Gaussians that come (pasted, back from the dead) become the selection.
enum class AfterAdding { select, keep_selection };

// Any change of the medium. An edit that changes nothing leaves no step, and a gesture that comes
// back to where it began takes its step back.
class MediumCommand : public QUndoCommand {
 public:
  MediumCommand(Document& document, MediumEdit edit, const QString& text,
                MergeId merge_id = no_merge, AfterAdding after_adding = AfterAdding::select);

  void undo() override;
  void redo() override;
  [[nodiscard]] int id() const override { return merge_id_; }
  bool mergeWith(const QUndoCommand* later) override;

 private:
  Document& document_;
  MediumEdit edit_;
  MergeId merge_id_;
  AfterAdding after_adding_;
};

}  // namespace brume
