#include "python/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "brume/at_time.h"
#include "brume/edits.h"
#include "brume/error.h"
#include "brume/limits.h"
#include "brume/mesh_arrays.h"
#include "python/integers.h"
#include "python/keyed.h"
#include "python/warnings.h"

namespace py = pybind11;

namespace brume::python {
namespace {

template <class T>
py::list listed(std::vector<T>& values) {
  py::list list;
  for (T& value : values) list.append(std::make_shared<T>(std::move(value)));
  values.clear();
  return list;
}

template <class T>
std::vector<T> values_of(const py::list& list, const char* name, const char* type) {
  std::vector<T> values;
  for (const py::handle element : list) {
    if (!py::isinstance<T>(element)) {
      throw py::type_error(std::string(name) + "[" + std::to_string(values.size()) + "]: found a " +
                           std::string(py::str(py::type::of(element).attr("__name__"))) +
                           "; allowed: a brume." + type);
    }
    values.push_back(*element.cast<std::shared_ptr<T>>());
  }
  return values;
}

template <class T>
T copied(const T& value) {
  return value;
}

std::shared_ptr<SharedScene> load(const std::filesystem::path& file) {
  std::vector<std::string> warnings;
  SceneFile loaded = [&] {
    const py::gil_scoped_release release;
    return load_scene_file(file, &warnings);
  }();
  warn_of(warnings);
  return std::make_shared<SharedScene>(std::move(loaded));
}

// The direction of a light that has one.
glm::dvec3* direction_of(Light& light) {
  if (light.spot) return &light.spot->direction;
  if (light.directional) return &light.directional->direction;
  if (light.area) return &light.area->direction;
  return nullptr;
}

const char* kind_of(const Light& light) {
  if (light.spot) return "spot";
  if (light.directional) return "directional";
  if (!light.area) return "point";
  switch (light.area->shape) {
    case AreaLight::Shape::rectangle:
      return "rectangle";
    case AreaLight::Shape::disk:
      return "disk";
    case AreaLight::Shape::sphere:
      break;
  }
  return "sphere";
}

// A value that only some kinds of light have.
template <class Class, class Find, class Key>
void def_of_some(Class& bound, const char* name, Find find, Keys<Key> LightKeys::*keys,
                 const char* doc) {
  const auto found = [ name, find ](Light & light) -> auto& {
    auto* value = find(light);
    if (value == nullptr) {
      throw py::attribute_error(std::string("a ") + kind_of(light) + " light has no " + name);
    }
    return *value;
  };
  using Value = std::remove_reference_t<decltype(found(std::declval<Light&>()))>;
  bound.def_property(
      name, [found](Light& light) { return found(light); },
      [=](Light& light, const Value& value) {
        Value& member = found(light);
        check_unkeyed(name, light.keys.*keys);
        member = value;
      },
      doc);
}

void bind_camera(py::module_& module) {
  py::class_<KeyedCamera, std::shared_ptr<KeyedCamera>> camera(module, "Camera",
                                                               "A pinhole, or a thin lens.");
  camera
      .def(py::init([](const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up,
                       double vertical_fov, double aperture,
                       const std::optional<double>& focus_distance) {
             return KeyedCamera{{eye, target, up, vertical_fov, aperture, focus_distance}, {}};
           }),
           py::arg("eye") = Camera{}.eye, py::arg("target") = Camera{}.target,
           py::arg("up") = Camera{}.up, py::arg("vertical_fov") = Camera{}.vertical_fov,
           py::arg("aperture") = 0.0, py::arg("focus_distance") = py::none())
      .def("__copy__", copied<KeyedCamera>)
      .def("__deepcopy__", [](const KeyedCamera& self, const py::dict&) { return self; })
      .def_readwrite("up", &KeyedCamera::up);
  def_keyed(camera, "eye", &Camera::eye, &CameraKeys::eye, "[u]");
  def_keyed(camera, "target", &Camera::target, &CameraKeys::target, "[u]");
  def_keyed(camera, "vertical_fov", &Camera::vertical_fov, &CameraKeys::vertical_fov,
            "In (0, 180) [degrees].");
  def_keyed(camera, "aperture", &Camera::aperture, &CameraKeys::aperture,
            "Radius of the lens, >= 0 [u]; 0: a pinhole.");
  def_keyed(camera, "focus_distance", &Camera::focus_distance, &CameraKeys::focus_distance,
            "Of the plane in focus, > 0 [u]; None: through the target.");
  def_clear_keys(camera);
}

void bind_environment(py::module_& module) {
  py::class_<Environment, std::shared_ptr<Environment>> environment(
      module, "Environment", "A latitude-longitude map that lights the scene from far away.");
  environment.def(py::init([](const std::filesystem::path& map) {
                    return std::make_shared<Environment>(load_environment(map));
                  }),
                  py::arg("map"), "An .exr or .hdr file.");
  def_keyed(environment, "intensity", &Environment::intensity, &EnvironmentKeys::intensity, ">= 0");
  def_keyed(environment, "rotation", &Environment::rotation, &EnvironmentKeys::rotation,
            "About +y [degrees].");
  def_clear_keys(environment);
}

void bind_light(py::module_& module) {
  py::class_<Light, std::shared_ptr<Light>> light(
      module, "Light",
      "A source of light, made by one of the static methods. `intensity` is RGB, >= 0: of a point "
      "or spot light radiant intensity [W/sr], of a directional one irradiance [W/u^2], of an area "
      "light radiance [W/(sr u^2)].");
  using Vec3 = glm::dvec3;
  light.def("__copy__", copied<Light>)
      .def("__deepcopy__", [](const Light& self, const py::dict&) { return self; })
      .def_static(
          "point",
          [](const Vec3& position, const Vec3& intensity) {
            return Light{.position = position, .intensity = intensity};
          },
          py::arg("position"), py::arg("intensity"))
      .def_static(
          "spot",
          [](const Vec3& position, const Vec3& direction, const Vec3& intensity, double inner,
             double outer) {
            return Light{.position = position,
                         .intensity = intensity,
                         .spot = SpotCone{direction, inner, outer}};
          },
          py::arg("position"), py::arg("direction"), py::arg("intensity"),
          py::arg("inner_angle") = 0.0, py::arg("outer_angle") = 45.0,
          "Angles from the axis [degrees].")
      .def_static(
          "directional",
          [](const Vec3& direction, const Vec3& irradiance, double diameter) {
            return Light{.intensity = irradiance, .directional = Directional{direction, diameter}};
          },
          py::arg("direction"), py::arg("irradiance"), py::arg("angular_diameter") = 0.0,
          "The sun has an angular diameter of 0.53 degrees.")
      .def_static(
          "rectangle",
          [](const Vec3& position, const Vec3& direction, const Vec3& radiance, double width,
             double height, const Vec3& up) {
            AreaLight area{.direction = direction, .up = up, .width = width, .height = height};
            return Light{.position = position, .intensity = radiance, .area = area};
          },
          py::arg("position"), py::arg("direction"), py::arg("radiance"), py::arg("width"),
          py::arg("height"), py::arg("up") = Vec3(0.0, 1.0, 0.0))
      .def_static(
          "disk",
          [](const Vec3& position, const Vec3& direction, const Vec3& radiance, double radius) {
            AreaLight area{
                .shape = AreaLight::Shape::disk, .direction = direction, .radius = radius};
            return Light{.position = position, .intensity = radiance, .area = area};
          },
          py::arg("position"), py::arg("direction"), py::arg("radiance"), py::arg("radius"))
      .def_static(
          "sphere",
          [](const Vec3& position, const Vec3& radiance, double radius) {
            AreaLight area{.shape = AreaLight::Shape::sphere, .radius = radius};
            return Light{.position = position, .intensity = radiance, .area = area};
          },
          py::arg("position"), py::arg("radiance"), py::arg("radius"))
      .def("__repr__",
           [](const Light& self) { return std::string("<brume.Light ") + kind_of(self) + ">"; })
      .def_property_readonly("kind", kind_of,
                             "'point', 'spot', 'directional', 'rectangle', 'disk' or 'sphere'.")
      .def_readwrite("name", &Light::name)
      .def_readwrite("on", &Light::on);
  def_keyed(light, "position", &Light::position, &LightKeys::position,
            "[u]; of no meaning for a directional light.");
  def_keyed(light, "intensity", &Light::intensity, &LightKeys::intensity, "RGB, >= 0.");
  def_clear_keys(light);
  def_of_some(light, "direction", direction_of, &LightKeys::direction,
              "The way it shines; any length but 0.");
  def_of_some(
      light, "inner_angle", [](Light& l) { return l.spot ? &l.spot->inner_angle : nullptr; },
      &LightKeys::inner_angle, "Of a spot: full intensity within, from the axis [degrees].");
  def_of_some(
      light, "outer_angle", [](Light& l) { return l.spot ? &l.spot->outer_angle : nullptr; },
      &LightKeys::outer_angle, "Of a spot: none beyond, from the axis [degrees].");
  def_of_some(
      light, "angular_diameter",
      [](Light& l) { return l.directional ? &l.directional->angular_diameter : nullptr; },
      &LightKeys::angular_diameter, "Of a directional light, in [0, 90) [degrees].");
  def_of_some(
      light, "width", [](Light& l) { return l.area ? &l.area->width : nullptr; }, &LightKeys::width,
      "Of a rectangle [u].");
  def_of_some(
      light, "height", [](Light& l) { return l.area ? &l.area->height : nullptr; },
      &LightKeys::height, "Of a rectangle [u].");
  def_of_some(
      light, "radius", [](Light& l) { return l.area ? &l.area->radius : nullptr; },
      &LightKeys::radius, "Of a disk or a sphere [u].");
}

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

void set_material(Surface& surface, const Material& material) {
  check_unkeyed("reflectance", surface.keys.reflectance);
  check_unkeyed("specular", surface.keys.specular);
  check_unkeyed("exponent", surface.keys.exponent);
  surface.material = material;
}

void bind_surface(py::module_& module) {
  py::class_<Surface, std::shared_ptr<Surface>> surface(
      module, "Surface",
      "A mesh in the scene: world = translate + rotate * (scale * mesh). `rotate` is a unit "
      "quaternion (w, x, y, z).");
  def_keyed(surface, "translate", &Surface::translate, &SurfaceKeys::translate, "[u]");
  def_keyed(surface, "scale", &Surface::scale, &SurfaceKeys::scale, "> 0");
  def_clear_keys(surface);
  surface.def("__copy__", copied<Surface>)
      .def("__deepcopy__", [](const Surface& self, const py::dict&) { return self; })
      .def_static(
          "load",
          [](const std::filesystem::path& mesh) {
            return std::make_shared<Surface>(load_surface(mesh));
          },
          py::arg("mesh"), "A mesh file: .obj, .ply, .stl or .off.")
      .def_static("primitive", primitive_surface, py::arg("shape"),
                  py::arg("size") = glm::dvec3(1.0),
                  "'plane', 'box', 'sphere' or 'cylinder' around the origin, y up.")
      .def_static("mesh", mesh_surface, py::arg("points"), py::arg("triangles"),
                  "Points (n, 3) [u] and triangles (m, 3), shaded flat. It cannot be saved.")
      .def_readwrite("name", &Surface::name)
      .def_readwrite("visible", &Surface::visible)
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
             const glm::dvec3& emissive) {
            Material material{.type = Material::Type::metallic_roughness};
            MetallicRoughness& values = material.metallic_roughness;
            values.base_color = base_color;
            values.metallic = metallic;
            values.roughness = roughness;
            values.emissive = emissive;
            set_material(self, material);
          },
          py::arg("base_color"), py::arg("metallic") = 0.0, py::arg("roughness") = 0.5,
          py::arg("emissive") = glm::dvec3(0.0), "glTF's material; emissive [W/(sr u^2)].");
}

}  // namespace

