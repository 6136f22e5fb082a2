#pragma once

#include <QImage>
#include <QStringList>
#include <array>
#include <optional>

#include "render/display/to_display.h"
#include "render/gl/display_options.h"

namespace brume {

struct ErrorMap;
struct Frame;

// View modes.
enum class ViewMode {
  final,          // the picture
  airlight,       // airlight only
  optical_depth,  // optical depth to the first surface or infinity, false colours
  outlines,       // dimmed picture with outlines of all Gaussians
  cost,           // Gaussian x ray pairs per pixel, false colours
  error,          // error of the airlight, false colours
  path_traced,    // the picture by paths, more and more of them while nothing changes
};

inline constexpr std::array view_modes{
    ViewMode::final, ViewMode::airlight, ViewMode::optical_depth, ViewMode::outlines,
    ViewMode::cost,  ViewMode::error,    ViewMode::path_traced};

QString view_mode_title(ViewMode mode);  // "Airlight Only"
ViewMode next_view_mode(ViewMode mode);

// `look` is ignored for false colours. In error mode, the dimmed picture until
// error_picture() is available.
QImage to_picture(const Frame& frame, const DisplayLook& look, ViewMode mode);
// The same for a frame on the device; nullopt if unsupported.
std::optional<gl::DisplayOptions> display_options(const DisplayLook& look, ViewMode mode);
QImage error_picture(const ErrorMap& map);

// Title and equidistant tick labels of a false-colour scale; or a title alone.
struct ColorScale {
  QString title;
  QStringList ticks;
};
// Empty for modes without. `map`: may be null.
ColorScale color_scale(const Frame& frame, ViewMode mode, const ErrorMap* map);

// The false colour of t, clamped to [0, 1]: dark blue over green to pale yellow.
QRgb false_color(double t);
// That of an optical depth >= 0, from 0 to 4.
QRgb depth_color(double optical_depth);

}  // namespace brume
