#include "core/io/disk/file_version.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <span>
#include <vector>

#include "core/io/disk/content_hash.h"

namespace brume {
namespace {

// The hash depends on where the content is cut.
constexpr std::size_t piece = std::size_t{1} << 20;  // [bytes]

}  // namespace

FileVersion FileVersion::of_content(std::string_view content) {
  ContentHash hash;
  FileVersion version;
  version.size_ = content.size();
  for (; !content.empty(); content.remove_prefix(std::min(piece, content.size()))) {
    const std::string_view chunk = content.substr(0, piece);
    hash.add(std::span<const char>(chunk.data(), chunk.size()));
  }
  version.hash_ = hash.value();
  return version;
}

std::optional<FileVersion> FileVersion::read(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::vector<char> buffer(piece);
  ContentHash hash;
  FileVersion version;
  while (in) {
    in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    const auto count = static_cast<std::size_t>(in.gcount());
    if (count == 0) break;
    version.size_ += count;
    hash.add(std::span<const char>(buffer.data(), count));
  }
  if (!in.eof()) return std::nullopt;
  version.hash_ = hash.value();
  return version;
}

std::string FileVersion::text() const {
  return std::to_string(size_) + '-' + std::to_string(hash_);
}

std::optional<FileVersion> FileVersion::parse(const std::string& text) {
  FileVersion version;
  const char* end = text.data() + text.size();
  const auto size = std::from_chars(text.data(), end, version.size_);
  if (size.ec != std::errc() || size.ptr == end || *size.ptr != '-') return std::nullopt;
  const auto hash = std::from_chars(size.ptr + 1, end, version.hash_);
  if (hash.ec != std::errc() || hash.ptr != end) return std::nullopt;
  return version;
}

}  // namespace brume
