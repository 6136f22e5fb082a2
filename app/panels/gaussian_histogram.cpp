#include "app/panels/gaussian_histogram.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/commands/select_command.h"
#include "app/document/document.h"
#include "app/document/number_text.h"
#include "app/widgets/application.h"

namespace brume {
namespace {

constexpr double far_apart = 20.0;  // the factor from which an axis is logarithmic

}  // namespace

GaussianHistogram::Axis::Axis(std::span<const double> values) {
  if (values.empty()) return;
  const auto [min_value, max_value] = std::minmax_element(values.begin(), values.end());
  low = *min_value;
  high = *max_value;
  logarithmic = low > 0.0 && high > far_apart * low;
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
  setObjectName("histogram_" + attribute_name(field));
  setToolTip(tr("Drag to select the Gaussians in a range; Shift adds, Ctrl removes"));
  setCursor(Qt::CrossCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(&document_, &Document::scene_replaced, this, &GaussianHistogram::refresh);
  connect(&document_, &Document::medium_changed, this, &GaussianHistogram::refresh);
  connect(&document_, &Document::selection_changed, this, [this] { update(); });
  if (field_ == GaussianAttribute::albedo) {
    connect(&document_, &Document::part_changed, this, [this] {
      if (document_.scene().optics.albedo != shown_albedo_) refresh();
    });
  }
  refresh();
}

void GaussianHistogram::refresh() {
  const Medium& medium = document_.medium();
  const bool is_shown = field_ == GaussianAttribute::albedo     ? medium.has_albedos()
                        : field_ == GaussianAttribute::emission ? medium.has_emission()
                                                                : true;
  shown_albedo_ = document_.scene().optics.albedo;
  values_.clear();
  for (std::size_t i = 0; is_shown && i < medium.size(); ++i) {
    values_.push_back(attribute_value(document_.effective_gaussian(i), field_));
  }
  setVisible(is_shown);
  update();
}

QRect GaussianHistogram::bars() const {
  const int line = fontMetrics().height();
  return rect().adjusted(2, 2, -2, -line - 2);
}

void GaussianHistogram::paintEvent(QPaintEvent* /*event*/) {
  const Axis axis = dragging_ ? drag_axis_ : this->axis();
  std::array<std::size_t, bins> all{};
  std::array<std::size_t, bins> selected{};
  auto next = document_.selection().begin();
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const auto bin =
        static_cast<std::size_t>(std::clamp(axis.position(values_[i]) * bins, 0.0, bins - 1.0));
    ++all[bin];
    // Both are sorted by id.
    if (next != document_.selection().end() && *next == document_.medium().ids()[i]) {
      ++selected[bin];
      ++next;
    }
  }

  QPainter painter(this);
  const QRect area = bars();
  painter.fillRect(area, palette().base());
  const double limit = static_cast<double>(*std::max_element(all.begin(), all.end()));
  const auto draw = [&](const std::array<std::size_t, bins>& counts, const QColor& color) {
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
  const QRect below(area.left(), area.bottom() + 1, area.width(), fontMetrics().height());
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(below, Qt::AlignHCenter, attribute_title(field_));
  if (values_.empty()) return;
  const double left = dragging_ ? std::min(start_, end_) : 0.0;
  const double right = dragging_ ? std::max(start_, end_) : 1.0;
  const auto text = [&](double at) { return number_text(axis.at(at), 3); };
  painter.drawText(below, Qt::AlignLeft, text(left));
  painter.drawText(below, Qt::AlignRight, text(right));
}

void GaussianHistogram::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || values_.empty()) return;
  dragging_ = true;
  drag_axis_ = axis();
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
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (values_[i] >= low && values_[i] <= high) inside.push_back(document_.medium().ids()[i]);
  }
  const SelectMode mode = modifiers_.testFlag(Qt::ShiftModifier)     ? SelectMode::add
                          : modifiers_.testFlag(Qt::ControlModifier) ? SelectMode::remove
                                                                     : SelectMode::set;
  select_gaussians(document_, combined(before_, inside, mode), merge_id_);
  update();
}

}  // namespace brume
