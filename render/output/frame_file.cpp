#include "render/output/frame_file.h"

#include "core/error.h"
#include "core/io/file_bytes.h"
#include "core/io/image/image_file.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"

namespace brume {
namespace {

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

std::map<std::string, std::string> frame_metadata(const FrameInfo& info) {
  // Only its name: pictures are shared, and folders reveal their author.
  const std::string scene = std::filesystem::path(info.scene).filename().string();
  std::map<std::string, std::string> metadata{{"brume:scene", scene},
                                              {"brume:version", BRUME_VERSION},
                                              {"brume:airlight", info.airlight},
                                              {"brume:backend", info.backend}};
  if (info.noise) metadata["brume:noise"] = quoted_text(info.noise->picture);
  std::erase_if(metadata, [](const auto& entry) { return entry.second.empty(); });
  return metadata;
}

void check_frame_extension(const std::filesystem::path& file) {
  const std::string extension = lower_case_extension(file);
  if (extension == ".exr" || extension == ".png") return;
  throw InputError(file, "",
                   "found the extension " + quoted_text(extension) + "; allowed: .exr, .png");
}

void write_frame(const std::filesystem::path& file, const Frame& frame, const FrameInfo& info,
                 const ImageLayers& more) {
  check_frame_extension(file);
  std::map<std::string, std::string> metadata = frame_metadata(info);
  if (lower_case_extension(file) == ".exr") {
    ImageLayers layers = to_layers(frame);
    layers.metadata = std::move(metadata);
    keep(layers, info.layers);
    layers.channels.insert(more.channels.begin(), more.channels.end());
    layers.metadata.insert(more.metadata.begin(), more.metadata.end());
    write_exr(file, layers);
  } else {
    metadata["Software"] = "Brume " BRUME_VERSION;  // a keyword of the PNG standard
    metadata["brume:exposure"] = quoted_text(info.look.exposure);
    metadata["brume:view_transform"] = view_name(info.look);
    write_png(file, frame.film.width, frame.film.height, to_display(frame, info.look), metadata);
  }
}

}  // namespace brume
