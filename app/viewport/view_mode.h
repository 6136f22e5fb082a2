#pragma once

#include <QImage>
#include <array>

namespace brume {

struct Frame;

// What a view shows of a frame.
enum class ViewMode {
  final,          // the picture
  airlight,       // only what the medium scatters to the eye
  optical_depth,  // of the medium from the eye to the first surface or through, as a false colour
  outlines,       // the picture, darker, under the outlines of all Gaussians
};

inline constexpr std::array view_modes{ViewMode::final, ViewMode::airlight, ViewMode::optical_depth,
                                       ViewMode::outlines};

QString view_mode_title(ViewMode mode);  // "Airlight Only"
ViewMode next_view_mode(ViewMode mode);

// Exposure in stops; it does not count for optical depths.
QImage to_picture(const Frame& frame, double exposure, ViewMode mode);

// The false colour of an optical depth >= 0: dark blue at 0, over green, to pale yellow from 4 on.
QRgb depth_color(double optical_depth);

}  // namespace brume
