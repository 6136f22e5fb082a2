#pragma once

#include <QUndoCommand>
#include <vector>

#include "app/commands/merge_id.h"
#include "core/medium/gaussian.h"

namespace brume {

class Document;

// A change of the selection: a step of the history, but no change of the scene.
class SelectCommand : public QUndoCommand {
 public:
  SelectCommand(Document& document, std::vector<GaussianId> ids, MergeId merge_id);

  void undo() override;
  void redo() override;
  [[nodiscard]] int id() const override { return merge_id_; }
  bool mergeWith(const QUndoCommand* later) override;

 private:
  Document& document_;
  std::vector<GaussianId> before_;
  std::vector<GaussianId> after_;
  MergeId merge_id_;
};

// Selects Gaussians, in any order; those that are not there or cannot be selected are left out. No
// step if they are selected already.
void select_gaussians(Document& document, std::vector<GaussianId> ids, MergeId merge_id = no_merge);
void select_all(Document& document);
void invert_selection(Document& document);
// Takes to the selection whatever its balls of one radius touch, and away what touches the rest.
void grow_selection(Document& document);
void shrink_selection(Document& document);

}  // namespace brume
