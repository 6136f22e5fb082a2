#include "render/render_plan.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <optional>

#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/emitting_surfaces.h"
#include "core/scene/materials/coverage.h"
#include "core/scene/materials/ggx.h"
#include "core/scene/mesh.h"

namespace brume {
namespace {

bool mirrors(const Surface& surface) {
  return surface.material.type == Material::Type::metallic_roughness &&
         may_mirror(surface.material.metallic_roughness);
}

bool has_transfer(const Surface& surface) {
  return surface.transfer != Surface::Transfer::none &&
         surface.material.type != Material::Type::metallic_roughness && !surface.placed_copies;
}

// The content of a scene that there is to render.
struct Content {
  std::vector<PointLight> lights;  // that are on and not black
  std::size_t lights_off = 0;
  std::size_t black_lights = 0;
  std::size_t lights_beyond_paper = 0;
  bool surfaces, visible_lights, shining_shapes, environment, gaussians, homogeneous, noise;
  // Properties of Gaussians; emission counts as light of methods that know it.
  bool has_own_optics;
  bool has_emission = false;
  bool emissive_surfaces;

  Content(const Scene& scene, AirlightMethod method)
      : surfaces(!scene.surfaces.empty()),
        visible_lights(std::ranges::any_of(scene.lights, is_seen)),
        shining_shapes(std::ranges::any_of(scene.lights,
                                           [](const Light& light) {
                                             return is_seen(light) &&
                                                    light.intensity != glm::dvec3(0.0);
                                           })),
        environment(scene.environment && scene.environment->intensity > 0.0),
        gaussians(std::ranges::any_of(scene.medium.densities(), [](double c) { return c > 0.0; })),
        homogeneous(scene.medium.homogeneous_density() > 0.0),
        noise(gaussians && scene.optics.noise.amplitude > 0.0),
        has_own_optics(scene.medium.has_albedos() || scene.medium.has_emission()),
        emissive_surfaces(std::ranges::any_of(scene.surfaces, is_emissive)) {
    const bool is_paper = method == AirlightMethod::paper;
    has_emission = !is_paper && gaussians && scene.medium.has_emission();
    for (const Light& light : scene.lights) {
      if (!light.on) {
        ++lights_off;
      } else if (light.intensity == glm::dvec3(0.0)) {
        ++black_lights;
      } else if (is_paper && (!light.as<light::Point>() || profile_of(light))) {
        ++lights_beyond_paper;  // its closed form is that of isotropic lights nearby
      }
    }
    if (is_paper) lights_beyond_paper += std::ranges::count_if(scene.surfaces, is_emissive);
    // A sphere far away is one isotropic light, which is not `paper`'s either.
    lights = point_lights(scene, method == AirlightMethod::reference ? LightPoints::many
                                 : method == AirlightMethod::path    ? LightPoints::drawn
                                                                     : LightPoints::few);
    if (is_paper) {
      std::erase_if(lights, [](const PointLight& light) {
        return !light.falloff.is_isotropic() || light.is_far || light.radius > 0.0;
      });
    }
  }

  [[nodiscard]] bool medium() const { return gaussians || homogeneous; }
  [[nodiscard]] bool point_light() const { return !lights.empty(); }
  [[nodiscard]] bool light() const { return environment || point_light() || has_emission; }
  // From all directions: of an environment, or scattered by the medium.
  [[nodiscard]] bool indirect_light() const { return environment || (medium() && point_light()); }

  // Direct light of point lights uses shadow rays.
  [[nodiscard]] bool needs_transfer(const Surface& surface) const {
    if (!has_transfer(surface)) return false;
    switch (surface.transfer) {
      case Surface::Transfer::none:
        return false;
      case Surface::Transfer::shadow:
        return indirect_light();
      case Surface::Transfer::interreflection:
        return light();
    }
    return false;
  }

