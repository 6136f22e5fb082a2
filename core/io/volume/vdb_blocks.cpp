#include "core/io/volume/vdb_blocks.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <tuple>

#include "brume/error.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"

namespace brume {
namespace {

using Path = std::filesystem::path;

// The transform as spacing, rotation and origin.
void set_transform(const Path& path, const VdbGrid::Transform& transform, DensityGrid& grid) {
  grid.origin = transform.origin;
  glm::dmat3 axes = transform.axes;
  for (int k = 0; k < 3; ++k) {
    grid.spacing[k] = glm::length(axes[k]);
    const bool fits =
        std::isfinite(grid.origin[k]) && std::abs(grid.origin[k]) <= limits::coordinate &&
        grid.spacing[k] >= limits::min_length && grid.spacing[k] <= limits::max_length;
    if (!fits) throw InputError(path, "transform", "its voxels have no valid size or position");
    axes[k] /= grid.spacing[k];
  }
  const double shear =
      std::max({std::abs(glm::dot(axes[0], axes[1])), std::abs(glm::dot(axes[1], axes[2])),
                std::abs(glm::dot(axes[2], axes[0]))});
  if (shear > 1e-5) {
    throw InputError(path, "transform", "found shear; allowed: translation, rotation, scale");
  }
  if (glm::determinant(axes) < 0.0) {
    axes[0] = -axes[0];
    grid.spacing.x = -grid.spacing.x;
  }
  grid.rotation = glm::normalize(glm::quat_cast(axes));
}

class BlockReader {
 public:
  // `count`: how many blocks there are of other grids.
  BlockReader(const Path& path, std::string_view bytes, const VdbGrid& grid, std::size_t component,
              const std::function<float(double)>& to_value, std::size_t count)
      : path_(path),
        name_(grid.name),
        values_(*grid.values),
        component_(component),
        to_value_(to_value),
        reader_(vdb_tree(path, bytes, grid)),
        others_(static_cast<double>(count)) {}

  std::vector<DensityGrid::Block> read() {
    read_vdb_topology(reader_, values_,
                      {[&](const VdbTile& tile) { count(tile); },
                       [&](const VdbLeaf& leaf) {
                         count(1);
                         leaves_.push_back(leaf);
                       }});
    // Once, not by doubling.
    blocks_.reserve(static_cast<std::size_t>(count_));
    for (const VdbTile& tile : tiles_) add(tile);
    read_vdb_leaves(
        reader_, values_, leaves_,
        [&](const VdbLeaf& leaf, std::span<const double> values) { add(leaf, values); });
    return std::move(blocks_);
  }

 private:
  // Before they take any memory.
  void count(double blocks) {
    count_ += blocks;
    if (others_ + count_ > static_cast<double>(limits::volume_blocks)) {
      throw InputError(path_, name_,
                       "has more active voxels than the allowed " +
                           std::to_string(limits::volume_blocks) + " blocks of 8 x 8 x 8");
    }
  }

  float value_of(const VdbTile& tile) const {
    return to_value_(tile.value[static_cast<int>(component_)]);
  }

  void count(const VdbTile& tile) {
    if (value_of(tile) == 0.0f) return;
    count(std::pow(tile.side / DensityGrid::side, 3.0));
    tiles_.push_back(tile);
  }

  // A tile becomes voxels.
  void add(const VdbTile& tile) {
    const float value = value_of(tile);
    const int across = tile.side / DensityGrid::side;
    for (int i = 0; i < across * across * across; ++i) {
      const glm::ivec3 place(i / (across * across), i / across % across, i % across);
      blocks_.push_back({tile.corner + DensityGrid::side * place, {}});
      blocks_.back().values.fill(value);
    }
  }

  void add(const VdbLeaf& leaf, std::span<const double> values) {
    DensityGrid::Block block{leaf.corner, {}};
    bool is_empty = true;
    std::size_t next = component_;
    for (std::size_t i = 0; i < VdbLeaf::size; ++i) {
      if (!leaf.is_active(i)) continue;
      block.values[i] = to_value_(values[next]);
      next += values_.components;
      is_empty = is_empty && block.values[i] == 0.0f;
    }
    if (!is_empty) blocks_.push_back(block);
  }

