#include "render/splats/baked_splats.h"

#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include "core/math/sphere_rule.h"
#include "core/math/spherical_harmonics.h"
#include "render/cpu/sliced_airlight.h"
#include "render/prepare/albedo.h"
#include "render/prepare/frame_stages.h"
#include "render/render_plan.h"

namespace brume {
namespace {

constexpr int bands = 4;
// Exact for products of the bands and of what they resolve.
constexpr int rule_degree = 2 * (bands - 1);
// A line through a Gaussian's center: so far to both sides [radii], in so many slices.
constexpr double half_line = 3.0;
constexpr std::size_t line_slices = 12;
// The stages want a film, though no ray is of it.
constexpr Film no_film{16, 16};

// The light in a medium of one albedo.
class BakedGroup {
 public:
  BakedGroup(const RenderPlan& plan, Scene scene, const TransferStore& transfers, const Job& job,
             const AlbedoGroup& group, const FogExtent& extent)
      : scene_(std::move(scene)),
        work_(plan, scene_, scene_.camera, {no_film, plan.settings}, transfers, nullptr, job, group,
              extent) {}

  // False if stopped.
  bool prepare() {
    StageClock clock(work_.frame.statistics.stages);
    work_.make_layers();
    if (!stages_.begin(work_, clock)) return false;
    stages_.find_hits(work_, clock);
    if (!stages_.prepare_source(work_, clock)) return false;
    lights_ = stages_.sliced_lights(work_, clock);
    return !work_.job.stop.stop_requested();
  }

  // The radiance of a Gaussian along a direction.
  [[nodiscard]] glm::vec3 radiance(std::uint32_t index, const glm::dvec3& w) const {
    const GaussianTerm<double>& g = stages_.prepared().medium().gaussians()[index];
    const double half = half_line / g.a * (g.ellipsoid ? g.ellipsoid->reach(w) : 1.0);
    const glm::dvec3 eye = g.b - half * w;
    std::array<float, line_slices + 1> boundaries;
    for (std::size_t k = 0; k < boundaries.size(); ++k) {
      boundaries[k] = static_cast<float>(2.0 * half * static_cast<double>(k) / line_slices);
    }
    SliceNodes slices{{}, boundaries.size()};
    slices.boundaries.fill(boundaries.data());
    std::optional<SlicedSource> source;
    if (const SourceFunction* function = stages_.source_function(work_)) {
      source = {function, function->from_eye(eye)};
    }
    const double length = 2.0 * half;
    const glm::vec2 middle(0.5f);
    glm::vec3 airlight(0.0f);
    double depth = 0.0;
    sliced_airlight(stages_.prepared().medium(), std::span(&index, 1), lights_,
                    source ? &*source : nullptr,
                    {eye, std::span(&w, 1), std::span(&length, 1), 0, std::span(&middle, 1)},
                    slices, {std::span(&airlight, 1), std::span(&depth, 1)});
    const double opacity = -std::expm1(-depth);
    return opacity > 0.0 ? static_cast<float>(work_.group.albedo / opacity) * airlight
                         : glm::vec3(0.0f);
  }

  [[nodiscard]] std::span<const std::size_t> channels() const { return work_.group.channels; }

 private:
  Scene scene_;
  FrameContext work_;
  FrameStages stages_;
  std::vector<SlicedLight> lights_;
};

}  // namespace

std::optional<std::vector<SplatColor>> bake_splats(const Scene& scene, const Settings& settings,
                                                   const ShowRadiance& show,
                                                   const TransferStore& transfers, const Job& job) {
  Scene lit = scene;
  lit.medium.set_homogeneous_density(0.0);
  lit.optics.noise = {};
  Settings sliced = settings;
  sliced.airlight = AirlightMethod::sliced;
  sliced.airlight_scale = 1;
  // Every Gaussian has its splat.
  sliced.merge_error = 0.0;
  const RenderPlan plan(lit, no_film, sliced, &transfers);
  std::vector<SplatColor> colors(lit.medium.size(), SplatColor{});
  if (!plan.has_medium()) return colors;
  const FogExtent extent(lit);
  const std::vector<AlbedoGroup> albedos = albedo_groups(lit, plan.has_own_optics);
  std::vector<std::unique_ptr<BakedGroup>> groups;
  for (const AlbedoGroup& albedo : albedos) {
    Scene absorbing = lit;
    absorbing.medium = extinction_medium(lit, albedo);
    groups.push_back(std::make_unique<BakedGroup>(plan, std::move(absorbing), transfers,
                                                  Job{job.stop, {}}, albedo, extent));
    if (!groups.back()->prepare()) return std::nullopt;
  }
  struct Direction {
    glm::dvec3 w;
    std::array<float, sh_size(bands)> weights;  // of its value for each coefficient
  };
  std::vector<Direction> directions;
  for (const SphereNode& node : sphere_rule(rule_degree)) {
    Direction& direction = directions.emplace_back();
    direction.w = node.direction;
    const ShVector<double> basis = sh_basis(bands, node.direction);
    for (std::size_t i = 0; i < direction.weights.size(); ++i) {
      direction.weights[i] = static_cast<float>(node.weight * basis[i]);
    }
  }
  job.parallel_for_with_progress(colors.size(), [&](std::size_t i) {
    for (const Direction& direction : directions) {
      glm::vec3 radiance(0.0f);
      for (const auto& group : groups) {
        const glm::vec3 own_radiance = group->radiance(static_cast<std::uint32_t>(i), direction.w);
        for (const std::size_t channel : group->channels()) {
          radiance[static_cast<int>(channel)] = own_radiance[static_cast<int>(channel)];
        }
      }
      const glm::vec3 shown = show(radiance);
      for (std::size_t k = 0; k < direction.weights.size(); ++k) {
        colors[i][k] += direction.weights[k] * shown;
      }
    }
  });
  if (job.stop.stop_requested()) return std::nullopt;
  return colors;
}

}  // namespace brume
