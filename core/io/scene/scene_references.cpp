#include "core/io/scene/scene_references.h"

#include <algorithm>
#include <numbers>
#include <set>

#include "brume/error.h"
#include "brume/mesh_arrays.h"
#include "core/io/copies_file.h"
#include "core/io/disk/alike_file.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/gaussians/sequence_file.h"
#include "core/io/ies_file.h"
#include "core/io/image/radiance_map_file.h"
#include "core/io/image/texture_file.h"
#include "core/io/import/imported_scene_file.h"
#include "core/io/merl_file.h"
#include "core/io/mesh/mesh_file.h"
#include "core/io/text_scanner.h"
#include "core/scene/imported_scene.h"
#include "core/scene/lights/radiance_map.h"
#include "core/scene/materials/measured_brdf.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

// The folder without symbolic links, so that ".." in a reference is the real parent folder.
fs::path real_folder(const fs::path& folder) {
  return fs::weakly_canonical(folder.empty() ? fs::path(".") : folder);
}

// Runs `read`; an error of the file read becomes one of the scene, at the place that refers to it.
template <typename Read>
auto at_path(const JsonContext& context, const JsonPath& path, Read&& read) {
  try {
    return read();
  } catch (const InputError& error) {
    context.fail(path, error.what());
  }
}

// The same of a reader that appends to warnings, which become the scene's.
template <typename Read>
auto at_path_with_warnings(JsonContext& context, const JsonPath& path, Read&& read) {
  std::vector<std::string> warnings;
  auto content = at_path(context, path, [&] { return read(warnings); });
  for (const std::string& warning : warnings) context.warn(path, warning);
  return content;
}

// Stand-ins for files that are missing.

// It has no area, so that nothing is seen of it; without any triangle a scene would have no bounds.
std::shared_ptr<TriangleMesh> invisible_mesh() {
  return to_mesh({std::vector(3, glm::vec3(0.0f)),
                  std::vector(3, glm::vec3(0.0f, 1.0f, 0.0f)),
                  {glm::uvec3(0, 1, 2)}});
}

ImportedScene invisible_scene(const fs::path& file) {
  ImportedScene scene;
  scene.nodes.push_back({"missing"});
  scene.parts.push_back({0, invisible_mesh(), {}});
  scene.files.push_back(file);
  return scene;
}

RadianceMap black_map() {
  return {2, 1, {glm::vec3(0.0f), glm::vec3(0.0f)}};
}

MeasuredBrdf gray_brdf() {
  constexpr float reflectance = 0.5f;
  return MeasuredBrdf(
      std::vector(MeasuredBrdf::samples, glm::vec3(reflectance * std::numbers::inv_pi_v<float>)));
}

}  // namespace

SceneReferences::SceneReferences(const fs::path& scene_file, MissingFiles* missing)
    : scene_file_(scene_file),
      missing_(missing),
      directory_(real_folder(scene_file.parent_path())) {}

fs::path SceneReferences::found(const fs::path& file) const {
  if (missing_ != nullptr) {
    const auto replaced = missing_->found.find(file);
    if (replaced != missing_->found.end()) return replaced->second;
  }
  return find_file_named_alike(file);
}

void SceneReferences::note_missing(const fs::path& file) const {
  std::error_code error;
  if (missing_ == nullptr || missing_->only_frames || fs::exists(file, error)) return;
  add_missing(file);
}

void SceneReferences::add_missing(const fs::path& file) const {
  if (!is_missing(file)) missing_->missing.push_back(file);
}

bool SceneReferences::is_missing(const fs::path& file) const {
  return missing_ != nullptr && std::ranges::count(missing_->missing, file) > 0;
}

fs::path SceneReferences::absolute(const JsonContext& context, const JsonPath& path,
                                   const std::string& text) const {
  const bool is_name = !text.empty() && std::none_of(text.begin(), text.end(), [](unsigned char c) {
    return c < 0x20 || c == 0x7f;
  });
  if (!is_name) context.fail(path, "found \"" + text + "\"; allowed: a file name");
  return (directory_ / text).lexically_normal();
}

fs::path SceneReferences::resolve_pattern(const JsonContext& context, const JsonPath& path,
                                          const std::string& text) const {
  if (!FramePattern::parse(text)) {
    context.fail(path, "found " + quoted_text(text) +
                           "; allowed: a file name with one %d or %04d for the frame");
  }
  return found(absolute(context, path, text));
}

fs::path SceneReferences::resolve_output(const JsonContext& context, const JsonPath& path,
                                         const std::string& text) const {
  fs::path file = absolute(context, path, text);
  if (!file.has_stem() || file.filename() == "..") {
    context.fail(path, "found " + quoted_text(text) + "; allowed: a file name");
  }
  return file;
}

std::shared_ptr<const SequenceFrames> SceneReferences::sequence(JsonContext& context,
                                                                const JsonPath& path,
                                                                const MediumSequence& sequence,
                                                                std::size_t max_gaussians) {
  const FramePattern files = *FramePattern::parse(sequence.file.string());
  std::error_code error;
  std::set<fs::path> missing;
  for (int frame = sequence.first; missing_ != nullptr && frame <= sequence.last; ++frame) {
    const fs::path file = files.file_of(frame);
    if (fs::exists(file, error)) continue;
    if (missing_->only_frames) {
      add_missing(file);
      missing.insert(file);
      continue;
    }
    note_missing(sequence.file);
    const auto count = static_cast<std::size_t>(sequence.last - sequence.first) + 1;
    return sequence_frames(std::vector<SequenceFrame>(count));
  }
  return at_path_with_warnings(context, path, [&](std::vector<std::string>& warnings) {
    // By value: frames may be read when this is gone.
    const auto read = [missing](const fs::path& file, std::vector<GaussianNumber>* ids,
                                std::size_t max_count,
                                std::vector<std::string>* warnings_of_frame) {
      return missing.contains(file) ? std::vector<Gaussian>()
                                    : read_gaussian_frame(file, ids, max_count, warnings_of_frame);
    };
    return open_sequence(files, sequence.first, sequence.last, read, max_gaussians, &warnings);
  });
}

