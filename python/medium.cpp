#include "python/medium.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "brume/edits.h"
#include "brume/error.h"
#include "brume/files.h"
#include "brume/scene.h"
#include "python/integers.h"

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

// Of rows of three.
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

void append(const Shared& medium, const Doubles& centers, const Doubles& radii,
            const Doubles& densities) {
  const std::vector<glm::dvec3> rows = rows_of("centers", centers);
  const std::vector<double> radius = as_many("radii", radii, rows.size());
  const std::vector<double> density = as_many("densities", densities, rows.size());
  Medium added;
  added.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) added.append({rows[i], radius[i], density[i]});
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

// Row i for each Gaussian.
template <class Row>
Doubles optics_rows(const Shared& medium, Row row) {
  const Medium& all = medium->medium();
  Doubles rows({all.size(), std::size_t{3}});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const glm::dvec3 value = row(all.optics(i));
    for (int k = 0; k < 3; ++k) rows.mutable_at(i, k) = value[k];
  }
  return rows;
}

template <class Set>
void set_optics(const Shared& medium, const char* name, const Doubles& array, Set set) {
  const std::vector<glm::dvec3> rows = rows_of(name, array);
  Medium& all = medium->changeable();
  if (rows.size() != all.size()) {
    throw DomainError(name, "found " + std::to_string(rows.size()) +
                                " rows; allowed: " + std::to_string(all.size()));
  }
  std::vector<Gaussian> after;
  Medium trial;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    after.push_back(all.gaussian(i));
    set(after.back().optics, rows[i]);
    trial.append(after.back());
  }
  check(trial);
  // Value by value: the columns stay where arrays know them.
  MediumEdit::change(all, std::vector<GaussianId>(all.ids().begin(), all.ids().end()), after)
      .apply(all);
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
      "radii[i]^2) [1/u].\n\n"
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
            const std::vector<glm::dvec3> rows = rows_of("centers", array);
            Medium& all = self->changeable();
            if (rows.size() != all.size()) {
              throw DomainError("centers", "found " + std::to_string(rows.size()) +
                                               " rows; allowed: " + std::to_string(all.size()));
            }
            std::ranges::copy(rows, all.columns().centers.begin());
          },
          "(n, 3) float64, writable [u].")
      .def_property(
          "radii",
          [](const Shared& self) { return numbers(self, self->changeable().columns().radii); },
          [](const Shared& self, const Doubles& array) {
            set_numbers(self, "radii", array, &Medium::Columns::radii);
          },
          "(n,) float64, writable, > 0 [u].")
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
            return optics_rows(self, [](const GaussianOptics& optics) {
              return optics.albedo.value_or(glm::dvec3(nan));
            });
          },
          [](const Shared& self, const Doubles& rows) {
            set_optics(self, "albedos", rows, [](GaussianOptics& optics, const glm::dvec3& row) {
              const bool is_none = std::isnan(row.x) && std::isnan(row.y) && std::isnan(row.z);
              optics.albedo = is_none ? std::nullopt : std::optional(row);
            });
          },
          "A copy, (n, 3) float64: single-scattering albedo, RGB in (0, 1]; rows of NaN have that "
          "of the scene. Assign to change it.")
      .def_property(
          "emissions",
          [](const Shared& self) {
            return optics_rows(self, [](const GaussianOptics& optics) { return optics.emission; });
          },
          [](const Shared& self, const Doubles& rows) {
            set_optics(self, "emissions", rows, [](GaussianOptics& optics, const glm::dvec3& row) {
              optics.emission = row;
            });
          },
          "A copy, (n, 3) float64: emitted radiance, RGB >= 0 [W/(sr u^2)] per unit of optical "
          "depth. Assign to change it.")
      .def_property(
          "density", [](ArrayMedium& self) { return self.medium().homogeneous_density(); },
          [](ArrayMedium& self, double density) {
            Medium homogeneous;
            homogeneous.set_homogeneous_density(density);
            check(homogeneous);
            self.changeable().set_homogeneous_density(density);
          },
          "Homogeneous scattering coefficient, >= 0 [1/u].")
      .def("append", append, py::arg("centers"), py::arg("radii"), py::arg("densities"),
           "Adds Gaussians: centers (n, 3) [u], radii and densities (n,) or one number for all.")
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
            std::vector<Gaussian> gaussians;
            for (std::size_t i = 0; i < medium.size(); ++i) gaussians.push_back(medium.gaussian(i));
            save_gaussians(gaussians, file);
          },
          py::arg("file"), py::arg("voxel") = 0.1,
          "Writes .ply or .csv, losslessly, or .vdb: the density on voxels of this size [u].");
  module.def(
      "load_medium",
      [](const std::filesystem::path& file) {
        Medium medium;
        for (Gaussian gaussian : load_gaussians(file)) {
          gaussian.group = 0;  // of what scene?
          medium.append(gaussian);
        }
        return std::make_shared<ArrayMedium>(std::move(medium));
      },
      py::arg("file"), "Gaussians of a .ply or .csv file.");
}

}  // namespace brume::python
