#include "python/medium.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brume/edits.h"
#include "brume/error.h"
#include "brume/files.h"
#include "brume/limits.h"
#include "brume/scene.h"
#include "python/integers.h"
#include "python/keyed.h"
#include "python/warnings.h"

namespace py = pybind11;

namespace brume::python {

Medium& ArrayMedium::resizable() {
  if (views_ > 0) {
    PyErr_SetString(PyExc_BufferError,
                    "arrays of this medium exist: no Gaussian can be added or removed until they "
                    "are deleted");
    throw py::error_already_set();
  }
  return medium_;
}

py::capsule ArrayMedium::view_of(const std::shared_ptr<ArrayMedium>& medium) {
  using Owner = std::shared_ptr<ArrayMedium>;
  ++medium->views_;
  return {new Owner(medium), [](void* owner) {
            const std::unique_ptr<Owner> last(static_cast<Owner*>(owner));
            --(*last)->views_;
            (*last)->was_written_ = true;
          }};
}

namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Shared = std::shared_ptr<ArrayMedium>;

Doubles numbers(const Shared& medium, std::span<double> column) {
  return {{column.size()}, {sizeof(double)}, column.data(), ArrayMedium::view_of(medium)};
}

Doubles vectors(const Shared& medium, std::span<glm::dvec3> column) {
  return {{column.size(), std::size_t{3}},
          {sizeof(glm::dvec3), sizeof(double)},
          column.empty() ? nullptr : &column.front().x,
          ArrayMedium::view_of(medium)};
}

std::string shape_of(const Doubles& array) {
  return py::str(array.attr("shape"));
}

// One number for all of `count`, or as many.
std::vector<double> as_many(const char* name, const Doubles& array, std::size_t count) {
  if (array.ndim() == 0) return std::vector<double>(count, *array.data());
  if (array.ndim() != 1 || static_cast<std::size_t>(array.size()) != count) {
    throw DomainError(name, "found the shape " + shape_of(array) + "; allowed: a number, or (" +
                                std::to_string(count) + ",)");
  }
  return {array.data(), array.data() + count};
}

// An array as rows of three.
std::vector<glm::dvec3> rows_of(const char* name, const Doubles& array) {
  if (array.ndim() != 2 || array.shape(1) != 3) {
    throw DomainError(name, "found the shape " + shape_of(array) + "; allowed: (n, 3)");
  }
  std::vector<glm::dvec3> rows(static_cast<std::size_t>(array.shape(0)));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double* row = array.data() + 3 * i;
    rows[i] = {row[0], row[1], row[2]};
  }
  return rows;
}

// `count` rows of three.
std::vector<glm::dvec3> rows_of(const char* name, const Doubles& array, std::size_t count) {
  std::vector<glm::dvec3> rows = rows_of(name, array);
  if (rows.size() != count) {
    throw DomainError(
        name, "found " + std::to_string(rows.size()) + " rows; allowed: " + std::to_string(count));
  }
  return rows;
}

// A unit quaternion for each of `count` Gaussians, from rows of w, x, y, z.
std::vector<glm::dquat> unit_quaternions(const Doubles& array, std::size_t count) {
  if (array.ndim() != 2 || array.shape(1) != 4 ||
      static_cast<std::size_t>(array.shape(0)) != count) {
    throw DomainError("rotations", "found the shape " + shape_of(array) + "; allowed: (" +
                                       std::to_string(count) + ", 4)");
  }
  std::vector<glm::dquat> rotations;
  for (std::size_t i = 0; i < count; ++i) {
    const double* row = array.data() + 4 * i;
    const glm::dquat rotation(row[0], row[1], row[2], row[3]);
    const double length = glm::length(rotation);
    if (!(std::abs(length - 1.0) <= 1e-3)) {
      throw DomainError("rotations[" + std::to_string(i) + "]",
                        "found a quaternion of length " + std::string(py::str(py::float_(length))) +
                            "; allowed: 1");
    }
    rotations.push_back(rotation / length);
  }
  return rotations;
}

