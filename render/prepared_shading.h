#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/scene/brdf.h"
#include "core/scene/scene.h"
#include "render/cpu/average_depth_grid.h"
#include "render/environment_light.h"
#include "render/render_plan.h"
#include "render/settings.h"

namespace brume {

// What shading one surface needs besides its material.
struct SurfaceShading {
  const BrdfSh* brdf = nullptr;  // null: the material is diffuse, or nothing needs it
  const AverageDepthGrid* average_depth = nullptr;  // of the Gaussians; null: 0
};

// What the light that comes through the medium needs of a scene, kept from frame to frame: renewed
// where what it was made from has changed, by value.
class PreparedShading {
 public:
  void update(const Scene& scene, const RenderPlan& plan, const Settings& settings);

  // From here on, of the last update(). One for each surface of the scene.
  [[nodiscard]] const std::vector<SurfaceShading>& surfaces() const { return shading_; }
  // Null: there is none.
  [[nodiscard]] const EnvironmentLight* environment() const {
    return environment_ ? &*environment_ : nullptr;
  }

 private:
  struct Reflection {
    Material material;
    BrdfSh brdf;
  };
  struct Depths {
    std::shared_ptr<const TriangleMesh> mesh;
    glm::dvec3 translate;
    glm::dquat rotate;
    double scale;
    AverageDepthGrid grid;

    [[nodiscard]] bool of(const Surface& surface) const;
  };
  const BrdfSh& brdf_of(const Material& material);
  const AverageDepthGrid& average_depth_of(const Surface& surface);

  std::optional<EnvironmentLight> environment_;
  Medium medium_;  // of depths_
  // Pointers, so that references live on when a vector grows.
  std::vector<std::unique_ptr<Reflection>> reflections_;
  std::vector<std::unique_ptr<Depths>> depths_;
  std::vector<SurfaceShading> shading_;
};

}  // namespace brume
