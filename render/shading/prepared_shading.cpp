#include "render/shading/prepared_shading.h"

#include <algorithm>

#include "brume/mesh_arrays.h"
#include "render/shading/surface_shading.h"

namespace brume {
namespace {

Box bounds(const Surface& surface) {
  const MeshBox box = world_box(surface);
  return box.low.x <= box.high.x ? Box{box.low, box.high} : Box{};
}

}  // namespace

bool PreparedShading::Depths::matches(const Surface& surface) const {
  return mesh == surface.mesh && placement == Placement(surface) && copies == surface.placed_copies;
}

void PreparedShading::update(const Scene& scene, const RenderPlan& plan,
                             const TransferStore& transfers) {
  const ScatterTable& scattering =
      plan.settings.paper_spread ? ScatterTable::paper() : ScatterTable::distant();
  if (!plan.has_environment) {
    environment_.reset();
  } else if (!environment_ || !environment_->shows(*scene.environment, scattering)) {
    environment_.emplace(*scene.environment, scattering);
  }

  const auto is_unused = [&](const auto& is_used_by) {
    return std::none_of(scene.surfaces.begin(), scene.surfaces.end(), is_used_by);
  };
  std::erase_if(reflections_, [&](const auto& entry) {
    return is_unused([&](const Surface& s) { return s.material == entry->material; });
  });
  const bool needs_average = plan.runs(Stage::average_depth);
  const Revision medium = needs_average ? scene.medium.revision() : 0;
  if (medium_ != medium) {
    depths_.clear();
    medium_ = medium;
  }
  std::erase_if(depths_, [&](const auto& entry) {
    return is_unused([&](const Surface& s) { return entry->matches(s); });
  });

  const auto transfer_of = [&](const Surface& surface) {
    return plan.needs_transfer(surface) ? transfers.find(transfer_request(surface)) : nullptr;
  };
  std::erase_if(vertex_lights_, [&](const VertexLight& entry) {
    return is_unused(
        [&](const Surface& s) { return s == entry.surface && transfer_of(s) == entry.transfer; });
  });

  shading_.assign(scene.surfaces.size(), {});
  for (std::size_t i = 0; i < shading_.size(); ++i) {
    const Surface& surface = scene.surfaces[i];
    // All metallic-roughness materials share one table: GgxSh.
    if (surface.material.type != Material::Type::diffuse &&
        surface.material.type != Material::Type::metallic_roughness && plan.has_indirect_light) {
      shading_[i].material = &sh_material_of(surface.material);
    }
    if (needs_average) {
      shading_[i].average_depth = &average_depth_of(surface, scene.medium);
    }
    if (const auto transfer = transfer_of(surface)) {
      shading_[i].transfer = transfer.get();
      shading_[i].material = &sh_material_of(surface.material);
      if (std::ranges::find(vertex_lights_, surface, &VertexLight::surface) ==
          vertex_lights_.end()) {
        vertex_lights_.push_back({surface, transfer, nullptr});
      }
    }
  }
}

void PreparedShading::update_vertex_lighting(const Scene& scene, const MediumIndex& medium,
                                             const SurfaceLighting& lighting,
                                             const RenderPlan& plan, const Job& job,
                                             std::uint64_t& pairs) {
  if (vertex_lights_.empty()) return;
  VertexLightingInputs inputs(medium, lighting, plan.precision);
  if (inputs != vertex_inputs_) {
    for (VertexLight& entry : vertex_lights_) entry.light.reset();
    vertex_inputs_ = std::move(inputs);
  }
  for (std::size_t i = 0; i < shading_.size(); ++i) {
    if (!shading_[i].transfer) continue;
    const Surface& surface = scene.surfaces[i];
    auto& light = std::ranges::find(vertex_lights_, surface, &VertexLight::surface)->light;
    if (!light) {
      auto vertex_lighting = std::make_unique<const VertexLighting>(
          medium, lighting, surface, shading_[i], plan.precision, job, pairs);
      if (job.stop.stop_requested()) return;
      light = std::move(vertex_lighting);
      light_revision_ = new_revision();
    }
    shading_[i].transferred = light.get();
  }
}

const ShMaterial& PreparedShading::sh_material_of(const Material& material) {
  for (const auto& entry : reflections_) {
    if (entry->material == material) return entry->sh;
  }
  reflections_.push_back(
      std::make_unique<Reflection>(Reflection{material, ShMaterial(material, sh_max_bands)}));
  return reflections_.back()->sh;
}

const AverageDepthGrid& PreparedShading::average_depth_of(const Surface& surface,
                                                          const Medium& medium) {
  for (const auto& entry : depths_) {
    if (entry->matches(surface)) return entry->grid;
  }
  const GaussianTerms<double> gaussians(medium);
  light_revision_ = new_revision();
  depths_.push_back(
      std::make_unique<Depths>(Depths{surface.mesh, Placement(surface), surface.placed_copies,
                                      AverageDepthGrid(gaussians.all(), bounds(surface))}));
  return depths_.back()->grid;
}

}  // namespace brume
