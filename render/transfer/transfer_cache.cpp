#include "render/transfer/transfer_cache.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "brume/error.h"
#include "brume/mesh_arrays.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/disk/content_hash.h"
#include "core/io/disk/file_bytes.h"
#include "core/scene/mesh.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little, "files are written as they lie");

constexpr std::uint32_t version = 1;

// No coefficient is larger: sqrt(4 pi) for a function from 0 to 1.
constexpr float max_transfer = 4.0f;

// Hashes the mesh and all that decides how transfer is made from it.
std::uint64_t hash_of(const TriangleMesh& mesh, const TransferSettings& settings) {
  ContentHash hash;
  hash.add(version);
  hash.add(settings.order);
  hash.add(settings.directions);
  hash.add(settings.bounces);
  const MeshArrays& arrays = to_arrays(mesh);
  hash.add(std::span(arrays.points));
  hash.add(std::span(arrays.normals));
  for (const glm::uvec3& corners : arrays.triangles) hash.add(corners);
  return hash.value();
}

struct Header {
  std::array<char, 8> magic = {'b', 'r', 'u', 'm', 'e', 'P', 'R', 'T'};
  std::uint32_t version = brume::version;
  std::uint32_t order;
  std::uint64_t directions;
  std::uint32_t bounces;
  std::uint32_t sides = 0;  // bit 0: the front is there; bit 1: the back
  std::uint64_t vertices;
  std::uint64_t hash;

  Header(const TriangleMesh& mesh, const TransferSettings& settings, std::uint64_t hash_of_mesh)
      : order(static_cast<std::uint32_t>(settings.order)),
        directions(settings.directions),
        bounces(static_cast<std::uint32_t>(settings.bounces)),
        vertices(mesh.n_vertices()),
        hash(hash_of_mesh) {}
};
static_assert(sizeof(Header) == 48, "without padding");

std::uint64_t checksum(std::string_view bytes) {
  ContentHash hash;
  hash.add(std::span(bytes.data(), bytes.size()));
  return hash.value();
}

template <class Value>
std::string_view bytes_of(std::span<const Value> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

// Empty if it would be larger than a file may be.
std::string encode(const RadianceTransfer& transfer, Header header) {
  std::uintmax_t size = sizeof(Header) + sizeof(std::uint64_t);
  for (std::size_t s = 0; s < transfer.sides.size(); ++s) {
    const RadianceTransfer::Side& side = transfer.sides[s];
    if (!side.visibility.empty()) header.sides |= 1u << s;
    size += sizeof(float) * (side.visibility.size() + side.reflected.size());
  }
  std::string bytes;
  if (size > limits::file_bytes) return bytes;
  bytes.reserve(size);
  bytes += bytes_of(std::span<const Header>(&header, 1));
  for (const RadianceTransfer::Side& side : transfer.sides) {
    bytes += bytes_of(std::span(side.visibility));
    bytes += bytes_of(std::span(side.reflected));
  }
  const std::uint64_t sum = checksum(bytes);
  bytes += bytes_of(std::span<const std::uint64_t>(&sum, 1));
  return bytes;
}

// Throws InputError if `file` does not match `expected` in everything but its sides.
RadianceTransfer decode(const fs::path& file, const TransferSettings& settings, Header expected) {
  const auto refuse = [&](const char* message) { throw InputError(file, "", message); };
  const std::string bytes = read_bytes(file);
  if (bytes.size() < sizeof(Header) + sizeof(std::uint64_t)) refuse("is truncated");
  Header header = expected;
  std::memcpy(&header, bytes.data(), sizeof(Header));
  if (header.sides > 3) refuse("is damaged");
  expected.sides = header.sides;
  if (std::memcmp(&header, &expected, sizeof(Header)) != 0) refuse("belongs to something else");

  const std::size_t count = expected.vertices * sh_size(settings.order);
  const std::size_t term_count = static_cast<std::size_t>(settings.bounces) + 1;
  const auto sides = static_cast<std::size_t>(std::popcount(header.sides));
  const std::size_t payload = sizeof(float) * sides * count * (1 + term_count);
  if (bytes.size() != sizeof(Header) + payload + sizeof(std::uint64_t)) refuse("is truncated");
  const std::string_view content(bytes.data(), sizeof(Header) + payload);
  std::uint64_t sum = 0;
  std::memcpy(&sum, bytes.data() + content.size(), sizeof(sum));
  if (sum != checksum(content)) refuse("is damaged");

  const char* at = bytes.data() + sizeof(Header);
  const auto take = [&](std::vector<float>& values, std::size_t n) {
    values.resize(n);
    std::memcpy(values.data(), at, n * sizeof(float));
    at += n * sizeof(float);
    for (const float x : values) {
      if (!(std::abs(x) <= max_transfer)) refuse("is damaged");
    }
  };
  RadianceTransfer transfer{settings, expected.vertices, {}};
  for (std::size_t s = 0; s < transfer.sides.size(); ++s) {
    if ((header.sides >> s & 1u) == 0) continue;
    take(transfer.sides[s].visibility, count);
    take(transfer.sides[s].reflected, count * term_count);
  }
  return transfer;
}

// The name is a hash of the mesh's points, normals and triangles and of the settings.
fs::path file_of(const fs::path& folder, std::uint64_t hash) {
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
  return folder / (std::string(digits.data()) + ".transfer");
}

}  // namespace

fs::path cache_folder() {
  // A relative path is to be ignored (XDG Base Directory Specification).
  const auto absolute = [](const char* variable) {
    const char* const value = std::getenv(variable);
    const fs::path path = value ? value : "";
    return path.is_absolute() ? path : fs::path();
  };
  if (const fs::path cache = absolute("XDG_CACHE_HOME"); !cache.empty()) return cache / "brume";
  const fs::path home = absolute("HOME");
  return home.empty() ? home : home / ".cache" / "brume";
}

std::optional<RadianceTransfer> cached_radiance_transfer(
    const std::shared_ptr<const TriangleMesh>& mesh, const TransferSettings& settings,
    const fs::path& folder, const Job& job, std::vector<std::string>* warnings) {
  if (folder.empty() || job.stop.stop_requested()) return radiance_transfer(mesh, settings, job);
  const auto warn = [&](const std::string& line) {
    if (warnings) warnings->push_back(line);
  };
  const Header header(*mesh, settings, hash_of(*mesh, settings));
  const fs::path file = file_of(folder, header.hash);
  std::error_code error;
  if (fs::exists(file, error)) {
    try {
      RadianceTransfer transfer = decode(file, settings, header);
      if (job.progress) job.progress(1.0);
      return transfer;
    } catch (const InputError& mistake) {
      warn(mistake.what() + std::string("; radiance transfer is recomputed"));
    }
  }
  std::optional<RadianceTransfer> transfer = radiance_transfer(mesh, settings, job);
  if (!transfer) return transfer;
  try {
    const std::string bytes = encode(*transfer, header);
    fs::create_directories(folder, error);  // errors surface when the file is written
    if (!bytes.empty()) write_atomically(file, bytes);
  } catch (const InputError& mistake) {
    warn(mistake.what() + std::string("; radiance transfer is not cached"));
  }
  return transfer;
}

}  // namespace brume
