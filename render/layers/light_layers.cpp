#include "render/layers/light_layers.h"

#include <algorithm>
#include <glm/common.hpp>
#include <memory>
#include <set>

#include "brume/revision.h"
#include "core/scene/lights/emitting_surfaces.h"
#include "render/layers/layer_channels.h"
#include "render/render_plan.h"

namespace brume {
namespace {

// Practically off, but still a light of the frame: slices and tables stay as they are.
constexpr double dimmed = 1e-30;

constexpr std::size_t max_layer_name = 64;

bool is_shining(const Light& light) {
  return light.on && light.intensity != glm::dvec3(0.0);
}

bool is_lit_by_environment(const Scene& scene) {
  return scene.environment && scene.environment->intensity > 0.0;
}

// Without what shines by itself. The same medium stays the same one, so that what renderers prepare
// of it does too.
class EmissionRemoval {
 public:
  void remove(Scene& scene) {
    for (Surface& surface : scene.surfaces) {
      surface.material.metallic_roughness.emissive = glm::dvec3(0.0);
    }
    if (!scene.medium.has_emission()) return;
    if (!made_ || from_ != scene.medium.revision()) {
      from_ = scene.medium.revision();
      made_ = scene.medium.changed(scene.medium.homogeneous_density(), [](Gaussian gaussian) {
        gaussian.optics.emission = glm::dvec3(0.0);
        return gaussian;
      });
    }
    scene.medium = *made_;
  }

 private:
  Revision from_ = 0;
  std::optional<Medium> made_;
};

void dim(Scene& scene) {
  for (Light& light : scene.lights) light.intensity *= dimmed;
  if (scene.environment) scene.environment->intensity *= dimmed;
}

bool has_emission(const Scene& scene) {
  return scene.medium.has_emission() || std::ranges::any_of(scene.surfaces, is_emissive);
}

// A source of light: what makes a scene lit by it alone.
struct Source {
  std::string name;
  ChangeLight alone;
  bool is_written;
};

std::vector<Source> light_sources(const Scene& scene, const OutputLayers& layers) {
  std::vector<Source> sources;
  if (has_emission(scene)) sources.push_back({"emission", dim, layers.emission});
  const auto removal = std::make_shared<EmissionRemoval>();
  if (is_lit_by_environment(scene)) {
    const auto alone = [removal](Scene& lit) {
      const double intensity = lit.environment ? lit.environment->intensity : 0.0;
      dim(lit);
      removal->remove(lit);
      if (lit.environment) lit.environment->intensity = intensity;
    };
    sources.push_back({"environment", alone, layers.environment});
  }
  const std::vector<std::string> names = light_layer_names(scene.lights);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) continue;
    const auto alone = [removal, i](Scene& lit) {
      const glm::dvec3 intensity = lit.lights[i].intensity;
      dim(lit);
      removal->remove(lit);
      lit.lights[i].intensity = intensity;
    };
    sources.push_back({names[i], alone, layers.lights});
  }
  return sources;
}

glm::vec3 rgb(const std::vector<float>& values, std::size_t at) {
  return {values[at], values[at + 1], values[at + 2]};
}

// The parts of a frame: airlight; what surfaces send and what is behind all, through the medium.
struct FrameParts {
  const Frame& frame;

  [[nodiscard]] glm::vec3 airlight(std::size_t pixel) const {
    return rgb(frame.airlight, 3 * pixel);
  }
  [[nodiscard]] glm::vec3 surfaces(std::size_t pixel) const {
    return rgb(frame.beauty, 4 * pixel) - airlight(pixel) - background(pixel);
  }
  [[nodiscard]] glm::vec3 background(std::size_t pixel) const {
    return frame.background.empty() ? glm::vec3(0.0f) : rgb(frame.background, 3 * pixel);
  }
};

void write_source(const std::string& name, const Frame& frame, ImageLayers& image) {
  const FrameParts parts{frame};
  const LayerChannels airlight(image, "airlight." + name);
  const LayerChannels surface(image, "surface." + name);
  std::optional<LayerChannels> background;
  if (name == "environment") background.emplace(image, "background");
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    airlight.set(i, parts.airlight(i));
    surface.set(i, parts.surfaces(i));
    if (background) background->set(i, parts.background(i));
  }
}

// The background is in no layer of orders.
void write_orders(const Frame& all, const Frame& single, const OutputLayers& layers,
                  ImageLayers& image) {
  const FrameParts once{single};
  const FrameParts any{all};
  const auto write = [&](const std::string& name, auto value) {
    const LayerChannels airlight(image, "airlight." + name);
    const LayerChannels surface(image, "surface." + name);
    for (std::size_t i = 0; i < all.depth.size(); ++i) {
      airlight.set(i, value(once.airlight(i), any.airlight(i)));
      surface.set(i, value(once.surfaces(i), any.surfaces(i)));
    }
  };
  if (layers.direct)
    write("direct", [](const glm::vec3& first, const glm::vec3&) { return first; });
  if (layers.multiple) {
    write("multiple", [](const glm::vec3& first, const glm::vec3& total) { return total - first; });
  }
}

// `mirrored`: a frame in which surfaces show only what they mirror; null: nothing mirrors.
void write_reflection(const Frame* mirrored, ImageLayers& image) {
  const LayerChannels reflection(image, "reflection");
  if (!mirrored) return;
  const FrameParts parts{*mirrored};
  for (std::size_t i = 0; i < mirrored->depth.size(); ++i) {
    reflection.set(i, glm::max(parts.surfaces(i), 0.0f));
  }
}