// Radii of `count` Gaussians along their own axes.
std::vector<glm::dvec3> axis_radii_of(const Doubles& array, std::size_t count) {
  std::vector<glm::dvec3> radii = rows_of("radii", array, count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [least, greatest] = std::minmax({radii[i].x, radii[i].y, radii[i].z});
    if (!(least > 0.0 && least >= limits::min_stretch * greatest)) {
      throw DomainError("radii[" + std::to_string(i) + "]",
                        "allowed: radii > 0, each at least 1e-4 of the greatest");
    }
  }
  return radii;
}

void append(const Shared& medium, const Doubles& centers, const Doubles& radii,
            const Doubles& densities, const std::optional<Doubles>& rotations) {
  const std::vector<glm::dvec3> rows = rows_of("centers", centers);
  const bool are_balls = radii.ndim() < 2;
  if (are_balls && rotations) {
    throw DomainError("rotations", "allowed: with radii of the shape (n, 3)");
  }
  std::vector<double> radius(rows.size(), 1.0);
  std::vector<glm::dvec3> axis_radii;
  std::vector<glm::dquat> turned(rows.size(), glm::dquat(1.0, 0.0, 0.0, 0.0));
  if (are_balls) {
    radius = as_many("radii", radii, rows.size());
  } else {
    axis_radii = axis_radii_of(radii, rows.size());
    if (rotations) turned = unit_quaternions(*rotations, rows.size());
  }
  const std::vector<double> density = as_many("densities", densities, rows.size());
  Medium added;
  added.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Gaussian gaussian{rows[i], radius[i], density[i]};
    if (!are_balls) gaussian.set_radii(axis_radii[i], turned[i]);
    added.append(gaussian);
  }
  check(added);
  Medium& all = medium->resizable();
  for (std::size_t i = 0; i < added.size(); ++i) all.append(added.gaussian(i));
}

// Indices, also from the end, or a mask of all.
std::vector<std::size_t> indices_of(const py::object& chosen_ones, std::size_t count) {
  const py::array chosen = to_array(chosen_ones);
  std::vector<std::size_t> indices;
  if (chosen.dtype().kind() == 'b') {
    const auto mask = chosen.cast<py::array_t<bool>>();
    if (mask.ndim() != 1 || static_cast<std::size_t>(mask.size()) != count) {
      throw DomainError("indices",
                        "found a mask of another shape; allowed: (" + std::to_string(count) + ",)");
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (mask.at(i)) indices.push_back(i);
    }
    return indices;
  }
  for (const py::handle number : to_integers("indices", chosen).attr("ravel")()) {
    const auto index = number.cast<std::int64_t>();
    const std::int64_t from_start = index < 0 ? index + static_cast<std::int64_t>(count) : index;
    if (from_start < 0 || from_start >= static_cast<std::int64_t>(count)) {
      throw py::index_error("there is no Gaussian " + std::to_string(index));
    }
    indices.push_back(static_cast<std::size_t>(from_start));
  }
  return indices;
}

void remove(const Shared& medium, const py::object& chosen) {
  Medium& all = medium->resizable();
  std::vector<GaussianId> ids;
  for (const std::size_t index : indices_of(chosen, all.size())) ids.push_back(all.ids()[index]);
  std::ranges::sort(ids);
  const auto repeated = std::ranges::unique(ids);
  ids.erase(repeated.begin(), repeated.end());
  MediumEdit::remove(all, ids).apply(all);
}

// A copy: row i for each Gaussian, a vector of `width`.
template <class Row>
Doubles rows_for(const Shared& medium, int width, Row row) {
  const Medium& all = medium->medium();
  Doubles rows({all.size(), static_cast<std::size_t>(width)});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto value = row(all.gaussian(i));
    for (int k = 0; k < width; ++k) rows.mutable_at(i, k) = value[k];
  }
  return rows;
}

