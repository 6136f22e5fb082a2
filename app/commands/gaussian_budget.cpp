#include "app/commands/gaussian_budget.h"

#include <QCoreApplication>
#include <QLocale>

#include "app/document/document.h"
#include "brume/at_time.h"
#include "core/scene/animation/particles.h"

namespace brume {

std::size_t gaussian_count(const ScenePart& part) {
  std::size_t count = 0;
  if (const auto* emitters = std::get_if<Emitters>(&part)) {
    for (const Emitter& emitter : *emitters) count += max_particles(emitter);
  }
  if (const auto* sequences = std::get_if<Sequences>(&part)) {
    for (const MediumSequence& sequence : *sequences) count += gaussian_count(sequence);
  }
  return count;
}

bool has_room(Document& document, std::size_t added, std::size_t removed) {
  if (added <= removed) return true;
  const std::size_t count = gaussian_count(document.scene()) + added - removed;
  if (count <= limits::gaussians) return true;
  const QLocale english(QLocale::English);
  const QString text = QCoreApplication::translate(
      "Undo", "The scene would have %1 Gaussians, including emitters and sequences; allowed: %2");
  Q_EMIT document.refused(text.arg(english.toString(static_cast<qulonglong>(count)),
                                   english.toString(static_cast<qulonglong>(limits::gaussians))));
  return false;
}

}  // namespace brume
