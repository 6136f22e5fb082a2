#include "app/pictures/picture_scope.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace brume {
namespace {

constexpr int values = 256;
constexpr int max_pixels = 400'000;  // that are looked at
constexpr int max_columns = 512;

// The number of pixels that have a value, by channel, column and value.
class Counts {
 public:
  explicit Counts(int columns)
      : columns_(columns), counts_(static_cast<std::size_t>(3 * columns * values)) {}
  std::uint32_t& at(int channel, int column, int value) {
    return counts_[static_cast<std::size_t>((channel * columns_ + column) * values + value)];
  }
  [[nodiscard]] int columns() const { return columns_; }

 private:
  int columns_;
  std::vector<std::uint32_t> counts_;
};

// `column_of` says where a pixel counts, by its x and its value.
void count(const QImage& image, Counts& counts, auto&& column_of) {
  const int pixels = image.width() * image.height();
  const int step = std::max(1, pixels / max_pixels);
  for (int y = 0; y < image.height(); y += step) {
    const uchar* row = image.constScanLine(y);
    for (int x = 0; x < image.width(); ++x) {
      for (int c = 0; c < 3; ++c) {
        const int value = row[3 * x + c];
        ++counts.at(c, column_of(x, value), value);
      }
    }
  }
}

QImage black(int width) {
  QImage image(width, values, QImage::Format_RGB888);
  image.fill(Qt::black);
  return image;
}

// The share of the largest count, raised so that few pixels are seen, too.
int brightness(std::uint32_t count, std::uint32_t largest) {
  return count == 0 ? 0 : static_cast<int>(255.0 * std::pow(double{1.0} * count / largest, 0.3));
}

QImage waveform_of(const QImage& image) {
  const int columns = std::min(image.width(), max_columns);
  Counts counts(columns);
  count(image, counts, [&](int x, int) { return x * columns / image.width(); });
  std::uint32_t largest = 1;
  for (int c = 0; c < 3; ++c) {
    for (int x = 0; x < columns; ++x) {
      for (int v = 0; v < values; ++v) largest = std::max(largest, counts.at(c, x, v));
    }
  }
  QImage drawn = black(columns);
  for (int v = 0; v < values; ++v) {
    uchar* row = drawn.scanLine(values - 1 - v);
    for (int x = 0; x < columns; ++x) {
      for (int c = 0; c < 3; ++c) {
        row[3 * x + c] = static_cast<uchar>(brightness(counts.at(c, x, v), largest));
      }
    }
  }
  return drawn;
}

// Black and white, which much of a picture may be, do not make all else low.
QImage histogram_of(const QImage& image) {
  Counts counts(1);
  count(image, counts, [](int, int) { return 0; });
  std::uint32_t largest = 1;
  for (int c = 0; c < 3; ++c) {
    for (int v = 1; v < values - 1; ++v) largest = std::max(largest, counts.at(c, 0, v));
  }
  QImage drawn = black(values);
  for (int v = 0; v < values; ++v) {
    for (int c = 0; c < 3; ++c) {
      const double share = std::min(1.0, double{1.0} * counts.at(c, 0, v) / largest);
      const int height = static_cast<int>(std::ceil(share * values));
      for (int y = values - height; y < values; ++y) drawn.scanLine(y)[3 * v + c] = 200;
    }
  }
  return drawn;
}

}  // namespace

PictureScope::PictureScope(QWidget* parent) : QWidget(parent) {
  setObjectName("picture_scope");
  setMinimumSize(120, 130);
  hide();
}

void PictureScope::set_kind(Kind kind) {
  kind_ = kind;
  setVisible(kind != Kind::none);
  update_scope();
}

void PictureScope::show_image(const QImage& image) {
  image_ = image;
  update_scope();
}

void PictureScope::update_scope() {
  scope_ = {};
  if (!image_.isNull() && kind_ != Kind::none) {
    const QImage rgb = image_.convertToFormat(QImage::Format_RGB888);
    scope_ = kind_ == Kind::histogram ? histogram_of(rgb) : waveform_of(rgb);
  }
  update();
}

void PictureScope::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (!scope_.isNull()) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(rect(), scope_);
  }
  painter.setPen(QColor(255, 255, 255, 60));
  for (int k = 1; k < 4; ++k) {  // quarters of the values of the display
    if (kind_ == Kind::histogram) {
      painter.drawLine(width() * k / 4, 0, width() * k / 4, height());
    } else {
      painter.drawLine(0, height() * k / 4, width(), height() * k / 4);
    }
  }
}

}  // namespace brume
