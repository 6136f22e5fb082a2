#include "app/commands/edit_emitters.h"

#include <algorithm>

#include "app/commands/edit_medium.h"
#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "brume/error.h"
#include "brume/limits.h"
#include "core/math/rounded.h"
#include "core/scene/animation/particles.h"

namespace brume {

QString emitter_name(const Emitter& emitter, std::size_t index) {
  return emitter.name.empty() ? undo_text("emitter %1").arg(index + 1)
                              : QString::fromStdString(emitter.name);
}

Emitter new_emitter(const Scene& scene, const glm::dvec3& position, double size) {
  Emitter emitter;
  emitter.position = position;
  emitter.velocity = {0.0, rounded(0.1 * size, 2), 0.0};
  emitter.spread = rounded(0.03 * size, 2);
  emitter.radius = {rounded(born_radius(size), 2), rounded(0.08 * size, 2)};
  emitter.density = {rounded(0.6 / emitter.radius.x, 2), 0.0};
  // No two of a scene alike.
  emitter.seed = static_cast<std::int64_t>(scene.emitters.size()) + 1;
  return emitter;
}

void add_emitter(Document& document, const glm::dvec3& position, double size) {
  const std::size_t count = document.scene().emitters.size();
  if (count >= limits::emitters) return;
  const Emitter emitter = new_emitter(document.scene(), position, size);
  const QString text = undo_text("Add %1").arg(emitter_name(emitter, count));
  document.last_operation().perform(
      {text, emitter, [&document, text](const std::any& numbers) {
         Emitters emitters = document.scene().emitters;
         emitters.push_back(std::any_cast<Emitter>(numbers));
         const std::size_t index = emitters.size() - 1;
         set_scene_part(document, std::move(emitters), text);
         document.set_active_emitter(index);
         document.set_object(ObjectRef{ObjectRef::Kind::emitter, index});
       }});
}

EmissionSpan emission_span(const Emitter& emitter) {
  const Keys<double>& keys = emitter.keys.rate;
  EmissionSpan span;
  const auto emits = [](const Key<double>& key) { return key.value > 0.0; };
  const auto first = std::ranges::find_if(keys, emits);
  if (first == keys.end()) return span;
  if (first != keys.begin()) span.start = first->time;
  if (keys.back().value == 0.0) span.end = keys.back().time;
  return span;
}

void set_emission_span(Emitter& emitter, const EmissionSpan& span) {
  Keys<double> keys = emitter.keys.rate;
  const auto emits = [](const Key<double>& key) { return key.value > 0.0; };
  // What it does between stays; a rate that never was above 0 is that of the emitter.
  keys.erase(keys.begin(), std::ranges::find_if(keys, emits));
  while (!keys.empty() && keys.back().value == 0.0) keys.pop_back();
  const bool is_plain = keys.size() < 2;
  Key<double> first = keys.empty() ? Key<double>{.value = emitter.rate} : keys.front();
  const double rate = first.value;
  constexpr double min_length = 1e-3;  // seconds, so that keys stay apart
  std::erase_if(keys, [&span](const Key<double>& key) {
    return key.time < span.start + min_length || (span.end && key.time > *span.end - min_length);
  });
  const Interpolation held = Interpolation::constant;
  const bool has_start = span.start > 0.0;
  const bool was_first = first.time < span.start + min_length;
  if (is_plain) keys.clear();
  if (has_start || (is_plain ? span.end.has_value() : was_first)) {
    first.time = span.start;
    if (is_plain) first.interpolation = held;
    keys.insert(keys.begin(), first);
  }
  if (has_start) keys.insert(keys.begin(), {.time = 0.0, .value = 0.0, .interpolation = held});
  if (span.end) {
    keys.back().interpolation = held;
    keys.push_back({.time = std::max(*span.end, span.start + min_length), .interpolation = held});
  }
  emitter.keys.rate = std::move(keys);
  if (emitter.keys.rate.empty()) emitter.rate = rate;
}

void freeze_particles(Document& document, double time) {
  std::vector<Gaussian> frozen;
  for (const Emitter& emitter : document.scene().emitters) {
    if (!emitter.visible) continue;
    const auto particles = particles_at(emitter, time);
    frozen.insert(frozen.end(), particles.begin(), particles.end());
  }
  try {
    for (const MediumSequence& sequence : document.scene().sequences) {
      const auto gaussians = sequence_at(sequence, time, document.scene().optics.albedo);
      frozen.insert(frozen.end(), gaussians.begin(), gaussians.end());
    }
  } catch (const InputError& error) {
    Q_EMIT document.refused(QString::fromUtf8(error.what()));
    return;
  }
  add_gaussians(document, frozen, undo_text("Bake"));
}

}  // namespace brume
