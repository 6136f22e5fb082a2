#include "core/io/volume/vdb_tree.h"

#include <Imath/half.h>
#include <blosc.h>
#include <zlib.h>

#include <bit>
#include <set>
#include <string_view>
#include <tuple>

namespace brume {
namespace {

using Number = VdbValues::Number;

enum Compression : std::uint32_t { zip = 1, active_mask = 2, blosc = 4 };

constexpr int leaf_side = 8;
constexpr int lower_side = 16 * leaf_side;   // of a node of leaves [voxels]
constexpr int upper_side = 32 * lower_side;  // of a node of those
constexpr int farthest = 1 << 28;

bool is_real(Number number) {
  return number == Number::float32 || number == Number::float64;
}

std::size_t size_of(Number number) {
  switch (number) {
    case Number::boolean:
    case Number::mask:
      return 1;
    case Number::float16:
      return 2;
    case Number::int32:
    case Number::float32:
      return 4;
    case Number::int64:
    case Number::float64:
      return 8;
  }
  return 0;
}

// A value outside of nodes: never in half precision.
std::size_t whole_size(const VdbValues& values) {
  return values.components * size_of(values.number);
}

template <class Stored>
void append_as(std::string_view bytes, std::vector<double>& numbers) {
  for (std::size_t i = 0; i + sizeof(Stored) <= bytes.size(); i += sizeof(Stored)) {
    Stored value;
    std::memcpy(&value, bytes.data() + i, sizeof(Stored));
    numbers.push_back(static_cast<double>(value));
  }
}

void append(std::string_view bytes, Number number, std::vector<double>& numbers) {
  switch (number) {
    case Number::boolean:
    case Number::mask:
      return append_as<std::uint8_t>(bytes, numbers);
    case Number::float16:
      for (std::size_t i = 0; i + 2 <= bytes.size(); i += 2) {
        std::uint16_t bits;
        std::memcpy(&bits, bytes.data() + i, 2);
        numbers.push_back(static_cast<double>(imath_half_to_float(bits)));
      }
      return;
    case Number::int32:
      return append_as<std::int32_t>(bytes, numbers);
    case Number::int64:
      return append_as<std::int64_t>(bytes, numbers);
    case Number::float32:
      return append_as<float>(bytes, numbers);
    case Number::float64:
      return append_as<double>(bytes, numbers);
  }
}

// The value as three components, of which a number has only the first.
glm::dvec3 value_at(std::span<const double> numbers, std::size_t index, std::size_t components) {
  const double* value = numbers.data() + index * components;
  return components == 3 ? glm::dvec3(value[0], value[1], value[2]) : glm::dvec3(*value, 0.0, 0.0);
}

// `bytes` bytes that may be compressed: into `room`, or as they are.
std::string_view data(ByteReader& reader, std::uint32_t compression, std::size_t bytes,
                      std::string& room) {
  if ((compression & (zip | blosc)) == 0) return reader.read_bytes(bytes);
  const auto size = reader.number<std::int64_t>();
  if (size <= 0) {
    if (size != -static_cast<std::int64_t>(bytes)) reader.fail("contains values of the wrong size");
    return reader.read_bytes(bytes);
  }
  const std::string_view packed = reader.read_bytes(static_cast<std::uint64_t>(size));
  room.resize(bytes);
  bool done = false;
  if ((compression & blosc) != 0) {
    std::size_t found = 0;
    done = blosc_cbuffer_validate(packed.data(), packed.size(), &found) == 0 && found == bytes &&
           blosc_decompress_ctx(packed.data(), room.data(), bytes, /*numinternalthreads=*/1) ==
               static_cast<int>(bytes);
  } else {
    uLongf found = bytes;
    done = uncompress(reinterpret_cast<Bytef*>(room.data()), &found,
                      reinterpret_cast<const Bytef*>(packed.data()), packed.size()) == Z_OK &&
           found == bytes;
  }
  if (!done) reader.fail("contains damaged compressed values");
  return room;
}

template <std::size_t size>
class Mask {
 public:
  explicit Mask(ByteReader& reader) : bytes_(reader.read_bytes(size / 8)) {}
  [[nodiscard]] bool has(std::size_t i) const {
    return (static_cast<unsigned char>(bytes_[i / 8]) >> i % 8 & 1) != 0;
  }
  [[nodiscard]] std::size_t count() const {
    std::size_t sum = 0;
    for (const char byte : bytes_) {
      sum += static_cast<std::size_t>(std::popcount(static_cast<unsigned char>(byte)));
    }
    return sum;
  }

