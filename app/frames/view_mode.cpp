#include "app/frames/view_mode.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "app/document/text/number_text.h"
#include "app/frames/error_map.h"
#include "app/widgets/frame_image.h"
#include "app/widgets/frame_text.h"
#include "brume/frame.h"

namespace brume {
namespace {

constexpr double deepest = 4.0;      // optical depth at the end of the scale
constexpr double min_error = 0.001;  // the scale of errors is logarithmic
constexpr double error_decades = 2.0;
constexpr int cost_block = 8;           // pixels that a cost is the mean of, either way
constexpr double behind_outlines = -2;  // stops

QImage airlight_only(const Frame& frame, const DisplayLook& look) {
  Frame only;
  only.film = frame.film;
  const std::size_t pixels = frame.airlight.size() / 3;
  only.beauty.resize(4 * pixels, 1.0F);
  for (std::size_t k = 0; k < pixels; ++k) {
    std::copy_n(&frame.airlight[3 * k], 3, &only.beauty[4 * k]);
  }
  return frame_image(only, {look.exposure, look.view});
}

QImage depths(const Frame& frame) {
  QImage image(frame.film.width, frame.film.height, QImage::Format_RGB32);
  const float* transmittance = frame.transmittance.data();
  for (int y = 0; y < frame.film.height; ++y) {
    for (int x = 0; x < frame.film.width; ++x, transmittance += 3) {
      // Green stands for all where the three differ.
      const double t = std::clamp(static_cast<double>(transmittance[1]), 1e-30, 1.0);
      image.setPixel(x, y, depth_color(-std::log(t)));
    }
  }
  return image;
}

QString mode_text(const char* text) {
  return QCoreApplication::translate("ViewMode", text);
}

// Means over blocks: where airlight is interpolated, only some pixels cost anything.
struct Costs {
  int columns = 0;
  std::vector<double> means;
  double scale = 1.0;  // the largest, rounded up to 1, 2 or 5 times a power of ten
};

Costs costs_of(const Frame& frame) {
  const auto blocks = [](int pixels) { return (pixels + cost_block - 1) / cost_block; };
  Costs costs;
  costs.columns = blocks(frame.film.width);
  const auto count =
      static_cast<std::size_t>(costs.columns) * static_cast<std::size_t>(blocks(frame.film.height));
  costs.means.assign(count, 0.0);
  const std::vector<float>& pairs = frame.statistics.pixel_pairs;
  if (pairs.empty()) return costs;
  std::vector<int> pixels(count, 0);
  const auto width = static_cast<std::size_t>(frame.film.width);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::size_t block =
        i / width / cost_block * static_cast<std::size_t>(costs.columns) + i % width / cost_block;
    costs.means[block] += static_cast<double>(pairs[i]);
    ++pixels[block];
  }
  for (std::size_t k = 0; k < count; ++k) costs.means[k] /= pixels[k];
  const double max_value = *std::max_element(costs.means.begin(), costs.means.end());
  if (!(max_value > 0.0)) return costs;
  costs.scale = std::pow(10.0, std::floor(std::log10(max_value)));
  for (const double step : {2.0, 2.5, 2.0}) {
    if (costs.scale < max_value) costs.scale *= step;
  }
  return costs;
}

QImage cost_picture(const Frame& frame) {
  const Costs costs = costs_of(frame);
  QImage image(frame.film.width, frame.film.height, QImage::Format_RGB32);
  for (int y = 0; y < frame.film.height; ++y) {
    for (int x = 0; x < frame.film.width; ++x) {
      const auto block = static_cast<std::size_t>(y / cost_block * costs.columns + x / cost_block);
      image.setPixel(x, y, false_color(costs.means[block] / costs.scale));
    }
  }
  return image;
}

}  // namespace

QString view_mode_title(ViewMode mode) {
  switch (mode) {
    case ViewMode::final:
      return mode_text("Final Picture");
    case ViewMode::airlight:
      return mode_text("Airlight Only");
    case ViewMode::optical_depth:
      return mode_text("Optical Depth");
    case ViewMode::outlines:
      return mode_text("Outlines");
    case ViewMode::cost:
      return mode_text("Cost");
    case ViewMode::error:
      return mode_text("Error Against the Reference");
    case ViewMode::path_traced:
      return mode_text("Path Traced");
  }
  return {};
}