  const Path& path_;
  const std::string& name_;
  const VdbValues& values_;
  std::size_t component_;
  const std::function<float(double)>& to_value_;
  ByteReader reader_;
  double others_;
  double count_ = 0.0;
  std::vector<VdbTile> tiles_;
  std::vector<VdbLeaf> leaves_;
  std::vector<DensityGrid::Block> blocks_;
};

// A grid without blocks.
DensityGrid empty_grid(const Path& path, const VdbGrid& grid) {
  if (!grid.transform) {
    throw InputError(path, "transform",
                     "found a perspective transform; allowed: translation, rotation, scale");
  }
  DensityGrid result;
  set_transform(path, *grid.transform, result);
  return result;
}

// Where the voxels of `other` lie among those of `grid`. Throws InputError if they lie between
// them.
glm::ivec3 shift_between(const Path& path, const std::string& name, const DensityGrid& grid,
                         const DensityGrid& other) {
  constexpr double max_error = 0.05;  // [voxels], as far away as voxels are in a large volume
  constexpr double far = 1000.0;
  constexpr double max_shift = 1 << 28;
  const glm::dvec3 shift = glm::round(grid.to_voxel(other.origin));
  for (int k = -1; k < 3; ++k) {
    glm::dvec3 voxel(0.0);
    if (k >= 0) voxel[k] = far;
    const double error = glm::length(grid.to_voxel(other.to_world(voxel)) - voxel - shift);
    if (error < max_error && glm::length(shift) < max_shift) continue;
    throw InputError(path, name,
                     "found several grids of this name whose voxels do not coincide; allowed: "
                     "grids of one voxel size and rotation, whole voxels apart");
  }
  return glm::ivec3(shift);
}

// Adds blocks to those of a grid.
class BlockSum {
 public:
  explicit BlockSum(std::vector<DensityGrid::Block> blocks) : blocks_(std::move(blocks)) {
    for (std::size_t i = 0; i < blocks_.size(); ++i) places_[key(blocks_[i].corner)] = i;
  }

  void add(const DensityGrid::Block& block, const glm::ivec3& shift) {
    for (std::size_t i = 0; i < DensityGrid::block_size; ++i) {
      if (block.values[i] == 0.0f) continue;
      const auto n = static_cast<int>(i);
      const glm::ivec3 voxel = block.corner + shift + glm::ivec3(n / 64, n / 8 % 8, n % 8);
      const glm::ivec3 corner = block_corner(voxel);
      const glm::ivec3 p = voxel - corner;
      values_at(corner)[static_cast<std::size_t>(p.x * 64 + p.y * 8 + p.z)] += block.values[i];
    }
  }

  [[nodiscard]] std::size_t size() const { return blocks_.size(); }
  std::vector<DensityGrid::Block> take() { return std::move(blocks_); }

 private:
  using Key = std::tuple<int, int, int>;
  static Key key(const glm::ivec3& corner) { return {corner.x, corner.y, corner.z}; }

  DensityGrid::Values& values_at(const glm::ivec3& corner) {
    const auto [place, is_new] = places_.try_emplace(key(corner), blocks_.size());
    if (is_new) blocks_.push_back({corner, {}});
    return blocks_[place->second].values;
  }

  std::vector<DensityGrid::Block> blocks_;
  std::map<Key, std::size_t> places_;
};

// The density of a volume, 0 or more.
float to_density(const Path& path, const std::string& name, double value) {
  if (!std::isfinite(value) || value > limits::density) {
    throw InputError(path, name,
                     "found a density of " + quoted_text(value) + "; allowed: 0 to " +
                         quoted_text(limits::density));
  }
  return static_cast<float>(std::max(value, 0.0));
}

}  // namespace

ByteReader vdb_tree(const Path& path, std::string_view bytes, const VdbGrid& grid) {
  ByteReader reader(path, bytes.substr(0, static_cast<std::size_t>(grid.end)));
  reader.seek(grid.tree);
  return reader;
}

DensityGrid read_vdb_blocks(const Path& path, std::string_view bytes,
                            std::span<const VdbGrid> grids, std::size_t component,
                            const std::function<float(double)>& to_value) {
  const auto blocks_of = [&](const VdbGrid& grid, std::size_t others) {
    return BlockReader(path, bytes, grid, component, to_value, others).read();
  };
  DensityGrid result = empty_grid(path, grids.front());
  result.blocks = blocks_of(grids.front(), 0);
  if (grids.size() > 1) {
    BlockSum sum(std::move(result.blocks));
    for (const VdbGrid& grid : grids.subspan(1)) {
      const glm::ivec3 shift = shift_between(path, grid.name, result, empty_grid(path, grid));
      for (const DensityGrid::Block& block : blocks_of(grid, sum.size())) sum.add(block, shift);
    }
    result.blocks = sum.take();
  }
  result.sort();
  return result;
}

DensityGrid read_vdb_density(const Path& path, std::string_view bytes,
                             std::span<const VdbGrid> grids) {
  require_fog(path, grids, 1);
  return read_vdb_blocks(path, bytes, grids, 0,
                         [&](double value) { return to_density(path, grids.front().name, value); });
}

void require_fog(const Path& path, std::span<const VdbGrid> grids, std::size_t components) {
  for (const VdbGrid& grid : grids) {
    if (grid.kind == "level set") {
      throw InputError(path, grid.name, "found a level set; allowed: a fog volume");
    }
    if (grid.transform && (!grid.values || grid.values->components != components)) {
      throw InputError(path, grid.name,
                       "found values of type " + quoted_text(grid.type) + "; allowed: " +
                           (components == 1 ? "one number each" : "three numbers each"));
    }
  }
}

}  // namespace brume
