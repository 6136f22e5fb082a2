#pragma once

#include <filesystem>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace brume {

// The picture of an OpenEXR file, as it is stored.
struct ExrPicture {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;        // rows from the top; may be anything, even no number
  std::optional<glm::dmat3> to_rec709;  // absent: it is linear Rec. 709
  bool is_cube = false;                 // the six faces of an environment, one below the other

  void convert_to_rec709();  // in place
};

// Reads the picture of an OpenEXR file: R G B of the first flat part that has them, else luminance
// (Y, with RY and BY if it has chroma), else R G B of the only layer. Chromaticities that span no
// colours are a warning, and taken as Rec. 709. Throws InputError: the errors of read_exr, or a
// list of the channels where none of these is the picture.
ExrPicture read_exr_picture(const std::filesystem::path& file,
                            std::vector<std::string>* warnings = nullptr);

}  // namespace brume