  [[nodiscard]] std::vector<TransferRequest> transfers(const Scene& scene) const {
    std::vector<TransferRequest> requests;
    for (const Surface& surface : scene.surfaces) {
      if (!needs_transfer(surface)) continue;
      const TransferRequest request = transfer_request(surface);
      if (std::ranges::find(requests, request) == requests.end()) requests.push_back(request);
    }
    return requests;
  }
};

std::size_t triangle_count(const Scene& scene) {
  std::size_t count = 0;
  for (const Surface& surface : scene.surfaces) count += surface.mesh->n_faces();
  return count;
}

// A bound of the share of light that is scattered more than once: with each order there is at most
// the greatest albedo times the opacity of the deepest line as much.
double max_multiple_share(const Scene& scene) {
  glm::dvec3 w = scene.optics.albedo;
  if (scene.medium.homogeneous_density() > 0.0) return 1.0;  // fog may be endless
  const bool has_own = scene.medium.has_albedos();
  constexpr double opaque = 40.0;
  double depth = 0.0;
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    const Gaussian g = scene.medium.gaussian(i);
    const glm::dvec3 albedo = g.optics.albedo.value_or(scene.optics.albedo);
    depth += g.density / std::min({albedo.x, albedo.y, albedo.z}) * g.radius *
             std::sqrt(std::numbers::pi);
    w = glm::max(w, albedo);
    if (depth > opaque && !has_own) break;
  }
  const double opacity = -std::expm1(-depth);
  return std::max({w.x, w.y, w.z}) * opacity;
}

// Nullopt: it matters.
std::optional<Reason> why_scattered_once(const Scene& scene, const Content& content,
                                         const Settings& settings) {
  // The share of the allowed error that is negligible.
  constexpr double negligible = 0.1;
  if (!content.light()) return Reason::no_light;
  // Surfaces light each other, however thin the medium is, without one as well.
  if (content.surfaces) return std::nullopt;
  if (!content.medium()) return Reason::no_medium;
  if (max_multiple_share(scene) < negligible * settings.max_error) {
    return Reason::thin_medium;
  }
  return std::nullopt;
}

StageSet planned_stages(const Content& content, AirlightMethod method, bool has_transfers,
                        bool has_all_orders) {
  const bool paper = method == AirlightMethod::paper;
  const bool sliced = method == AirlightMethod::sliced;
  const bool path = method == AirlightMethod::path;
  const bool lit_gaussians = content.gaussians && content.point_light();
  // The grid serves airlight and light at surfaces. `paper` has average optical depths, and the
  // integral of the reference is its own.
  const bool needs_grid = sliced || (content.surfaces && !paper && !path);
  StageSet stages{Stage::prepare, Stage::composite};
  stages.add(Stage::transfer, has_transfers);
  stages.add(Stage::visibility, content.surfaces || content.visible_lights);
  // Light of all orders at surfaces is all that the grid holds.
  stages.add(Stage::environment,
             content.environment && needs_grid && (content.medium() || has_all_orders));
  stages.add(Stage::light_depth, paper && lit_gaussians);
  stages.add(Stage::eye_depth, paper && lit_gaussians);
  stages.add(Stage::light_table, sliced && lit_gaussians);
  stages.add(Stage::shadow_map,
             sliced && content.surfaces && content.medium() && content.point_light());
  if (path && (content.light() || content.emissive_surfaces)) {
    stages.add(Stage::paths, content.medium() || content.surfaces || content.visible_lights);
  } else {
    stages.add(content.light() ? Stage::airlight : Stage::transmittance, content.medium());
    stages.add(Stage::surfaces,
               content.shining_shapes ||
                   (content.surfaces && (content.light() || content.emissive_surfaces)));
  }
  return stages;
}

StageSet planned_parts(const Content& content, const Settings& settings, bool has_transfers) {
  const bool paper = settings.airlight == AirlightMethod::paper;
  const bool path = settings.airlight == AirlightMethod::path;
  StageSet parts;
  parts.add(Stage::homogeneous, content.homogeneous);
  parts.add(Stage::noise, content.noise);
  parts.add(Stage::upsample, content.medium() && settings.airlight_scale > 1 && !path);
  parts.add(Stage::average_depth,
            paper && content.surfaces && content.environment && content.gaussians);
  parts.add(Stage::surface_scattering,
            content.surfaces && content.medium() && content.light() && !path);
  // Parts that are known already are in the plan even if the rest is still to come.
  parts.add(Stage::vertex_light, has_transfers);
  return parts;
}

RenderPlan::SurfaceDepths planned_surface_depths(const Content& content, AirlightMethod method) {
  using enum RenderPlan::SurfaceDepths;
  if (!content.surfaces || !content.gaussians || !content.point_light()) return none;
  if (method == AirlightMethod::path) return none;
  return method == AirlightMethod::sliced ? tables : exact;
}

// Stages whose absence says something of the scene.
std::vector<SkippedStage> skipped_stages(const Scene& scene, const Content& content,
                                         AirlightMethod method, const RenderPlan& plan) {
  std::vector<SkippedStage> skipped;
  const auto skip = [&](Stage stage, Reason why, std::size_t count = 0) {
    skipped.push_back({stage, to_string(why, count)});
  };
  const bool requests_transfer = std::ranges::any_of(scene.surfaces, has_transfer);
  const bool is_refused = std::ranges::any_of(scene.surfaces, [](const Surface& surface) {
    return surface.transfer != Surface::Transfer::none && !has_transfer(surface);
  });
  if (is_refused) skip(Stage::transfer, Reason::transfer_refused);
  if (!plan.runs(Stage::visibility)) skip(Stage::visibility, Reason::no_surfaces);
  if (content.surfaces && !content.light() && !content.emissive_surfaces) {
    skip(Stage::surfaces, Reason::no_light);
  }
  if (plan.transfers.empty() && (requests_transfer || !is_refused)) {
    skip(Stage::transfer, !requests_transfer                  ? Reason::no_transfer_requested
                          : !content.light()                  ? Reason::no_light
                          : method == AirlightMethod::path    ? Reason::part_of_paths
                          : !content.transfers(scene).empty() ? Reason::part_of_all_orders
                                                              : Reason::only_direct_light);
  }
  if (content.surfaces && content.light() && !content.medium()) {
    skip(Stage::surface_scattering, Reason::no_medium);
  }
  if (!content.environment) {
    skip(Stage::environment,
         scene.environment ? Reason::black_environment : Reason::no_environment);
  }
  // The stages before the airlight depend on the method.
  if (!content.gaussians || !content.point_light()) {
    const Reason why = content.point_light() ? Reason::no_gaussians : Reason::no_light;
    if (method == AirlightMethod::paper) {
      skip(Stage::light_depth, why);
      skip(Stage::eye_depth, why);
    } else if (method == AirlightMethod::sliced) {
      skip(Stage::light_table, why);
    }
  }
  if (method == AirlightMethod::sliced && !plan.runs(Stage::shadow_map)) {
    skip(Stage::shadow_map, !content.surfaces        ? Reason::no_surfaces
                            : !content.point_light() ? Reason::no_light
                                                     : Reason::no_medium);
  }
  if (!content.homogeneous) skip(Stage::homogeneous, Reason::no_homogeneous_density);
  if (!content.noise) {
    skip(Stage::noise, content.gaussians ? Reason::no_noise : Reason::no_gaussians);
  }
  if (!plan.runs(Stage::airlight) && !(plan.runs(Stage::paths) && content.medium())) {
    skip(Stage::airlight, content.medium() ? Reason::no_light : Reason::no_medium);
  }
  if (content.lights_off > 0) skip(Stage::lights, Reason::lights_off, content.lights_off);
  if (content.black_lights > 0) skip(Stage::lights, Reason::black_lights, content.black_lights);
  if (method == AirlightMethod::paper && content.has_own_optics) {
    skip(Stage::airlight, Reason::optics_beyond_paper);
  }
  if (content.lights_beyond_paper > 0) {
    skip(Stage::lights, Reason::lights_beyond_paper, content.lights_beyond_paper);
  }
  if (!plan.transfers.empty() && !plan.runs(Stage::transfer)) {
    skip(Stage::transfer, Reason::transfer_pending);
  }
  return skipped;
}

}  // namespace

