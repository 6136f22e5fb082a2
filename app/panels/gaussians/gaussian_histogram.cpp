#include "app/panels/gaussians/gaussian_histogram.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/commands/gaussians/select_command.h"
#include "app/document/document.h"
#include "app/document/text/number_text.h"
#include "app/widgets/application.h"

namespace brume {
namespace {

constexpr double far_apart = 20.0;  // the factor from which an axis is logarithmic

// Counting so many takes longer than a picture: it waits for a gesture to pause.
constexpr std::size_t many = 20'000;
constexpr int recount_after = 250;  // milliseconds

bool is_of_colour(GaussianAttribute field) {
  return field == GaussianAttribute::albedo || field == GaussianAttribute::emission;
}

// Whether Gaussians need not have it.
bool is_optional(GaussianAttribute field) {
  return is_of_colour(field) || field == GaussianAttribute::elongation;
}

}  // namespace

GaussianHistogram::Axis::Axis(double least, double greatest)
    : low(least), high(greatest), logarithmic(low > 0.0 && high > far_apart * low) {}

std::size_t GaussianHistogram::Axis::bin(double value) const {
  return static_cast<std::size_t>(std::clamp(position(value) * bins, 0.0, bins - 1.0));
}

double GaussianHistogram::Axis::at(double position) const {
  if (position >= 1.0) return high;  // exactly
  return logarithmic ? low * std::pow(high / low, position) : low + position * (high - low);
}

double GaussianHistogram::Axis::position(double value) const {
  if (!(high > low)) return 0.5;
  return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

GaussianHistogram::GaussianHistogram(Document& document, GaussianAttribute field, QWidget* parent)
    : QWidget(parent), document_(document), field_(field) {
  setObjectName(QString("histogram_") + attribute_id(field));
  setToolTip(tr("Drag to select the Gaussians in a range; Shift adds, Ctrl removes"));
  setCursor(Qt::CrossCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  on_change(document_, Change::scene, this, &GaussianHistogram::refresh);
  on_medium_edit(document_, this, &GaussianHistogram::follow);
  on_change(document_, Change::selection, this, [this] { update(); });
  if (field_ == GaussianAttribute::albedo) {
    on_change(document_, Change::part, this, [this] {
      if (document_.scene().optics.albedo != shown_albedo_) refresh();
    });
  }
  recount_timer_.setSingleShot(true);
  recount_timer_.setInterval(recount_after);
  connect(&recount_timer_, &QTimer::timeout, this, &GaussianHistogram::refresh);
  refresh();
}

bool GaussianHistogram::has_any() const {
  const Medium& medium = document_.medium();
  switch (field_) {
    case GaussianAttribute::albedo:
      return medium.has_albedos();
    case GaussianAttribute::emission:
      return medium.has_emission();
    case GaussianAttribute::elongation:
      return std::ranges::any_of(
          medium.shapes(), [](const GaussianShape& shape) { return shape != GaussianShape(); });
    default:
      return !medium.empty();
  }
}

void GaussianHistogram::refresh() {
  shown_albedo_ = document_.scene().optics.albedo;
  is_counted_ = false;
  recount_timer_.stop();
  setVisible(!is_optional(field_) || has_any());
  update();
}

void GaussianHistogram::follow(const MediumEdit& edit) {
  if (is_of_colour(field_)) return refresh();
  if (is_optional(field_)) setVisible(has_any());
  if (!is_counted_) return;
  // Values outside the axis count at its end, until the axis follows.
  bool fits = true;
  const auto add = [&](const Gaussian& gaussian) {
    const double added = value(gaussian);
    fits = fits && added >= axis_.low && added <= axis_.high;
    ++all_[axis_.bin(added)];
  };
  const auto remove = [&](const Gaussian& gaussian) {
    const double removed = value(gaussian);
    fits = fits && removed > axis_.low && removed < axis_.high;
    --all_[axis_.bin(removed)];
  };
  for (const MediumEdit::Entry& entry : edit.added()) add(entry.gaussian);
  for (const MediumEdit::Entry& entry : edit.removed()) remove(entry.gaussian);
  for (const MediumEdit::Change& change : edit.changed()) {
    if (value(change.before) == value(change.after)) continue;
    add(change.after);
    remove(change.before);
  }
  update();
  if (recount_timer_.isActive() || !fits) {
    if (document_.medium().size() < many) return refresh();
    recount_timer_.start();
  }
}

double GaussianHistogram::value(std::size_t index) const {
  return document_.value(index, field_);
}

double GaussianHistogram::value(Gaussian gaussian) const {
  gaussian.optics.albedo = gaussian.optics.albedo.value_or(document_.scene().optics.albedo);
  return attribute_value(gaussian, field_);
}

void GaussianHistogram::count_all() const {
  if (std::exchange(is_counted_, true)) return;
  axis_ = {};
  all_ = {};
  if (!has_any()) return;
  std::vector<double> values(document_.medium().size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(i);
  const auto [least, greatest] = std::ranges::minmax(values);
  axis_ = Axis(least, greatest);
  for (const double each : values) ++all_[axis_.bin(each)];
}

const GaussianHistogram::Axis& GaussianHistogram::axis() const {
  count_all();
  return axis_;
}

GaussianHistogram::Counts GaussianHistogram::selected_on(const Axis& axis) const {
  Counts counts{};
  if (!has_any()) return counts;
  for (const GaussianId id : document_.selection()) {
    ++counts[axis.bin(value(*document_.medium().index_of(id)))];
  }
  return counts;
}

QRect GaussianHistogram::bars() const {
  const int line = fontMetrics().height();
  return rect().adjusted(2, 2, -2, -line - 2);
}

void GaussianHistogram::paintEvent(QPaintEvent* /*event*/) {
  count_all();
  const Axis& axis = dragging_ ? drag_axis_ : axis_;
  const Counts& all = dragging_ ? drag_all_ : all_;
  const Counts selected = selected_on(axis);

  QPainter painter(this);
  const QRect area = bars();
  painter.fillRect(area, palette().base());
  const double limit = static_cast<double>(*std::max_element(all.begin(), all.end()));
  const auto draw = [&](const Counts& counts, const QColor& color) {
    for (std::size_t k = 0; k < bins && limit > 0.0; ++k) {
      if (counts[k] == 0) continue;
      // By the root, so that few are seen beside many.
      const double height = area.height() * std::sqrt(static_cast<double>(counts[k]) / limit);
      const double width = static_cast<double>(area.width()) / bins;
      painter.fillRect(QRectF(area.left() + static_cast<double>(k) * width,
                              area.bottom() + 1 - height, std::max(width - 1.0, 1.0), height),
                       color);
    }
  };
  draw(all, palette().color(QPalette::PlaceholderText));
  draw(selected, accent_color());
  if (dragging_) {
    const auto [left, right] = std::minmax(start_, end_);
    QColor veil = accent_color();
    veil.setAlpha(60);
    painter.fillRect(QRectF(area.left() + left * area.width(), area.top(),
                            std::max(1.0, (right - left) * area.width()), area.height()),
                     veil);
  }
  draw_axis(painter, QRect(area.left(), area.bottom() + 1, area.width(), fontMetrics().height()));
}

// The ends of the axis, or of what is dragged over, and between them as much of the title as fits.
void GaussianHistogram::draw_axis(QPainter& painter, const QRect& line) const {
  painter.setPen(palette().color(QPalette::WindowText));
  QString low;
  QString high;
  if (has_any()) {
    const Axis& axis = dragging_ ? drag_axis_ : axis_;
    low = number_text(axis.at(dragging_ ? std::min(start_, end_) : 0.0), 3);
    high = number_text(axis.at(dragging_ ? std::max(start_, end_) : 1.0), 3);
    painter.drawText(line, Qt::AlignLeft, low);
    painter.drawText(line, Qt::AlignRight, high);
  }
  const QFontMetrics metrics = fontMetrics();
  const int gap = metrics.horizontalAdvance(' ');
  const QRect between = line.adjusted(metrics.horizontalAdvance(low) + gap, 0,
                                      -metrics.horizontalAdvance(high) - gap, 0);
  const QString title = attribute_title(field_);
  // In the middle of the bars where it does not touch the ends.
  QRect place(0, 0, metrics.horizontalAdvance(title), line.height());
  place.moveCenter(line.center());
  painter.drawText(between.contains(place) ? line : between, Qt::AlignHCenter,
                   metrics.elidedText(title, Qt::ElideRight, between.width()));
}

void GaussianHistogram::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !has_any()) return;
  drag_axis_ = axis();
  drag_all_ = all_;
  dragging_ = true;
  modifiers_ = event->modifiers();
  before_ = document_.selection();
  merge_id_ = new_merge_id();
  start_ = std::clamp((event->position().x() - bars().left()) / bars().width(), 0.0, 1.0);
  select_range(event->position());
}

void GaussianHistogram::mouseMoveEvent(QMouseEvent* event) {
  if (dragging_) select_range(event->position());
}

void GaussianHistogram::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  dragging_ = false;
  update();
}

void GaussianHistogram::select_range(QPointF to) {
  end_ = std::clamp((to.x() - bars().left()) / bars().width(), 0.0, 1.0);
  const auto [left, right] = std::minmax(start_, end_);
  const double low = drag_axis_.at(left);
  const double high = drag_axis_.at(right);
  std::vector<GaussianId> inside;
  for (std::size_t i = 0; i < document_.medium().size(); ++i) {
    const double gaussian_value = value(i);
    if (gaussian_value >= low && gaussian_value <= high)
      inside.push_back(document_.medium().ids()[i]);
  }
  const SelectMode mode = modifiers_.testFlag(Qt::ShiftModifier)     ? SelectMode::add
                          : modifiers_.testFlag(Qt::ControlModifier) ? SelectMode::remove
                                                                     : SelectMode::set;
  select_gaussians(document_, combined(before_, inside, mode), merge_id_);
  update();
}

}  // namespace brume
