#include "tools/brume/frame_fingerprint.h"

#include <array>
#include <cstdio>
#include <optional>
#include <span>

#include "brume/version.h"
#include "core/io/disk/content_hash.h"
#include "core/io/disk/file_version.h"
#include "core/io/scene/scene_file.h"
#include "core/io/scene/scene_files.h"

namespace brume {
namespace {

void add_text(ContentHash& hash, std::string_view text) {
  hash.add(std::span<const char>(text.data(), text.size()));
}

}  // namespace

FrameFingerprint::FrameFingerprint(const SceneDocument& document, const std::string& options) {
  ContentHash hash;
  add_text(hash, version());
  add_text(hash, options);
  // The same wherever the scene lies: references are hashed by what they hold.
  const std::vector<std::filesystem::path> files = files_of(document);
  add_text(hash, document_to_json(document, files.empty() ? "/" : files.front().parent_path()));
  for (const std::filesystem::path& file : files) {
    const std::optional<FileVersion> version = FileVersion::read(file);
    add_text(hash, version ? version->text() : "missing");
  }
  all_frames_ = hash.value();
}

std::string FrameFingerprint::of(int frame) const {
  ContentHash hash;
  hash.add(all_frames_);
  hash.add(static_cast<std::int64_t>(frame));
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash.value()));
  return text.data();
}

}  // namespace brume