RenderPlan::RenderPlan(const Scene& scene, const Film& film, const Settings& requested,
                       const TransferStore* shared, const Motion& in_motion)
    : motion(in_motion) {
  settings = without_auto(requested);
  const AirlightMethod method = settings.airlight;
  const Content content(scene, method);
  const bool is_reference = method == AirlightMethod::reference;
  const bool is_path = method == AirlightMethod::path;
  settings = limit_light_map_memory(settings, content.lights.size(), content.surfaces);
  lights = content.lights;
  has_density = content.medium();
  has_own_optics = content.has_own_optics && method != AirlightMethod::paper;
  const bool wants_all_orders =
      method == AirlightMethod::sliced && settings.scattering == Scattering::multiple;
  const std::optional<Reason> why_once =
      wants_all_orders ? why_scattered_once(scene, content, settings) : std::nullopt;
  const bool has_all_orders = wants_all_orders && !why_once;
  // Paths and the grid of all orders keep light out and send it back themselves.
  if (!is_path && !has_all_orders) transfers = content.transfers(scene);

  stages = planned_stages(
      content, method, !transfers.empty() && (!shared || shared->has(transfers)), has_all_orders);
  parts = planned_parts(content, settings, !transfers.empty());
  skipped = skipped_stages(scene, content, method, *this);

  stages.add(Stage::scattering, has_all_orders);
  stages.add(Stage::samples, settings.samples > 1 && !is_path);
  if (why_once) skipped.push_back({Stage::scattering, to_string(*why_once)});

  const FilmRegion whole = film.region.value_or(FilmRegion{0, 0, film.width, film.height});
  const auto pixels =
      static_cast<std::size_t>(whole.full_width) * static_cast<std::size_t>(whole.full_height);
  has_holes = brume::has_holes(scene.surfaces);
  has_panes = brume::has_panes(scene.surfaces);
  has_copies = std::ranges::any_of(
      scene.surfaces, [](const Surface& surface) { return surface.placed_copies != nullptr; });
  has_visible_lights = content.visible_lights;
  // The rasterizer fills triangles.
  rasterizes = content.surfaces && !has_holes && !has_panes && !has_copies &&
               triangle_count(scene) <= pixels;
  if (is_reference && has_medium() && has_panes) {
    skipped.push_back({Stage::shadow_map, to_string(Reason::panes_beyond_reference)});
  }
  has_environment = content.environment;
  has_environment_in_medium = content.environment && content.medium();
  has_all_light_at_surfaces = runs(Stage::scattering) && content.surfaces;
  has_receivers = runs(Stage::environment) && content.surfaces && !has_all_light_at_surfaces;
  has_indirect_light = (content.indirect_light() || runs(Stage::scattering)) && !is_path;
  has_metallic_roughness =
      runs(Stage::surfaces) && std::ranges::any_of(scene.surfaces, [](const Surface& surface) {
        return surface.material.type == Material::Type::metallic_roughness;
      });
  // In motion they reflect harmonics.
  has_mirrors = settings.mirrors && motion == Motion() && runs(Stage::surfaces) &&
                method == AirlightMethod::sliced && std::ranges::any_of(scene.surfaces, mirrors);
  surface_depths = planned_surface_depths(content, method);
  has_exact_occlusion = is_reference;
  precision = is_reference ? Settings::Precision::plain_double : settings.precision;
  depth_error = is_reference ? reference_depth_error
                : is_path    ? path_depth_error
                             : settings.depth_error;
  // Other methods are held to the medium as it is.
  merge_error = method == AirlightMethod::sliced ? settings.merge_error : 0.0;
}

bool RenderPlan::needs_transfer(const Surface& surface) const {
  return has_transfer(surface) &&
         std::ranges::find(transfers, transfer_request(surface)) != transfers.end();
}

bool shows_mirrored_light(const Scene& scene, const Settings& settings) {
  const RenderPlan plan(scene, scene.film, settings);
  return plan.has_mirrors ||
         (plan.runs(Stage::paths) && std::ranges::any_of(scene.surfaces, mirrors));
}

std::vector<TransferRequest> needed_transfers(const Scene& scene, const Settings& settings) {
  if (scene.surfaces.empty()) return {};
  return RenderPlan(scene, scene.film, settings).transfers;
}

}  // namespace brume
