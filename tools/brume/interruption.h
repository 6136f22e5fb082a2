#pragma once

#include <optional>
#include <stop_token>
#include <utility>

namespace brume {

// Thrown where Ctrl-C has stopped the work.
struct Interrupted {};

// Requested by the first SIGINT.
std::stop_token interruption();

// Throws Interrupted after a SIGINT.
void check_interrupted();

// The result of long work, nothing if it was stopped.
template <class T>
T finished(std::optional<T> result) {
  if (!result) throw Interrupted();
  return std::move(*result);
}

// While one lives, SIGINT requests the stop above, so that the work ends by itself and cleans up.
// Work that does not listen is ended half a second later, and by a second SIGINT at once, as SIGINT
// would end the program without all this.
class InterruptionWatch {
 public:
  InterruptionWatch();
  ~InterruptionWatch();
  InterruptionWatch(const InterruptionWatch&) = delete;
  InterruptionWatch& operator=(const InterruptionWatch&) = delete;
};

// Ends the program as SIGINT does, so that a shell, for which it is exit code 130, ends the script
// too.
[[noreturn]] void end_interrupted();

}  // namespace brume
