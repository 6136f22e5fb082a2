#include <string>
#include <utility>

#include "brume/error.h"
#include "brume/fit.h"
#include "brume/version.h"
#include "python/frame.h"
#include "python/interruptible.h"
#include "python/medium.h"
#include "python/scene.h"

namespace py = pybind11;

namespace brume::python {
namespace {

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;

std::pair<std::shared_ptr<ArrayMedium>, double> fit(const Floats& densities, double voxel,
                                                    const glm::dvec3& origin, std::size_t count,
                                                    double max_error, const std::string& shape,
                                                    const py::object& progress) {
  if (densities.ndim() != 3) {
    throw DomainError("densities", "found " + std::to_string(densities.ndim()) +
                                       " dimensions; allowed: 3, for x, y and z");
  }
  if (shape != "ball" && shape != "ellipsoid") {
    throw DomainError("shape", "found '" + shape + "'; allowed: 'ball', 'ellipsoid'");
  }
  const FitShape fit_shape = shape == "ball" ? FitShape::ball : FitShape::ellipsoid;
  const glm::ivec3 size(static_cast<int>(densities.shape(0)), static_cast<int>(densities.shape(1)),
                        static_cast<int>(densities.shape(2)));
  const DensityGrid grid =
      grid_of({densities.data(), static_cast<std::size_t>(densities.size())}, size, voxel, origin);
  const std::optional<Fit> fit = interruptible(
      [&](const std::stop_token& stop, const std::function<void(double)>& fraction) {
        return fit_gaussians(grid, {count, max_error, fit_shape}, stop, fraction);
      },
      progress);
  Medium medium;
  for (const Gaussian& gaussian : fit->gaussians) medium.append(gaussian);
  return {std::make_shared<ArrayMedium>(std::move(medium)), fit->density_error};
}

}  // namespace
}  // namespace brume::python

PYBIND11_MODULE(_brume, module) {
  using namespace brume::python;
  py::register_exception<brume::InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception<brume::DomainError>(module, "DomainError", PyExc_ValueError);
  bind_medium(module);
  bind_scene(module);
  bind_frame(module);
  module.def(
      "fit", fit, py::arg("densities"), py::arg("voxel"), py::arg("origin") = glm::dvec3(0.0),
      py::arg("count") = 500, py::arg("max_error") = 0.0, py::arg("shape") = "ellipsoid",
      py::arg("progress") = py::none(),
      "Fits Gaussians to densities (nx, ny, nz), >= 0 [1/u], on voxels of this size [u], the "
      "first centred at `origin`. At most `count`, fewer if they keep `max_error`, the "
      "relative RMS error; ellipsoids, or 'ball'. Returns the Medium and its error.");
  module.attr("__version__") = brume::version();
}
