#include "app/commands/objects/edit_emitters.h"

#include <algorithm>

#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "brume/error.h"
#include "brume/limits.h"
#include "core/math/rounded.h"
#include "core/scene/animation/particles.h"

namespace brume {
namespace {

Keys<double>::const_iterator first_above_zero(const Keys<double>& keys) {
  return std::ranges::find_if(keys, [](const Key<double>& key) { return key.value > 0.0; });
}

// The keyframes of a rate that is 0 outside a span; none if it always is the same.
Keys<double> span_keys(double rate, const EmissionSpan& span) {
  Keys<double> keys;
  const auto add = [&keys](double time, double value) {
    keys.push_back({.time = time, .value = value, .interpolation = Interpolation::constant});
  };
  if (span.start > 0.0) add(0.0, 0.0);
  if (span.start > 0.0 || span.end) add(span.start, rate);
  if (span.end) add(*span.end, 0.0);
  return keys;
}

}  // namespace

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
  // No two emitters of a scene have the same particles.
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

std::optional<EmissionSpan> emission_span(const Emitter& emitter) {
  const Keys<double>& keys = emitter.keys.rate;
  if (keys.empty()) return emitter.rate > 0.0 ? std::optional(EmissionSpan{}) : std::nullopt;
  const auto first = first_above_zero(keys);
  if (first == keys.end()) return std::nullopt;
  EmissionSpan span{.start = first->time};
  if (keys.back().value == 0.0) span.end = keys.back().time;
  return keys == span_keys(first->value, span) ? std::optional(span) : std::nullopt;
}

void set_emission_span(Emitter& emitter, EmissionSpan span) {
  if (!emission_span(emitter)) return;
  constexpr double min_length = 1e-3;  // seconds, so that keys stay apart
  constexpr double last_end = domain::seconds.max_value;
  span.start = emission_time.nearest(span.start);
  if (span.start < min_length) span.start = 0.0;
  if (span.end) span.end = std::clamp(*span.end, span.start + min_length, last_end);
  Keys<double>& keys = emitter.keys.rate;
  const double rate = keys.empty() ? emitter.rate : first_above_zero(keys)->value;
  keys = span_keys(rate, span);
  if (keys.empty()) emitter.rate = rate;
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
