#include "core/io/volume/volume_optics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include "brume/error.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/volume/vdb_blocks.h"
#include "core/number_domain.h"

namespace brume {
namespace {

constexpr std::array<const char*, 3> channel_suffixes{"_r", "_g", "_b"};

// How programs name the grids of a role, in order of preference: Brume, Blender, Houdini, EmberGen,
// FumeFX. What Blender calls `emission`, a single number, is where its simulation adds smoke.
struct OpticsRoleGrids {
  std::vector<std::string_view> names;
  std::size_t components;
};
OpticsRoleGrids grids_of(OpticsRole role) {
  switch (role) {
    case OpticsRole::color:
      return {{"albedo", "color", "Cd"}, 3};
    case OpticsRole::emission:
      return {{"emission"}, 3};
    case OpticsRole::temperature:
      return {{"temperature", "temp"}, 1};
    case OpticsRole::flame:
      return {{"flame", "flames", "fire", "burn", "heat"}, 1};
  }
  return {};
}

std::size_t components_of(const VolumeGridInfo& grid) {
  const auto values = VdbValues::of_type(grid.type);
  return values ? values->components : 0;
}

bool has_numbers(const std::vector<VolumeGridInfo>& grids, const std::string& name) {
  return std::ranges::any_of(grids, [&](const VolumeGridInfo& grid) {
    return grid.name == name && components_of(grid) == 1;
  });
}

class OpticsReader {
 public:
  OpticsReader(const std::filesystem::path& path, std::size_t max_blocks)
      : path_(path),
        max_blocks_(max_blocks),
        bytes_(read_bytes(path)),
        grids_(read_vdb_grids(path, bytes_)) {
    for (const VdbGrid& grid : grids_) infos_.push_back({.name = grid.name, .type = grid.type});
  }

  // The grid to take; no_grid if none.
  [[nodiscard]] std::string chosen(OpticsRole role, const std::string& name) const {
    return name == auto_grid ? default_grid(role, possible_grids(role, infos_)) : name;
  }

  [[nodiscard]] bool has(const std::string& name) const {
    return std::ranges::any_of(grids_, [&](const VdbGrid& grid) { return grid.name == name; });
  }

  // Whether a colour is three grids.
  [[nodiscard]] bool is_split(const std::string& name) const {
    return !has(name) && std::ranges::all_of(channel_suffixes, [&](const char* suffix) {
      return has_numbers(infos_, name + suffix);
    });
  }

  // Values times `scale`; none of them counts if all are below `min_value`.
  std::optional<FieldGrid> field(const std::string& name, std::size_t components, double scale,
                                 const NumberDomain& domain, double min_value) {
    const std::vector<VdbGrid> grids = grids_named(path_, grids_, name);
    require_fog(path_, grids, components);
    FieldGrid field = covered(grids);
    for (std::size_t k = 0; k < components; ++k) add(field, grids, k, scale, domain);
    return with_values_from(min_value, std::move(field));
  }

  std::optional<FieldGrid> split_color(const std::string& name, const NumberDomain& domain,
                                       double min_value) {
    FieldGrid field = covered(grids_named(path_, grids_, name + channel_suffixes[0]));
    for (const char* suffix : channel_suffixes) {
      const std::vector<VdbGrid> grids = grids_named(path_, grids_, name + suffix);
      require_fog(path_, grids, 1);
      add(field, grids, 0, 1.0, domain);
    }
    return with_values_from(min_value, std::move(field));
  }

  DensityGrid density(const std::string& name) {
    return at_most(read_vdb_density(path_, bytes_, grids_named(path_, grids_, name)), max_blocks_);
  }

 private:
  // A field without components yet. Where several grids have a value, it is their mean.
  FieldGrid covered(std::span<const VdbGrid> grids) {
    FieldGrid field;
    field.coverage =
        at_most(read_vdb_blocks(path_, bytes_, grids, 0, [](double) { return 1.0f; }), max_blocks_);
    return field;
  }

