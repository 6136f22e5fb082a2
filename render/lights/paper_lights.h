#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/scene/camera_rays.h"
#include "render/geometry/medium_index.h"

namespace brume {

struct PaperLight {
  glm::dvec3 position{0.0};
  glm::dvec3 intensity{0.0};     // RGB [W/sr]
  double h_min = 0.0;            // see light_limits.h [u]
  double depth_to_eye = 0.0;     // T(s, v) of the Gaussians, without b0
  std::vector<double> frozen;    // per Gaussian: Tbar_i(s, b_i) + Tbar_i(v, b_i), b0 included
  bool conserve_energy = false;  // see PaperOptions
};

// All lights of a frame, and the optical depths from the eye to every Gaussian.
struct PaperLights {
  std::vector<PaperLight> lights;
  std::vector<double> from_eye;  // per Gaussian: Tbar_i(v, b_i) without b0
  bool at_mean = false;          // see PaperOptions
};

// Whether a point lies near a Gaussian so dense that in-scattering varies strongly within it: one
// sample per Gaussian is then inaccurate, and energy scaling makes it worse.
bool is_in_dense_gaussian(const MediumIndex& medium, const glm::dvec3& point);
// The same of where any view ray starts; of parallel ones, of the plane in which they do.
bool starts_in_dense_gaussian(const MediumIndex& medium, const CameraRays& rays);

}  // namespace brume
