#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/scene/camera_rays.h"
#include "render/scattering/lobe/view_depths.h"
#include "render/scattering/source_grid.h"
#include "render/util/job.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Surfaces and the light that they send.
struct SentLight {
  const RayCaster& ray_caster;
  std::span<const Surface> surfaces;
  // Radiance per level of the grid, as reflected_light(): of one channel times `color`, or three.
  std::span<const std::vector<float>> reflected;
  std::size_t channels;
  glm::vec3 color;
};

// Parts of surfaces that send light, relative to the eye that sees them; for kernels filled up to
// whole vectors by black ones.
struct SeenSurfels {
  std::vector<float> x, y, z, normal_x, normal_y, normal_z;
  std::vector<float> area;     // [u^2]
  std::vector<float> passing;  // share of light that the medium lets through to the eye
  std::array<std::vector<float>, 3> radiance;

  [[nodiscard]] std::size_t size() const { return x.size(); }
};

// Returns those seen from `start` before the eye. Each is narrow beside its distance from there,
// also where a surface is seen at a grazing angle, and narrower still where the camera looks. In
// parallel.
SeenSurfels seen_surfels(const SourceGrid& grid, const SentLight& sent, const CameraRays& rays,
                         double start, const ViewDepths& depths, const Job& job);

}  // namespace brume
