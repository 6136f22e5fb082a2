#include "core/io/volume/vdb_file.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>

#include "brume/limits.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

constexpr std::int64_t magic = 0x56444220;
constexpr std::uint32_t oldest_version = 222;

std::string read_string(ByteReader& reader) {
  return std::string(reader.read_bytes(reader.number<std::uint32_t>()));
}

// Calls visit(name, bytes of the value) for each of a list of properties.
template <class Visit>
void each_property(ByteReader& reader, Visit visit) {
  const auto count = reader.number<std::uint32_t>();
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string name = read_string(reader);
    read_string(reader);  // its type
    visit(name, reader.read_bytes(reader.number<std::uint32_t>()));
  }
}

glm::dvec3 read_vector(ByteReader& reader) {
  glm::dvec3 v;
  for (int k = 0; k < 3; ++k) v[k] = reader.number<double>();
  return v;
}

// Each kind is stored as its members, of which what matters comes first.
std::optional<VdbGrid::Transform> read_transform(ByteReader& reader) {
  constexpr std::uint64_t vector = 3 * sizeof(double);
  const std::string kind = read_string(reader);
  VdbGrid::Transform transform{glm::dmat3(1.0), glm::dvec3(0.0)};
  const auto scale = [&] {
    const glm::dvec3 factors = read_vector(reader);
    for (int k = 0; k < 3; ++k) transform.axes[k][k] = factors[k];
    reader.read_bytes(4 * vector);
  };
  if (kind == "ScaleMap" || kind == "UniformScaleMap") {
    scale();
  } else if (kind == "TranslationMap") {
    transform.origin = read_vector(reader);
  } else if (kind == "ScaleTranslateMap" || kind == "UniformScaleTranslateMap") {
    transform.origin = read_vector(reader);
    scale();
  } else if (kind == "AffineMap" || kind == "UnitaryMap") {
    // A matrix that is applied to rows.
    for (int row = 0; row < 4; ++row) {
      const glm::dvec3 v = read_vector(reader);
      (row < 3 ? transform.axes[row] : transform.origin) = v;
      if (reader.number<double>() != (row < 3 ? 0.0 : 1.0)) return std::nullopt;
    }
  } else {
    return std::nullopt;
  }
  return transform;
}

// The descriptor of a grid; `parent` names the grid whose tree it shares, if any.
struct Descriptor {
  std::string unique_name;
  VdbGrid grid;
  std::string parent;
  std::uint64_t begin;
};

Descriptor read_descriptor(ByteReader& reader) {
  Descriptor result;
  result.unique_name = read_string(reader);
  // A number follows where there are more grids of the name.
  result.grid.name = result.unique_name.substr(0, result.unique_name.find('\x1e'));
  // Such as Tree_float_5_4_3_HalfFloat.
  constexpr std::string_view before = "Tree_";
  constexpr std::string_view after = "_5_4_3";
  std::string& type = result.grid.type;
  type = read_string(reader);
  if (type.starts_with(before)) type.erase(0, before.size());
  const std::size_t end = type.find(after);
  if (end != std::string::npos) {
    type.resize(end);
    result.grid.values = VdbValues::of_type(type);
  }
  result.parent = read_string(reader);
  result.begin = reader.number<std::uint64_t>();
  reader.number<std::uint64_t>();  // of the leaves' values
  result.grid.end = reader.number<std::uint64_t>();
  return result;
}

void read_grid(ByteReader& reader, Descriptor& descriptor) {
  VdbGrid& grid = descriptor.grid;
  reader.seek(descriptor.begin);
  const auto compression = reader.number<std::uint32_t>();
  bool half = false;
  each_property(reader, [&](const std::string& name, std::string_view value) {
    if (name == "class") grid.kind = value;
    if (name == "is_saved_as_half_float") half = !value.empty() && value[0] != 0;
  });
  if (grid.values) {
    grid.values->compression = compression;
    grid.values->half = half;
  }
  grid.transform = read_transform(reader);
  grid.tree = reader.position();
}

std::string names_of(const std::vector<VdbGrid>& grids) {
  std::set<std::string> known;
  std::string names;
  for (const VdbGrid& grid : grids) {
    if (!known.insert(grid.name).second) continue;
    if (!names.empty()) names += ", ";
    names += quoted_text(grid.name);
  }
  return names.empty() ? "none" : names;
}

std::uint32_t read_version(ByteReader& reader) {
  if (reader.number<std::int64_t>() != magic) reader.fail("not an OpenVDB file");
  return reader.number<std::uint32_t>();
}

}  // namespace

std::uint32_t vdb_version(const std::filesystem::path& file, std::string_view bytes) {
  ByteReader reader(file, bytes);
  return read_version(reader);
}

std::vector<VdbGrid> read_vdb_grids(const std::filesystem::path& file, std::string_view bytes) {
  ByteReader reader(file, bytes);
  const std::uint32_t version = read_version(reader);
  if (version < oldest_version) {
    reader.fail("found version " + std::to_string(version) +
                " of the format; allowed: " + std::to_string(oldest_version) + " and later");
  }
  reader.read_bytes(2 * sizeof(std::uint32_t));  // version of the library
  if (reader.number<std::uint8_t>() == 0) {
    reader.fail("was written as a stream; allowed: a file with the offsets of its grids");
  }
  reader.read_bytes(36);  // a UUID as text
  each_property(reader, [](const std::string&, std::string_view) {});

  const auto count = reader.number<std::uint32_t>();
  if (count > limits::volume_grids) reader.fail("found " + std::to_string(count) + " grids");
  std::vector<Descriptor> descriptors;
  for (std::uint32_t i = 0; i < count; ++i) {
    Descriptor descriptor = read_descriptor(reader);
    // Each grid starts behind the previous one, so that nothing is read twice.
    if (descriptor.begin < reader.position()) reader.fail("contains nested grids");
    read_grid(reader, descriptor);
    const std::uint64_t end = descriptor.grid.end;
    if (end < reader.position()) reader.fail("contains a grid that ends before it begins");
    reader.seek(end);
    descriptors.push_back(std::move(descriptor));
  }
  std::vector<VdbGrid> grids;
  for (const Descriptor& descriptor : descriptors) {
    VdbGrid grid = descriptor.grid;
    // Not linear: what follows is not where it is looked for.
    if (!grid.transform) grid.values = std::nullopt;
    if (!descriptor.parent.empty()) {
      const auto parent =
          std::find_if(descriptors.begin(), descriptors.end(), [&](const Descriptor& other) {
            return other.unique_name == descriptor.parent && other.parent.empty();
          });
      if (parent == descriptors.end()) reader.fail("has no grid " + quoted_text(descriptor.parent));
      grid.values = parent->grid.transform ? parent->grid.values : std::nullopt;
      grid.tree = parent->grid.tree;
      grid.end = parent->grid.end;
    }
    grids.push_back(std::move(grid));
  }
  return grids;
}

std::vector<VdbGrid> grids_named(const std::filesystem::path& path,
                                 const std::vector<VdbGrid>& grids, const std::string& name) {
  std::vector<VdbGrid> named;
  std::ranges::copy_if(grids, std::back_inserter(named),
                       [&](const VdbGrid& grid) { return grid.name == name; });
  if (named.empty()) {
    throw InputError(path, "",
                     "has no grid " + quoted_text(name) + "; its grids: " + names_of(grids));
  }
  return named;
}

}  // namespace brume
