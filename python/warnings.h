#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace brume::python {

// Issues them as Python's UserWarning; throws if a filter of Python's makes errors of them.
inline void warn_of(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) != 0) {
      throw pybind11::error_already_set();
    }
  }
}

}  // namespace brume::python
