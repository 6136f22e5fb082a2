#include "app/commands/gaussians/add_fog.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "app/commands/gaussian_budget.h"
#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/gaussians/select_command.h"
#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/document/text/words.h"
#include "core/math/rounded.h"

namespace brume {
namespace {

void add_rounded(Document& document, std::vector<Gaussian> gaussians,
                 const GaussianOptics& optics = {}) {
  for (Gaussian& gaussian : gaussians) {
    for (int k = 0; k < 3; ++k) gaussian.center[k] = rounded(gaussian.center[k], 6);
    gaussian.radius = rounded(gaussian.radius, 4);
    gaussian.density = rounded(gaussian.density, 4);
    gaussian.optics = optics;
  }
  add_gaussians(document, gaussians, undo_text("Add"));
}

// Density of even fog with an optical depth over a length.
double density_over(double optical_depth, double length) {
  return optical_depth / length;
}

std::vector<Gaussian> above_ground(std::vector<Gaussian> gaussians, const FindGround& find_ground) {
  std::erase_if(gaussians, [&](const Gaussian& gaussian) {
    const auto ground = find_ground(gaussian.center.x, gaussian.center.z);
    return !ground || gaussian.center.y < *ground;
  });
  return gaussians;
}

// No two of a scene alike.
std::uint64_t seed_of(const Document& document) {
  return document.medium().next_id() + 1;
}

FogNumbers ground_mist(const Document& document, const FogPlace& place) {
  // Gaussians are as thick as the layer; wider ones, which takes fewer.
  const double height = 0.06 * place.size;
  return FogShape{.center = place.target,
                  .size = {1.8 * place.size, height, 1.8 * place.size},
                  .density = density_over(3.0, place.size),
                  .spacing = height,
                  .flatness = 2.5,
                  .jitter = 0.8,
                  .seed = seed_of(document)};
}

void lay(Document& document, const FogNumbers& numbers, const FogPlace& place) {
  add_rounded(document, lay_on_ground(std::get<FogShape>(numbers), place.find_ground));
}

FogNumbers steam(const Document& document, const FogPlace& place) {
  const double width = 0.05 * place.size;
  return FogColumn{.foot = place.target,
                   .height = std::min(0.45 * place.size, 0.9 * place.headroom),
                   .width = width,
                   .spread = 0.3,
                   .lean = {0.06 * place.size, 0.0, 0.02 * place.size},
                   .density = density_over(1.2, width),
                   .count = 40,
                   .turbulence = 0.7,
                   .seed = seed_of(document)};
}

void add_steam(Document& document, const FogNumbers& numbers, const FogPlace& /*place*/) {
  add_rounded(document, rise(std::get<FogColumn>(numbers)));
}

FogNumbers smoke_column(const Document& document, const FogPlace& place) {
  const double height = std::min(1.2 * place.size, 0.9 * place.headroom);
  const double width = 0.06 * place.size;
  return FogColumn{.foot = place.target,
                   .height = height,
                   .width = width,
                   .spread = 0.17,
                   .lean = {0.35 * height, 0.0, -0.1 * height},
                   .density = density_over(1.8, width),
                   .count = 90,
                   .turbulence = 0.6,
                   .seed = seed_of(document)};
}

void add_smoke_column(Document& document, const FogNumbers& numbers, const FogPlace& /*place*/) {
  add_rounded(document, rise(std::get<FogColumn>(numbers)),
              {.albedo = glm::dvec3(0.55, 0.53, 0.5)});
}

FogNumbers haze(const Document& /*document*/, const FogPlace& place) {
  return EvenFog{density_over(0.35, 2.0 * place.size)};
}

void add_haze(Document& document, const FogNumbers& numbers, const FogPlace& /*place*/) {
  const double density =
      document.medium().homogeneous_density() + std::get<EvenFog>(numbers).density;
  set_homogeneous_density(document, density, no_merge);
}

// The cloud's extent and spacing are relative to the place's size; it takes half of
// the light that crosses it.
FogShape cloud_on_ground(const Document& document, const FogPlace& place, double width,
                         double height, double spacing, double jitter) {
  return {.center = place.target + glm::dvec3(0.0, 0.5 * height * place.size, 0.0),
          .size = place.size * glm::dvec3(width, height, width),
          .density = density_over(0.7, width * place.size),
          .spacing = spacing * place.size,
          .jitter = jitter,
          .seed = seed_of(document)};
}

FogNumbers dust(const Document& document, const FogPlace& place) {
  return cloud_on_ground(document, place, 1.8, 0.7, 0.28, 1.0);
}

void add_dust(Document& document, const FogNumbers& numbers, const FogPlace& place) {
  add_rounded(document, above_ground(fill(std::get<FogShape>(numbers)), place.find_ground),
              {.albedo = glm::dvec3(0.95, 0.86, 0.7)});
}

FogNumbers god_rays(const Document& document, const FogPlace& place) {
  return cloud_on_ground(document, place, 2.0, 1.0, 0.4, 0.3);
}

// Even haze, and a sun from beyond if there is none.
void add_god_rays(Document& document, const FogNumbers& numbers, const FogPlace& place) {
  const Scene& scene = document.scene();
  const bool has_sun = std::ranges::any_of(
      scene.lights, [](const Light& light) { return light.on && light.as<light::Directional>(); });
  if (!has_sun) {
    glm::dvec3 to_eye = place.eye - place.target;
    to_eye.y = 0.0;
    const double length = glm::length(to_eye);
    to_eye = length > 0.0 ? to_eye / length : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 aside(to_eye.z, 0.0, -to_eye.x);
    const glm::dvec3 way = glm::normalize(0.7 * to_eye + 0.6 * aside + glm::dvec3(0.0, -0.7, 0.0));
    Lights lights = scene.lights;
    Light sun;
    sun.intensity = glm::dvec3(8.0, 7.0, 5.5);
    sun.kind = light::Directional{{rounded(way.x, 3), rounded(way.y, 3), rounded(way.z, 3)}, 0.5};
    lights.push_back(sun);
    set_scene_part(document, lights, undo_text("Add sun"));
  }
  MediumOptics optics = scene.optics;
  if (optics.anisotropy < 0.3) {
    optics.anisotropy = 0.3;
    set_scene_part(document, optics, undo_text("Set anisotropy"));
  }
  add_rounded(document, above_ground(fill(std::get<FogShape>(numbers)), place.find_ground));
}

constexpr std::array ready_made_fog = std::to_array<FogPreset>({
    {"fog.ground_mist", QT_TRANSLATE_NOOP("Fog", "&Ground Mist"),
     QT_TRANSLATE_NOOP("Fog", "A shallow, patchy layer that lies on the ground in view"),
     ground_mist, lay},
    {"fog.steam", QT_TRANSLATE_NOOP("Fog", "&Steam"),
     QT_TRANSLATE_NOOP("Fog", "A thin white plume from the ground"), steam, add_steam},
    {"fog.smoke_column", QT_TRANSLATE_NOOP("Fog", "S&moke Column"),
     QT_TRANSLATE_NOOP("Fog", "A dense grey column that bends with the wind"), smoke_column,
     add_smoke_column},
    {"fog.haze", QT_TRANSLATE_NOOP("Fog", "&Haze"),
     QT_TRANSLATE_NOOP("Fog", "Thin even fog everywhere: more homogeneous density"), haze,
     add_haze},
    {"fog.dust", QT_TRANSLATE_NOOP("Fog", "&Dust"),
     QT_TRANSLATE_NOOP("Fog", "A thin, uneven, ochre cloud above the ground in view"), dust,
     add_dust},
    {"fog.god_rays", QT_TRANSLATE_NOOP("Fog", "God &Rays"),
     QT_TRANSLATE_NOOP("Fog", "Haze for beams of light, and a sun from beyond if there is none"),
     god_rays, add_god_rays},
});

// A macro of `work` that selects what it adds.
void as_one_step(Document& document, const QString& text, const std::function<void()>& work) {
  const GaussianId first = document.medium().next_id();
  document.undo_stack().beginMacro(text);
  work();
  std::vector<GaussianId> added;
  for (const GaussianId id : document.medium().ids()) {
    if (id >= first) added.push_back(id);
  }
  if (!added.empty()) select_gaussians(document, added);
  document.undo_stack().endMacro();
}

QString problem_of(const FogShape& shape) {
  return fog_problem(shape);
}
QString problem_of(const auto& /*numbers*/) {
  return {};
}

// Numbers that are easy to read and to change.
template <class Numbers>
Numbers tidy(Numbers numbers) {
  constexpr int digits = 3;
  visit_fields<Numbers>([&numbers]<class F>(const F& field) {
    auto& value = field.of(numbers);
    if constexpr (std::is_same_v<typename F::Value, glm::dvec3>) {
      for (int k = 0; k < 3; ++k) value[k] = rounded(value[k], digits);
    } else if constexpr (std::is_same_v<typename F::Value, double>) {
      value = rounded(value, digits);
    }
  });
  return numbers;
}

// Adds fog by numbers that can be adjusted.
template <class Numbers>
void perform(Document& document, const QString& title, const Numbers& numbers, const auto& add) {
  document.last_operation().perform({title, numbers, [&document, add](const std::any& given) {
                                       const auto& wanted = std::any_cast<const Numbers&>(given);
                                       const QString problem = problem_of(wanted);
                                       if (problem.isEmpty()) return add(wanted);
                                       Q_EMIT document.refused(problem);
                                     }});
}

}  // namespace

std::span<const FogPreset> fog_presets() {
  return ready_made_fog;
}

QString fog_problem(const FogShape& shape) {
  if (cell_count(shape) <= max_fog_cells) return {};
  return undo_text("More than %1: make the spacing larger.")
      .arg(gaussians_text(static_cast<std::size_t>(max_fog_cells)));
}

void add_fog_preset(Document& document, const FogPreset& preset, const FogPlace& place) {
  const QString title = QCoreApplication::translate("Fog", preset.title).remove('&');
  const auto add = [&document, &preset, place, title](const auto& numbers) {
    as_one_step(document, undo_text("Add %1").arg(in_sentence(title)),
                [&] { preset.add(document, numbers, place); });
  };
  std::visit([&](const auto& numbers) { perform(document, title, tidy(numbers), add); },
             preset.numbers(document, place));
}

void add_fog_shape(Document& document, const FogShape& shape) {
  const char* const names[] = {QT_TRANSLATE_NOOP("Undo", "Add fog box"),
                               QT_TRANSLATE_NOOP("Undo", "Add fog sphere"),
                               QT_TRANSLATE_NOOP("Undo", "Add height fog")};
  const QString text = undo_text(names[static_cast<int>(shape.kind)]);
  perform(document, text, shape, [&document, text](const FogShape& numbers) {
    const std::vector<Gaussian> gaussians = fill(numbers);
    if (!has_room(document, gaussians.size(), 0)) return;
    as_one_step(document, text, [&] { add_rounded(document, gaussians); });
  });
}

}  // namespace brume
