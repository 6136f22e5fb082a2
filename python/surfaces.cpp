#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "brume/error.h"
#include "brume/files.h"
#include "brume/limits.h"
#include "brume/mesh_arrays.h"
#include "core/scene/fields/surface_fields.h"
#include "python/fields.h"
#include "python/integers.h"
#include "python/keyed.h"
#include "python/parts.h"
#include "python/warnings.h"

namespace py = pybind11;

namespace brume::python {
namespace {

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;

// A mesh of points (n, 3) and triangles (m, 3), with flat normals.
std::shared_ptr<Surface> mesh_surface(const Floats& points, const py::object& indices) {
  const Integers triangles = to_integers("triangles", to_array(indices));
  if (points.ndim() != 2 || points.shape(1) != 3 || triangles.ndim() != 2 ||
      triangles.shape(1) != 3) {
    throw DomainError("points, triangles", "allowed: arrays of the shapes (n, 3) and (m, 3)");
  }
  // Each triangle has vertices of its own.
  MeshArrays arrays;
  for (py::ssize_t i = 0; i < triangles.shape(0); ++i) {
    std::array<glm::vec3, 3> corners;
    for (py::ssize_t k = 0; k < 3; ++k) {
      const auto index = static_cast<py::ssize_t>(triangles.at(i, k));
      if (index < 0 || index >= points.shape(0)) {
        throw DomainError("triangles[" + std::to_string(i) + "]",
                          "there is no point " + std::to_string(index));
      }
      glm::vec3& corner = corners[static_cast<std::size_t>(k)];
      for (int c = 0; c < 3; ++c) {
        corner[c] = points.at(index, c);
        if (!(std::abs(corner[c]) <= limits::coordinate)) {
          throw DomainError("points[" + std::to_string(index) + "]",
                            "allowed: numbers from -1e12 to 1e12");
        }
      }
    }
    const glm::dvec3 a(corners[0]);
    const glm::dvec3 across = glm::cross(glm::dvec3(corners[1]) - a, glm::dvec3(corners[2]) - a);
    const double area = glm::length(across);
    if (!(area > 0.0)) continue;
    const glm::vec3 normal(across / area);
    const auto first = static_cast<unsigned>(arrays.points.size());
    arrays.triangles.push_back({first, first + 1, first + 2});
    for (const glm::vec3& corner : corners) {
      arrays.points.push_back(corner);
      arrays.normals.push_back(normal);
    }
  }
  if (arrays.triangles.empty())
    throw DomainError("triangles", "allowed: at least one with an area");
  auto surface = std::make_shared<Surface>();
  surface->mesh = to_mesh(arrays);
  return surface;
}

std::shared_ptr<Surface> primitive_surface(const std::string& shape, const glm::dvec3& size) {
  constexpr std::array names{"plane", "box", "sphere", "cylinder"};
  const auto name = std::ranges::find(names, shape);
  if (name == names.end()) {
    throw DomainError("shape", "found '" + shape + "'; allowed: plane, box, sphere, cylinder");
  }
  for (int k = 0; k < 3; ++k) {
    if (!(size[k] >= limits::min_length && size[k] <= limits::max_length)) {
      throw DomainError("size", "allowed: three numbers from 1e-12 to 1e12");
    }
  }
  auto surface = std::make_shared<Surface>();
  surface->primitive = Primitive{static_cast<Primitive::Shape>(name - names.begin()), size};
  surface->mesh = mesh_of(*surface->primitive);
  return surface;
}

AlphaMode alpha_mode(const std::string& name) {
  constexpr std::array names{"opaque", "cutout", "blend"};
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    throw DomainError("alpha", "found '" + name + "'; allowed: opaque, cutout, blend");
  }
  return static_cast<AlphaMode>(found - names.begin());
}

void set_material(Surface& surface, const Material& material) {
  check_unkeyed("reflectance", surface.keys.reflectance);
  check_unkeyed("specular", surface.keys.specular);
  check_unkeyed("exponent", surface.keys.exponent);
  surface.material = material;
}

}  // namespace

