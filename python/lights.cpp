#include <type_traits>
#include <utility>

#include "brume/files.h"
#include "core/scene/fields/camera_fields.h"
#include "python/fields.h"
#include "python/keyed.h"
#include "python/parts.h"
#include "python/warnings.h"

namespace py = pybind11;

namespace brume::python {
namespace {

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

}  // namespace

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

void bind_camera(py::module_& module) {
  py::class_<KeyedCamera, std::shared_ptr<KeyedCamera>> camera(module, "Camera",
                                                               "A pinhole, or a thin lens.");
  def_fields<Camera>(camera);
  camera.def("__copy__", copied<KeyedCamera>)
      .def("__deepcopy__", [](const KeyedCamera& self, const py::dict&) { return self; });
  def_clear_keys(camera);
}

void bind_environment(py::module_& module) {
  py::class_<Environment, std::shared_ptr<Environment>> environment(
      module, "Environment", "A latitude-longitude map that lights the scene from far away.");
  environment.def(py::init([](const std::filesystem::path& map) {
                    std::vector<std::string> warnings;
                    auto loaded = std::make_shared<Environment>(load_environment(map, &warnings));
                    warn_of(warnings);
                    return loaded;
                  }),
                  py::arg("map"), "An .exr or .hdr file.");
  def_keyed(environment, "intensity", &Environment::intensity, &EnvironmentKeys::intensity, ">= 0");
  def_keyed(environment, "rotation", &Environment::rotation, &EnvironmentKeys::rotation,
            "About +y [degrees].");
  def_clear_keys(environment);
}

}  // namespace brume::python
