#pragma once

#include "brume/scene.h"
#include "python/vectors.h"

namespace brume::python {

// A camera with its keyframes.
struct KeyedCamera : Camera {
  CameraKeys keys;
};

template <class T>
T copied(const T& value) {
  return value;
}

// The parts of a scene that Python holds.
void bind_camera(pybind11::module_& module);
void bind_environment(pybind11::module_& module);
void bind_light(pybind11::module_& module);
void bind_surface(pybind11::module_& module);

}  // namespace brume::python
