#pragma once

#include <memory>
#include <optional>

#include "render/cpu/visibility.h"

namespace brume {

class Document;

// Which surface a ray meets, for tools. What it takes to know that is built when it is first asked
// for, and again when the surfaces have changed.
class SurfacePicker {
 public:
  explicit SurfacePicker(const Document& document) : document_(document) {}

  // Of a ray of unit direction.
  std::optional<SurfacePoint> hit(const glm::dvec3& origin, const glm::dvec3& direction);

 private:
  const Document& document_;
  std::unique_ptr<Visibility> visibility_;
};

}  // namespace brume
