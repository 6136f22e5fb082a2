#pragma once

#include <cstddef>
#include <glm/ext/vector_int3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/camera_rays.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// The places of an EyeLobe's table: columns along view rays through even positions of the film, in
// layers of equal distance. Index: x fastest, z is the layer.
class LobeColumns {
 public:
  static constexpr glm::ivec3 size{24, 16, 20};

  // Layers begin at `start` along the rays, and are at least min_distance apart in the middle.
  // `medium_end`: that before a sky.
  LobeColumns(const CameraRays& rays, const RayCaster& ray_caster,
              std::span<const Surface> surfaces, double start, double min_distance,
              double medium_end);

  static constexpr std::size_t count() { return static_cast<std::size_t>(size.x * size.y); }
  [[nodiscard]] const glm::dvec3& eye() const { return eye_; }
  [[nodiscard]] const glm::dvec3& direction(std::size_t column) const {
    return directions_[column];
  }
  // The start of its ray, relative to the eye.
  [[nodiscard]] const glm::dvec3& offset(std::size_t column) const { return offsets_[column]; }

  [[nodiscard]] double start() const { return start_; }
  // The distance from the start to the layer in the middle.
  [[nodiscard]] double distance() const { return distance_; }
  [[nodiscard]] double distance(int layer) const {
    return start_ + distance_ * layer / (size.z - layer);
  }

  // The distance to the surface that ends it, infinite without.
  [[nodiscard]] double surface(std::size_t column) const { return surfaces_[column]; }
  // The distance up to which light is gathered: not so near a surface that its parts are told
  // apart.
  [[nodiscard]] double end(std::size_t column) const;
  // Tells whether a surface hides the place of a layer.
  [[nodiscard]] bool hides(std::size_t column, int layer) const {
    return distance(layer) > end(column);
  }

  // Continues values behind surfaces, as rays that pass by them are looked up between both. Hidden
  // values are those of the place where the column ends.
  void fill_hidden(std::span<glm::vec4> values) const;
  // Sets hidden values beside an edge to those of what is seen past it.
  void pass_by_hidden(std::span<glm::vec4> values) const;

 private:
  struct Place {
    int x, y, layer;
  };

  // Calls visit(column) for all columns beside a place that are seen on its layer.
  template <class Visit>
  void each_seen_beside(const Place& place, const std::vector<bool>& is_hidden, Visit visit) const;
  // Tells whether the surface that ends a column goes on below the place of a layer of a neighbour.
  [[nodiscard]] bool goes_on(std::size_t column, std::size_t neighbour, int layer) const;
  [[nodiscard]] std::vector<bool> hidden_on(int layer) const;
  [[nodiscard]] glm::vec4 continued(std::span<const glm::vec4> values, const Place& place,
                                    std::size_t neighbour) const;
  // The mean of what those continue that are seen beside it.
  [[nodiscard]] std::optional<glm::vec4> mean_continued(std::span<const glm::vec4> values,
                                                        const Place& place,
                                                        const std::vector<bool>& is_hidden) const;

  glm::dvec3 eye_;
  double start_;
  double distance_;
  std::vector<glm::dvec3> directions_, offsets_;
  std::vector<double> surfaces_;
  std::vector<glm::dvec3> points_, normals_;  // where it meets one
};

}  // namespace brume
