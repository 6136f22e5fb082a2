#pragma once

#include <QImage>
#include <QString>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "render/display/to_display.h"

namespace brume {

struct Settings;

// Data that a rendered picture has besides its beauty.
struct PictureLayer {
  QString name;               // "airlight", "airlight.light_1"
  int channels = 3;           // or 1
  std::vector<float> values;  // of each pixel
};

// A rendered picture that is kept for comparison.
struct Picture {
  QString name;     // "Camera, frame 12"
  QString details;  // how it was made, and in what time
  int width = 0;
  int height = 0;
  std::vector<float> rgb;  // linear radiance, rows from the top
  DisplayLook look;        // that `image` shows it with
  QImage image;
  std::vector<PictureLayer> layers;

  // Linear radiance of a pixel, which is within the picture.
  [[nodiscard]] std::array<float, 3> at(int x, int y) const;
};

std::size_t layer_bytes(const Picture& picture);
std::shared_ptr<const Picture> without_layers(const Picture& picture);

std::shared_ptr<const Picture> make_picture(const Frame& frame, const DisplayLook& look,
                                            const QString& name, const QString& details);

// A layer as a picture of its own, distances as greys, near ones light, 0 where nothing is hit.
// Null: it has none by this name.
std::shared_ptr<const Picture> layer_picture(const Picture& picture, const QString& name);

// Writes what `image` shows as a PNG. Throws InputError.
void save_picture(const Picture& picture, const std::filesystem::path& file, const QString& name,
                  const QString& note);

// "16 slices · 800 × 600 · 1.2 s", of a path-traced frame with its noise.
QString picture_details(const Frame& frame, const Settings& settings, double milliseconds);

// RMS of A - B relative to that of B, over all channels; nullopt if their sizes differ.
std::optional<double> relative_difference(const Picture& a, const Picture& b);
// |A - B|, as A is shown and some stops brighter. Null if their sizes differ.
QImage difference_image(const Picture& a, const Picture& b, double stops);

}  // namespace brume
