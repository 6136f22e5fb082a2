#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <string>

namespace brume {

using Integers =
    pybind11::array_t<std::int64_t, pybind11::array::c_style | pybind11::array::forcecast>;

// An array of whatever numpy can convert.
inline pybind11::array to_array(const pybind11::object& value) {
  pybind11::array array = pybind11::array::ensure(value);
  if (!array) throw pybind11::error_already_set();
  return array;
}

// An array of integers, or an empty one of any type. Throws TypeError, so that no fraction is lost.
inline Integers to_integers(const char* name, const pybind11::array& array) {
  const char kind = array.dtype().kind();
  if (array.size() > 0 && kind != 'i' && kind != 'u') {
    throw pybind11::type_error(std::string(name) + ": found numbers of the type " +
                               std::string(pybind11::str(array.dtype())) + "; allowed: integers");
  }
  return array;
}

}  // namespace brume
