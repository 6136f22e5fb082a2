#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "brume/gaussian.h"
#include "brume/splat.h"
#include "core/medium/splat.h"

namespace brume {

// How Gaussians become the splats of a file. Their depth is that of the density, whatever the
// albedo; what they emit is left out.
struct SplatOutput {
  OpacityAlong along = OpacityAlong::mean;
  glm::dvec3 albedo{1.0};  // of Gaussians without one of their own
  // The color that each Gaussian shows in place of its albedo; empty: that.
  std::span<const SplatColor> colors{};
  // A PLY is turned by half about z, so that y points down, as captures have it and most viewers
  // of PLY expect.
  bool y_down = false;
  // The ids of Gaussians in a PLY; empty: none. Programs of splatting skip a property that they do
  // not know; an attribute of glTF has too few bits for ids.
  std::span<const GaussianNumber> ids{};
};

// The albedo as the color of a splat: sh_of_albedo().
glm::dvec3 sh_color(const Gaussian& gaussian, const SplatOutput& output);

// The opacity of an optical depth >= 0, in [0, 1].
double opacity_of_depth(double depth);

// The color of a splat that is the same from every side, as RGB coefficients of the spherical
// harmonic of degree 0: color = 0.5 + 0.2821 coefficient, sRGB-encoded as viewers of splats expect.
// `albedo` in [0, 1].
glm::dvec3 sh_of_albedo(const glm::dvec3& albedo);

// The inverse for finite coefficients; what is darker or brighter becomes the least or greatest
// albedo, domain::albedo. `is_linear`: the color is not encoded.
glm::dvec3 albedo_of_sh(const glm::dvec3& coefficient, bool is_linear = false);

}  // namespace brume
