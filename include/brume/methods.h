#pragma once

#include "brume/export.h"

namespace brume {

// How the light in the medium is computed; resources/manual/airlight.md compares them.
enum class AirlightMethod {
  auto_,      // the cheapest settings of `sliced` that keep max_error, measured on the frame itself
  paper,      // the paper's approximation, as published
  sliced,     // exact optical depths per slice of the ray, light from a table
  reference,  // the converged integral
  path,       // path tracing: all orders of scattering, surfaces included
};

// Which orders of scattering are rendered.
enum class Scattering { single, multiple };

// Render device: auto_ selects gl if there is a GPU; software OpenGL is used only on request, since
// cpu is faster.
enum class Backend { auto_, cpu, gl };

// The names of the command line, without parameters.
BRUME_EXPORT const char* to_string(AirlightMethod method);
BRUME_EXPORT const char* to_string(Scattering scattering);

}  // namespace brume
