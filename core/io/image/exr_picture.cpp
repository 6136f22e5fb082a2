#include "core/io/image/exr_picture.h"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>

#include <array>
#include <cstddef>

#include "brume/error.h"
#include "core/io/image/exr_color.h"
#include "core/io/image/exr_limits.h"
#include "core/io/image/exr_reading.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t longest_list = 600;  // of channels, in an error

// Where a file has its picture.
struct PictureChannels {
  enum class Kind { rgb, luminance, luminance_chroma };
  int part = 0;
  Kind kind = Kind::rgb;
  std::array<std::string, 3> names;  // of red, green, blue
};

// Nuke's layers have the long names.
constexpr std::array<std::array<const char*, 3>, 3> rgb_names{
    {{"R", "G", "B"}, {"r", "g", "b"}, {"red", "green", "blue"}}};

bool has(const Imf::ChannelList& channels, const std::string& name) {
  return channels.findChannel(name) != nullptr;
}

// The layers of a part that have colours; without a name it is the picture itself.
std::vector<PictureChannels> color_layers(const Imf::ChannelList& channels, int part) {
  std::vector<PictureChannels> layers;
  for (auto c = channels.begin(); c != channels.end(); ++c) {
    const std::string name = c.name();
    const std::size_t base = name.rfind('.') + 1;  // 0 without a dot
    const std::string layer = name.substr(0, base);
    for (const auto& [red, green, blue] : rgb_names) {
      if (name.substr(base) != red) continue;
      if (!has(channels, layer + green) || !has(channels, layer + blue)) continue;
      layers.push_back({part, PictureChannels::Kind::rgb, {name, layer + green, layer + blue}});
    }
  }
  return layers;
}

std::string list_of_channels(const Imf::MultiPartInputFile& input) {
  std::string list;
  for (int part = 0; part < input.parts(); ++part) {
    const Imf::Header& header = input.header(part);
    if (input.parts() > 1) {
      list += (part > 0 ? "; part " : "part ") + std::to_string(part + 1);
      list += is_flat(header) ? ":" : " (deep):";
    }
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
      list += (list.empty() ? "" : " ") + std::string(c.name());
    }
  }
  return quoted_text(list, longest_list);
}

PictureChannels find_picture(const fs::path& file, const Imf::MultiPartInputFile& input) {
  using Kind = PictureChannels::Kind;
  std::vector<PictureChannels> layers;
  std::optional<PictureChannels> luminance;
  bool has_flat = false;
  for (int part = 0; part < input.parts(); ++part) {
    if (!is_flat(input.header(part))) continue;
    has_flat = true;
    const Imf::ChannelList& channels = input.header(part).channels();
    for (const PictureChannels& layer : color_layers(channels, part)) {
      if (layer.names[0].find('.') == std::string::npos) return layer;
      layers.push_back(layer);
    }
    // X Y Z are positions, or CIE's.
    if (luminance || !has(channels, "Y") || has(channels, "X")) continue;
    const bool has_chroma = has(channels, "RY") && has(channels, "BY");
    if (has_chroma && input.parts() > 1) continue;  // OpenEXR reads it of single parts only
    luminance = {part, has_chroma ? Kind::luminance_chroma : Kind::luminance, {"Y", "", ""}};
  }
  if (!has_flat) throw InputError(file, "header", "found only deep images; allowed: a flat one");
  if (luminance) return *luminance;
  if (layers.size() == 1) return layers.front();
  throw InputError(file, "header",
                   std::string(layers.empty() ? "there are no channels R G B or Y"
                                              : "there are no channels R G B, but several layers "
                                                "that have them") +
                       "; its channels: " + list_of_channels(input));
}

// Half precision, as OpenEXR converts luminance and chroma.
void read_rgba(const fs::path& file, ExrPicture& picture) {
  Imf::RgbaInputFile input(file.c_str());
  const Imath::Box2i window = input.dataWindow();
  std::vector<Imf::Rgba> row(static_cast<std::size_t>(picture.width));
  input.setFrameBuffer(row.data() - window.min.x, 1, 0);  // every row
  for (int y = window.min.y; y <= window.max.y; ++y) {
    input.readPixels(y);
    for (const Imf::Rgba& pixel : row) picture.pixels.emplace_back(pixel.r, pixel.g, pixel.b);
  }
}

void read_floats(Imf::InputPart& part, const Imath::Box2i& window, const PictureChannels& channels,
                 ExrPicture& picture) {
  picture.pixels.resize(static_cast<std::size_t>(picture.width) *
                        static_cast<std::size_t>(picture.height));
  const bool is_rgb = channels.kind == PictureChannels::Kind::rgb;
  Imf::FrameBuffer frame;
  for (int k = 0; k < (is_rgb ? 3 : 1); ++k) {
    frame.insert(channels.names[static_cast<std::size_t>(k)],
                 Imf::Slice::Make(Imf::FLOAT, &picture.pixels.front()[k], window, sizeof(glm::vec3),
                                  sizeof(glm::vec3) * static_cast<std::size_t>(picture.width)));
  }
  part.setFrameBuffer(frame);
  part.readPixels(window.min.y, window.max.y);
  if (is_rgb) return;
  for (glm::vec3& pixel : picture.pixels) pixel = glm::vec3(pixel.x);
}

void read_chromaticities(const fs::path& file, const Imf::Header& header, ExrPicture& picture,
                         std::vector<std::string>* warnings) {
  if (!Imf::hasChromaticities(header)) return;
  const Imf::Chromaticities& chromaticities = Imf::chromaticities(header);
  if (chromaticities == Imf::Chromaticities()) return;
  picture.to_rec709 = to_rec709(chromaticities);
  if (picture.to_rec709 || warnings == nullptr) return;
  warnings->push_back(InputError(file, "attribute chromaticities",
                                 "they span no colours, so the picture is taken as linear Rec. 709")
                          .what());
}

}  // namespace

void ExrPicture::convert_to_rec709() {
  if (!to_rec709) return;
  for (glm::vec3& pixel : pixels) pixel = glm::vec3(*to_rec709 * glm::dvec3(pixel));
  to_rec709.reset();
}

ExrPicture read_exr_picture(const fs::path& file, std::vector<std::string>* warnings) {
  check_exr_file(file);
  return guarded_exr(file, [&] {
    Imf::MultiPartInputFile input(file.c_str());
    const PictureChannels channels = find_picture(file, input);
    const Imf::Header& header = input.header(channels.part);
    check_exr_image(file, header);
    const Imath::Box2i window = header.dataWindow();
    ExrPicture picture;
    picture.width = window.max.x - window.min.x + 1;
    picture.height = window.max.y - window.min.y + 1;
    picture.is_cube = Imf::hasEnvmap(header) && Imf::envmap(header) == Imf::ENVMAP_CUBE;
    Imf::InputPart part(input, channels.part);
    read_last_row(part, header);
    if (channels.kind == PictureChannels::Kind::luminance_chroma) {
      read_rgba(file, picture);
    } else {
      check_exr_sampling(file, header);
      read_floats(part, window, channels, picture);
    }
    if (channels.kind != PictureChannels::Kind::luminance) {
      read_chromaticities(file, header, picture, warnings);
    }
    return picture;
  });
}

}  // namespace brume