void bind_surface(py::module_& module) {
  py::class_<Surface, std::shared_ptr<Surface>> surface(
      module, "Surface",
      "A mesh in the scene: world = translate + rotate * (scale * mesh). `rotate` is a unit "
      "quaternion (w, x, y, z).");
  def_keyed(surface, "translate", &Surface::translate, &SurfaceKeys::translate, "[u]");
  def_keyed(surface, "scale", &Surface::scale, &SurfaceKeys::scale, "> 0");
  def_clear_keys(surface);
  def_values<Surface>(surface);
  surface.def("__copy__", copied<Surface>)
      .def("__deepcopy__", [](const Surface& self, const py::dict&) { return self; })
      .def_static(
          "load",
          [](const std::filesystem::path& mesh) {
            std::vector<std::string> warnings;
            auto loaded = std::make_shared<Surface>(load_surface(mesh, &warnings));
            warn_of(warnings);
            return loaded;
          },
          py::arg("mesh"), "A mesh file: .obj, .ply, .stl or .off.")
      .def_static("primitive", primitive_surface, py::arg("shape"),
                  py::arg("size") = glm::dvec3(1.0),
                  "'plane', 'box', 'sphere' or 'cylinder' around the origin, y up.")
      .def_static("mesh", mesh_surface, py::arg("points"), py::arg("triangles"),
                  "Points (n, 3) [u] and triangles (m, 3), shaded flat. It cannot be saved.")
      .def_readwrite("name", &Surface::name)
      .def(
          "scatter",
          [](Surface& self, const std::string& over, double density, std::int64_t seed,
             const glm::dvec2& scale, double turn) {
            self.copies = Copies{.scatter = {over, density, seed, scale, turn}};
          },
          py::arg("over"), py::arg("density"), py::arg("seed") = std::int64_t{0},
          py::arg("scale") = glm::dvec2(1.0), py::arg("turn") = 0.0,
          "Copies of it at random points of the surface of that name: so many per u^2, of a scale "
          "between two, turned by so many degrees at most.")
      .def(
          "load_copies",
          [](Surface& self, const std::filesystem::path& file) {
            std::vector<std::string> warnings;
            self.copies = load_copies(file, &warnings);
            warn_of(warnings);
          },
          py::arg("file"), "Copies of it as a file places them: PLY or CSV.")
      .def(
          "clear_copies", [](Surface& self) { self.copies.reset(); }, "It stands alone.")
      .def_property(
          "rotate",
          [](const Surface& self) {
            return std::tuple(self.rotate.w, self.rotate.x, self.rotate.y, self.rotate.z);
          },
          [](Surface& self, const std::tuple<double, double, double, double>& q) {
            const glm::dquat rotation(std::get<0>(q), std::get<1>(q), std::get<2>(q),
                                      std::get<3>(q));
            // Within rounding, as in a file.
            if (!(std::abs(glm::length(rotation) - 1.0) < 1e-3)) {
              throw DomainError("rotate", "allowed: a unit quaternion, (w, x, y, z)");
            }
            check_unkeyed("rotate", self.keys.rotate);
            self.rotate = glm::normalize(rotation);
          })
      .def_property(
          "reflectance", [](const Surface& self) { return self.material.reflectance; },
          [](Surface& self, const glm::dvec3& value) {
            check_unkeyed("reflectance", self.keys.reflectance);
            self.material.reflectance = value;
          },
          "Diffuse albedo, RGB in [0, 1], of diffuse and phong materials.")
      .def(
          "set_diffuse",
          [](Surface& self, const glm::dvec3& reflectance) {
            set_material(self, {.type = Material::Type::diffuse, .reflectance = reflectance});
          },
          py::arg("reflectance"))
      .def(
          "set_phong",
          [](Surface& self, const glm::dvec3& reflectance, const glm::dvec3& specular,
             double exponent) {
            set_material(self, {.type = Material::Type::phong,
                                .reflectance = reflectance,
                                .specular = specular,
                                .exponent = exponent});
          },
          py::arg("reflectance"), py::arg("specular"), py::arg("exponent"))
      .def(
          "set_metallic_roughness",
          [](Surface& self, const glm::dvec3& base_color, double metallic, double roughness,
             const glm::dvec3& emissive, const std::string& alpha, double opacity,
             double alpha_cutoff, const glm::dvec3& transmission) {
            Material material{.type = Material::Type::metallic_roughness};
            MetallicRoughness& values = material.metallic_roughness;
            values.base_color = base_color;
            values.metallic = metallic;
            values.roughness = roughness;
            values.emissive = emissive;
            values.alpha = alpha_mode(alpha);
            values.opacity = opacity;
            values.alpha_cutoff = alpha_cutoff;
            values.transmission = transmission;
            set_material(self, material);
          },
          py::arg("base_color"), py::arg("metallic") = 0.0, py::arg("roughness") = 0.5,
          py::arg("emissive") = glm::dvec3(0.0), py::arg("alpha") = "opaque",
          py::arg("opacity") = 1.0, py::arg("alpha_cutoff") = 0.5,
          py::arg("transmission") = glm::dvec3(0.0),
          "glTF's material; emissive [W/(sr u^2)]; alpha 'opaque', 'cutout' or 'blend'.");
}

}  // namespace brume::python
