#include "tools/scene_reader/limited_files.h"

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <cstring>

#include "brume/error.h"
#include "core/io/disk/alike_file.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/text_scanner.h"
#include "core/io/unicode_text.h"

namespace brume {
namespace {

class Bytes : public Assimp::IOStream {
 public:
  explicit Bytes(std::string bytes) : bytes_(std::move(bytes)) {}

  size_t Read(void* buffer, size_t size, size_t count) override {
    if (size == 0) return 0;
    const size_t whole = std::min(count, (bytes_.size() - position_) / size);
    std::memcpy(buffer, bytes_.data() + position_, whole * size);
    position_ += whole * size;
    return whole;
  }
  size_t Write(const void*, size_t, size_t) override { return 0; }
  aiReturn Seek(size_t offset, aiOrigin origin) override {
    const size_t from = origin == aiOrigin_SET   ? 0
                        : origin == aiOrigin_CUR ? position_
                                                 : bytes_.size();
    const size_t position = origin == aiOrigin_END ? from - offset : from + offset;
    if (position > bytes_.size()) return aiReturn_FAILURE;
    position_ = position;
    return aiReturn_SUCCESS;
  }
  size_t Tell() const override { return position_; }
  size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::string bytes_;
  size_t position_ = 0;
};

}  // namespace

std::filesystem::path place_of(const std::filesystem::path& named,
                               const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::path found = find_file_named_alike(named);
  if (std::filesystem::exists(found, error)) return found;
  std::string text = named.string();
  std::ranges::replace(text, '\\', '/');
  found = find_file_named_alike(folder / std::filesystem::path(text).filename());
  return std::filesystem::exists(found, error) ? found : named;
}

bool LimitedFiles::Exists(const char* file) const {
  std::error_code error;
  return std::filesystem::is_regular_file(file, error);
}

Assimp::IOStream* LimitedFiles::Open(const char* file, const char* mode) {
  if (std::strpbrk(mode, "wa+") != nullptr) return nullptr;
  std::string bytes;
  bool is_any_there = false;
  for (const std::filesystem::path& path : places_of(file)) {
    try {
      const bool is_replaced = scene_text_ && path == scene_;
      // A byte order mark would become part of the first keyword.
      if (is_any_there) bytes += '\n';
      bytes += is_replaced ? *scene_text_ : as_utf8(read_bytes(path));
      if (std::ranges::count(opened_, path) == 0) opened_.push_back(path);
      is_any_there = true;
    } catch (const InputError&) {
      missed_.push_back(path);
    }
  }
  return is_any_there ? new Bytes(std::move(bytes)) : nullptr;  // Close() gets it
}

std::vector<std::filesystem::path> LimitedFiles::places_of(const std::string& name) const {
  const std::filesystem::path folder = scene_.parent_path();
  const std::filesystem::path whole = place_of(name, folder).lexically_normal();
  const auto exists = [](const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::exists(file, error);
  };
  if (exists(whole)) return {whole};
  const std::string names =
      std::filesystem::path(name).lexically_normal().lexically_relative(folder).string();
  std::vector<std::filesystem::path> places;
  TextScanner scanner(names);
  scanner.next_line();
  for (std::string_view token = scanner.next_token(); !token.empty();
       token = scanner.next_token()) {
    std::filesystem::path place = place_of(folder / token, folder).lexically_normal();
    if (std::ranges::count(places, place) == 0) places.push_back(std::move(place));
  }
  return std::ranges::any_of(places, exists) ? places : std::vector{whole};
}

void LimitedFiles::Close(Assimp::IOStream* stream) {
  delete stream;
}

}  // namespace brume
