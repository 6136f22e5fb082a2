#include "app/commands/edit_splines.h"

#include "app/commands/allowed_name.h"
#include "app/commands/scene_part_command.h"
#include "app/commands/select_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"

namespace brume {
namespace {

QString title_of(const PaintedSpline& spline) {
  return QString::fromStdString(spline.name);
}

// With a number if another spline has it.
std::string free_spline_name(const Splines& splines, const QString& name, SplineId own) {
  return free_name(name,
                   [&](const QString& text) {
                     return std::ranges::any_of(splines, [&](const PaintedSpline& other) {
                       return other.id != own && title_of(other) == text;
                     });
                   })
      .toStdString();
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
  for (const PaintedSpline& other : splines) spline.id = std::max(spline.id, other.id);
  ++spline.id;
  spline.name = free_spline_name(splines, undo_text("Spline"), spline.id);
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
  Splines splines = document.scene().splines;
  PaintedSpline* spline = find_spline(splines, id);
  const QString trimmed = allowed_name(name, 10);  // with room for a number
  if (!spline || trimmed.isEmpty() || trimmed == title_of(*spline)) return;
  const QString old_name = title_of(*spline);
  spline->name = free_spline_name(splines, trimmed, id);
  const QString text = undo_text("Rename %1 to %2").arg(old_name, title_of(*spline));
  set_scene_part(document, std::move(splines), text);
}

void delete_spline(Document& document, SplineId spline) {
  remove_spline(document, spline, true, undo_text("Delete %1"));
}

void release_spline(Document& document, SplineId spline) {
  remove_spline(document, spline, false, undo_text("Delete %1, keep its fog"));
}

}  // namespace brume
