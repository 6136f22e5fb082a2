#include "app/commands/gaussians/edit_splines.h"

#include "app/commands/allowed_name.h"
#include "app/commands/gaussians/select_command.h"
#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"

namespace brume {
namespace {

QString title_of(const PaintedSpline& spline) {
  return QString::fromStdString(spline.name);
}

void remove_spline(Document& document, SplineId id, bool with_fog, const QString& text) {
  Splines splines = document.scene().splines;
  const PaintedSpline* spline = find_spline(splines, id);
  if (!spline) return;
  const QString step = text.arg(title_of(*spline));
  MediumEdit edit;
  if (with_fog) {
    edit = MediumEdit::remove(document.medium(), present_gaussians(document, *spline));
  }
  std::erase_if(splines, [id](const PaintedSpline& other) { return other.id == id; });
  document.undo_stack().push(
      new ScenePartCommand(document, {std::move(splines)}, std::move(edit), step));
}

}  // namespace

PaintedSpline new_spline(const Document& document) {
  PaintedSpline spline;
  const Splines& splines = document.scene().splines;
  spline.id = new_id(splines);
  spline.name = free_name(splines, undo_text("Spline"), spline.id);
  return spline;
}

std::vector<GaussianId> present_gaussians(const Document& document, const PaintedSpline& spline) {
  std::vector<GaussianId> present = spline.gaussians;
  std::erase_if(present, [&](GaussianId id) { return !document.medium().index_of(id); });
  return present;
}

void select_spline(Document& document, SplineId id) {
  if (const PaintedSpline* spline = find_spline(document.scene().splines, id)) {
    select_gaussians(document, present_gaussians(document, *spline));
  }
}

void rename_spline(Document& document, SplineId id, const QString& name) {
  rename_one(document, document.scene().splines, id, name);
}

void delete_spline(Document& document, SplineId spline) {
  remove_spline(document, spline, true, undo_text("Delete %1"));
}

void release_spline(Document& document, SplineId spline) {
  remove_spline(document, spline, false, undo_text("Delete %1, keep its fog"));
}

}  // namespace brume