// The sum of frames, in double.
class FrameSum {
 public:
  explicit FrameSum(const Frame& frame)
      : beauty_(frame.beauty.size()),
        airlight_(frame.airlight.size()),
        background_(frame.airlight.size()) {}
  void add(const Frame& frame) {
    for (std::size_t i = 0; i < beauty_.size(); ++i) {
      beauty_[i] += static_cast<double>(frame.beauty[i]);
    }
    for (std::size_t i = 0; i < airlight_.size(); ++i) {
      airlight_[i] += static_cast<double>(frame.airlight[i]);
      background_[i] += static_cast<double>(frame.background[i]);
    }
  }
  // A and the transmittance are of one of them.
  void replace(const Frame& one, Frame& frame) const {
    frame.background.resize(background_.size());
    frame.transmittance = one.transmittance;
    for (std::size_t i = 0; i < beauty_.size(); ++i) {
      frame.beauty[i] = i % 4 == 3 ? one.beauty[i] : finite(static_cast<float>(beauty_[i]));
    }
    for (std::size_t i = 0; i < airlight_.size(); ++i) {
      frame.airlight[i] = finite(static_cast<float>(airlight_[i]));
      frame.background[i] = finite(static_cast<float>(background_[i]));
    }
  }

 private:
  std::vector<double> beauty_, airlight_, background_;
};

bool wants_sources(const OutputLayers& layers) {
  return layers.lights || layers.environment || layers.emission;
}
bool wants_orders(const OutputLayers& layers) {
  return layers.direct || layers.multiple;
}
bool renders_reflection(const Scene& scene, const Settings& settings, const OutputLayers& layers) {
  return layers.reflection && shows_mirrored_light(scene, settings);
}

}  // namespace

std::vector<std::string> light_layer_names(const std::vector<Light>& lights) {
  std::set<std::string> used{"direct", "multiple", "environment", "emission"};
  std::vector<std::string> names(lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (!is_shining(lights[i])) continue;
    std::string name = lights[i].name.substr(0, max_layer_name);
    if (name.empty()) name = "light_" + std::to_string(i + 1);
    for (char& c : name) {
      const bool is_plain =
          (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
      if (!is_plain) c = '_';
    }
    names[i] = name;
    for (int n = 2; !used.insert(names[i]).second; ++n) names[i] = name + "_" + std::to_string(n);
  }
  return names;
}

std::size_t light_layer_frames(const Scene& scene, const Settings& settings,
                               const OutputLayers& layers) {
  std::size_t frames = wants_orders(layers) ? 2 : 0;
  if (renders_reflection(scene, settings, layers)) ++frames;
  if (!wants_sources(layers)) return frames;
  frames += static_cast<std::size_t>(std::ranges::count_if(scene.lights, is_shining));
  if (is_lit_by_environment(scene)) ++frames;
  if (has_emission(scene)) ++frames;
  return frames;
}

bool add_light_layers(const RenderLit& render_lit, const Scene& scene, const Settings& settings,
                      const OutputLayers& layers, const Job& job, Frame& frame,
                      ImageLayers& image) {
  Settings exact = settings;
  exact.airlight_scale = 1;
  exact.background_apart = true;
  const std::size_t frames = light_layer_frames(scene, settings, layers);
  std::size_t done = 0;
  const auto as_it_is = [](Scene&) {};
  const auto render = [&](const ChangeLight& light, const Settings& with) {
    const auto progress = [&](std::size_t n) {
      return static_cast<double>(n) / static_cast<double>(std::max<std::size_t>(frames, 1));
    };
    const Job part = job.subrange(progress(done), progress(done + 1));
    ++done;
    return render_lit(light, with, part);
  };
  if (wants_sources(layers)) {
    FrameSum sum(frame);
    std::optional<Frame> alone;
    for (const Source& source : light_sources(scene, layers)) {
      alone = render(source.alone, exact);
      if (!alone) return false;
      sum.add(*alone);
      if (source.is_written) write_source(source.name, *alone, image);
    }
    if (alone) sum.replace(*alone, frame);
  } else if (wants_orders(layers)) {
    std::optional<Frame> whole = render(as_it_is, exact);
    if (!whole) return false;
    frame.beauty = std::move(whole->beauty);
    frame.airlight = std::move(whole->airlight);
    frame.transmittance = std::move(whole->transmittance);
    frame.background = std::move(whole->background);
  }
  if (wants_orders(layers)) {
    exact.scattering = Scattering::single;
    const std::optional<Frame> single = render(as_it_is, exact);
    if (!single) return false;
    write_orders(frame, *single, layers, image);
  }
  if (layers.reflection) {
    std::optional<Frame> mirrored;
    if (renders_reflection(scene, settings, layers)) {
      // Attenuated as the picture is.
      Settings alone = settings;
      if (wants_sources(layers) || wants_orders(layers)) alone.airlight_scale = 1;
      alone.mirrored_alone = true;
      mirrored = render(as_it_is, alone);
      if (!mirrored) return false;
    }
    write_reflection(mirrored ? &*mirrored : nullptr, image);
  }
  return true;
}

}  // namespace brume
