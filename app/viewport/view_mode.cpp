#include "app/viewport/view_mode.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "render/frame.h"

namespace brume {
namespace {

constexpr double deepest = 4.0;         // optical depth at the end of the scale
constexpr double behind_outlines = -2;  // stops

QImage displayed(const Frame& frame, double exposure) {
  const auto bytes = to_display(frame, exposure);
  QImage image(frame.film.width, frame.film.height, QImage::Format_RGB888);
  const auto row = static_cast<std::size_t>(frame.film.width) * 3;
  for (int y = 0; y < frame.film.height; ++y) {
    std::memcpy(image.scanLine(y), bytes.data() + static_cast<std::size_t>(y) * row, row);
  }
  return image;
}

QImage airlight_only(const Frame& frame, double exposure) {
  Frame only;
  only.film = frame.film;
  const std::size_t pixels = frame.airlight.size() / 3;
  only.beauty.resize(4 * pixels, 1.0F);
  for (std::size_t k = 0; k < pixels; ++k) {
    std::copy_n(&frame.airlight[3 * k], 3, &only.beauty[4 * k]);
  }
  return displayed(only, exposure);
}

QImage depths(const Frame& frame) {
  QImage image(frame.film.width, frame.film.height, QImage::Format_RGB32);
  const float* transmittance = frame.transmittance.data();
  for (int y = 0; y < frame.film.height; ++y) {
    for (int x = 0; x < frame.film.width; ++x, transmittance += 3) {
      // Of green, where the three differ.
      const double t = std::clamp(static_cast<double>(transmittance[1]), 1e-30, 1.0);
      image.setPixel(x, y, depth_color(-std::log(t)));
    }
  }
  return image;
}

}  // namespace

QString view_mode_title(ViewMode mode) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("ViewMode", text); };
  switch (mode) {
    case ViewMode::final:
      return tr("Final Picture");
    case ViewMode::airlight:
      return tr("Airlight Only");
    case ViewMode::optical_depth:
      return tr("Optical Depth");
    case ViewMode::outlines:
      return tr("Outlines");
  }
  return {};
}

ViewMode next_view_mode(ViewMode mode) {
  return mode == ViewMode::outlines ? ViewMode::final
                                    : static_cast<ViewMode>(static_cast<int>(mode) + 1);
}

QImage to_picture(const Frame& frame, double exposure, ViewMode mode) {
  switch (mode) {
    case ViewMode::airlight:
      return airlight_only(frame, exposure);
    case ViewMode::optical_depth:
      return depths(frame);
    case ViewMode::outlines:
      return displayed(frame, exposure + behind_outlines);
    default:
      return displayed(frame, exposure);
  }
}

QRgb depth_color(double optical_depth) {
  // Lightness grows all the way, so that it can be read without colours too.
  struct Stop {
    double r, g, b;
  };
  static constexpr std::array stops{Stop{12, 7, 50},    Stop{60, 40, 120},  Stop{38, 110, 140},
                                    Stop{50, 165, 110}, Stop{150, 205, 70}, Stop{253, 240, 160}};
  const double at = std::clamp(optical_depth / deepest, 0.0, 1.0) * (stops.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double t = at - static_cast<double>(k);
  const auto mix = [t](double a, double b) {
    return static_cast<int>(std::lround(a + t * (b - a)));
  };
  return qRgb(mix(stops[k].r, stops[k + 1].r), mix(stops[k].g, stops[k + 1].g),
              mix(stops[k].b, stops[k + 1].b));
}

}  // namespace brume
