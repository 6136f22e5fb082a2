#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "brume/surface.h"

namespace brume {

struct PointLight;

// Whether a surface emits light: with the same radiance in all directions of both sides. Point
// lights stand only for the outer side of those that are closed.
bool is_emissive(const Surface& surface);
bool emits(const Material& material);

struct EmittingTriangle {
  std::array<glm::dvec3, 3> corners;  // [u]
  glm::dvec3 radiance{0.0};           // RGB, its mean over the triangle [W/(sr u^2)]
  std::uint32_t surface = 0;          // index in the scene
  std::uint32_t index = 0;            // in the surface's mesh
  std::uint32_t copy = 0;             // 0: of its own placement; see Surface::placed_copies
};

// The normal of a triangle's front times its area [u^2].
glm::dvec3 area_vector(const std::array<glm::dvec3, 3>& triangle);

// How many surfaces emit; each copy is one.
std::size_t emitter_count(std::span<const Surface> surfaces);

// All triangles of surfaces that emit and of their copies, in their order: surface by surface, copy
// by copy.
std::vector<EmittingTriangle> emitting_triangles(std::span<const Surface> surfaces);

// At most `max_count` point lights that send as much as the surfaces do: each stands for
// neighbouring pieces that face about the same way, most of them where the brightest and largest
// pieces are. Fewer where fewer pieces emit.
std::vector<PointLight> emitting_points(std::span<const Surface> surfaces, int max_count);

}  // namespace brume
