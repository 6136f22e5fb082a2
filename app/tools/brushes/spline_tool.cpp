#include "app/tools/brushes/spline_tool.h"

#include <QHBoxLayout>
#include <QLineF>
#include <QPushButton>
#include <algorithm>

#include "app/commands/gaussian_budget.h"
#include "app/commands/gaussians/edit_splines.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/view/drawing/overlay.h"
#include "app/view/view.h"
#include "app/widgets/application.h"
#include "app/widgets/interface_settings.h"
#include "app/widgets/rows.h"
#include "brume/limits.h"
#include "core/authoring/spline.h"
#include "core/scene/camera_rays.h"

namespace brume {
namespace {

constexpr double point_reach = 9.0;   // pixels
constexpr double sample_step = 0.25;  // of the curve, relative to the radius

}  // namespace

SplineTool::SplineTool(Document& document, View& view) : PaintbrushTool(document, view) {
  connect(this, &Tool::options_changed, this, [this] {
    if (is_adopting_ || spline().points.empty()) return;
    if (options_id_ == no_merge) options_id_ = new_merge_id();
    repaint(spline().points, tr("Repaint spline"), options_id_);
  });
  on_change(document, Change::active_spline, this, [this] {
    forget_gesture();
    adopt_brush();
  });
  // Also by undo, which may have taken the dragged point away.
  on_change(document, Change::splines, this, [this] {
    if (dragged_ && *dragged_ >= spline().points.size()) dragged_.reset();
    hovered_.reset();
    adopt_brush();
  });
}

const PaintedSpline& SplineTool::spline() const {
  static const PaintedSpline none;
  const PaintedSpline* active = document_.active_spline();
  return active ? *active : none;
}

void SplineTool::forget_gesture() {
  hovered_.reset();
  dragged_.reset();
  options_id_ = no_merge;
  Q_EMIT appearance_changed();
}

void SplineTool::finish() {
  document_.set_active_spline(0);
  forget_gesture();
}

void SplineTool::adopt_brush() {
  const PaintedSpline& active = spline();
  if (active.points.empty()) return;
  mirrored_ = stroke_options();
  mirrored_.mirrors = active.mirrors.axes;
  if (active.brush == brush() && active.optics == optics() && mirrored_ == stroke_options()) return;
  is_adopting_ = true;
  set_optics(active.optics);
  set_stroke_options(mirrored_);
  set_brush(active.brush);
  is_adopting_ = false;
}

QString SplineTool::hint() const {
  return tr(
      "Click to add points, drag them to bend the line, Ctrl + click removes one. The brush can be "
      "changed until New begins another.");
}

void SplineTool::add_options(QHBoxLayout& row) {
  auto* fresh = named(new QPushButton(tr("New")), "spline_new",
                      tr("Leaves this line as it is; the next click begins another"));
  connect(fresh, &QPushButton::clicked, this, &SplineTool::finish);
  row.addWidget(fresh);
  add_brush_options(row, "spline");
}

std::optional<std::size_t> SplineTool::pick(QPointF position) const {
  const CameraRays rays = view().rays();
  std::optional<std::size_t> nearest;
  double reach = point_reach * handle_scale();
  for (std::size_t k = 0; k < spline().points.size(); ++k) {
    const glm::dvec3 projected = rays.project(spline().points[k]);
    const double distance = QLineF(position, QPointF(projected.x, projected.y)).length();
    if (projected.z <= 0.0 || distance > reach) continue;
    nearest = k;
    reach = distance;
  }
  return nearest;
}

void SplineTool::hover(QPointF position) {
  hovered_ = pick(position);
  PaintbrushTool::hover(position);
}

void SplineTool::press(QPointF position, Qt::KeyboardModifiers modifiers) {
  if (modifiers.testFlag(Qt::AltModifier)) {
    PaintbrushTool::press(position, modifiers);  // picks the brush
    return;
  }
  hover(position);
  gesture_id_ = new_merge_id();
  options_id_ = no_merge;
  before_ = spline().points;
  std::vector<glm::dvec3> points = before_;
  if (hovered_ && modifiers.testFlag(Qt::ControlModifier)) {
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(*hovered_));
    hovered_.reset();
    repaint(std::move(points), tr("Remove point of spline"), gesture_id_);
    return;
  }
  dragged_ = hovered_;
  if (dragged_) return begin_drag(position);
  const auto point = paint_at(position);
  if (!point) return;
  if (points.size() >= limits::spline_points) {
    Q_EMIT refused(
        tr("A spline has at most %1 points. New begins another.").arg(limits::spline_points));
    return;
  }
  dragged_ = points.size();
  dragged_depth_.emplace(*point);
  points.push_back(point->position);
  repaint(std::move(points), tr("Add point to spline"), gesture_id_);
}

// The point stays on the surface that it lies on, or else in the plane through itself.
void SplineTool::begin_drag(QPointF position) {
  const glm::dvec3& place = spline().points[*dragged_];
  const auto around = paint_point(view(), paint_target(), position, offset());
  PaintPoint begin{place, -view().rays().forward(), view().rays().distance_to(place)};
  begin.unsnapped = place;
  if (around && around->on_surface && glm::distance(around->position, place) < brush().radius) {
    begin.distance = around->distance;
    begin.on_surface = true;
  }
  dragged_depth_.emplace(begin);
}

