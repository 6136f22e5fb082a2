#pragma once

// Marks the symbols that the shared library exports. All else is hidden.
#define BRUME_EXPORT __attribute__((visibility("default")))
