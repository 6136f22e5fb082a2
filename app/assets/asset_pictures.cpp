#include "app/assets/asset_pictures.h"

#include <exception>
#include <glm/geometric.hpp>

#include "app/commands/edit_lights.h"
#include "app/files/recent_pictures.h"
#include "app/import/add_imported.h"
#include "app/import/import_kind.h"
#include "app/view/bounds.h"
#include "brume/at_time.h"
#include "brume/files.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/import/imported_scene_file.h"
#include "core/io/scene/scene_file.h"
#include "render/display/to_display.h"
#include "render/renderer.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr Film picture_film{240, 160};
constexpr int picture_slices = 12;
// Larger files are known by their icon: reading them only for a thumbnail takes too long.
constexpr std::uintmax_t max_bytes = std::uintmax_t{256} << 20;
constexpr std::size_t max_gaussians = 200'000;

// Files that change get another picture.
fs::path cache_name(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error).time_since_epoch().count();
  return fs::path(file).concat("#").concat(std::to_string(error ? 0 : time));
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

// Nullopt: there is nothing to be seen of it.
std::optional<Scene> picture_scene(const Asset& asset, const std::stop_token& stop) {
  std::error_code error;
  if (fs::file_size(asset.file, error) > max_bytes || error) return std::nullopt;
  switch (asset.kind) {
    case AssetKind::scene:
      return load_document(asset.file).scene;
    case AssetKind::surface:
    case AssetKind::fog:
      break;
    case AssetKind::light:
    case AssetKind::camera:
    case AssetKind::brush:
      return std::nullopt;
  }
  if (asset.file.extension() == ".brume") return on_stage(load_document(asset.file).scene);
  if (is_volume(asset.file) || is_vtk_file(asset.file)) return std::nullopt;
  return on_stage(file_scene(asset.file, stop));
}

std::optional<QImage> picture_of(const Asset& asset, const std::stop_token& stop) {
  const fs::path cached = cache_name(asset.file);
  if (QImage known = recent_image(cached); !known.isNull()) return known;
  try {
    std::optional<Scene> scene = picture_scene(asset, stop);
    if (!scene || scene->medium.size() > max_gaussians) return std::nullopt;
    *scene = evaluate_at(*scene, 0.0);
    Settings settings = sliced_settings({}, picture_slices);
    settings.scattering = Scattering::single;
    const auto frame = Renderer().render(*scene, scene->camera, picture_film, settings, stop, {});
    if (!frame) return std::nullopt;
    const auto bytes = to_display(*frame, {});
    const QImage picture(bytes.data(), picture_film.width, picture_film.height,
                         3 * picture_film.width, QImage::Format_RGB888);
    save_recent_picture(cached, picture);
    return picture.copy();
  } catch (const std::exception&) {
    return std::nullopt;  // who adds it is told why
  }
}

}  // namespace

void AssetPictures::make(const std::vector<Asset>& assets) {
  job_.start([this, assets](const Job& job) -> BackgroundJob::Apply {
    for (std::size_t k = 0; k < assets.size() && !job.stop.stop_requested(); ++k) {
      const auto picture = picture_of(assets[k], job.stop);
      if (picture) job_.deliver(job, [this, k, image = *picture] { Q_EMIT made(k, image); });
    }
    return {};
  });
}

}  // namespace brume
