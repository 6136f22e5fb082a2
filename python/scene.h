#pragma once

#include <memory>

#include "brume/files.h"
#include "python/medium.h"
#include "python/parts.h"

namespace brume::python {

// A scene whose parts Python holds and changes: what list and what medium they are in does not
// matter to their lives. They are put together to be rendered or saved.
class SharedScene {
 public:
  explicit SharedScene(SceneFile file = {});

  // A copy of all parts, not checked. Throws Python's TypeError.
  [[nodiscard]] SceneFile assembled() const;
  // The same without the medium's Gaussians.
  [[nodiscard]] SceneFile without_gaussians() const;
  // Takes a copy of another medium's Gaussians, without their groups; they get ids that none had.
  void set_medium(ArrayMedium& other);

  std::shared_ptr<ArrayMedium> medium;
  std::shared_ptr<KeyedCamera> camera;
  std::shared_ptr<Environment> environment;  // null: none
  pybind11::list lights;
  pybind11::list surfaces;
  SceneFile rest;  // without the above
};

void bind_scene(pybind11::module_& module);

}  // namespace brume::python
