#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace brume {

// What a file holds, as a number: two versions are the same if their contents are. To notice that
// another program has written a file since it was read here.
class FileVersion {
 public:
  static FileVersion of_content(std::string_view content);
  // Nothing where there is no such file, or it cannot be read.
  static std::optional<FileVersion> read(const std::filesystem::path& file);

  // As text, and back; nothing where the text is none.
  [[nodiscard]] std::string text() const;
  static std::optional<FileVersion> parse(const std::string& text);

  bool operator==(const FileVersion&) const = default;

 private:
  std::uint64_t size_ = 0;  // [bytes]
  std::uint64_t hash_ = 0;
};

}  // namespace brume
