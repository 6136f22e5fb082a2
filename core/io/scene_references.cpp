#include "core/io/scene_references.h"

#include <algorithm>

#include "core/error.h"
#include "core/io/file_bytes.h"
#include "core/io/gaussian_file.h"
#include "core/io/merl_file.h"
#include "core/io/mesh_file.h"
#include "core/io/radiance_map_file.h"
#include "core/io/sequence_file.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

// The folder without symbolic links, so that ".." in a reference is the real parent folder.
fs::path real_folder(const fs::path& folder) {
  return fs::weakly_canonical(folder.empty() ? fs::path(".") : folder);
}

// Runs `read`; an error of the file read becomes one of the scene, at the place that refers to it.
template <typename Read>
auto at_place(const JsonContext& context, const JsonPlace& place, Read&& read) {
  try {
    return read();
  } catch (const InputError& error) {
    context.fail(place, error.what());
  }
}

}  // namespace

SceneReferences::SceneReferences(const fs::path& scene_file)
    : scene_file_(scene_file), directory_(real_folder(scene_file.parent_path())) {}

fs::path SceneReferences::absolute(const JsonContext& context, const JsonPlace& place,
                                   const std::string& text) const {
  const bool is_name = !text.empty() && std::none_of(text.begin(), text.end(), [](unsigned char c) {
    return c < 0x20 || c == 0x7f;
  });
  if (!is_name) context.fail(place, "found \"" + text + "\"; allowed: a file name");
  return (directory_ / text).lexically_normal();
}

fs::path SceneReferences::resolve_pattern(const JsonContext& context, const JsonPlace& place,
                                          const std::string& text) const {
  if (!FramePattern::parse(fs::path(text).filename().string()) ||
      FramePattern::is_pattern(fs::path(text).parent_path().string())) {
    context.fail(
        place, "found " + shown(text) + "; allowed: a file name with one %d or %04d for the frame");
  }
  const fs::path file = absolute(context, place, text);
  if (!FramePattern::parse(file.string())) {
    context.fail(place, "found " + shown(file.string()) + "; allowed: a path without another %d");
  }
  return file;
}

std::vector<SequenceFrame> SceneReferences::sequence(const JsonContext& context,
                                                     const JsonPlace& place,
                                                     const MediumSequence& sequence,
                                                     std::size_t max_gaussians) {
  return at_place(context, place, [&] {
    return read_sequence(*FramePattern::parse(sequence.file.string()), sequence.first,
                         sequence.last, read_gaussians, max_gaussians);
  });
}

fs::path SceneReferences::resolve(const JsonContext& context, const JsonPlace& place,
                                  const std::string& text) const {
  const fs::path file = absolute(context, place, text);
  at_place(context, place, [&] { return regular_file_size(file); });
  std::error_code error;
  if (fs::equivalent(file, scene_file_, error)) {
    context.fail(place, "found the scene itself, " + text + "; allowed: another file");
  }
  return file;
}

std::shared_ptr<const TriangleMesh> SceneReferences::mesh(const JsonContext& context,
                                                          const JsonPlace& place,
                                                          const fs::path& file) {
  std::shared_ptr<const TriangleMesh>& mesh = meshes_[file];
  if (!mesh) mesh = at_place(context, place, [&] { return read_mesh(file); });
  return mesh;
}

std::vector<Gaussian> SceneReferences::gaussians(const JsonContext& context, const JsonPlace& place,
                                                 const fs::path& file, std::size_t max_gaussians) {
  return at_place(context, place, [&] { return read_gaussians(file, nullptr, max_gaussians); });
}

std::shared_ptr<const RadianceMap> SceneReferences::radiance_map(const JsonContext& context,
                                                                 const JsonPlace& place,
                                                                 const fs::path& file) {
  return at_place(context, place, [&] { return read_radiance_map(file); });
}

std::shared_ptr<const MeasuredBrdf> SceneReferences::measured_brdf(const JsonContext& context,
                                                                   const JsonPlace& place,
                                                                   const fs::path& file) {
  std::shared_ptr<const MeasuredBrdf>& measured = measured_[file];
  if (!measured) measured = at_place(context, place, [&] { return read_merl(file); });
  return measured;
}

std::string SceneReferences::text_for(const fs::path& file, const fs::path& directory) {
  const fs::path absolute = fs::absolute(file).lexically_normal();
  const fs::path relative = absolute.lexically_relative(real_folder(fs::absolute(directory)));
  return (relative.empty() ? absolute : relative).generic_string();
}

}  // namespace brume
