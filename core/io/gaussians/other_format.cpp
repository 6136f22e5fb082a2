#include "core/io/gaussians/other_format.h"

#include <string>

#include "brume/error.h"
#include "core/io/disk/file_bytes.h"

namespace brume {

void refuse_compressed_splats(const std::filesystem::path& file, std::string_view what) {
  const bool is_ply = lower_case_extension(file) == ".ply";
  throw InputError(file, "",
                   "has compressed splats (" + std::string(what) +
                       "); allowed: plain ones, as splat-transform (of npm, "
                       "@playcanvas/splat-transform) makes them: splat-transform " +
                       file.filename().string() + " " + file.stem().string() +
                       (is_ply ? "_plain.ply" : ".ply"));
}

void refuse_other_format(const std::filesystem::path& file, std::string_view begin) {
  const std::string extension = lower_case_extension(file);
  // These begin with numbers of the first splats.
  if (extension == ".splat" || extension == ".ksplat") refuse_compressed_splats(file, extension);
  const bool is_gzip = begin.starts_with("\x1f\x8b");
  const bool is_zip = begin.starts_with("PK\x03\x04");
  if (begin.starts_with("NGSP") || (is_gzip && extension != ".gz")) {
    refuse_compressed_splats(file, "SPZ");
  }
  if (is_zip && extension != ".zip") refuse_compressed_splats(file, "SOG");
  if (is_gzip || is_zip) {
    throw InputError(
        file, "",
        std::string("is packed; allowed: what ") + (is_zip ? "unzip" : "gunzip") + " makes of it");
  }
  if (begin.starts_with(" BDV")) {
    throw InputError(file, "",
                     "is a volume (OpenVDB); allowed: Gaussians, which brume fit makes of one: "
                     "brume fit " +
                         file.filename().string() + " -o " + file.stem().string() + ".ply");
  }
}

}  // namespace brume
