#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "brume/camera.h"
#include "brume/gaussian.h"

namespace brume {

// A spot's direction at a time [s].
struct SampleKey {
  double time;
  glm::dvec3 direction;
};

struct SampleLight {
  glm::dvec3 position;
  glm::dvec3 intensity;
  // A spot if its outer angle is above 0 [degrees]. It has keyframes, or shines along the first.
  double inner_angle = 0.0;
  double outer_angle = 0.0;
  std::vector<SampleKey> directions = {};
  // Its intensity is an irradiance, it shines along the first direction, and has no position.
  bool is_directional = false;
  // A two-sided rectangle if they are above 0 [u]: its intensity is a radiance, the first direction
  // its normal.
  double width = 0.0;
  double height = 0.0;
  std::string profile = {};  // of a point light or a spot, relative to the scene file; "" for none
  double profile_rotation = 0.0;
};

// Angles in degrees.
SampleLight spot(const glm::dvec3& position, const glm::dvec3& direction,
                 const glm::dvec3& intensity, double inner, double outer);

struct SampleSurface {
  std::string mesh;  // relative to the scene file
  glm::dvec3 translate{0.0};
  double scale = 1.0;
  glm::dvec3 reflectance{0.5};
  double specular = 0.0;  // above 0: phong
  double exponent = 1.0;
  std::string transfer = {};  // "" for none
};

// The content of a sample scene: a small part of what a scene file can hold.
struct SampleScene {
  Camera camera;
  double homogeneous_density = 0.0;
  double albedo = 1.0;
  double anisotropy = 0.0;
  std::vector<Gaussian> gaussians;
  std::string medium_file;  // relative to the scene file; "" for none
  std::vector<SampleLight> lights;
  std::string environment;  // relative to the scene file; "" for none
  double environment_intensity = 1.0;
  std::vector<SampleSurface> surfaces;
};

// Writes a scene file, version 1, with numbers rounded to four decimals: the last digits of a
// computation, in which machines may differ, never reach the file.
void write_sample_scene(const std::filesystem::path& file, const SampleScene& scene);

// The same rounding, for what other files hold.
double rounded(double value);

}  // namespace brume
