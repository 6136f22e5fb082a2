#include "app/pictures/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/document/text/number_text.h"
#include "app/widgets/frame_image.h"
#include "app/widgets/frame_text.h"
#include "brume/frame.h"
#include "brume/version.h"
#include "core/io/image/image_file.h"
#include "core/number_domain.h"
#include "render/output/compare.h"

namespace brume {
namespace {

constexpr const char* distance_layer = "distance";

// Adds the layers of light, and distances.
void add_layers(const Frame& frame, Picture& picture) {
  const auto add = [&picture](const QString& name, int channels, std::vector<float> values) {
    const std::size_t count = static_cast<std::size_t>(picture.width * picture.height * channels);
    if (values.size() == count) picture.layers.push_back({name, channels, std::move(values)});
  };
  add("airlight", 3, frame.airlight);
  add("transmittance", 3, frame.transmittance);
  add("background", 3, frame.background);
  add(distance_layer, 1, frame.depth);
  const auto& channels = frame.layers.channels;
  for (const auto& [name, red] : channels) {
    const QString layer = QString::fromStdString(name).section('.', 0, -2);
    const auto channel = [&](const char* component) {
      const auto found = channels.find(layer.toStdString() + component);
      return found == channels.end() ? nullptr : &found->second;
    };
    const bool is_vector = name.ends_with(".X");
    const auto* green = channel(is_vector ? ".Y" : ".G");
    const auto* blue = channel(is_vector ? ".Z" : ".B");
    if (!(is_vector || name.ends_with(".R")) || !green || !blue || layer.startsWith("Crypto")) {
      continue;
    }
    std::vector<float> values;
    values.reserve(3 * red.size());
    for (std::size_t i = 0; i < red.size(); ++i) {
      values.insert(values.end(), {red[i], (*green)[i], (*blue)[i]});
    }
    add(layer, 3, std::move(values));
  }
}

// Distances run from the nearest, white, to the farthest.
QImage layer_image(const PictureLayer& layer, const Picture& picture) {
  Frame frame;
  frame.film = {picture.width, picture.height};
  frame.beauty.assign(picture.rgb.size() / 3 * 4, 1.0F);
  float nearest = std::numeric_limits<float>::infinity();
  float farthest = 0.0F;
  for (const float value : layer.name == distance_layer ? layer.values : std::vector<float>()) {
    if (!std::isfinite(value)) continue;  // nothing is hit
    nearest = std::min(nearest, value);
    farthest = std::max(farthest, value);
  }
  const float range = std::max(farthest - nearest, std::numeric_limits<float>::min());
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    float value = picture.rgb[i];
    if (layer.name == distance_layer) {
      value = value > 0.0F ? 1.0F - 0.95F * (value - nearest) / range : 0.0F;
    }
    frame.beauty[i / 3 * 4 + i % 3] = std::max(value, 0.0F);
  }
  return frame_image(frame, layer.name == distance_layer ? DisplayLook() : picture.look);
}

// A picture without radiance and layers.
Picture head_of(const Picture& picture) {
  return {.name = picture.name,
          .details = picture.details,
          .width = picture.width,
          .height = picture.height,
          .rgb = {},
          .look = picture.look,
          .image = {},
          .layers = {}};
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

std::size_t layer_bytes(const Picture& picture) {
  std::size_t bytes = 0;
  for (const PictureLayer& layer : picture.layers) bytes += layer.values.size() * sizeof(float);
  return bytes;
}

std::shared_ptr<const Picture> without_layers(const Picture& picture) {
  auto result = std::make_shared<Picture>(head_of(picture));
  result->rgb = picture.rgb;
  result->image = picture.image;
  return result;
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
  picture->image = frame_image(frame, look);
  add_layers(frame, *picture);
  return picture;
}

std::shared_ptr<const Picture> layer_picture(const Picture& picture, const QString& name) {
  const auto layer = std::ranges::find(picture.layers, name, &PictureLayer::name);
  if (layer == picture.layers.end()) return nullptr;
  auto result = std::make_shared<Picture>(head_of(picture));
  const int copies = layer->channels == 1 ? 3 : 1;  // greys
  result->rgb.reserve(layer->values.size() * static_cast<std::size_t>(copies));
  for (const float value : layer->values) {
    result->rgb.insert(result->rgb.end(), copies, std::isfinite(value) ? value : 0.0F);
  }
  result->image = layer_image(*layer, *result);
  return result;
}

void save_picture(const Picture& picture, const std::filesystem::path& file, const QString& name,
                  const QString& note) {
  std::vector<std::uint8_t> bytes;
  const auto row = static_cast<std::size_t>(picture.width) * 3;
  bytes.reserve(row * static_cast<std::size_t>(picture.height));
  for (int y = 0; y < picture.height; ++y) {
    const uchar* line = picture.image.constScanLine(y);
    bytes.insert(bytes.end(), line, line + row);
  }
  write_png(file, picture.width, picture.height, bytes,
            {{"Software", std::string("Brume ") + version()},
             {"Title", name.toStdString()},
             {"Comment", note.toStdString()},
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
  return frame_image(frame, {a.look.exposure + stops, a.look.view});
}

}  // namespace brume
