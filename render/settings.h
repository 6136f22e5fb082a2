#pragma once

namespace brume {

enum class AirlightMethod {
  paper,      // the paper's approximation, as published
  reference,  // the integral itself, converged
};

// How a frame is rendered; what is rendered is the Scene's.
struct Settings {
  AirlightMethod airlight = AirlightMethod::paper;

  // Worker threads; 0 takes all.
  int threads = 0;

  // `reference`: the relative tolerance of each ray's quadrature.
  double reference_tolerance = 1e-4;

  // `paper`: SIMD in float, or the plain double path that the tests hold it against.
  enum class Arithmetic { simd_float, plain_double };
  Arithmetic arithmetic = Arithmetic::simd_float;

  bool operator==(const Settings&) const = default;
};

const char* to_string(AirlightMethod method);

}  // namespace brume
