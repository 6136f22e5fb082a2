#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "brume/gaussian.h"

namespace brume {

// All of these throw InputError if the file cannot be written.
void write_bytes(const std::filesystem::path& file, const std::string& bytes);

// Gaussians as binary PLY points in single precision.
void write_gaussian_ply(const std::filesystem::path& file, const std::vector<Gaussian>& gaussians);

// Triangles of up to 65,536 vertices as binary PLY in single precision, indices in 16 bits.
void write_mesh_ply(const std::filesystem::path& file, const std::vector<glm::dvec3>& vertices,
                    const std::vector<std::array<std::uint16_t, 3>>& triangles);

// The square [-1, 1] x [-1, 1] at y = 0, facing up, as OBJ.
void write_plane(const std::filesystem::path& file);

// The box [-1, 1] x [0, 1] x [-1, 1] without its top and its front (z = 1), facing inwards, each
// side with its own corners so that its edges stay sharp, as OFF.
void write_open_box(const std::filesystem::path& file);

}  // namespace brume
