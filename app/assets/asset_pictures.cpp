#include "app/assets/asset_pictures.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <exception>
#include <glm/geometric.hpp>

#include "app/commands/objects/edit_lights.h"
#include "app/document/paths.h"
#include "app/files/recent_pictures.h"
#include "app/import/add_imported.h"
#include "app/import/import_kind.h"
#include "app/view/camera/bounds.h"
#include "app/widgets/frame_image.h"
#include "brume/at_time.h"
#include "brume/files.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/import/imported_scene_file.h"
#include "core/io/scene/scene_file.h"
#include "render/renderer.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr Film picture_film{240, 160};
constexpr int picture_slices = 12;
// Larger files are known by their icon: reading them only for a thumbnail takes too long.
constexpr std::uintmax_t max_bytes = std::uintmax_t{256} << 20;
constexpr std::size_t max_gaussians = 200'000;

constexpr const char* version_key = "version";

// Files that change have another version.
QString version_of(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error).time_since_epoch().count();
  return error ? QString() : QString::number(time);
}

// The size of the files that a JSON document names, as scene files and glTF do.
std::uintmax_t bytes_of_files(const QJsonValue& json, const fs::path& folder) {
  std::uintmax_t bytes = 0;
  if (json.isString()) {
    std::error_code error;
    const fs::path file = folder / to_path(json.toString());
    if (fs::is_regular_file(file, error)) bytes = fs::file_size(file, error);
    return error ? 0 : bytes;
  }
  for (const QJsonValue& value : json.toArray()) bytes += bytes_of_files(value, folder);
  for (const QJsonValue& value : json.toObject()) bytes += bytes_of_files(value, folder);
  return bytes;
}

bool is_small(const fs::path& file) {
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(file, error);
  if (error || bytes > max_bytes) return false;
  const std::string extension = lower_case_extension(file);
  if (extension != ".brume" && extension != ".gltf") return true;
  const auto json = QJsonDocument::fromJson(QByteArray::fromStdString(read_bytes(file)));
  const QJsonValue value = json.isArray() ? QJsonValue(json.array()) : QJsonValue(json.object());
  return bytes + bytes_of_files(value, file.parent_path()) <= max_bytes;
}

// Lit and framed for itself, seen from above to the right.
std::optional<Scene> on_stage(Scene scene) {
  scene.camera = {};
  scene.environment.reset();
  const auto sphere = bounding_sphere(scene);
  if (!sphere || !(sphere->radius > 0.0)) return std::nullopt;
  constexpr double distance = 2.7;  // in radii
  scene.camera.target = sphere->center;
  scene.camera.eye =
      sphere->center + distance * sphere->radius * glm::normalize(glm::dvec3(0.5, 0.35, 1.0));
  for (Surface& surface : scene.surfaces) surface.holdout = false;
  scene.lights = {light_outside(sphere->center, sphere->radius, scene.camera.eye)};
  return scene;
}

Scene file_scene(const fs::path& file, const std::stop_token& stop) {
  Scene scene;
  switch (import_kind_of(file)) {
    case ImportKind::scene: {
      std::vector<std::string> warnings;
      const auto imported = read_imported_scene(file, warnings, stop);
      if (imported && !imported->parts.empty()) scene.surfaces = {surface_of(imported)};
      break;
    }
    case ImportKind::mesh:
      scene.surfaces = {load_surface(file)};
      break;
    case ImportKind::gaussians:
    case ImportKind::splats:
      for (const Gaussian& gaussian : read_gaussians(file)) scene.medium.append(gaussian);
      break;
    case ImportKind::environment:
      break;
  }
  return scene;
}

// The scene that shows an asset; nullopt: there is nothing to be seen of it.
std::optional<Scene> picture_scene(const Asset& asset, const std::stop_token& stop) {
  switch (asset.kind) {
    case AssetKind::scene:
    case AssetKind::surface:
    case AssetKind::fog:
      break;
    case AssetKind::light:
    case AssetKind::camera:
    case AssetKind::brush:
      return std::nullopt;
  }
  if (is_volume(asset.file) || is_vtk_file(asset.file) || !is_small(asset.file)) {
    return std::nullopt;
  }
  if (asset.kind == AssetKind::scene) return load_document(asset.file).scene;
  if (lower_case_extension(asset.file) == ".brume") {
    return on_stage(load_document(asset.file).scene);
  }
  return on_stage(file_scene(asset.file, stop));
}

std::optional<QImage> picture_of(const Asset& asset, const QString& version,
                                 const std::stop_token& stop) {
  // A scene that was opened has another picture.
  const fs::path cached = fs::path(asset.file).concat("#asset");
  if (QImage known = recent_image(cached); known.text(version_key) == version && !known.isNull()) {
    return known;
  }
  try {
    std::optional<Scene> scene = picture_scene(asset, stop);
    if (!scene || scene->medium.size() > max_gaussians) return std::nullopt;
    *scene = evaluate_at(*scene, 0.0);
    Settings settings = sliced_settings({}, picture_slices);
    settings.scattering = Scattering::single;
    const auto frame = Renderer().render(*scene, scene->camera, picture_film, settings, stop, {});
    if (!frame) return std::nullopt;
    QImage picture = frame_image(*frame, {});
    picture.setText(version_key, version);
    save_recent_picture(cached, picture);
    return picture;
  } catch (const std::exception&) {
    return std::nullopt;  // who adds it is told why
  }
}

}  // namespace

void AssetPictures::make(const std::vector<Asset>& assets) {
  job_.start([this, assets](const Job& job) -> BackgroundJob::Apply {
    for (std::size_t k = 0; k < assets.size() && !job.stop.stop_requested(); ++k) {
      const fs::path& file = assets[k].file;
      const QString version = version_of(file);
      const auto known = without_.find(file);
      if (known != without_.end() && known->second == version) continue;
      const auto picture = picture_of(assets[k], version, job.stop);
      if (picture) {
        job_.deliver(job, [this, k, image = *picture] { Q_EMIT made(k, image); });
      } else if (!job.stop.stop_requested()) {
        without_[file] = version;
      }
    }
    return {};
  });
}

}  // namespace brume
