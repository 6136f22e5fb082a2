#include "app/panels/time/curve_axes.h"

#include <QPainter>
#include <QPalette>
#include <algorithm>
#include <cmath>

#include "app/document/number_text.h"
#include "app/document/timeline.h"

namespace brume {
namespace {

// 1, 2 or 5 times a power of ten, at least `step`.
double round_step(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= step) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

QPointF CurveAxes::position(double time, double value) const {
  return {(time - shown_.left()) / time_per_pixel(), (shown_.bottom() - value) / value_per_pixel()};
}

double CurveAxes::time_at(double x) const {
  return shown_.left() + x * time_per_pixel();
}

double CurveAxes::value_at(double y) const {
  return shown_.bottom() - y * value_per_pixel();
}

double CurveAxes::time_per_pixel() const {
  return shown_.width() / std::max(1.0, size_.width());
}

double CurveAxes::value_per_pixel() const {
  return shown_.height() / plot_height();
}

void CurveAxes::fit(const std::vector<Curve>& curves, const Timeline& timeline) {
  if (curves.empty()) return;
  double begin = timeline.time_of(timeline.first());
  double end = timeline.time_of(timeline.last());
  double low = curves.front().points().front().value;
  double high = low;
  const auto include = [&](double time, double value) {
    begin = std::min(begin, time);
    end = std::max(end, time);
    low = std::min(low, value);
    high = std::max(high, value);
  };
  for (const Curve& curve : curves) {
    const std::vector<Curve::Point> points = curve.points();
    for (const Curve::Point& point : points) include(point.time, point.value);
    constexpr int samples = 200;  // tangents lead beyond the keys
    for (int k = 1; k < samples; ++k) {
      const double time =
          std::lerp(points.front().time, points.back().time, static_cast<double>(k) / samples);
      include(time, curve.at(time));
    }
  }
  // A constant has no range of its own.
  const double range = high > low ? high - low : std::max(1.0, std::abs(high));
  const double length = std::max(end - begin, timeline.time_of(1));
  const double middle = 0.5 * (low + high);
  constexpr double margin = 0.1;
  shown_ = QRectF(begin - 0.03 * length, middle - (0.5 + margin) * range, 1.06 * length,
                  (1.0 + 2.0 * margin) * range);
}

void CurveAxes::pan(const QPointF& pixels) {
  shown_.translate(-pixels.x() * time_per_pixel(), pixels.y() * value_per_pixel());
}

void CurveAxes::zoom(const QPointF& at, double in_time, double in_value) {
  const double time = time_at(at.x());
  const double value = value_at(at.y());
  const double width = std::clamp(shown_.width() * in_time, 1e-3, 1e6);
  const double height = std::clamp(shown_.height() * in_value, 1e-9, 1e12);
  shown_ = QRectF(time - (time - shown_.left()) * width / shown_.width(),
                  value - (value - shown_.top()) * height / shown_.height(), width, height);
}

void CurveAxes::paint_grid(QPainter& painter, const QPalette& palette,
                           const Timeline& timeline) const {
  constexpr double between_lines = 60.0;  // pixels
  QColor line = palette.color(QPalette::Text);
  QColor text = line;
  line.setAlphaF(0.12F);
  text.setAlphaF(0.6F);
  const double width = size_.width();
  const QRectF ruler(0.0, plot_height(), width, ruler_height);
  painter.fillRect(ruler, palette.color(QPalette::AlternateBase));
  const double frames = timeline.frame_of(shown_.width());
  const double column = std::max(1.0, round_step(frames * between_lines / width));
  const double left = timeline.frame_of(shown_.left());
  for (double f = std::ceil(left / column) * column; f <= left + frames; f += column) {
    const double x = position(timeline.time_of(f), 0.0).x();
    painter.setPen(line);
    painter.drawLine(QPointF(x, 0), QPointF(x, size_.height()));
    painter.setPen(text);
    painter.drawText(QPointF(x + 3, size_.height() - 5), number_text(f));
  }
  const double row = round_step(between_lines * 0.7 * value_per_pixel());
  const double first_row = std::ceil(shown_.top() / row);
  for (double k = first_row; k * row <= shown_.bottom(); ++k) {
    const double y = position(0.0, k * row).y();
    painter.setPen(line);
    painter.drawLine(QPointF(0, y), QPointF(width, y));
    painter.setPen(text);
    painter.drawText(QPointF(4, y - 3), number_text(k * row, 5));
  }
}

}  // namespace brume
