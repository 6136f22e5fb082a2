#pragma once

#include <array>
#include <string>
#include <vector>

#include "brume/scene.h"

namespace brume {

// A ray of tests/golden/multiple_scattering.json: radiances along it by orders of scattering, by an
// independent path tracer.
struct GoldenRay {
  std::string name;
  Scene scene;  // whose only pixel is the ray; densities are extinction
  double albedo = 1.0;
  std::array<double, 3> orders{};        // 1, 2, 3 and up
  std::array<double, 3> order_errors{};  // standard errors
  double radiance = 0.0;                 // of all orders
  double standard_error = 0.0;

  // The scene as files have it: densities are scattering coefficients.
  [[nodiscard]] Scene scattering_scene() const;
};

std::vector<GoldenRay> golden_rays();

}  // namespace brume
