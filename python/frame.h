#pragma once

#include "python/vectors.h"

namespace brume::python {

void bind_frame(pybind11::module_& module);

}  // namespace brume::python
