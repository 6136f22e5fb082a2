#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// Vectors of GLM are tuples in Python: what cannot be written through cannot be written in vain.
// Any sequence of as many numbers becomes one.
namespace pybind11::detail {

template <int n>
struct type_caster<glm::vec<n, double>> {
  using Vector = glm::vec<n, double>;
  PYBIND11_TYPE_CASTER(Vector, const_name("tuple[float, ...]"));

  bool load(handle source, bool) {
    if (!isinstance<sequence>(source) || isinstance<str>(source)) return false;
    const auto values = reinterpret_borrow<sequence>(source);
    if (values.size() != n) return false;
    for (int k = 0; k < n; ++k) {
      make_caster<double> number;
      if (!number.load(values[static_cast<std::size_t>(k)], true)) return false;
      value[k] = cast_op<double>(number);
    }
    return true;
  }

  static handle cast(const Vector& vector, return_value_policy, handle) {
    tuple result(n);
    for (int k = 0; k < n; ++k) result[static_cast<std::size_t>(k)] = float_(vector[k]);
    return result.release();
  }
};

}  // namespace pybind11::detail
