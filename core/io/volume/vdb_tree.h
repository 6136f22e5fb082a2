#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>

#include "core/io/byte_reader.h"

namespace brume {

// The trees of OpenVDB files, as version 222 and later of the format store them: a root that knows
// nodes of 32^3 nodes of 16^3 leaves of 8^3 voxels. A tree is stored as its topology, then the
// values of its leaves. They are read here, not by the library, because the library trusts its
// files: damaged ones make it loop for minutes or write where it must not.

// How values are stored.
struct VdbValues {
  // A mask has no values but whether voxels are active: these are 1.
  enum class Number { boolean, mask, int32, int64, float16, float32, float64 };
  Number number = Number::float32;
  std::size_t components = 1;  // 1 or 3
  bool half = false;           // floating-point numbers in nodes are stored in half precision
  std::uint32_t compression = 0;

  // The type that a tree's values have in OpenVDB ("float", "vec3s"); nothing for those that are
  // no numbers.
  static std::optional<VdbValues> of_type(const std::string& type);
};

// A region of one value.
struct VdbTile {
  glm::ivec3 corner;
  int side;  // [voxels]
  glm::dvec3 value;
};

struct VdbLeaf {
  static constexpr std::size_t size = 512;
  glm::ivec3 corner;
  std::array<std::uint64_t, size / 64> mask;  // of the active voxels, z fastest

  [[nodiscard]] bool is_active(std::size_t voxel) const {
    return (mask[voxel / 64] >> voxel % 64 & 1) != 0;
  }
  [[nodiscard]] std::size_t active() const;
};

// Visits active values, in the order of the file.
struct VdbVisitor {
  std::function<void(const VdbTile&)> tile;
  std::function<void(const VdbLeaf&)> leaf;
};

// Reads a topology. Coordinates stay within 2^28 and no place comes twice. Throws InputError.
void read_vdb_topology(ByteReader& reader, const VdbValues& values, const VdbVisitor& visitor);

// Reads what follows a topology: calls visit(leaf, its active voxels' values, `components` numbers
// each) for all of its leaves. Throws InputError.
void read_vdb_leaves(
    ByteReader& reader, const VdbValues& values, std::span<const VdbLeaf> leaves,
    const std::function<void(const VdbLeaf&, std::span<const double> values)>& visit);

}  // namespace brume