SharedScene::SharedScene(SceneFile file) : rest(std::move(file)) {
  Scene& scene = rest.scene;
  medium = std::make_shared<ArrayMedium>(std::exchange(scene.medium, {}));
  medium->density_keys() = std::exchange(scene.density_keys, {});
  camera = std::make_shared<KeyedCamera>(scene.camera, std::exchange(scene.camera_keys, {}));
  if (scene.environment) environment = std::make_shared<Environment>(*scene.environment);
  scene.environment.reset();
  lights = listed(scene.lights);
  surfaces = listed(scene.surfaces);
}

SceneFile SharedScene::without_gaussians() const {
  SceneFile file = rest;
  if (!camera) throw py::type_error("camera: found None; allowed: a brume.Camera");
  file.scene.camera = *camera;
  file.scene.camera_keys = camera->keys;
  file.scene.density_keys = medium->density_keys();
  if (environment) file.scene.environment = *environment;
  file.scene.lights = values_of<Light>(lights, "lights", "Light");
  file.scene.surfaces = values_of<Surface>(surfaces, "surfaces", "Surface");
  return file;
}

SceneFile SharedScene::assembled() const {
  SceneFile file = without_gaussians();
  file.scene.medium = medium->copy();
  return file;
}

void SharedScene::set_medium(ArrayMedium& other) {
  Medium fresh = medium->copy();
  const std::vector<GaussianId> old(fresh.ids().begin(), fresh.ids().end());
  const Medium source = other.copy();
  MediumEdit::remove(fresh, old).apply(fresh);
  fresh.set_homogeneous_density(source.homogeneous_density());
  for (std::size_t i = 0; i < source.size(); ++i) {
    Gaussian gaussian = source.gaussian(i);
    gaussian.group = 0;
    fresh.append(gaussian);
  }
  medium = std::make_shared<ArrayMedium>(std::move(fresh));
  medium->density_keys() = other.density_keys();
}

