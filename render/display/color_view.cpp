#include "render/display/color_view.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>

#include "brume/error.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/text_scanner.h"

namespace OCIO = OCIO_NAMESPACE;

namespace brume {
namespace {

// OpenColorIO 2.1 has the transforms of ACES 1.0, but no configuration of them. The matrix is from
// linear Rec. 709 to ACES2065-1, adapted from D65 to the white of ACES (Bradford).
constexpr const char* aces_text = R"(ocio_profile_version: 2
search_path: ""
strictparsing: true
roles:
  default: raw
  scene_linear: lin_rec709
  aces_interchange: ACES2065-1
  cie_xyz_d65_interchange: CIE-XYZ-D65
displays:
  sRGB:
    - !<View> {name: ACES 1.0 SDR, view_transform: ACES 1.0 SDR, display_colorspace: <USE_DISPLAY_NAME>}
    - !<View> {name: Un-tone-mapped, view_transform: Un-tone-mapped, display_colorspace: <USE_DISPLAY_NAME>}
  Rec.1886 Rec.709:
    - !<View> {name: ACES 1.0 SDR, view_transform: ACES 1.0 SDR, display_colorspace: <USE_DISPLAY_NAME>}
    - !<View> {name: Un-tone-mapped, view_transform: Un-tone-mapped, display_colorspace: <USE_DISPLAY_NAME>}
default_view_transform: Un-tone-mapped
view_transforms:
  - !<ViewTransform>
    name: ACES 1.0 SDR
    from_scene_reference: !<BuiltinTransform> {style: ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO_1.0}
  - !<ViewTransform>
    name: Un-tone-mapped
    from_scene_reference: !<BuiltinTransform> {style: UTILITY - ACES-AP0_to_CIE-XYZ-D65_BFD}
display_colorspaces:
  - !<ColorSpace>
    name: CIE-XYZ-D65
    isdata: false
  - !<ColorSpace>
    name: sRGB
    from_display_reference: !<BuiltinTransform> {style: DISPLAY - CIE-XYZ-D65_to_sRGB}
  - !<ColorSpace>
    name: Rec.1886 Rec.709
    from_display_reference: !<BuiltinTransform> {style: DISPLAY - CIE-XYZ-D65_to_REC.1886-REC.709}
colorspaces:
  - !<ColorSpace>
    name: ACES2065-1
    isdata: false
  - !<ColorSpace>
    name: lin_rec709
    isdata: false
    to_scene_reference: !<MatrixTransform> {matrix: [0.439632981919491, 0.382988698151554, 0.177378319928955, 0, 0.0897764429588424, 0.813439428748981, 0.0967841282921771, 0, 0.0175411703831727, 0.111546553302387, 0.870912276314441, 0, 0, 0, 0, 1]}
  - !<ColorSpace>
    name: raw
    isdata: true
)";

// The same matrix, row by row with the alpha.
constexpr std::array<double, 16> rec709_to_aces{0.439632981919491,
                                                0.382988698151554,
                                                0.177378319928955,
                                                0.0,
                                                0.0897764429588424,
                                                0.813439428748981,
                                                0.0967841282921771,
                                                0.0,
                                                0.0175411703831727,
                                                0.111546553302387,
                                                0.870912276314441,
                                                0.0,
                                                0.0,
                                                0.0,
                                                0.0,
                                                1.0};

constexpr const char* ocio_scheme = "ocio://";  // of configurations in OpenColorIO itself

[[noreturn]] void refuse(const std::string& config, const std::string& why) {
  throw InputError(config, "", why);
}

std::string one_line(const OCIO::Exception& error) {
  std::string text = error.what();
  std::ranges::replace(text, '\n', ' ');
  return text;
}

// Its complaints are about all of a configuration: what a view needs may be whole.
std::vector<std::string> complaints_about(const std::string& config, const OCIO::Config& content) {
  try {
    content.validate();
    return {};
  } catch (const OCIO::Exception& error) {
    return {InputError(config, "", "OpenColorIO says: " + one_line(error)).what()};
  }
}

// Throws InputError where a transform reads what is no regular file, such as a pipe, which would be
// waited for.
void check_files(const OCIO::Config& config, const OCIO::ConstTransformRcPtr& transform) {
  if (const auto group = OCIO::DynamicPtrCast<const OCIO::GroupTransform>(transform)) {
    for (int i = 0; i < group->getNumTransforms(); ++i) check_files(config, group->getTransform(i));
  }
  const auto file = OCIO::DynamicPtrCast<const OCIO::FileTransform>(transform);
  if (!file) return;
  try {
    regular_file_size(config.getCurrentContext()->resolveFileLocation(file->getSrc()));
  } catch (const OCIO::Exception&) {  // a missing one counts where it is used
  }
}

// The same of all that a configuration has.
void check_files(const OCIO::Config& config) {
  for (int i = 0;
       i < config.getNumColorSpaces(OCIO::SEARCH_REFERENCE_SPACE_ALL, OCIO::COLORSPACE_ALL); ++i) {
    const auto space = config.getColorSpace(
        config.getColorSpaceNameByIndex(OCIO::SEARCH_REFERENCE_SPACE_ALL, OCIO::COLORSPACE_ALL, i));
    check_files(config, space->getTransform(OCIO::COLORSPACE_DIR_TO_REFERENCE));
    check_files(config, space->getTransform(OCIO::COLORSPACE_DIR_FROM_REFERENCE));
  }
  for (int i = 0; i < config.getNumLooks(); ++i) {
    const auto look = config.getLook(config.getLookNameByIndex(i));
    check_files(config, look->getTransform());
    check_files(config, look->getInverseTransform());
  }
  for (int i = 0; i < config.getNumViewTransforms(); ++i) {
    const auto view = config.getViewTransform(config.getViewTransformNameByIndex(i));
    check_files(config, view->getTransform(OCIO::VIEWTRANSFORM_DIR_TO_REFERENCE));
    check_files(config, view->getTransform(OCIO::VIEWTRANSFORM_DIR_FROM_REFERENCE));
  }
  for (int i = 0; i < config.getNumNamedTransforms(); ++i) {
    const auto named = config.getNamedTransform(config.getNamedTransformNameByIndex(i));
    check_files(config, named->getTransform(OCIO::TRANSFORM_DIR_FORWARD));
    check_files(config, named->getTransform(OCIO::TRANSFORM_DIR_INVERSE));
  }
}

OCIO::ConstConfigRcPtr open_config(const std::string& config) {
  static const bool is_quiet = [] {  // it writes to standard error otherwise
    OCIO::SetLoggingLevel(OCIO::LOGGING_LEVEL_NONE);
    return true;
  }();
  (void)is_quiet;
  try {
    if (config == aces_config) {
      std::istringstream text(aces_text);
      return OCIO::Config::CreateFromStream(text);
    }
    if (config.starts_with(ocio_scheme)) {
      if (OCIO::GetVersionHex() < 0x02020000) {
        refuse(config, std::string("needs OpenColorIO 2.2 or newer, which has configurations of "
                                   "its own; this is ") +
                           OCIO::GetVersion() + "; allowed: a file .ocio, or aces");
      }
    } else {
      regular_file_size(config);  // its own error if it is missing, or no file
    }
    OCIO::ConstConfigRcPtr read = OCIO::Config::CreateFromFile(config.c_str());
    check_files(*read);
    return read;
  } catch (const OCIO::Exception& error) {
    refuse(config, "no configuration of OpenColorIO: " + one_line(error));
  }
}

std::vector<ColorDisplay> displays_of(const OCIO::Config& config) {
  std::vector<ColorDisplay> displays;
  for (int i = 0; i < config.getNumDisplays(); ++i) {
    ColorDisplay display{config.getDisplay(i), {}};
    for (int k = 0; k < config.getNumViews(display.name.c_str()); ++k) {
      display.views.emplace_back(config.getView(display.name.c_str(), k));
    }
    if (!display.views.empty()) displays.push_back(std::move(display));
  }
  return displays;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// The choice with nothing left open.
ColorChoice settled(ColorChoice choice, const OCIO::Config& config) {
  const std::vector<ColorDisplay> displays = displays_of(config);
  if (displays.empty()) refuse(choice.config, "the configuration has no display");
  if (choice.display.empty()) choice.display = displays.front().name;
  const auto display = std::ranges::find(displays, choice.display, &ColorDisplay::name);
  if (display == displays.end()) {
    std::vector<std::string> names;
    for (const ColorDisplay& known : displays) names.push_back(known.name);
    refuse(choice.config,
           "found the display " + quoted_text(choice.display) + "; allowed: " + listed(names));
  }
  if (choice.view.empty()) choice.view = display->views.front();
  if (std::ranges::find(display->views, choice.view) == display->views.end()) {
    refuse(choice.config, "found the view " + quoted_text(choice.view) + " of " +
                              quoted_text(choice.display) + "; allowed: " + listed(display->views));
  }
  return choice;
}

bool is_of_data(const OCIO::Config& config, const ColorChoice& choice) {
  const OCIO::ConstColorSpaceRcPtr space = config.getColorSpace(
      config.getDisplayViewColorSpaceName(choice.display.c_str(), choice.view.c_str()));
  return space && space->isData();
}

OCIO::TransformRcPtr to_source(const OCIO::Config& config, std::string& source) {
  for (const char* name :
       {"lin_rec709", "Linear Rec.709 (sRGB)", "lin_rec709_srgb", "Linear Rec.709",
        "Utility - Linear - Rec.709", "Utility - Linear - sRGB", "lin_srgb", "Linear BT.709"}) {
    if (!config.getColorSpace(name)) continue;
    source = name;
    return nullptr;
  }
  if (config.hasRole("aces_interchange")) {
    source = "aces_interchange";
    auto matrix = OCIO::MatrixTransform::Create();
    matrix->setMatrix(rec709_to_aces.data());
    return matrix;
  }
  source = OCIO::ROLE_SCENE_LINEAR;
  for (const char* role : {OCIO::ROLE_SCENE_LINEAR, OCIO::ROLE_RENDERING, OCIO::ROLE_REFERENCE}) {
    if (!config.hasRole(role)) continue;
    source = role;
    break;
  }
  return nullptr;
}

std::vector<std::filesystem::path> files_used(const std::string& config,
                                              const OCIO::Processor& processor) {
  if (!is_config_file(config)) return {};
  std::vector<std::filesystem::path> files{config};
  const OCIO::ConstProcessorMetadataRcPtr metadata = processor.getProcessorMetadata();
  for (int i = 0; i < metadata->getNumFiles(); ++i) files.emplace_back(metadata->getFile(i));
  return files;
}

}  // namespace

struct ColorView::Processor {
  OCIO::ConstCPUProcessorRcPtr cpu;
};

bool is_config_file(const std::string& config) {
  return config != aces_config && !config.starts_with(ocio_scheme);
}

std::vector<ColorDisplay> color_displays(const std::string& config) {
  return displays_of(*open_config(config));
}

std::string default_color_config() {
  const char* file = std::getenv("OCIO");
  return file && *file ? file : aces_config;
}

ColorView::ColorView(const ColorChoice& choice) {
  const OCIO::ConstConfigRcPtr config = open_config(choice.config);
  choice_ = settled(choice, *config);
  try {
    std::string source;
    const OCIO::TransformRcPtr first = to_source(*config, source);
    const auto view = OCIO::DisplayViewTransform::Create();
    view->setSrc(source.c_str());
    view->setDisplay(choice_.display.c_str());
    view->setView(choice_.view.c_str());
    const auto all = OCIO::GroupTransform::Create();
    // OpenColorIO converts nothing to a view of data.
    if (first && !is_of_data(*config, choice_)) all->appendTransform(first);
    all->appendTransform(view);
    const OCIO::ConstProcessorRcPtr processor = config->getProcessor(all);
    processor_ = std::make_unique<const Processor>(Processor{processor->getDefaultCPUProcessor()});
    files_ = files_used(choice_.config, *processor);
  } catch (const OCIO::Exception& error) {
    refuse(choice_.config,
           "the view " + quoted_text(choice_.view) + " cannot be used: " + one_line(error));
  }
  if (is_config_file(choice_.config)) warnings_ = complaints_about(choice_.config, *config);
}

ColorView::~ColorView() = default;

void ColorView::apply(std::span<float> rgb) const {
  OCIO::PackedImageDesc image(rgb.data(), static_cast<long>(rgb.size() / 3), 1, 3);
  processor_->cpu->apply(image);
}

}  // namespace brume