void SplineTool::move(std::span<const QPointF> path) {
  PaintbrushTool::hover(path.back());
  if (!dragged_ || *dragged_ >= spline().points.size()) return;
  std::vector<glm::dvec3> points = spline().points;
  const auto point = paint_point(view(), paint_target(), path.back(), offset(), dragged_depth_);
  if (!point) return;
  dragged_depth_->extend(*point);
  points[*dragged_] = point->position;
  const bool is_new = before_.size() < points.size();
  repaint(std::move(points), is_new ? tr("Add point to spline") : tr("Move point of spline"),
          gesture_id_);
}

void SplineTool::release(QPointF /*position*/) {
  dragged_.reset();
}

void SplineTool::cancel() {
  if (dragged_) repaint(before_, {}, gesture_id_);
  dragged_.reset();
}

void SplineTool::abandon() {
  finish();
}

std::vector<Gaussian> SplineTool::painted(const PaintedSpline& spline) const {
  PaintStroke stroke(spline.brush, static_cast<std::uint64_t>(spline.seed));
  std::vector<Gaussian> gaussians;
  for (const glm::dvec3& point : sample_spline(spline.points, sample_step * spline.brush.radius)) {
    for (const Gaussian& gaussian : stroke.extend(point)) {
      append_images(gaussians, gaussian, spline.mirrors, false);
    }
  }
  return gaussians;
}

void SplineTool::repaint(std::vector<glm::dvec3> points, const QString& text, MergeId merge_id) {
  const PaintedSpline before = spline();
  PaintedSpline after = before;
  if (before.id == 0) {
    after = new_spline(document_);
    after.seed = static_cast<std::int64_t>(stroke_seed());
  }
  after.points = std::move(points);
  after.brush = brush();
  after.optics = optics();
  const bool mirrors_otherwise = stroke_options().mirrors != mirrored_.mirrors ||
                                 stroke_options().mirrors_at_pivot != mirrored_.mirrors_at_pivot;
  if (before.id == 0 || mirrors_otherwise) after.mirrors = mirror_planes();

  const Medium& medium = document_.medium();
  const std::vector<GaussianId> present = present_gaussians(document_, before);
  const std::vector<Gaussian> old = document_.gaussians(present);
  std::vector<Gaussian> gaussians = painted(after);
  // Fog stays in the group that it is in.
  for (std::size_t k = 0; k < gaussians.size() && !old.empty(); ++k) {
    gaussians[k].group = old[k < old.size() ? k : 0].group;
  }
  if (after == before && gaussians == old) return;
  // Ids stay with as many as there are, so that what is said of them does, too.
  const std::size_t kept = std::min(present.size(), gaussians.size());
  const std::span<const Gaussian> all(gaussians);
  if (!has_room(document_, gaussians.size() - kept, present.size() - kept)) return;
  const std::span<const GaussianId> ids(present);
  MediumEdit edit = MediumEdit::change(medium, ids.first(kept), all.first(kept));
  edit.merge(MediumEdit::remove(medium, ids.subspan(kept)));
  edit.merge(MediumEdit::add(medium, all.subspan(kept)));
  after.gaussians.assign(present.begin(), present.begin() + static_cast<std::ptrdiff_t>(kept));
  for (const MediumEdit::Entry& entry : edit.added()) after.gaussians.push_back(entry.id);

  Splines splines = document_.scene().splines;
  const SplineId id = after.id;
  if (after.points.empty()) {
    std::erase_if(splines, [id](const PaintedSpline& other) { return other.id == id; });
  } else if (PaintedSpline* found = find_spline(splines, id)) {
    *found = std::move(after);
  } else if (splines.size() < limits::splines) {
    splines.push_back(std::move(after));
  } else {
    Q_EMIT refused(tr("A scene has at most %1 splines.").arg(limits::splines));
    return;
  }
  mirrored_ = stroke_options();
  document_.undo_stack().push(
      new ScenePartCommand(document_, {std::move(splines)}, std::move(edit), text, merge_id));
  if (before.id == 0) {
    const std::optional<std::size_t> dragged = dragged_;
    document_.set_active_spline(id);
    dragged_ = dragged;
  }
  Q_EMIT appearance_changed();
}

void SplineTool::draw(Overlay& overlay, const CameraRays& rays) const {
  if (!hovered_ && !dragged_) PaintbrushTool::draw(overlay, rays);
  const std::vector<glm::dvec3>& points = spline().points;
  if (points.empty()) return;
  const QColor accent = accent_color();
  const QRgb line = qRgba(accent.red(), accent.green(), accent.blue(), 170);
  // The step is as fine as can be seen.
  const double step = std::max(0.5 * brush().radius, 0.002 * view_distance());
  const auto samples = sample_spline(points, step);
  for (std::size_t k = 1; k < samples.size(); ++k) {
    overlay.add_line(rays, samples[k - 1], samples[k], line);
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const glm::dvec3 projected = rays.project(points[k]);
    if (projected.z <= 0.0) continue;
    const bool is_active = k == dragged_ || (!dragged_ && k == hovered_);
    const QRgb color = is_active ? qRgb(255, 255, 255) : accent.rgb();
    overlay.marks.push_back(
        {static_cast<float>(projected.x), static_cast<float>(projected.y), color});
    overlay.add_circle(projected.x, projected.y, (is_active ? 7.0 : 5.0) * handle_scale(), color);
  }
}

}  // namespace brume