void bind_scene(py::module_& module) {
  bind_camera(module);
  bind_environment(module);
  bind_light(module);
  bind_surface(module);

  py::class_<SharedScene, std::shared_ptr<SharedScene>>(
      module, "Scene",
      "What is rendered. Parts are changed in place; `lights` and `surfaces` are lists. Groups, "
      "emitters, sequences and keyframes are kept as the file has them; a value with keyframes is "
      "set after clear_keys() of the object that has it.")
      .def(py::init([] { return std::make_shared<SharedScene>(); }))
      .def_property(
          "medium", [](const SharedScene& self) { return self.medium; },
          [](SharedScene& self, ArrayMedium& other) { self.set_medium(other); },
          "Assigning another copies its Gaussians.")
      .def_readwrite("camera", &SharedScene::camera)
      .def_readwrite("environment", &SharedScene::environment, "None: none.")
      .def_property(
          "lights", [](const SharedScene& self) { return self.lights; },
          [](SharedScene& self, const py::sequence& lights) { self.lights = py::list(lights); },
          "A list of Light.")
      .def_property(
          "surfaces", [](const SharedScene& self) { return self.surfaces; },
          [](SharedScene& self, const py::sequence& list) { self.surfaces = py::list(list); },
          "A list of Surface.")
      .def("__deepcopy__",
           [](const SharedScene& self, const py::dict&) {
             return std::make_shared<SharedScene>(self.assembled());
           })
      .def("__repr__",
           [](const SharedScene& self) {
             return "<brume.Scene of " + std::to_string(self.medium->medium().size()) +
                    " Gaussians, " + std::to_string(self.lights.size()) + " lights, " +
                    std::to_string(self.surfaces.size()) + " surfaces>";
           })
      .def_property(
          "size",
          [](const SharedScene& self) {
            return std::pair(self.rest.scene.film.width, self.rest.scene.film.height);
          },
          [](SharedScene& self, const std::pair<int, int>& size) {
            self.rest.scene.film = {size.first, size.second};
          },
          "(width, height) of its pictures [pixels].")
      .def_property(
          "albedo", [](const SharedScene& self) { return self.rest.scene.optics.albedo; },
          [](SharedScene& self, const glm::dvec3& value) {
            MediumOptics& optics = self.rest.scene.optics;
            check_unkeyed("albedo", optics.keys.albedo);
            optics.albedo = value;
          },
          "Single-scattering albedo of the medium, RGB in (0, 1].")
      .def_property(
          "anisotropy", [](const SharedScene& self) { return self.rest.scene.optics.anisotropy; },
          [](SharedScene& self, double value) {
            MediumOptics& optics = self.rest.scene.optics;
            check_unkeyed("anisotropy", optics.keys.anisotropy);
            optics.anisotropy = value;
          },
          "g of Henyey-Greenstein, in [-0.95, 0.95].")
      .def(
          "clear_keys", [](SharedScene& self) { self.rest.scene.optics.keys = {}; },
          "Removes the keyframes of albedo and anisotropy, which are then constant.")
      .def_property_readonly(
          "is_animated",
          [](const SharedScene& self) { return is_animated(self.without_gaussians().scene); })
      .def_property_readonly(
          "last_moment",
          [](const SharedScene& self) { return last_moment(self.without_gaussians().scene); },
          "Time of the last keyframe [s].")
      .def_property(
          "frames_per_second", [](const SharedScene& self) { return frame_rate(self.rest.scene); },
          [](SharedScene& self, double rate) {
            Scene whole = self.without_gaussians().scene;
            set_frame_rate(whole, rate);
            self.rest.scene.playback = whole.playback;
          },
          "Of the timeline, else 30, from 1 to 1000: frame n is at n / frames_per_second seconds; "
          "shutters and motion count in frames.")
      .def(
          "save",
          [](const SharedScene& self, const std::filesystem::path& file) {
            save_scene_file(self.assembled(), file);
          },
          py::arg("file"),
          "Writes a .brume file; keys of the loaded file that Brume does not know are kept.");
  module.def("load", load, py::arg("file"), "The scene of a .brume file, with all its files.");
}

}  // namespace brume::python
