#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "brume/density_grid.h"
#include "core/io/volume/volume_file.h"

namespace brume {

// The optics in the grids of an OpenVDB file, besides the density: its colour, and how it
// shines.
enum class OpticsRole { color, emission, temperature, flame };

// In place of a grid's name: the first that is there under a name that programs use, or no grid.
inline constexpr const char* auto_grid = "auto";
inline constexpr const char* no_grid = "none";

// Names of grids: auto_grid, no_grid, or a name in the file.
struct VolumeOpticsNames {
  std::string color = auto_grid;
  std::string emission = auto_grid;
  std::string temperature = auto_grid;
  std::string flame = auto_grid;
};

// The grids of a file that can have a role, by their types: a colour has three components, or is
// three grids NAME_r, NAME_g and NAME_b; an emission has three, a temperature and a flame one.
std::vector<std::string> possible_grids(OpticsRole role, const std::vector<VolumeGridInfo>& grids);
// Which of these auto_grid takes; no_grid if none.
std::string default_grid(OpticsRole role, const std::vector<std::string>& possible);

// A sampled quantity of one or three components that has values in some places only, where it is
// trilinear: a colour, a temperature.
struct FieldGrid {
  std::vector<DensityGrid> components;  // 1 or 3, of the same transform
  DensityGrid coverage;                 // how many values a voxel has

  // The value at a point of the world, a single component in x; nullopt where it has none.
  [[nodiscard]] std::optional<glm::dvec3> at(const glm::dvec3& world) const;
};

// Rotates a field about the world origin; its values stay.
void rotate(FieldGrid& field, const glm::dquat& turn);

struct VolumeOptics {
  std::optional<FieldGrid> color;        // RGB >= 0
  bool is_color_of_density = false;      // the colour is multiplied by the density (NAME_r, ...)
  std::optional<FieldGrid> emission;     // RGB, [W/(sr u^2)] per unit of extinction optical depth
  std::optional<FieldGrid> temperature;  // [K], somewhere from 800 K, where matter glows
  std::optional<DensityGrid> flame;      // >= 0, maybe nowhere more
};

// Reads these grids, each downsampled by two until it has at most `max_blocks`; fields without
// a value that is not zero are none, nor are temperatures at which nothing glows. A temperature of
// 1 in the file is `temperature_scale` K. Negative numbers become 0. Throws InputError: not such a
// grid, damaged, numbers that are not finite or beyond their domain.
VolumeOptics read_volume_optics(const std::filesystem::path& file, const VolumeOpticsNames& names,
                                double temperature_scale, std::size_t max_blocks);

}  // namespace brume
