#pragma once

namespace brume::gl {

// Failure injection for tests.
struct Failures {
  bool memory = false;   // every allocation fails
  bool shader = false;   // every compilation fails
  bool context = false;  // the context is lost
};

inline Failures& failures() {
  static Failures injected;
  return injected;
}

}  // namespace brume::gl
