#pragma once

namespace brume::gl {

// What is to fail, so that tests see what comes of it on machines where nothing does.
struct Failures {
  bool memory = false;   // of whatever is allocated
  bool shader = false;   // of whatever is compiled
  bool context = false;  // it is lost
};

inline Failures& failures() {
  static Failures injected;
  return injected;
}

}  // namespace brume::gl
