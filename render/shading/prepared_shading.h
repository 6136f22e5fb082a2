#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "brume/revision.h"
#include "brume/scene.h"
#include "core/scene/placement.h"
#include "render/geometry/medium_index.h"
#include "render/optical_depth/average_depth_grid.h"
#include "render/render_plan.h"
#include "render/scattering/environment_light.h"
#include "render/settings.h"
#include "render/shading/vertex_lighting.h"
#include "render/transfer/sh_material.h"
#include "render/transfer/transfer_store.h"
#include "render/util/job.h"

namespace brume {

// Data for shading one surface, besides its material.
struct SurfaceShading {
  const ShMaterial* material = nullptr;             // null: diffuse, or unused
  const AverageDepthGrid* average_depth = nullptr;  // of the Gaussians; null: zero
  // Null: no transfer requested, or not computed yet.
  const RadianceTransfer* transfer = nullptr;
  const VertexLighting* transferred = nullptr;  // set by update_vertex_lighting()
};

// Caches for shading surfaces.
class PreparedShading {
 public:
  void update(const Scene& scene, const RenderPlan& plan, const TransferStore& transfers);

  // Updates the vertex lighting of surfaces with transfer under `lighting`, for the scene of the
  // last update(). `pairs` += Gaussian x path pairs evaluated.
  void update_vertex_lighting(const Scene& scene, const MediumIndex& medium,
                              const SurfaceLighting& lighting, const RenderPlan& plan,
                              const Job& job, std::uint64_t& pairs);

  // State after the last update(), one entry per surface of the scene.
  [[nodiscard]] const std::vector<SurfaceShading>& surfaces() const { return shading_; }
  // The revision of vertex lighting and average depths.
  [[nodiscard]] Revision light_revision() const { return light_revision_; }
  // Null: no environment.
  [[nodiscard]] const EnvironmentLight* environment() const {
    return environment_ ? &*environment_ : nullptr;
  }

 private:
  struct Reflection {
    Material material;
    ShMaterial sh;
  };
  struct Depths {
    std::shared_ptr<const TriangleMesh> mesh;
    Placement placement;
    std::shared_ptr<const CopyPlacements> copies;
    AverageDepthGrid grid;

    [[nodiscard]] bool matches(const Surface& surface) const;
  };
  Revision light_revision_ = 0;
  struct VertexLight {
    Surface surface;
    std::shared_ptr<const RadianceTransfer> transfer;
    std::unique_ptr<const VertexLighting> light;  // null: not computed yet
  };
  const ShMaterial& sh_material_of(const Material& material);
  const AverageDepthGrid& average_depth_of(const Surface& surface, const Medium& medium);

  std::optional<EnvironmentLight> environment_;
  Revision medium_ = 0;  // of depths_; 0: there are none
  // Pointers, to keep references valid when a vector grows.
  std::vector<std::unique_ptr<Reflection>> reflections_;
  std::vector<std::unique_ptr<Depths>> depths_;
  VertexLightingInputs vertex_inputs_;  // of vertex_lights_
  std::vector<VertexLight> vertex_lights_;
  std::vector<SurfaceShading> shading_;
};

}  // namespace brume
