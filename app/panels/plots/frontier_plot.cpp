#include "app/panels/plots/frontier_plot.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "app/document/text/number_text.h"
#include "app/frames/frame_quality.h"
#include "app/widgets/frame_text.h"

namespace brume {
namespace {

constexpr double min_error = 1e-4;  // less is not told apart
constexpr double radius = 3.5;      // of a point [px]

double shown_error(double error) {
  return std::max(error, min_error);
}

// A power of ten in per cent; far beyond any use, only how far.
QString axis_text(double error) {
  return error > 9.0 ? QString("1e%1 %").arg(std::lround(std::log10(error)) + 2)
                     : bound_text(error);
}

double power_of_ten_below(double value) {
  return std::pow(10.0, std::floor(std::log10(value) + 1e-9));
}

}  // namespace

double FrontierPlot::Range::position(double value) const {
  return std::log(value / low) / std::log(high / low);
}

FrontierPlot::FrontierPlot(QWidget* parent) : QWidget(parent) {
  setObjectName("frontier");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void FrontierPlot::show_quality(const FrameQuality& quality) {
  std::vector<Point> points;
  const QualityControl& control = quality.control();
  for (const FrameQuality::Tried& tried : quality.tried()) {
    points.push_back({tried.settings, tried.error, std::max(tried.milliseconds, 0.1),
                      quality.is_measured() && tried.settings == quality.settings(),
                      tried.settings == control.settings()});
  }
  show_points(std::move(points), quality.max_error());
}

void FrontierPlot::show_points(std::vector<Point> points, double max_error) {
  points_ = std::move(points);
  max_error_ = max_error;
  double errors[] = {max_error_, max_error_};
  double times[] = {10.0, 10.0};
  for (const Point& point : points_) {
    errors[0] = std::min(errors[0], shown_error(point.error.low));
    errors[1] = std::max(errors[1], shown_error(point.error.high));
    times[0] = std::min(times[0], point.milliseconds);
    times[1] = std::max(times[1], point.milliseconds);
  }
  const auto around = [](const double(&ends)[2]) {
    return Range{power_of_ten_below(ends[0]), 10.0 * power_of_ten_below(ends[1])};
  };
  errors_ = around(errors);
  milliseconds_ = around(times);
  update();
}

QRectF FrontierPlot::area() const {
  const QFontMetricsF metrics(font());
  const double line = metrics.height();
  const QRectF inside = QRectF(rect()).adjusted(0, 0.5 * line, -6, -1.5 * line);
  double widest = metrics.horizontalAdvance("0.01 %");
  for (const double error : labelled_errors(inside.height())) {
    widest = std::max(widest, metrics.horizontalAdvance(axis_text(error)));
  }
  return inside.adjusted(widest + 4, 0, 0, 0);
}

std::vector<double> FrontierPlot::labelled_errors(double height) const {
  const double line = QFontMetricsF(font()).height();
  const double powers = std::log10(errors_.high / errors_.low);
  const double step = std::max(1.0, std::ceil(powers * line / std::max(height, 1.0)));
  std::vector<double> labelled;
  for (double power = 0.0; power < powers + 0.5; power += step) {
    labelled.push_back(errors_.low * std::pow(10.0, power));
  }
  return labelled;
}

std::vector<FrontierPlot::Label> FrontierPlot::error_labels() const {
  const QRectF area = this->area();
  const double line = QFontMetricsF(font()).height();
  std::vector<Label> labels;
  for (const double error : labelled_errors(area.height())) {
    labels.push_back(
        {QRectF(0, height_of(error) - 0.5 * line, area.left() - 4, line), axis_text(error)});
  }
  return labels;
}

double FrontierPlot::height_of(double error) const {
  return area().bottom() - area().height() * errors_.position(shown_error(error));
}

QPointF FrontierPlot::position(const Point& point) const {
  return {area().left() + area().width() * milliseconds_.position(point.milliseconds),
          height_of(point.error.rel_rmse)};
}

bool FrontierPlot::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  for (const Point& point : points_) {
    const QPointF off = position(point) - QPointF(help->pos());
    if (std::hypot(off.x(), off.y()) > 2.0 * radius) continue;
    QString text = tr("%1: %2 in %3")
                       .arg(settings_text(point.settings), error_text(point.error),
                            duration_text(point.milliseconds));
    if (point.is_shown) text += tr("\nOn screen");
    if (point.is_auto_choice) text += tr("\nAuto's choice");
    QToolTip::showText(help->globalPos(), text, this);
    return true;
  }
  QToolTip::showText(help->globalPos(),
                     tr("Settings tried in this scene: error against milliseconds per frame. "
                        "Filled point: on screen; ring: auto's choice; line: error bound."),
                     this);
  return true;
}

void FrontierPlot::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = this->area();
  const QColor text = palette().color(QPalette::WindowText);
  QColor faint = text;
  faint.setAlphaF(0.15F);
  painter.fillRect(area, palette().base());

  for (double value = errors_.low; value < 1.01 * errors_.high; value *= 10.0) {
    const double y = height_of(value);
    painter.setPen(faint);
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
  }
  painter.setPen(text);
  for (const Label& label : error_labels()) {
    painter.drawText(label.place, Qt::AlignRight | Qt::AlignVCenter, label.text);
  }
  for (double value = milliseconds_.low; value < 1.01 * milliseconds_.high; value *= 10.0) {
    const double x = area.left() + area.width() * milliseconds_.position(value);
    painter.setPen(faint);
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  }
  // Only the ends have room for their numbers.
  painter.setPen(text);
  const QRectF below(area.left() - 12, area.bottom(), area.width() + 18, height() - area.bottom());
  const QString low = tr("%1 ms").arg(number_text(milliseconds_.low));
  const QString high = tr("%1 ms").arg(number_text(milliseconds_.high));
  if (QFontMetricsF(font()).horizontalAdvance(low + "  " + high) <= below.width()) {
    painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, low);
  }
  painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter, high);
  const QColor accent = palette().color(QPalette::Highlight);
  painter.setPen(QPen(accent, 1, Qt::DashLine));
  painter.drawLine(QPointF(area.left(), height_of(max_error_)),
                   QPointF(area.right(), height_of(max_error_)));

  for (const Point& point : points_) {
    const QPointF dot_position = position(point);
    painter.setPen(text);
    painter.drawLine(QPointF(dot_position.x(), height_of(point.error.low)),
                     QPointF(dot_position.x(), height_of(point.error.high)));
    painter.setBrush(point.is_shown ? accent : palette().base());
    painter.drawEllipse(dot_position, radius, radius);
    if (!point.is_auto_choice) continue;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(accent, 1.5));
    painter.drawEllipse(dot_position, radius + 3.0, radius + 3.0);
  }
}

}  // namespace brume