ViewMode next_view_mode(ViewMode mode) {
  return mode == view_modes.back() ? view_modes.front()
                                   : static_cast<ViewMode>(static_cast<int>(mode) + 1);
}

QImage to_picture(const Frame& frame, const DisplayLook& look, ViewMode mode) {
  switch (mode) {
    case ViewMode::airlight:
      return airlight_only(frame, look);
    case ViewMode::optical_depth:
      return depths(frame);
    case ViewMode::cost:
      return cost_picture(frame);
    case ViewMode::outlines:
    case ViewMode::error:
      return frame_image(frame, {look.exposure + behind_outlines, look.view});
    default:
      return frame_image(frame, look);
  }
}

std::optional<gl::DisplayOptions> display_options(const DisplayLook& look, ViewMode mode) {
  if (look.view) return std::nullopt;
  using Layer = gl::DisplayOptions::Layer;
  switch (mode) {
    case ViewMode::final:
    case ViewMode::path_traced:
      if (look.plate) return std::nullopt;
      return {{.layer = Layer::beauty, .exposure = look.exposure}};
    case ViewMode::outlines:
    case ViewMode::error:
      return {{.layer = Layer::beauty, .exposure = look.exposure + behind_outlines}};
    case ViewMode::airlight:
      return {{.layer = Layer::airlight, .exposure = look.exposure}};
    default:
      return std::nullopt;
  }
}

QImage error_picture(const ErrorMap& map) {
  QImage image(map.film.width, map.film.height, QImage::Format_RGB32);
  const float* error = map.error.data();
  for (int y = 0; y < map.film.height; ++y) {
    for (int x = 0; x < map.film.width; ++x, ++error) {
      const double e = std::max(static_cast<double>(*error), min_error);
      image.setPixel(x, y, false_color(std::log10(e / min_error) / error_decades));
    }
  }
  return image;
}

ColorScale color_scale(const Frame& frame, ViewMode mode, const ErrorMap* map) {
  switch (mode) {
    case ViewMode::optical_depth:
      return {mode_text("Optical depth"), {"0", "1", "2", "3", "4"}};
    case ViewMode::cost: {
      const double max_value = costs_of(frame).scale;
      return {mode_text("Pairs of Gaussian and ray per pixel"),
              {"0", number_text(0.5 * max_value), number_text(max_value)}};
    }
    case ViewMode::error: {
      if (!map) return {mode_text("Error: waiting for the measurement"), {}};
      QString title =
          map->all_orders ? mode_text("Error, all orders of scattering") : mode_text("Error");
      if (map->done < 1.0) {
        title += mode_text(", %1 % of the pixels").arg(fixed_text(100.0 * map->done, 0));
      }
      return {title, {"0.1 %", "1 %", "10 %"}};
    }
    case ViewMode::path_traced: {
      const QString paths = paths_text(frame);
      return {paths.isEmpty() ? mode_text("Path traced: waiting for the first paths")
                              : mode_text("Path traced, %1").arg(paths),
              {}};
    }
    default:
      return {};
  }
}

QRgb depth_color(double optical_depth) {
  return false_color(optical_depth / deepest);
}

QRgb false_color(double t) {
  // Lightness grows all the way, so that it can be read without colours too.
  struct Stop {
    double r, g, b;
  };
  static constexpr std::array stops{Stop{12, 7, 50},    Stop{60, 40, 120},  Stop{38, 110, 140},
                                    Stop{50, 165, 110}, Stop{150, 205, 70}, Stop{253, 240, 160}};
  const double place = std::clamp(t, 0.0, 1.0) * (stops.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const double part = place - static_cast<double>(k);
  const auto mix = [part](double a, double b) {
    return static_cast<int>(std::lround(a + part * (b - a)));
  };
  return qRgb(mix(stops[k].r, stops[k + 1].r), mix(stops[k].g, stops[k + 1].g),
              mix(stops[k].b, stops[k + 1].b));
}

}  // namespace brume
