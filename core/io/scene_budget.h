#pragma once

#include <cstddef>

#include "core/io/json_reader.h"

namespace brume {

class MeasuredBrdf;
struct RadianceMap;
struct TriangleMesh;

// What a scene that is being read has taken of limits::gaussians and limits::scene_bytes: whatever
// its files hold one by one, together they fit into memory. Throws InputErrors that name the place
// in the scene.
class SceneBudget {
 public:
  explicit SceneBudget(const JsonContext& context) : context_(context) {}

  // Gaussians with what they take of memory.
  void take_gaussians(const JsonPlace& place, std::size_t count);
  void take(const JsonPlace& place, const RadianceMap& map);
  void take(const JsonPlace& place, const MeasuredBrdf& measured);
  // Of one surface: what is rendered has a copy of its own for each.
  void take(const JsonPlace& place, const TriangleMesh& mesh);

  [[nodiscard]] std::size_t gaussians_left() const;

 private:
  void take_bytes(const JsonPlace& place, std::size_t bytes);

  const JsonContext& context_;
  std::size_t gaussians_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace brume
