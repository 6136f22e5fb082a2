#include "app/document/time/scene_at.h"

#include "brume/at_time.h"
#include "brume/error.h"

namespace brume {

Scene scene_at(const Scene& animation, double time, QString& problem) {
  try {
    return evaluate_at(animation, time);
  } catch (const InputError& error) {
    problem = QString::fromUtf8(error.what());
  }
  Scene without = animation;
  without.sequences.clear();
  return evaluate_at(without, time);
}

}  // namespace brume
