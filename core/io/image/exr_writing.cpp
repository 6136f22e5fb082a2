#include "core/io/image/exr_writing.h"

#include <ImfFramesPerSecond.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

namespace brume {
namespace {

// OpenEXR's vectors are rows, GLM's columns: element by element they are the same in memory.
Imath::M44f to_imath(const glm::dmat4& matrix) {
  Imath::M44f result;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) result[i][j] = static_cast<float>(matrix[i][j]);
  }
  return result;
}

}  // namespace

void add_attributes(const std::map<std::string, std::string>& texts,
                    const std::optional<ExrView>& view, Imf::Header& header) {
  Imf::addChromaticities(header, {});
  for (const auto& [name, text] : texts) header.insert(name, Imf::StringAttribute(text));
  if (!view) return;
  Imf::addWorldToCamera(header, to_imath(view->world_to_camera));
  Imf::addWorldToNDC(header, to_imath(view->world_to_ndc));
  if (view->frames_per_second > 0.0) {
    Imf::addFramesPerSecond(header, Imf::guessExactFps(view->frames_per_second));
  }
}

}  // namespace brume
