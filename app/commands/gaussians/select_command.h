#pragma once

#include <QUndoCommand>
#include <vector>

#include "app/commands/merge_id.h"
#include "app/document/gaussian_attribute.h"
#include "brume/gaussian.h"

namespace brume {

class Document;

// A change of the selection: an undo step that does not modify the scene.
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

// How a chosen set combines with the selection.
enum class SelectMode { set, add, remove, intersect, toggle };

// Combines two sorted sets of ids.
std::vector<GaussianId> combined(const std::vector<GaussianId>& selection,
                                 const std::vector<GaussianId>& chosen, SelectMode mode);

// Selects Gaussians (ids in any order); missing and unselectable ones are skipped. No step if
// unchanged.
void select_gaussians(Document& document, std::vector<GaussianId> ids, MergeId merge_id = no_merge);
void select_all(Document& document);
void invert_selection(Document& document);
// Grows the selection to touching Gaussians (spheres of one radius); shrinks it by those that touch
// the rest.
void grow_selection(Document& document);
void shrink_selection(Document& document);
// Selects all whose attribute is within similar_by of what the selection has, from least to
// greatest; those in the groups of the selection. Nothing is similar to none.
inline constexpr double similar_by = 0.1;  // of the value
void select_similar(Document& document, GaussianAttribute field);
void select_same_groups(Document& document);

}  // namespace brume
