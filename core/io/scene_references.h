#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/io/json_reader.h"
#include "core/io/missing_files.h"
#include "core/scene/scene.h"

namespace brume {

// The files a scene refers to: finds them relative to the scene, reads and checks them. An error
// names the scene, the JSON path of the reference, the file and the place in it.
class SceneReferences {
 public:
  // `missing`: as load_scene() has it; nullptr: what is missing is an error.
  SceneReferences(const std::filesystem::path& scene_file, MissingFiles* missing);

  // The absolute path that the text at `place` means. It is a file, and not the scene itself.
  std::filesystem::path resolve(const JsonContext& context, const JsonPlace& place,
                                const std::string& text) const;

  // The same of a name with %04d for the number of a frame; whether its files are there is not
  // looked at.
  std::filesystem::path resolve_pattern(const JsonContext& context, const JsonPlace& place,
                                        const std::string& text) const;
  // The frames of a sequence whose file, first and last are known; at most `max_gaussians` in all.
  std::vector<SequenceFrame> sequence(const JsonContext& context, const JsonPlace& place,
                                      const MediumSequence& sequence, std::size_t max_gaussians);

  // Meshes and measured BRDFs are read once and shared.
  std::shared_ptr<const TriangleMesh> mesh(const JsonContext& context, const JsonPlace& place,
                                           const std::filesystem::path& file);
  std::shared_ptr<const MeasuredBrdf> measured_brdf(const JsonContext& context,
                                                    const JsonPlace& place,
                                                    const std::filesystem::path& file);
  std::vector<Gaussian> gaussians(const JsonContext& context, const JsonPlace& place,
                                  const std::filesystem::path& file, std::size_t max_gaussians);
  std::shared_ptr<const RadianceMap> radiance_map(const JsonContext& context,
                                                  const JsonPlace& place,
                                                  const std::filesystem::path& file);

  // How a scene file in `directory` refers to `file`: relative where it can.
  static std::string text_for(const std::filesystem::path& file,
                              const std::filesystem::path& directory);

 private:
  [[nodiscard]] std::filesystem::path absolute(const JsonContext& context, const JsonPlace& place,
                                               const std::string& text) const;

  // The file where it is now. Notes what is missing, where that is no error.
  [[nodiscard]] std::filesystem::path found(const std::filesystem::path& file) const;
  void note_missing(const std::filesystem::path& file) const;
  [[nodiscard]] bool is_missing(const std::filesystem::path& file) const;

  std::filesystem::path scene_file_;
  MissingFiles* missing_;
  std::filesystem::path directory_;
  std::map<std::filesystem::path, std::shared_ptr<const TriangleMesh>> meshes_;
  std::map<std::filesystem::path, std::shared_ptr<const MeasuredBrdf>> measured_;
};

}  // namespace brume
