#pragma once

#include <cstddef>
#include <span>

#include "brume/limits.h"
#include "core/io/scene/json_reader.h"

namespace brume {

class MeasuredBrdf;
class PhotometricProfile;
class Texture;
struct ImportedPart;
struct RadianceMap;
struct Surface;
struct TriangleMesh;

// Memory budget while reading a scene: the sum over all files stays within limits::gaussians and
// limits::scene_bytes. Throws InputError naming the JSON path.
class SceneBudget {
 public:
  explicit SceneBudget(const JsonContext& context) : context_(context) {}

  // Reserves Gaussians and their memory.
  void reserve_gaussians(const JsonPath& path, std::size_t count);
  void reserve(const JsonPath& path, const RadianceMap& map);
  void reserve(const JsonPath& path, const MeasuredBrdf& measured);
  void reserve(const JsonPath& path, const PhotometricProfile& profile);
  // Per use: rendering on a device copies it for each.
  void reserve(const JsonPath& path, const Texture& texture);
  // Parts of one surface; a texture of several counts once.
  void reserve(const JsonPath& path, std::span<const ImportedPart* const> parts);
  // Per surface: rendering copies the mesh for each.
  void reserve(const JsonPath& path, const TriangleMesh& mesh);

  // Copies of a surface; those of one that emits are lights, triangle by triangle.
  void reserve_copies(const JsonPath& path, double count, const Surface& surface);

  [[nodiscard]] std::size_t gaussians_left() const;
  [[nodiscard]] std::size_t copies_left() const;

 private:
  void reserve_bytes(const JsonPath& path, std::size_t bytes);

  const JsonContext& context_;
  std::size_t gaussians_ = 0;
  std::size_t parts_ = 0;  // of imported scenes
  std::size_t bytes_ = 0;
};

}  // namespace brume
