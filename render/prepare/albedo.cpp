#include "render/prepare/albedo.h"

#include <algorithm>
#include <cmath>

#include "core/scene/materials/coverage.h"

namespace brume {

namespace {

// Whether a channel's albedos are those of another.
bool are_equal(const Scene& scene, bool with_own_albedos, int a, int b) {
  if (scene.optics.albedo[a] != scene.optics.albedo[b]) return false;
  if (!with_own_albedos) return true;
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    const GaussianOptics optics = scene.medium.optics(i);
    if (optics.albedo && (*optics.albedo)[a] != (*optics.albedo)[b]) return false;
  }
  return true;
}

}  // namespace

glm::dvec3 channel_weights(const AlbedoGroup& group) {
  glm::dvec3 weights(0.0);
  for (const std::size_t c : group.channels) {
    weights[static_cast<int>(c)] = 1.0 / static_cast<double>(group.channels.size());
  }
  return weights;
}

std::vector<AlbedoGroup> albedo_groups(const Scene& scene, bool with_own_optics) {
  const bool is_apart = has_colored_panes(scene.surfaces);
  const bool has_albedos = with_own_optics && scene.medium.has_albedos();
  const bool has_own_optics = has_albedos || (with_own_optics && scene.medium.has_emission());
  std::vector<AlbedoGroup> groups;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const int c = static_cast<int>(channel);
    const auto same = std::ranges::find_if(groups, [&](const AlbedoGroup& group) {
      return !is_apart &&
             are_equal(scene, has_albedos, static_cast<int>(group.channels.front()), c);
    });
    if (same != groups.end()) {
      same->channels.push_back(channel);
    } else {
      groups.push_back({scene.optics.albedo[c], {channel}, has_own_optics});
    }
  }
  return groups;
}

Medium extinction_medium(const Scene& scene, const AlbedoGroup& group) {
  const Medium& scattering = scene.medium;
  if (group.albedo == 1.0 && !scattering.has_albedos()) return scattering;
  const int channel = static_cast<int>(group.channels.front());
  return scattering.changed(scattering.homogeneous_density() / group.albedo, [&](Gaussian g) {
    if (!group.has_own_optics) g.optics = {};
    const double albedo = g.optics.albedo ? (*g.optics.albedo)[channel] : group.albedo;
    g.density /= albedo;
    g.optics.albedo.reset();
    if (albedo != group.albedo) g.optics.albedo = glm::dvec3(albedo / group.albedo);
    g.optics.emission /= group.albedo;
    return g;
  });
}

const Medium& ExtinctionMedia::update(std::size_t which, const Scene& scene,
                                      const AlbedoGroup& group) {
  if (entries_.size() <= which) entries_.resize(which + 1);
  Entry& entry = entries_[which];
  if (entry.group != group || entry.scattering != scene.medium.revision()) {
    entry = {scene.medium.revision(), group, extinction_medium(scene, group)};
  }
  return entry.medium;
}

void copy_channels(const AlbedoGroup& group, const Frame& group_frame, Frame& frame) {
  const auto albedo = static_cast<float>(group.albedo);
  const auto copy = [&](std::vector<float> Frame::*layer) {
    for (std::size_t i = 0; i < (group_frame.*layer).size() / 3; ++i) {
      for (const std::size_t c : group.channels) {
        (frame.*layer)[3 * i + c] = (group_frame.*layer)[3 * i + c];
      }
    }
  };
  copy(&Frame::transmittance);
  copy(&Frame::background);
  const auto copy_light = [&](std::vector<float> Frame::*airlights,
                              std::vector<float> Frame::*beauties) {
    for (std::size_t i = 0; i < (group_frame.*airlights).size() / 3; ++i) {
      for (const std::size_t c : group.channels) {
        const float airlight = (group_frame.*airlights)[3 * i + c];
        const float behind = std::max((group_frame.*beauties)[4 * i + c] - airlight, 0.0f);
        (frame.*airlights)[3 * i + c] = albedo * airlight;
        (frame.*beauties)[4 * i + c] = albedo * airlight + behind;
      }
    }
  };
  copy_light(&Frame::airlight, &Frame::beauty);
  copy_light(&Frame::airlight_at_centers, &Frame::beauty_at_centers);
}

namespace {

// Adds the share of the channels of a group to the alpha of pixels.
void add_alpha(const AlbedoGroup& group, const Frame& group_frame, std::vector<float>& alpha) {
  const float share = static_cast<float>(group.channels.size()) / 3.0f;
  alpha.resize(group_frame.beauty.size() / 4, 0.0f);
  for (std::size_t i = 0; i < alpha.size(); ++i) alpha[i] += share * group_frame.beauty[4 * i + 3];
}

}  // namespace

std::optional<Frame> render_groups(const Scene& scene, std::span<const AlbedoGroup> groups,
                                   ExtinctionMedia& media, const Job& job,
                                   const RenderGroup& render) {
  if (groups.size() == 1 && groups[0].albedo == 1.0 && !scene.medium.has_albedos()) {
    return render(scene, 0, groups[0], job);
  }
  std::optional<Frame> frame;
  std::vector<float> alpha;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Scene absorbing = scene;
    absorbing.medium = media.update(i, scene, groups[i]);
    const auto progress_at = [&](std::size_t n) {
      return static_cast<double>(n) / static_cast<double>(groups.size());
    };
    std::optional<Frame> group_frame =
        render(absorbing, i, groups[i], job.subrange(progress_at(i), progress_at(i + 1)));
    if (!group_frame) return std::nullopt;
    if (auto& noise = group_frame->statistics.path_noise) {
      noise->airlight_variance *= groups[i].albedo * groups[i].albedo;
    }
    add_alpha(groups[i], *group_frame, alpha);
    if (!frame) {
      frame = *group_frame;
    } else {
      add_cost(group_frame->statistics, frame->statistics);
    }
    copy_channels(groups[i], *group_frame, *frame);
  }
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    frame->beauty[4 * i + 3] = std::min(alpha[i], 1.0f);
  }
  return frame;
}

void add_cost(const FrameStatistics& group_frame, FrameStatistics& sum) {
  sum.frame_milliseconds += group_frame.frame_milliseconds;
  sum.light_pairs += group_frame.light_pairs;
  sum.view_pairs += group_frame.view_pairs;
  sum.exact_pixels = std::max(sum.exact_pixels, group_frame.exact_pixels);
  sum.sampled_pixels = std::max(sum.sampled_pixels, group_frame.sampled_pixels);
  if (group_frame.scattering && sum.scattering) {
    sum.scattering->sweeps += group_frame.scattering->sweeps;
    sum.scattering->residual = std::max(sum.scattering->residual, group_frame.scattering->residual);
  }
  for (std::size_t i = 0; i < group_frame.pixel_pairs.size(); ++i) {
    sum.pixel_pairs[i] += group_frame.pixel_pairs[i];
  }
  if (sum.path_noise && group_frame.path_noise) {
    sum.path_noise->airlight_variance += group_frame.path_noise->airlight_variance;
    sum.path_noise->surface_variance += group_frame.path_noise->surface_variance;
  }
  for (const StageTime& stage : group_frame.stages) {
    add_time(sum.stages, stage.stage, stage.milliseconds);
  }
}

}  // namespace brume
