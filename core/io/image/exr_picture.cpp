#include "core/io/image/exr_picture.h"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>

#include <ImfChromaticities.h>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/matrix.hpp>

#include "brume/error.h"
#include "core/io/image/exr_reading.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr double min_determinant = 1e-9;  // of primaries that span colours; Rec. 709 has 0.1

// Lam 1985: from XYZ to responses of the eye's cones.
const glm::dmat3 bradford(0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367,
                          1.0296);

glm::dvec3 xyz_of(const Imath::V2f& chromaticity) {
  const glm::dvec2 xy(chromaticity.x, chromaticity.y);
  return {xy.x, xy.y, 1.0 - xy.x - xy.y};
}

glm::dvec3 white_of(const Imf::Chromaticities& chromaticities) {
  return xyz_of(chromaticities.white) / static_cast<double>(chromaticities.white.y);
}

glm::dmat3 diagonal(const glm::dvec3& v) {
  return {{v.x, 0.0, 0.0}, {0.0, v.y, 0.0}, {0.0, 0.0, v.z}};
}

// Finite, too.
bool is_positive(const glm::dvec3& v) {
  return v.x > 0.0 && v.y > 0.0 && v.z > 0.0 && std::isfinite(v.x + v.y + v.z);
}

// White, (1, 1, 1), has the luminance 1.
std::optional<glm::dmat3> rgb_to_xyz(const Imf::Chromaticities& chromaticities) {
  const glm::dmat3 primaries(xyz_of(chromaticities.red), xyz_of(chromaticities.green),
                             xyz_of(chromaticities.blue));
  if (!(std::abs(glm::determinant(primaries)) >= min_determinant)) return std::nullopt;
  const glm::dvec3 scale = glm::inverse(primaries) * white_of(chromaticities);
  if (!is_positive(scale)) return std::nullopt;
  return primaries * diagonal(scale);
}

bool is_xyz(const Imf::Chromaticities& c) {
  return c.red == Imath::V2f(1.0f, 0.0f) && c.green == Imath::V2f(0.0f, 1.0f) &&
         c.blue == Imath::V2f(0.0f, 0.0f);
}

// From linear RGB of primaries and a white to linear Rec. 709, whose white it becomes (Bradford).
// Colours whose primaries are the axes of CIE XYZ have no white: they are not adapted. nullopt: the
// primaries span no colours, or the white is none of them.
std::optional<glm::dmat3> to_rec709(const Imf::Chromaticities& chromaticities) {
  const Imf::Chromaticities rec709;  // OpenEXR's default
  const std::optional<glm::dmat3> to_xyz = rgb_to_xyz(chromaticities);
  if (!to_xyz) return std::nullopt;
  const glm::dmat3 from_xyz = glm::inverse(*rgb_to_xyz(rec709));
  if (is_xyz(chromaticities)) return from_xyz * *to_xyz;
  const glm::dvec3 cones = bradford * white_of(chromaticities);
  if (!is_positive(cones)) return std::nullopt;
  const glm::dmat3 adaptation =
      glm::inverse(bradford) * diagonal(bradford * white_of(rec709) / cones) * bradford;
  return from_xyz * adaptation * *to_xyz;
}

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