// Sets a column for each Gaussian; `set` gets it and its index.
template <class Set>
void change_all(const Shared& medium, Set set) {
  Medium& all = medium->changeable();
  std::vector<Gaussian> after;
  Medium trial;
  for (std::size_t i = 0; i < all.size(); ++i) {
    after.push_back(all.gaussian(i));
    set(after.back(), i);
    trial.append(after.back());
  }
  check(trial);
  // Value by value: the columns stay where arrays know them.
  MediumEdit::change(all, std::vector<GaussianId>(all.ids().begin(), all.ids().end()), after)
      .apply(all);
}

void set_ellipsoids(const Shared& medium, const Doubles& radii, const Doubles& rotations) {
  const std::size_t count = medium->changeable().size();
  const std::vector<glm::dvec3> axis_radii = axis_radii_of(radii, count);
  const std::vector<glm::dquat> turned = unit_quaternions(rotations, count);
  change_all(medium, [&](Gaussian& gaussian, std::size_t i) {
    gaussian.set_radii(axis_radii[i], turned[i]);
  });
}

// Checked, then written into the columns, which stay where arrays know them.
void set_numbers(const Shared& medium, const char* name, const Doubles& array,
                 std::span<double> Medium::Columns::*column) {
  Medium& all = medium->changeable();
  const std::vector<double> values = as_many(name, array, all.size());
  std::ranges::copy(values, (all.columns().*column).begin());
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void bind_medium(py::module_& module) {
  py::class_<ArrayMedium, Shared>(
      module, "Medium",
      "A scattering medium: b(x) = density + sum of densities[i] exp(-|x - centers[i]|^2 / "
      "radii[i]^2) [1/u], or of ellipsoids that have three radii.\n\n"
      "The arrays are the medium itself: nothing is copied, and what is written to them is "
      "rendered next. While one exists, no Gaussian can be added or removed (BufferError).")
      .def(py::init([] { return std::make_shared<ArrayMedium>(); }))
      .def("__len__", [](ArrayMedium& self) { return self.medium().size(); })
      .def("__repr__",
           [](ArrayMedium& self) {
             return "<brume.Medium of " + std::to_string(self.medium().size()) + " Gaussians>";
           })
      .def_property(
          "centers",
          [](const Shared& self) { return vectors(self, self->changeable().columns().centers); },
          [](const Shared& self, const Doubles& array) {
            Medium& all = self->changeable();
            std::ranges::copy(rows_of("centers", array, all.size()), all.columns().centers.begin());
          },
          "(n, 3) float64, writable [u].")
      .def_property(
          "radii",
          [](const Shared& self) { return numbers(self, self->changeable().columns().radii); },
          [](const Shared& self, const Doubles& array) {
            set_numbers(self, "radii", array, &Medium::Columns::radii);
          },
          "(n,) float64, writable, > 0 [u]; of an ellipsoid the greatest, and the others with it.")
      .def_property(
          "densities",
          [](const Shared& self) { return numbers(self, self->changeable().columns().densities); },
          [](const Shared& self, const Doubles& array) {
            set_numbers(self, "densities", array, &Medium::Columns::densities);
          },
          "(n,) float64, writable: scattering coefficients at the centers, >= 0 [1/u].")
      .def_property(
          "albedos",
          [](const Shared& self) {
            return rows_for(self, 3, [](const Gaussian& gaussian) {
              return gaussian.optics.albedo.value_or(glm::dvec3(nan));
            });
          },
          [](const Shared& self, const Doubles& array) {
            const auto rows = rows_of("albedos", array, self->changeable().size());
            change_all(self, [&](Gaussian& gaussian, std::size_t i) {
              const bool is_none = glm::all(glm::isnan(rows[i]));
              gaussian.optics.albedo = is_none ? std::nullopt : std::optional(rows[i]);
            });
          },
          "A copy, (n, 3) float64: single-scattering albedo, RGB in (0, 1]; rows of NaN have that "
          "of the scene. Assign to change it.")
      .def_property(
          "emissions",
          [](const Shared& self) {
            return rows_for(self, 3, [](const Gaussian& g) { return g.optics.emission; });
          },
          [](const Shared& self, const Doubles& array) {
            const auto rows = rows_of("emissions", array, self->changeable().size());
            change_all(self, [&](Gaussian& gaussian, std::size_t i) {
              gaussian.optics.emission = rows[i];
            });
          },
          "A copy, (n, 3) float64: emitted radiance, RGB >= 0 [W/(sr u^2)] per unit of optical "
          "depth. Assign to change it.")
      .def_property_readonly(
          "axis_radii",
          [](const Shared& self) {
            return rows_for(self, 3, [](const Gaussian& gaussian) { return gaussian.radii(); });
          },
          "A copy, (n, 3) float64: of ellipsoids along their own axes, of balls three of one "
          "length [u].")
      .def_property_readonly(
          "rotations",
          [](const Shared& self) {
            return rows_for(self, 4, [](const Gaussian& gaussian) {
              const glm::dquat& q = gaussian.shape.rotation;
              return glm::dvec4(q.w, q.x, q.y, q.z);
            });
          },
          "A copy, (n, 4) float64: unit quaternions w, x, y, z, which turn the own axes of "
          "ellipsoids into those of the scene.")
      .def("set_ellipsoids", set_ellipsoids, py::arg("radii"), py::arg("rotations"),
           "Makes the Gaussians ellipsoids: radii along their own axes (n, 3) [u], each at least "
           "1e-4 of the greatest, and unit quaternions w, x, y, z (n, 4).")
      .def_property(
          "density", [](ArrayMedium& self) { return self.medium().homogeneous_density(); },
          [](ArrayMedium& self, double density) {
            check_unkeyed("density", self.density_keys());
            Medium homogeneous;
            homogeneous.set_homogeneous_density(density);
            check(homogeneous);
            self.changeable().set_homogeneous_density(density);
          },
          "Homogeneous scattering coefficient, >= 0 [1/u].")
      .def(
          "clear_keys", [](ArrayMedium& self) { self.density_keys().clear(); },
          "Removes the keyframes of the homogeneous density, which is then constant.")
      .def("append", append, py::arg("centers"), py::arg("radii"), py::arg("densities"),
           py::arg("rotations") = py::none(),
           "Adds Gaussians: centers (n, 3) [u], radii and densities (n,) or one number for all. "
           "Radii (n, 3) make ellipsoids, turned by rotations (n, 4): unit quaternions w, x, y, z.")
      .def("remove", remove, py::arg("indices"),
           "Removes the Gaussians at these indices, or where a mask (n,) of bool is true.")
      .def(
          "save",
          [](ArrayMedium& self, const std::filesystem::path& file, double voxel) {
            const Medium& medium = self.medium();
            std::string extension = file.extension().string();
            std::ranges::transform(extension, extension.begin(),
                                   [](unsigned char c) { return std::tolower(c); });
            if (extension == ".vdb") {
              save_volume(medium, voxel, file);
              return;
            }
            if (extension != ".ply" && extension != ".csv") {
              throw DomainError(
                  "file", "found the extension '" + extension + "'; allowed: .ply, .csv, .vdb");
            }
            check(medium);
            save_gaussians(medium.gaussians(), file);
          },
          py::arg("file"), py::arg("voxel") = 0.1,
          "Writes .ply or .csv, losslessly, or .vdb: the density on voxels of this size [u].");
  module.def(
      "load_medium",
      [](const std::filesystem::path& file) {
        Medium medium;
        std::vector<std::string> warnings;
        std::vector<Gaussian> gaussians = load_gaussians(file, {}, &warnings);
        warn_of(warnings);
        for (Gaussian& gaussian : gaussians) {
          gaussian.group = 0;  // of what scene?
          medium.append(gaussian);
        }
        return std::make_shared<ArrayMedium>(std::move(medium));
      },
      py::arg("file"), "Gaussians of a .ply or .csv file.");
}

}  // namespace brume::python
