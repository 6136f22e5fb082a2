#include "app/commands/edit_emitters.h"

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

void add_emitter(Document& document, const glm::dvec3& position, double size) {
  const std::size_t count = document.scene().emitters.size();
  if (count >= limits::emitters) return;
  Emitter emitter;
  emitter.position = position;
  emitter.velocity = {0.0, rounded(0.1 * size, 2), 0.0};
  emitter.spread = rounded(0.03 * size, 2);
  emitter.radius = {rounded(born_radius(size), 2), rounded(0.08 * size, 2)};
  emitter.density = {rounded(0.6 / emitter.radius.x, 2), 0.0};
  // No two of a scene alike.
  emitter.seed = static_cast<std::int64_t>(count) + 1;
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