 private:
  std::string_view bytes_;
};

class NodeReader {
 public:
  NodeReader(ByteReader& reader, const VdbValues& values) : reader_(reader), values_(values) {}

  // Reads the values of a node of `size` values, `active` of them active; `packed`: only active
  // ones are stored. Skips inactive values.
  struct Numbers {
    std::span<const double> numbers;
    bool packed;
  };
  Numbers read(std::size_t size, std::size_t active) {
    // Inactive values as stored: at most two, and a mask that selects between them.
    const auto inactive = reader_.number<std::int8_t>();
    if (inactive < 0 || inactive > 6) reader_.fail("contains an invalid tree node");
    const bool has_one = inactive == 2 || inactive == 4 || inactive == 5;
    if (has_one) reader_.read_bytes((inactive == 5 ? 2 : 1) * whole_size(values_));
    if (inactive >= 3 && inactive <= 5) reader_.read_bytes(size / 8);
    const bool packed = (values_.compression & active_mask) != 0 && inactive != 6;
    const std::size_t stored = packed ? active : size;
    const bool half = values_.half && is_real(values_.number);
    numbers_.clear();
    if (half && stored == 0) return {numbers_, packed};
    const Number number = half ? Number::float16 : values_.number;
    const std::string_view bytes =
        data(reader_, values_.compression, stored * values_.components * size_of(number), room_);
    if (active > 0) append(bytes, number, numbers_);
    return {numbers_, packed};
  }

 private:
  ByteReader& reader_;
  const VdbValues& values_;
  std::vector<double> numbers_;
  std::string room_;
};

class TopologyReader {
 public:
  TopologyReader(ByteReader& reader, const VdbValues& values, const VdbVisitor& visitor)
      : reader_(reader), values_(values), visitor_(visitor), nodes_(reader, values) {}

  void read() {
    reader_.number<std::int32_t>();           // how many buffers a leaf has: one
    reader_.read_bytes(whole_size(values_));  // the background
    const auto tiles = reader_.number<std::uint32_t>();
    const auto nodes = reader_.number<std::uint32_t>();
    constexpr std::uint32_t max_nodes = 1'000'000;  // of 4096^3 voxels each
    if (tiles > max_nodes || nodes > max_nodes) reader_.fail("contains a root with too many nodes");
    for (std::uint32_t i = 0; i < tiles; ++i) {
      const glm::ivec3 corner = root_corner();
      std::vector<double> number;
      append(reader_.read_bytes(whole_size(values_)), values_.number, number);
      if (reader_.number<std::uint8_t>() == 0) continue;
      visitor_.tile({corner, upper_side, value_at(number, 0, values_.components)});
    }
    for (std::uint32_t i = 0; i < nodes; ++i) {
      const glm::ivec3 corner = root_corner();
      node<32, lower_side>(corner, [&](const glm::ivec3& lower) {
        node<16, leaf_side>(lower, [&](const glm::ivec3& leaf) { read_leaf(leaf); });
      });
    }
  }

 private:
  glm::ivec3 root_corner() {
    const auto x = reader_.number<std::int32_t>();
    const auto y = reader_.number<std::int32_t>();
    const auto z = reader_.number<std::int32_t>();
    for (const std::int32_t k : {x, y, z}) {
      if (k % upper_side != 0) reader_.fail("contains an invalid tree root");
      if (k < -farthest || k > farthest) reader_.fail("has voxels too far from the origin");
    }
    if (!seen_.emplace(x, y, z).second) reader_.fail("contains the same position twice");
    return {x, y, z};
  }

