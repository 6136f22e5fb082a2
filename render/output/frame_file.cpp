#include "render/output/frame_file.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "brume/error.h"
#include "brume/files.h"
#include "brume/request_options.h"
#include "brume/version.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"
#include "core/scene/camera_rays.h"

namespace brume {
namespace {

// The layers of the contract: R G B A, airlight.R/G/B, transmittance.R/G/B, Z.
ImageLayers to_layers(const Frame& frame) {
  ImageLayers image;
  image.width = frame.film.width;
  image.height = frame.film.height;
  const auto split = [&](const std::vector<float>& pixels,
                         std::initializer_list<const char*> names) {
    const std::size_t stride = names.size();
    std::size_t k = 0;
    for (const char* name : names) {
      std::vector<float>& channel = image.channels[name];
      channel.resize(pixels.size() / stride);
      for (std::size_t i = 0; i < channel.size(); ++i) channel[i] = pixels[i * stride + k];
      ++k;
    }
  };
  split(frame.beauty, {"R", "G", "B", "A"});
  split(frame.airlight, {"airlight.R", "airlight.G", "airlight.B"});
  split(frame.transmittance, {"transmittance.R", "transmittance.G", "transmittance.B"});
  split(frame.depth, {"Z"});
  return image;
}

void keep(ImageLayers& image, const OutputLayers& layers) {
  std::erase_if(image.channels, [&layers](const auto& channel) {
    const std::string& name = channel.first;
    return (name.starts_with("airlight.") && !layers.airlight) ||
           (name.starts_with("transmittance.") && !layers.transmittance) ||
           (name == "Z" && !layers.depth);
  });
}

}  // namespace

bool is_deep_file(const std::filesystem::path& file) {
  return lower_case_extension(file) == ".exr" && lower_case_extension(file.stem()) == ".deep";
}

std::optional<std::string> fingerprint_of(const std::filesystem::path& file) {
  try {
    const std::map<std::string, std::string> texts =
        lower_case_extension(file) == ".png" ? read_png_texts(file) : read_exr_texts(file);
    const auto found = texts.find("brume:fingerprint");
    return found == texts.end() ? std::nullopt : std::optional(found->second);
  } catch (const InputError&) {  // there is no such file, or part of one
    return std::nullopt;
  }
}

ExrView exr_view(const Camera& camera, const Film& film, double frames_per_second) {
  const CameraRays rays(camera, film);
  const CameraRays::FilmPlane plane = rays.plane();
  const glm::dvec3 right = glm::normalize(plane.per_x);
  const glm::dvec3 up = -glm::normalize(plane.per_y);
  const glm::dmat4 to_axes(glm::transpose(glm::dmat3(right, up, rays.forward())));
  // The center of the view in NDC, and how far a slope of 1 is from there.
  const glm::dvec2 center =
      (rays.axis() - glm::dvec2(rays.first_pixel())) / glm::dvec2(film.width, film.height);
  const double per_x = 1.0 / (glm::length(plane.per_x) * film.width);
  const double per_y = 1.0 / (glm::length(plane.per_y) * film.height);
  ExrView view;
  view.world_to_camera = glm::translate(to_axes, -rays.eye());
  const glm::dvec4 x(per_x, 0.0, 0.0, 0.0);
  const glm::dvec4 y(0.0, -per_y, 0.0, 0.0);
  // A pinhole divides all by the depth, and z is its inverse; else z is the depth.
  const glm::dmat4 to_ndc =
      rays.is_parallel() ? glm::dmat4(x, y, {0.0, 0.0, 1.0, 0.0}, {center.x, center.y, 0.0, 1.0})
                         : glm::dmat4(x, y, {center.x, center.y, 0.0, 1.0}, {0.0, 0.0, 1.0, 0.0});
  view.world_to_ndc = to_ndc * view.world_to_camera;
  view.frames_per_second = frames_per_second;
  return view;
}

std::map<std::string, std::string> frame_metadata(const Frame& frame, const FrameInfo& info) {
  // Only its name: pictures are shared, and folders reveal their author.
  const std::string scene = std::filesystem::path(info.scene).filename().string();
  std::map<std::string, std::string> metadata{{"brume:scene", scene},
                                              {"brume:version", version()},
                                              {"brume:backend", frame.statistics.backend},
                                              {"brume:fingerprint", info.fingerprint}};
  for (const RequestOption& option : request_options()) {
    if (!frame.request || !option.is_in_header || !option.is_in_header(*frame.request)) continue;
    metadata["brume:" + option.keyword()] = option.get(*frame.request);
  }
  if (info.frame) metadata["brume:frame"] = std::to_string(*info.frame);
  if (frame.error) {
    metadata["brume:error"] = quoted_text(frame.error->rel_rmse);
    metadata["brume:block_error"] = quoted_text(frame.error->block_median);
  }
  if (frame.picture_error) {
    metadata["brume:picture_error"] = quoted_text(frame.picture_error->rel_rmse);
    metadata["brume:picture_block_error"] = quoted_text(frame.picture_error->block_median);
  }
  if (const auto noise = relative_noise(frame)) {
    metadata["brume:noise"] = quoted_text(noise->picture);
  }
  std::erase_if(metadata, [](const auto& entry) { return entry.second.empty(); });
  return metadata;
}

void check_frame_extension(const std::filesystem::path& file) {
  const std::string extension = lower_case_extension(file);
  if (extension == ".exr" || extension == ".png") return;
  throw InputError(file, "",
                   "found the extension " + quoted_text(extension) + "; allowed: .exr, .png");
}

void write_frame(const std::filesystem::path& file, const Frame& frame, const FrameInfo& info) {
  check_frame_extension(file);
  std::map<std::string, std::string> metadata = frame_metadata(frame, info);
  if (lower_case_extension(file) == ".exr") {
    ImageLayers layers = to_layers(frame);
    layers.metadata = std::move(metadata);
    keep(layers, frame.request ? frame.request->layers : OutputLayers{});
    layers.channels.insert(frame.layers.channels.begin(), frame.layers.channels.end());
    layers.metadata.insert(frame.layers.metadata.begin(), frame.layers.metadata.end());
    write_exr(file, layers, exr_view(frame.camera, frame.film, frame.frames_per_second));
  } else {
    metadata["Software"] = std::string("Brume ") + version();  // a keyword of the PNG standard
    metadata["brume:exposure"] = quoted_text(info.look.exposure);
    metadata["brume:view_transform"] = view_name(info.look);
    const auto [width, height] = std::pair(frame.film.width, frame.film.height);
    if (info.bits == 16) {
      write_png(file, width, height, to_display_16(frame, info.look), metadata);
    } else {
      write_png(file, width, height, to_display(frame, info.look), metadata);
    }
  }
}

void save_frame(const Frame& frame, const std::filesystem::path& file, double exposure) {
  write_frame(file, frame, {.look = {exposure, nullptr}});
}

std::string encode_png(const Frame& frame, double exposure) {
  return encode_png(frame.film.width, frame.film.height, to_display(frame, {exposure, nullptr}));
}

}  // namespace brume