  // Downsampled as the field's coverage is, which has at least as many blocks.
  void add(FieldGrid& field, std::span<const VdbGrid> grids, std::size_t component, double scale,
           const NumberDomain& domain) {
    const auto to_value = [&](double value) {
      const double scaled = std::max(scale * value, 0.0);
      if (!std::isfinite(value) || !domain.contains(scaled)) {
        throw InputError(path_, grids.front().name, domain.refusal(scale * value));
      }
      return static_cast<float>(scaled);
    };
    DensityGrid blocks = read_vdb_blocks(path_, bytes_, grids, component, to_value);
    const double spacing = std::abs(field.coverage.spacing.x);
    while (std::abs(blocks.spacing.x) < 0.75 * spacing) blocks = coarser(blocks);
    field.components.push_back(std::move(blocks));
  }

  static std::optional<FieldGrid> with_values_from(double min_value, FieldGrid field) {
    const bool has_values = std::ranges::any_of(field.components, [&](const DensityGrid& grid) {
      return std::ranges::any_of(grid.blocks, [&](const DensityGrid::Block& block) {
        return static_cast<double>(std::ranges::max(block.values)) >= min_value;
      });
    });
    return has_values ? std::optional(std::move(field)) : std::nullopt;
  }

  const std::filesystem::path& path_;
  std::size_t max_blocks_;
  std::string bytes_;
  std::vector<VdbGrid> grids_;
  std::vector<VolumeGridInfo> infos_;
};

constexpr NumberDomain color_domain{0.0, 1e6, "a number >= 0 (up to 1e6)"};
constexpr NumberDomain kelvin_domain{0.0, domain::temperature.max_value,
                                     "a temperature up to 40000 K"};

}  // namespace

std::vector<std::string> possible_grids(OpticsRole role, const std::vector<VolumeGridInfo>& grids) {
  std::vector<std::string> possible;
  const std::size_t components = grids_of(role).components;
  const auto add = [&](const std::string& name) {  // once
    if (std::ranges::find(possible, name) == possible.end()) possible.push_back(name);
  };
  for (const VolumeGridInfo& grid : grids) {
    if (components_of(grid) == components) add(grid.name);
    if (role != OpticsRole::color || !grid.name.ends_with(channel_suffixes[0])) continue;
    const std::string name = grid.name.substr(0, grid.name.size() - 2);
    if (std::ranges::all_of(channel_suffixes, [&](const char* suffix) {
          return has_numbers(grids, name + suffix);
        })) {
      add(name);
    }
  }
  return possible;
}

std::string default_grid(OpticsRole role, const std::vector<std::string>& possible) {
  for (const std::string_view name : grids_of(role).names) {
    if (std::ranges::find(possible, name) != possible.end()) return std::string(name);
  }
  return no_grid;
}

VolumeOptics read_volume_optics(const std::filesystem::path& path, const VolumeOpticsNames& names,
                                double temperature_scale, std::size_t max_blocks) {
  OpticsReader reader(path, max_blocks);
  constexpr double more_than_0 = std::numeric_limits<float>::denorm_min();
  VolumeOptics optics;
  if (const auto name = reader.chosen(OpticsRole::color, names.color); name != no_grid) {
    optics.is_color_of_density = reader.is_split(name);
    optics.color = optics.is_color_of_density
                       ? reader.split_color(name, color_domain, more_than_0)
                       : reader.field(name, 3, 1.0, color_domain, more_than_0);
  }
  if (const auto name = reader.chosen(OpticsRole::emission, names.emission); name != no_grid) {
    optics.emission = reader.field(name, 3, 1.0, domain::intensity, more_than_0);
  }
  if (const auto name = reader.chosen(OpticsRole::temperature, names.temperature);
      name != no_grid) {
    optics.temperature =
        reader.field(name, 1, temperature_scale, kelvin_domain, domain::temperature.min_value);
  }
  if (const auto name = reader.chosen(OpticsRole::flame, names.flame); name != no_grid) {
    optics.flame = reader.density(name);
  }
  return optics;
}

std::optional<glm::dvec3> FieldGrid::at(const glm::dvec3& world) const {
  const glm::dvec3 voxel = coverage.to_voxel(world);
  const double weight = coverage.at(voxel);
  if (!(weight > 1e-6)) return std::nullopt;
  glm::dvec3 value(0.0);
  for (std::size_t k = 0; k < components.size(); ++k) {
    value[static_cast<int>(k)] = components[k].at(voxel) / weight;
  }
  return value;
}

void rotate(FieldGrid& field, const glm::dquat& turn) {
  for (DensityGrid& component : field.components) rotate(component, turn);
  rotate(field.coverage, turn);
}

}  // namespace brume
