#include "app/panels/time/curve_axes.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/document/text/number_text.h"
#include "app/document/time/timeline.h"

namespace brume {

CurveAxes::Range CurveAxes::range(std::size_t track) const {
  return track < ranges_.size() ? ranges_[track] : Range();
}

QPointF CurveAxes::position(double time, double value, std::size_t track) const {
  return {scale().x_of(timeline_.frame_of(time)),
          (range(track).high - value) / value_per_pixel(track)};
}

double CurveAxes::time_at(double x) const {
  return timeline_.time_of(scale().frame_at(x));
}

double CurveAxes::value_at(double y, std::size_t track) const {
  return range(track).high - y * value_per_pixel(track);
}

double CurveAxes::time_per_pixel() const {
  return timeline_.time_of(scale().frames_per_pixel());
}

double CurveAxes::value_per_pixel(std::size_t track) const {
  const Range shown = range(track);
  return (shown.high - shown.low) / std::max(1.0, size_.height());
}

void CurveAxes::fit(const std::vector<Curve>& curves) {
  std::vector<std::optional<Range>> found;
  for (const Curve& curve : curves) {
    found.resize(std::max(found.size(), curve.track + 1));
    std::optional<Range>& values = found[curve.track];
    const auto include = [&values](double value) {
      if (!values) values = Range{value, value};
      values->low = std::min(values->low, value);
      values->high = std::max(values->high, value);
    };
    const std::vector<Curve::Point> points = curve.points();
    for (const Curve::Point& point : points) include(point.value);
    constexpr int samples = 200;  // tangents lead beyond the keys
    for (int k = 1; k < samples; ++k) {
      const double part = static_cast<double>(k) / samples;
      include(curve.at(std::lerp(points.front().time, points.back().time, part)));
    }
  }
  ranges_.clear();
  for (const std::optional<Range>& values : found) {
    const Range shown = values.value_or(Range());
    // A constant has no range of its own.
    const double length =
        shown.high > shown.low ? shown.high - shown.low : std::max(1.0, std::abs(shown.high));
    const double middle = 0.5 * (shown.low + shown.high);
    constexpr double margin = 0.1;
    ranges_.push_back({middle - (0.5 + margin) * length, middle + (0.5 + margin) * length});
  }
}

void CurveAxes::pan(double pixels) {
  for (std::size_t k = 0; k < ranges_.size(); ++k) {
    const double shift = pixels * value_per_pixel(k);
    ranges_[k].low += shift;
    ranges_[k].high += shift;
  }
}

void CurveAxes::zoom(double y, double factor) {
  for (std::size_t k = 0; k < ranges_.size(); ++k) {
    const double fixed = value_at(y, k);
    Range& shown = ranges_[k];
    const double length = shown.high - shown.low;
    const double zoomed = std::clamp(length * factor, 1e-9, 1e12) / length;
    shown = {fixed + zoomed * (shown.low - fixed), fixed + zoomed * (shown.high - fixed)};
  }
}

void CurveAxes::paint_values(QPainter& painter, const QWidget& widget, std::size_t track) const {
  constexpr double between_lines = 42.0;  // pixels
  QColor line = widget.palette().color(QPalette::Text);
  QColor text = line;
  line.setAlphaF(0.12F);
  text.setAlphaF(0.6F);
  const Range shown = range(track);
  const double step = round_step(between_lines * value_per_pixel(track));
  for (double k = std::ceil(shown.low / step); k * step <= shown.high; ++k) {
    const double y = position(0.0, k * step, track).y();
    painter.setPen(line);
    painter.drawLine(QPointF(0, y), QPointF(size_.width(), y));
    painter.setPen(text);
    painter.drawText(QPointF(4, y - 3), number_text(k * step, 5));
  }
}

}  // namespace brume
