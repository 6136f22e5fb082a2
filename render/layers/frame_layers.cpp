#include "render/layers/frame_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brume/at_time.h"
#include "core/scene/camera_rays.h"
#include "render/layers/cryptomatte.h"
#include "render/layers/layer_channels.h"
#include "render/layers/surface_layers.h"

namespace brume {
namespace {

// Adds the planar depth of the points that Z is the distance of.
void add_planar_depth(const CameraRays& rays, const Frame& frame, ImageLayers& image) {
  std::vector<float>& planar = image.channels["depth.planar"];
  planar = frame.depth;
  const auto width = static_cast<std::size_t>(frame.film.width);
  for (std::size_t i = 0; i < planar.size(); ++i) {
    const glm::dvec3 direction =
        rays.direction(static_cast<double>(i % width) + 0.5, static_cast<double>(i / width) + 0.5);
    planar[i] *= static_cast<float>(glm::dot(direction, rays.forward()));
  }
}

bool has_surface_layers(const OutputLayers& layers) {
  return layers.normal || layers.albedo || layers.position || layers.motion || layers.objects ||
         layers.materials;
}

void add_optical_depth(const Frame& frame, ImageLayers& image) {
  const LayerChannels depths(image, "optical_depth");
  const auto depth = [](float transmittance) {
    return -std::log(std::max(transmittance, std::numeric_limits<float>::min()));
  };
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    const float* const t = frame.transmittance.data() + 3 * i;
    depths.set(i, glm::max(glm::vec3(depth(t[0]), depth(t[1]), depth(t[2])), 0.0f));
  }
}

}  // namespace

bool has_more_layers(const OutputLayers& layers) {
  OutputLayers plain;
  plain.airlight = layers.airlight;
  plain.transmittance = layers.transmittance;
  plain.depth = layers.depth;
  return layers != plain;
}

bool has_light_layers(const OutputLayers& layers) {
  return layers.lights || layers.environment || layers.emission || layers.direct ||
         layers.multiple || layers.reflection;
}

std::size_t layer_bytes(const Scene& scene, const Film& film, const OutputLayers& layers) {
  const auto sources = static_cast<std::size_t>(std::ranges::count_if(
      light_layer_names(scene.lights), [](const std::string& name) { return !name.empty(); }));
  std::size_t channels = 0;
  if (layers.lights) channels += 6 * sources;
  if (layers.environment) channels += 9;
  if (layers.emission) channels += 6;
  for (const bool two : {layers.direct, layers.multiple}) channels += two ? 6 : 0;
  for (const bool one : {layers.reflection, layers.optical_depth, layers.normal, layers.albedo,
                         layers.position, layers.motion}) {
    channels += one ? 3 : 0;
  }
  if (layers.planar_depth) channels += 1;
  // Coverage is gathered apart from the channels.
  for (const bool matte : {layers.objects, layers.materials}) {
    channels += matte ? 4 * CoverageFilm::ranks : 0;
  }
  return channels * sizeof(float) * static_cast<std::size_t>(film.width) *
         static_cast<std::size_t>(film.height);
}

RenderLit render_lit_by(FrameRenderer& renderer, const ExposedView& view) {
  return [&renderer, view](const ChangeLight& light, const Settings& settings, const Job& job) {
    ExposedView lit = view;
    lit.scene_at = [&](double time) {
      Scene scene = view.scene_at(time);
      light(scene);
      return scene;
    };
    return render_exposure(renderer, lit, settings, job);
  };
}

std::optional<ImageLayers> render_layers(const LayeredFrame& layered, const OutputLayers& layers,
                                         const Job& job) {
  const Scene& scene = layered.scene;
  const Camera& camera = layered.camera ? *layered.camera : scene.camera;
  const Film& film = layered.frame.film;
  ImageLayers image;
  image.width = film.width;
  image.height = film.height;
  if (!add_light_layers(layered.render, scene, layered.settings, layers, job, layered.frame,
                        image)) {
    return std::nullopt;
  }
  if (layers.optical_depth) add_optical_depth(layered.frame, image);
  if (layers.planar_depth) add_planar_depth(CameraRays(camera, film), layered.frame, image);
  if (has_surface_layers(layers)) {
    std::optional<Scene> next;
    if (layers.motion) {
      next = evaluate_at(layered.animated, scene.time + 1.0 / frame_rate(layered.animated));
    }
    const Camera& next_camera = layered.camera || !next ? camera : next->camera;
    add_surface_layers(scene, camera, film, layers, next ? &*next : nullptr, next_camera, job,
                       image);
  }
  if (job.stop.stop_requested()) return std::nullopt;
  return image;
}

}  // namespace brume