  // A node of side^3 children of child_side^3 voxels: calls child(corner) for each.
  template <int side, int child_side, class Child>
  void node(const glm::ivec3& corner, Child child) {
    constexpr std::size_t size = std::size_t{side} * side * side;
    const auto place = [&](std::size_t i) {
      const auto n = static_cast<int>(i);
      return corner + child_side * glm::ivec3(n / (side * side), n / side % side, n % side);
    };
    const Mask<size> children(reader_);
    const Mask<size> active(reader_);
    const auto [numbers, packed] = nodes_.read(size, active.count());
    std::size_t stored = 0;
    for (std::size_t i = 0; i < size; ++i) {
      if (!active.has(i)) continue;
      if (children.has(i)) reader_.fail("contains an invalid tree node");
      const std::size_t index = packed ? stored++ : i;
      visitor_.tile({place(i), child_side, value_at(numbers, index, values_.components)});
    }
    for (std::size_t i = 0; i < size; ++i) {
      if (children.has(i)) child(place(i));
    }
  }

  void read_leaf(const glm::ivec3& corner) {
    VdbLeaf leaf{corner, {}};
    for (std::uint64_t& word : leaf.mask) word = reader_.number<std::uint64_t>();
    visitor_.leaf(leaf);
  }

  ByteReader& reader_;
  const VdbValues& values_;
  const VdbVisitor& visitor_;
  NodeReader nodes_;
  std::set<std::tuple<int, int, int>> seen_;
};

}  // namespace

std::optional<VdbValues> VdbValues::of_type(const std::string& type) {
  static constexpr std::tuple<std::string_view, Number, std::size_t> types[] = {
      {"bool", Number::boolean, 1},   {"mask", Number::mask, 1},    {"int32", Number::int32, 1},
      {"int64", Number::int64, 1},    {"half", Number::float16, 1}, {"float", Number::float32, 1},
      {"double", Number::float64, 1}, {"vec3i", Number::int32, 3},  {"vec3s", Number::float32, 3},
      {"vec3d", Number::float64, 3}};
  for (const auto& [name, number, components] : types) {
    if (name == type) return VdbValues{number, components, false, 0};
  }
  return std::nullopt;
}

std::size_t VdbLeaf::active() const {
  std::size_t sum = 0;
  for (const std::uint64_t word : mask) sum += static_cast<std::size_t>(std::popcount(word));
  return sum;
}

void read_vdb_topology(ByteReader& reader, const VdbValues& values, const VdbVisitor& visitor) {
  TopologyReader(reader, values, visitor).read();
}

namespace {

// Leaves of booleans and masks: the mask of active voxels, the corner and, of booleans, a mask of
// those that are true; never compressed.
void read_bit_leaves(
    ByteReader& reader, Number number, std::span<const VdbLeaf> leaves,
    const std::function<void(const VdbLeaf&, std::span<const double> values)>& visit) {
  constexpr std::size_t corner_bytes = 3 * sizeof(std::int32_t);
  std::vector<double> active;
  for (const VdbLeaf& leaf : leaves) {
    reader.read_bytes(VdbLeaf::size / 8 + corner_bytes);
    active.assign(leaf.active(), 1.0);
    if (number == Number::boolean) {
      const Mask<VdbLeaf::size> values(reader);
      std::size_t next = 0;
      for (std::size_t i = 0; i < VdbLeaf::size; ++i) {
        if (leaf.is_active(i)) active[next++] = values.has(i) ? 1.0 : 0.0;
      }
    }
    visit(leaf, active);
  }
}

}  // namespace

void read_vdb_leaves(
    ByteReader& reader, const VdbValues& values, std::span<const VdbLeaf> leaves,
    const std::function<void(const VdbLeaf&, std::span<const double> values)>& visit) {
  if (values.number == Number::boolean || values.number == Number::mask) {
    return read_bit_leaves(reader, values.number, leaves, visit);
  }
  NodeReader nodes(reader, values);
  std::vector<double> active;
  for (const VdbLeaf& leaf : leaves) {
    reader.read_bytes(VdbLeaf::size / 8);  // its mask again
    const auto [numbers, packed] = nodes.read(VdbLeaf::size, leaf.active());
    if (packed || numbers.empty()) {
      visit(leaf, numbers);
      continue;
    }
    active.clear();
    for (std::size_t i = 0; i < VdbLeaf::size; ++i) {
      if (!leaf.is_active(i)) continue;
      const auto value = numbers.subspan(i * values.components, values.components);
      active.insert(active.end(), value.begin(), value.end());
    }
    visit(leaf, active);
  }
}

}  // namespace brume
