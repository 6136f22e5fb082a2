#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace brume {

// A fingerprint of a file's content, to detect that another program has changed it.
class FileVersion {
 public:
  static FileVersion of_content(std::string_view content);
  // nullopt if missing or unreadable.
  static std::optional<FileVersion> read(const std::filesystem::path& file);

  // Conversion to text and back; nullopt for other text.
  [[nodiscard]] std::string text() const;
  static std::optional<FileVersion> parse(const std::string& text);

  bool operator==(const FileVersion&) const = default;

 private:
  std::uint64_t size_ = 0;  // [bytes]
  std::uint64_t hash_ = 0;
};

}  // namespace brume
