#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/scene/scene.h"
#include "render/cpu/average_depth_grid.h"
#include "render/cpu/transferred_light.h"
#include "render/environment_light.h"
#include "render/job.h"
#include "render/medium_index.h"
#include "render/render_plan.h"
#include "render/settings.h"
#include "render/transfer/sh_material.h"
#include "render/transfer/transfer_store.h"

namespace brume {

// What shading one surface needs besides its material.
struct SurfaceShading {
  const ShMaterial* material = nullptr;             // null: it is diffuse, or nothing needs it
  const AverageDepthGrid* average_depth = nullptr;  // of the Gaussians; null: 0
  // Null: the surface needs no transfer, or it is not there yet.
  const RadianceTransfer* transfer = nullptr;
  const TransferredLight* transferred = nullptr;  // after take_light()
};

// What the light that comes through the medium needs of a scene, kept from frame to frame: renewed
// where what it was made from has changed, by value.
class PreparedShading {
 public:
  void update(const Scene& scene, const RenderPlan& plan, const Settings& settings,
              const TransferStore& transfers);

  // Sets the light of surfaces with transfer: what `lighting` makes of the scene of the last
  // update(). `pairs` += the Gaussian x path pairs evaluated.
  void take_light(const Scene& scene, const MediumIndex& medium, const SurfaceLighting& lighting,
                  const Settings& settings, Settings::Arithmetic arithmetic, const Job& job,
                  std::uint64_t& pairs);

  // From here on, of the last update(). One for each surface of the scene.
  [[nodiscard]] const std::vector<SurfaceShading>& surfaces() const { return shading_; }
  // Another number whenever light was taken or the average depths of a surface were found.
  [[nodiscard]] std::uint64_t light_revision() const { return light_revision_; }
  // Null: there is none.
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
    glm::dvec3 translate;
    glm::dquat rotate;
    double scale;
    AverageDepthGrid grid;

    [[nodiscard]] bool of(const Surface& surface) const;
  };
  // All that decides what light reaches vertices.
  struct LitBy {
    Medium medium;
    std::vector<PointLight> lights;
    std::optional<Environment> environment;
    double anisotropy = 0.0;
    double fog_depth = 0.0;
    double albedo = 1.0;
    Settings settings;

    bool operator==(const LitBy&) const = default;
  };
  static LitBy lit_by(const Scene& scene, const SurfaceLighting& lighting, const Settings& settings,
                      Settings::Arithmetic arithmetic);
  std::uint64_t light_revision_ = 0;
  struct VertexLight {
    Surface surface;
    std::shared_ptr<const RadianceTransfer> transfer;
    std::unique_ptr<const TransferredLight> light;  // null: not taken yet
  };
  const ShMaterial& sh_material_of(const Material& material);
  const AverageDepthGrid& average_depth_of(const Surface& surface);

  std::optional<EnvironmentLight> environment_;
  Medium medium_;  // of depths_
  // Pointers, so that references live on when a vector grows.
  std::vector<std::unique_ptr<Reflection>> reflections_;
  std::vector<std::unique_ptr<Depths>> depths_;
  LitBy lit_by_;  // of vertex_lights_
  std::vector<VertexLight> vertex_lights_;
  std::vector<SurfaceShading> shading_;
};

}  // namespace brume