fs::path SceneReferences::resolve(const JsonContext& context, const JsonPath& path,
                                  const std::string& text) const {
  fs::path file = found(absolute(context, path, text));
  note_missing(file);
  if (is_missing(file)) return file;
  at_path(context, path, [&] { return regular_file_size(file); });
  std::error_code error;
  if (fs::equivalent(file, scene_file_, error)) {
    context.fail(path, "found the scene itself, " + text + "; allowed: another file");
  }
  return file;
}

std::shared_ptr<const TriangleMesh> SceneReferences::mesh(JsonContext& context,
                                                          const JsonPath& path,
                                                          const fs::path& file) {
  std::shared_ptr<const TriangleMesh>& mesh = meshes_[file];
  if (!mesh && is_missing(file)) mesh = invisible_mesh();
  if (mesh) return mesh;
  std::vector<std::string> warnings;
  mesh = at_path(context, path, [&] { return read_mesh(file, &warnings); });
  for (const std::string& warning : warnings) context.warn(path, warning);
  return mesh;
}

std::shared_ptr<const CopyPlacements> SceneReferences::copies(JsonContext& context,
                                                              const JsonPath& path,
                                                              const fs::path& file,
                                                              std::size_t max_count) {
  std::shared_ptr<const CopyPlacements>& copies = copies_[file];
  if (!copies && is_missing(file)) copies = std::make_shared<const CopyPlacements>();
  if (copies) return copies;
  return copies = at_path_with_warnings(context, path, [&](std::vector<std::string>& warnings) {
           return std::make_shared<const CopyPlacements>(read_copies(file, max_count, &warnings));
         });
}

std::shared_ptr<const ImportedScene> SceneReferences::imported(JsonContext& context,
                                                               const JsonPath& path,
                                                               const fs::path& file) {
  std::shared_ptr<const ImportedScene>& scene = imported_[file];
  if (!scene && is_missing(file)) {
    scene = std::make_shared<const ImportedScene>(invisible_scene(file));
  }
  if (scene) return scene;
  return scene = at_path_with_warnings(context, path, [&](std::vector<std::string>& warnings) {
           return read_imported_scene(file, warnings);
         });
}

std::vector<Gaussian> SceneReferences::gaussians(JsonContext& context, const JsonPath& path,
                                                 const fs::path& file, std::size_t max_gaussians,
                                                 std::size_t max_group,
                                                 std::vector<GaussianNumber>& ids) {
  if (is_missing(file)) return {};
  return at_path_with_warnings(context, path, [&](std::vector<std::string>& warnings) {
    return read_grouped_gaussians(file, max_gaussians, max_group, ids, &warnings);
  });
}

std::shared_ptr<const RadianceMap> SceneReferences::radiance_map(JsonContext& context,
                                                                 const JsonPath& path,
                                                                 const fs::path& file) {
  if (is_missing(file)) return std::make_shared<const RadianceMap>(black_map());
  return at_path_with_warnings(context, path, [&](std::vector<std::string>& warnings) {
    return read_radiance_map(file, &warnings);
  });
}

std::shared_ptr<const PhotometricProfile> SceneReferences::profile(const JsonContext& context,
                                                                   const JsonPath& path,
                                                                   const fs::path& file) {
  std::shared_ptr<const PhotometricProfile>& profile = profiles_[file];
  if (!profile && is_missing(file)) {
    profile = std::make_shared<const PhotometricProfile>(PhotometricProfile::isotropic());
  }
  if (!profile) profile = at_path(context, path, [&] { return read_ies(file); });
  return profile;
}

std::shared_ptr<const MeasuredBrdf> SceneReferences::measured_brdf(const JsonContext& context,
                                                                   const JsonPath& path,
                                                                   const fs::path& file) {
  std::shared_ptr<const MeasuredBrdf>& measured = measured_[file];
  if (!measured && is_missing(file)) measured = std::make_shared<const MeasuredBrdf>(gray_brdf());
  if (!measured) measured = at_path(context, path, [&] { return read_merl(file); });
  return measured;
}

std::pair<fs::path, std::shared_ptr<const Texture>> SceneReferences::texture(
    JsonContext& context, const JsonPath& path, const std::string& text, bool has_colors) {
  std::error_code error;
  const fs::path place = found(absolute(context, path, text));
  if (!fs::exists(place, error)) {
    note_missing(place);
    context.warn(path, "the texture " + quoted_text(place.string()) +
                           " is missing; the scene is drawn without it");
    return {place, nullptr};
  }
  fs::path file = resolve(context, path, text);
  std::shared_ptr<const Texture>& texture = textures_[{file, has_colors}];
  if (!texture) {
    texture = at_path_with_warnings(context, path, [&](std::vector<std::string>& warnings) {
      return read_texture(file, has_colors, &warnings);
    });
  }
  return {std::move(file), texture};
}

std::string SceneReferences::text_for(const fs::path& file, const fs::path& directory) {
  const fs::path absolute = fs::absolute(file).lexically_normal();
  const fs::path relative = absolute.lexically_relative(real_folder(fs::absolute(directory)));
  return (relative.empty() ? absolute : relative).generic_string();
}

}  // namespace brume
