#include "app/import/asset_kind.h"

#include <QStandardPaths>
#include <array>
#include <string>
#include <utility>

#include "app/document/paths.h"
#include "app/import/import_kind.h"
#include "core/io/disk/file_bytes.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr const char* asset_folder = "assets";

struct SavedKind {
  AssetKind kind;
  const char* word;
  const char* extension;
};
constexpr std::array saved_kinds{SavedKind{AssetKind::surface, ".surface", ".brume"},
                                 SavedKind{AssetKind::fog, ".fog", ".brume"},
                                 SavedKind{AssetKind::light, ".light", ".brume"},
                                 SavedKind{AssetKind::camera, ".camera", ".brume"},
                                 SavedKind{AssetKind::brush, ".brush", ".json"}};

const SavedKind* saved_kind(const fs::path& file) {
  const std::string extension = lower_case_extension(file);
  const std::string word = lower_case_extension(file.stem());
  for (const SavedKind& kind : saved_kinds) {
    if (extension == kind.extension && word == kind.word) return &kind;
  }
  return nullptr;
}

}  // namespace

std::optional<AssetKind> asset_kind(const fs::path& file) {
  if (const SavedKind* kind = saved_kind(file)) return kind->kind;
  if (lower_case_extension(file) == ".brume") return AssetKind::scene;
  if (!can_import(file)) return std::nullopt;
  if (is_volume(file) || is_vtk_file(file)) return AssetKind::fog;
  switch (import_kind_of(file)) {
    case ImportKind::gaussians:
    case ImportKind::splats:
      return AssetKind::fog;
    case ImportKind::mesh:
    case ImportKind::scene:
      return AssetKind::surface;
    case ImportKind::environment:
      break;
  }
  return std::nullopt;
}

QString asset_name(const fs::path& file) {
  return to_qstring(saved_kind(file) ? file.stem().stem() : file.stem());
}

std::string asset_extension(AssetKind kind) {
  for (const SavedKind& saved : saved_kinds) {
    if (saved.kind == kind) return std::string(saved.word) + saved.extension;
  }
  return ".brume";
}

fs::path asset_file(fs::path file, AssetKind kind) {
  const SavedKind* present = saved_kind(file);
  if (!present || present->kind != kind) file += asset_extension(kind);
  return file;
}

fs::path user_asset_folder() {
  return to_path(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)) / asset_folder;
}

fs::path scene_asset_folder(const fs::path& scene) {
  return scene.parent_path() / asset_folder;
}

}  // namespace brume
