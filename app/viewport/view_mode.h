#pragma once

#include <QImage>
#include <QStringList>
#include <array>
#include <optional>

#include "render/gl/display_options.h"

namespace brume {

struct ErrorMap;
struct Frame;

// What a view shows of a frame.
enum class ViewMode {
  final,          // the picture
  airlight,       // only what the medium scatters to the eye
  optical_depth,  // of the medium from the eye to the first surface or through, as a false colour
  outlines,       // the picture, darker, under the outlines of all Gaussians
  cost,           // pairs of Gaussian and ray evaluated around each pixel, as a false colour
  error,          // the airlight's distance to the reference, as a false colour
};

inline constexpr std::array view_modes{ViewMode::final,         ViewMode::airlight,
                                       ViewMode::optical_depth, ViewMode::outlines,
                                       ViewMode::cost,          ViewMode::error};

QString view_mode_title(ViewMode mode);  // "Airlight Only"
ViewMode next_view_mode(ViewMode mode);

// Exposure in stops; it does not count for false colours. The error has its own, error_picture():
// until that is there, the picture is shown darker.
QImage to_picture(const Frame& frame, double exposure, ViewMode mode);
// The same of a frame that stays on the device; nullopt where that cannot be.
std::optional<gl::DisplayOptions> display_options(double exposure, ViewMode mode);
QImage error_picture(const ErrorMap& map);

// What false colours mean: the ends of the scale and what lies evenly between.
struct ColorScale {
  QString title;
  QStringList ticks;
};
// Empty where there are none. `map`: null while the error is not known yet.
ColorScale color_scale(const Frame& frame, ViewMode mode, const ErrorMap* map);

// The false colour of t, clamped to [0, 1]: dark blue over green to pale yellow.
QRgb false_color(double t);
// That of an optical depth >= 0, from 0 to 4.
QRgb depth_color(double optical_depth);

}  // namespace brume
