#include "app/tools/spline_tool.h"

#include <QHBoxLayout>
#include <QLineF>
#include <QPushButton>
#include <algorithm>

#include "app/commands/gaussian_budget.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/view/overlay.h"
#include "app/view/view.h"
#include "app/widgets/application.h"
#include "core/authoring/spline.h"

namespace brume {
namespace {

constexpr double point_reach = 9.0;   // pixels
constexpr double sample_step = 0.25;  // of the curve, relative to the radius

}  // namespace

SplineTool::SplineTool(Document& document, View& view) : PaintbrushTool(document, view) {
  connect(this, &Tool::options_changed, this, [this] {
    if (spline_->points.empty()) return;
    if (options_id_ == no_merge) options_id_ = new_merge_id();
    repaint(spline_->points, tr("Repaint spline"), options_id_);
  });
}

void SplineTool::finish() {
  spline_ = std::make_shared<PaintedSpline>();  // steps of undo keep the old one
  hovered_.reset();
  dragged_.reset();
  options_id_ = no_merge;
  Q_EMIT appearance_changed();
}

QString SplineTool::hint() const {
  return tr(
      "Click to add points, drag them to bend the line, Ctrl + click removes one. The brush can be "
      "changed until New begins another.");
}

void SplineTool::add_options(QHBoxLayout& row) {
  auto* fresh = new QPushButton(tr("New"));
  fresh->setObjectName("spline_new");
  fresh->setToolTip(tr("Leaves this line as it is; the next click begins another"));
  connect(fresh, &QPushButton::clicked, this, &SplineTool::finish);
  row.addWidget(fresh);
  add_brush_options(row, "spline");
}

std::optional<std::size_t> SplineTool::pick(QPointF position) const {
  const CameraRays rays = view().rays();
  std::optional<std::size_t> nearest;
  double reach = point_reach;
  for (std::size_t k = 0; k < spline_->points.size(); ++k) {
    const glm::dvec3 at = rays.project(spline_->points[k]);
    const double distance = QLineF(position, QPointF(at.x, at.y)).length();
    if (at.z <= 0.0 || distance > reach) continue;
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
  before_ = spline_->points;
  std::vector<glm::dvec3> points = before_;
  if (hovered_ && modifiers.testFlag(Qt::ControlModifier)) {
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(*hovered_));
    hovered_.reset();
    repaint(std::move(points), tr("Remove point of spline"), gesture_id_);
    return;
  }
  dragged_ = hovered_;
  if (dragged_) return;
  const auto point = paint_at(position);
  if (!point) return;
  dragged_ = points.size();
  points.push_back(point->position);
  if (points.size() == 1) spline_->seed = stroke_seed();
  repaint(std::move(points), tr("Add point to spline"), gesture_id_);
}

void SplineTool::move(std::span<const QPointF> path) {
  PaintbrushTool::hover(path.back());
  if (!dragged_ || *dragged_ >= spline_->points.size()) return;
  std::vector<glm::dvec3> points = spline_->points;
  // A view plane goes through the point itself.
  const auto point =
      paint_point(paint_target(), points[*dragged_], view().rays(), path.back(), view().surfaces());
  if (!point) return;
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

// Undo may have taken the dragged point away.
void SplineTool::medium_changed() {
  if (dragged_ && *dragged_ >= spline_->points.size()) dragged_.reset();
  hovered_.reset();
}

// Comes with another scene before anything else: its brush must not repaint the old spline.
void SplineTool::fit_to(double distance) {
  finish();
  PaintbrushTool::fit_to(distance);
}

std::vector<Gaussian> SplineTool::painted(const PaintedSpline& spline) {
  PaintStroke stroke(brush(), spline.seed);
  std::vector<Gaussian> gaussians;
  for (const glm::dvec3& point : sample_spline(spline.points, sample_step * brush().radius)) {
    for (const Gaussian& gaussian : stroke.extend(point)) {
      append_images(gaussians, gaussian, false);
    }
  }
  return gaussians;
}

void SplineTool::repaint(std::vector<glm::dvec3> points, const QString& text, MergeId merge_id) {
  PaintedSpline after = *spline_;
  after.points = std::move(points);
  const std::vector<Gaussian> gaussians = painted(after);
  const Medium& medium = document_.medium();
  // What has been erased or deleted since is not there any more.
  std::vector<GaussianId> present;
  std::vector<Gaussian> old;
  for (const GaussianId id : spline_->ids) {
    const auto index = medium.index_of(id);
    if (!index) continue;
    present.push_back(id);
    old.push_back(medium.gaussian(*index));
  }
  if (after.points == spline_->points && gaussians == old) return;
  // Ids stay with as many as there are, so that what is said of them does, too.
  const std::size_t kept = std::min(present.size(), gaussians.size());
  const std::span<const Gaussian> all(gaussians);
  if (!has_room(document_, gaussians.size() - kept, present.size() - kept)) return;
  const std::span<const GaussianId> ids(present);
  MediumEdit edit = MediumEdit::change(medium, ids.first(kept), all.first(kept));
  edit.merge(MediumEdit::remove(medium, ids.subspan(kept)));
  edit.merge(MediumEdit::add(medium, all.subspan(kept)));
  after.ids.assign(present.begin(), present.begin() + static_cast<std::ptrdiff_t>(kept));
  for (const MediumEdit::Entry& entry : edit.added()) after.ids.push_back(entry.id);
  document_.undo_stack().push(
      new SplineCommand(document_, spline_, std::move(after), std::move(edit), text, merge_id));
  Q_EMIT appearance_changed();
}

void SplineTool::draw(Overlay& overlay, const CameraRays& rays) const {
  if (!hovered_ && !dragged_) PaintbrushTool::draw(overlay, rays);
  if (spline_->points.empty()) return;
  const QColor accent = accent_color();
  const QRgb line = qRgba(accent.red(), accent.green(), accent.blue(), 170);
  const auto samples = sample_spline(spline_->points, 0.5 * brush().radius);
  for (std::size_t k = 1; k < samples.size(); ++k) {
    overlay.add_line(rays, samples[k - 1], samples[k], line);
  }
  for (std::size_t k = 0; k < spline_->points.size(); ++k) {
    const glm::dvec3 at = rays.project(spline_->points[k]);
    if (at.z <= 0.0) continue;
    const bool is_active = k == dragged_ || (!dragged_ && k == hovered_);
    const QRgb color = is_active ? qRgb(255, 255, 255) : accent.rgb();
    overlay.marks.push_back({static_cast<float>(at.x), static_cast<float>(at.y), color});
    overlay.add_circle(at.x, at.y, is_active ? 7.0 : 5.0, color);
  }
}

}  // namespace brume
