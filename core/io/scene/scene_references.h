#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "brume/scene.h"
#include "core/io/scene/json_reader.h"
#include "core/io/scene/missing_files.h"

namespace brume {

// Resolves, reads and validates the files that a scene refers to. Errors name the scene, the JSON
// path of the reference, the file and the place in it.
class SceneReferences {
 public:
  // `missing`: see load_document(); nullptr: missing files are errors.
  SceneReferences(const std::filesystem::path& scene_file, MissingFiles* missing);

  // The absolute path of a reference; it must be a file other than the scene.
  std::filesystem::path resolve(const JsonContext& context, const JsonPath& path,
                                const std::string& text) const;

  // Whether it was found missing, and that is no error.
  [[nodiscard]] bool is_missing(const std::filesystem::path& file) const;

  // resolve() for a pattern of frames; does not check that files exist.
  std::filesystem::path resolve_pattern(const JsonContext& context, const JsonPath& path,
                                        const std::string& text) const;
  // The same for a file that is to be written.
  std::filesystem::path resolve_output(const JsonContext& context, const JsonPath& path,
                                       const std::string& text) const;
  // Opens the frames of a sequence whose file, first and last are set; at most `max_gaussians`.
  std::shared_ptr<const SequenceFrames> sequence(JsonContext& context, const JsonPath& path,
                                                 const MediumSequence& sequence,
                                                 std::size_t max_gaussians);

  // Meshes, profiles, measured BRDFs and textures are cached and shared.
  std::shared_ptr<const TriangleMesh> mesh(JsonContext& context, const JsonPath& path,
                                           const std::filesystem::path& file);
  // None of a missing file.
  std::shared_ptr<const CopyPlacements> copies(JsonContext& context, const JsonPath& path,
                                               const std::filesystem::path& file,
                                               std::size_t max_count);
  // A scene of another program, cached and shared, too.
  std::shared_ptr<const ImportedScene> imported(JsonContext& context, const JsonPath& path,
                                                const std::filesystem::path& file);
  std::shared_ptr<const PhotometricProfile> profile(const JsonContext& context,
                                                    const JsonPath& path,
                                                    const std::filesystem::path& file);
  std::shared_ptr<const MeasuredBrdf> measured_brdf(const JsonContext& context,
                                                    const JsonPath& path,
                                                    const std::filesystem::path& file);
  // The file of a texture and what it holds: null if it is missing, which is a warning.
  std::pair<std::filesystem::path, std::shared_ptr<const Texture>> texture(JsonContext& context,
                                                                           const JsonPath& path,
                                                                           const std::string& text,
                                                                           bool has_colors);
  // Their groups are the numbers of the column `group`, at most `max_group`; without groups it is
  // not read. `ids`: as of read_with_ids().
  std::vector<Gaussian> gaussians(JsonContext& context, const JsonPath& path,
                                  const std::filesystem::path& file, std::size_t max_gaussians,
                                  std::size_t max_group, std::vector<GaussianNumber>& ids);
  std::shared_ptr<const RadianceMap> radiance_map(JsonContext& context, const JsonPath& path,
                                                  const std::filesystem::path& file);

  // The reference from a scene file in `directory` to `file`: relative if possible.
  static std::string text_for(const std::filesystem::path& file,
                              const std::filesystem::path& directory);

 private:
  [[nodiscard]] std::filesystem::path absolute(const JsonContext& context, const JsonPath& path,
                                               const std::string& text) const;

  // The current location of a file; records missing ones if that is no error.
  [[nodiscard]] std::filesystem::path found(const std::filesystem::path& file) const;
  void note_missing(const std::filesystem::path& file) const;
  void add_missing(const std::filesystem::path& file) const;

  std::filesystem::path scene_file_;
  MissingFiles* missing_;
  std::filesystem::path directory_;
  std::map<std::filesystem::path, std::shared_ptr<const TriangleMesh>> meshes_;
  std::map<std::filesystem::path, std::shared_ptr<const CopyPlacements>> copies_;
  std::map<std::filesystem::path, std::shared_ptr<const ImportedScene>> imported_;
  std::map<std::filesystem::path, std::shared_ptr<const PhotometricProfile>> profiles_;
  std::map<std::filesystem::path, std::shared_ptr<const MeasuredBrdf>> measured_;
  std::map<std::pair<std::filesystem::path, bool>, std::shared_ptr<const Texture>> textures_;
};

}  // namespace brume
