#include "core/io/gaussians/gaussian_file.h"

#include <algorithm>
#include <cstdint>

#include "brume/error.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_columns.h"
#include "core/io/gaussians/gaussian_csv.h"
#include "core/io/gaussians/gaussian_ply.h"
#include "core/io/gaussians/other_format.h"
#include "core/io/gaussians/splat_gltf.h"
#include "core/io/gaussians/splat_ply.h"

namespace brume {
namespace {

enum class Format : std::uint8_t { ply, csv, gltf };

// By what the file begins with. Throws InputError for formats that are not read.
Format format_of(const std::filesystem::path& file) {
  const std::string bytes = read_first_bytes(file, 64);
  if (bytes.starts_with("ply")) return Format::ply;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool is_json = first != std::string::npos && bytes[first] == '{';
  if (is_json && file.filename().string().ends_with("meta.json")) {
    refuse_compressed_splats(file, "SOG");
  }
  if (is_json || bytes.starts_with("glTF")) return Format::gltf;
  refuse_other_format(file, bytes);
  return Format::csv;
}

std::vector<Gaussian> read_numbered(const std::filesystem::path& file,
                                    std::vector<GaussianNumber>* ids, std::size_t max_count,
                                    std::vector<GaussianNumber>* groups, const SplatInput& splats,
                                    std::vector<std::string>* warnings) {
  switch (format_of(file)) {
    case Format::ply:
      return read_gaussians_ply(file, ids, max_count, groups, splats, warnings);
    case Format::gltf:
      return read_splats_gltf(file, max_count, splats, warnings);
    case Format::csv:
      break;
  }
  return read_gaussians_csv(file, ids, max_count, groups);
}

// The Gaussians that read(&ids) reads; without ids where the file has none, or no ids but another
// program's words.
template <class Read>
std::vector<Gaussian> with_ids_if_any(std::vector<GaussianNumber>& ids, Read read) {
  try {
    return read(&ids);
  } catch (const InputError&) {
    ids.clear();  // if it is these, the file is read without; if not, there is the same error again
    return read(nullptr);
  }
}

bool is_gltf_name(const std::filesystem::path& file) {
  const std::string extension = lower_case_extension(file);
  return extension == ".glb" || extension == ".gltf";
}

}  // namespace

std::vector<Gaussian> read_gaussians(const std::filesystem::path& file,
                                     std::vector<GaussianNumber>* ids, std::size_t max_count,
                                     const SplatInput& splats, std::vector<std::string>* warnings) {
  return read_numbered(file, ids, max_count, nullptr, splats, warnings);
}

std::vector<Gaussian> read_with_ids(const std::filesystem::path& file,
                                    std::vector<GaussianNumber>& ids, const SplatInput& splats,
                                    std::vector<std::string>* warnings) {
  return with_ids_if_any(ids, [&](std::vector<GaussianNumber>* wanted) {
    return read_gaussians(file, wanted, limits::gaussians, splats, warnings);
  });
}

std::vector<GaussianNumber> written_ids(const Medium& medium) {
  const std::span<const GaussianId> ids = medium.ids();
  if (ids.empty() || ids.back() == ids.size()) return {};  // they ascend
  if (!gaussian_columns::is_id(static_cast<double>(ids.back()))) return {};
  std::vector<GaussianNumber> numbers;
  for (const GaussianId id : ids) numbers.push_back(static_cast<GaussianNumber>(id));
  return numbers;
}

std::size_t max_gaussian_count(const std::filesystem::path& file) {
  const Format format = format_of(file);
  if (format == Format::ply) return max_gaussian_count_ply(file);
  if (format == Format::gltf) return splat_count_gltf(file);
  const std::string bytes = read_bytes(file);
  const auto ends_line = [](char c) { return c == '\n' || c == '\r'; };
  return static_cast<std::size_t>(std::ranges::count_if(bytes, ends_line)) + 1;
}

bool has_splats(const std::filesystem::path& file) {
  switch (format_of(file)) {
    case Format::ply:
      return has_splats_ply(file);
    case Format::gltf:
      return has_splats_gltf(file);
    case Format::csv:
      break;
  }
  return false;
}

std::vector<Gaussian> read_grouped_gaussians(const std::filesystem::path& file,
                                             std::size_t max_count, std::size_t max_group,
                                             std::vector<GaussianNumber>& ids,
                                             std::vector<std::string>* warnings) {
  std::vector<GaussianNumber> groups;
  std::vector<Gaussian> gaussians = with_ids_if_any(ids, [&](std::vector<GaussianNumber>* wanted) {
    groups.clear();
    return read_numbered(file, wanted, max_count, max_group > 0 ? &groups : nullptr, {}, warnings);
  });
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (groups[i] > max_group) {
      throw InputError(file, "Gaussian " + std::to_string(i),
                       "group: found " + std::to_string(groups[i]) +
                           "; allowed: an integer from 0 to " + std::to_string(max_group) +
                           ", the number of the scene's groups");
    }
    gaussians[i].group = groups[i];
  }
  return gaussians;
}

void write_gaussians(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                     std::span<const GaussianNumber> ids) {
  if (lower_case_extension(file) == ".csv") {
    write_gaussians_csv(file, gaussians, ids);
  } else if (is_gltf_name(file)) {
    write_splats_gltf(file, gaussians);
  } else {
    write_gaussians_ply(file, gaussians, ids);
  }
}

void write_splats(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                  const SplatOutput& output) {
  if (is_gltf_name(file)) {
    write_splats_gltf(file, gaussians, output);
  } else {
    write_splats_ply(file, gaussians, output);
  }
}

}  // namespace brume
