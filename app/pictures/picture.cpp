#include "app/pictures/picture.h"

#include <cmath>
#include <cstring>

#include "app/document/number_text.h"
#include "app/widgets/frame_text.h"
#include "brume/frame.h"
#include "brume/version.h"
#include "core/io/image/image_file.h"
#include "core/number_domain.h"
#include "render/output/compare.h"

namespace brume {
namespace {

QImage shown(const Frame& frame, const DisplayLook& look) {
  const std::vector<std::uint8_t> bytes = to_display(frame, look);
  QImage image(frame.film.width, frame.film.height, QImage::Format_RGB888);
  const auto row = static_cast<std::size_t>(frame.film.width) * 3;
  for (int y = 0; y < frame.film.height; ++y) {
    std::memcpy(image.scanLine(y), bytes.data() + static_cast<std::size_t>(y) * row, row);
  }
  return image;
}

bool have_same_size(const Picture& a, const Picture& b) {
  return a.width == b.width && a.height == b.height;
}

}  // namespace

std::array<float, 3> Picture::at(int x, int y) const {
  const float* pixel = &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                 static_cast<std::size_t>(x))];
  return {pixel[0], pixel[1], pixel[2]};
}

std::shared_ptr<const Picture> make_picture(const Frame& frame, const DisplayLook& look,
                                            const QString& name, const QString& details) {
  auto picture = std::make_shared<Picture>();
  picture->name = name;
  picture->details = details;
  picture->width = frame.film.width;
  picture->height = frame.film.height;
  const std::size_t pixels = frame.beauty.size() / 4;
  picture->rgb.resize(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    std::copy_n(&frame.beauty[4 * i], 3, &picture->rgb[3 * i]);
  }
  picture->look = look;
  picture->image = shown(frame, look);
  return picture;
}

void save_picture(const Picture& picture, const std::filesystem::path& file) {
  std::vector<std::uint8_t> bytes;
  const auto row = static_cast<std::size_t>(picture.width) * 3;
  bytes.reserve(row * static_cast<std::size_t>(picture.height));
  for (int y = 0; y < picture.height; ++y) {
    const uchar* line = picture.image.constScanLine(y);
    bytes.insert(bytes.end(), line, line + row);
  }
  write_png(file, picture.width, picture.height, bytes,
            {{"Software", std::string("Brume ") + version()},
             {"brume:exposure", quoted_text(picture.look.exposure)},
             {"brume:view_transform", view_name(picture.look)},
             {"brume:made", picture.details.toStdString()}});
}

QString picture_details(const Frame& frame, const Settings& settings, double milliseconds) {
  const QString paths = paths_text(frame);
  return QString("%1 · %2 × %3 · %4")
      .arg(paths.isEmpty() ? settings_text(settings) : paths)
      .arg(frame.film.width)
      .arg(frame.film.height)
      .arg(duration_text(milliseconds));
}

std::optional<double> relative_difference(const Picture& a, const Picture& b) {
  if (!have_same_size(a, b)) return std::nullopt;
  const ChannelPair all{a.rgb, b.rgb};
  return compare({&all, 1}).rel_rmse;
}

QImage difference_image(const Picture& a, const Picture& b, double stops) {
  if (!have_same_size(a, b)) return {};
  Frame frame;
  frame.film = {a.width, a.height};
  frame.beauty.resize(a.rgb.size() / 3 * 4, 1.0F);
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    frame.beauty[i / 3 * 4 + i % 3] = std::abs(a.rgb[i] - b.rgb[i]);
  }
  return shown(frame, {a.look.exposure + stops, a.look.view});
}

}  // namespace brume
