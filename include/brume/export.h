#pragma once

// What the shared library shows of itself. All else is hidden.
#define BRUME_EXPORT __attribute__((visibility("default")))
