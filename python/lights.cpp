#include <string_view>
#include <type_traits>
#include <utility>

#include "brume/files.h"
#include "core/scene/fields/camera_fields.h"
#include "core/scene/fields/environment_fields.h"
#include "core/scene/fields/light_fields.h"
#include "python/fields.h"
#include "python/keyed.h"
#include "python/parts.h"
#include "python/warnings.h"

namespace py = pybind11;

namespace brume::python {
namespace {

// A value that only some kinds of lights have.
template <class T>
auto& value_of(auto& light, const char* name) {
  auto* value = find_value<T>(light, name);
  if (value == nullptr) {
    throw py::attribute_error(std::string("a ") + kind_info(light).name + " light has no " + name);
  }
  return *value;
}

template <class F>
void def_light_value(auto& bound, const F& field) {
  using Value = typename F::Value;
  const char* name = field.info.name;
  bound.def_property(
      name, [name](const Light& light) { return value_of<Value>(light, name); },
      [name, field](Light& light, const Value& value) {
        Value& member = value_of<Value>(light, name);
        if constexpr (F::can_have_keys) check_unkeyed(name, light.keys.*field.keys);
        member = value;
      },
      description(field).c_str());
}

// An argument of the function that makes a light; it has a default where files need none.
template <class Kind, std::size_t k>
auto argument() {
  constexpr const FieldInfo& info = std::get<k>(fields<Kind>).info;
  if constexpr (info.is_required) {
    return py::arg(info.name);
  } else {
    const Light usual{.kind = Kind()};
    return py::arg(info.name) = std::get<k>(fields<Kind>).of(usual);
  }
}

template <class Kind, std::size_t... k>
void def_kind(auto& bound, const LightKindInfo& info, std::index_sequence<k...>) {
  using Table = std::remove_cvref_t<decltype(fields<Kind>)>;
  bound.def_static(
      info.name,
      [](const typename std::tuple_element_t<k, Table>::Value&... values) {
        Light light{.kind = Kind()};
        ((std::get<k>(fields<Kind>).of(light) = values), ...);
        return light;
      },
      argument<Kind, k>()..., info.says);
}

}  // namespace

void bind_light(py::module_& module) {
  py::class_<Light, std::shared_ptr<Light>> light(
      module, "Light",
      "A source of light, made by one of the static methods. `intensity` is RGB, >= 0: of a point "
      "or spot light radiant intensity [W/sr], of a directional one irradiance [W/u^2], of an area "
      "light radiance [W/(sr u^2)].");
  visit_light_kinds([&]<class Kind>(const LightKindInfo& info, const Kind&) {
    constexpr auto count = std::tuple_size_v<std::remove_cvref_t<decltype(fields<Kind>)>>;
    def_kind<Kind>(light, info, std::make_index_sequence<count>());
  });
  light.def("__copy__", copied<Light>)
      .def("__deepcopy__", [](const Light& self, const py::dict&) { return self; })
      .def("__repr__",
           [](const Light& self) {
             return std::string("<brume.Light ") + kind_info(self).name + ">";
           })
      .def_property_readonly(
          "kind", [](const Light& self) { return kind_info(self).name; },
          "'point', 'spot', 'directional', 'rectangle', 'disk' or 'sphere'.")
      .def_readwrite("name", &Light::name);
  def_keyed(light, "position", &Light::position, &LightKeys::position,
            "[u]; of no meaning for a directional light.");
  def_keyed(light, "intensity", &Light::intensity, &LightKeys::intensity, "RGB, >= 0.");
  visit_light_fields([&light](const auto& field, const Light&) {
    const bool is_common = is_strength(field) || std::string_view(field.info.name) == "position";
    if (!is_common) def_light_value(light, field);
  });
  def_clear_keys(light);
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
  py::class_<Sky> bound_sky(module, "Sky", "A clear sky, computed for an elevation of its sun.");
  def_fields<Sky>(bound_sky);
  def_clear_keys(bound_sky);
  py::class_<Environment, std::shared_ptr<Environment>> environment(
      module, "Environment",
      "A latitude-longitude map, or a sky, that lights the scene from far away.");
  environment.def(py::init([](const std::filesystem::path& map) {
                    std::vector<std::string> warnings;
                    auto loaded = std::make_shared<Environment>(load_environment(map, &warnings));
                    warn_of(warnings);
                    return loaded;
                  }),
                  py::arg("map"), "An .exr or .hdr file.");
  environment.def(py::init([](const Sky& sky) {
                    auto made = std::make_shared<Environment>();
                    made->sky = sky;
                    return made;
                  }),
                  py::arg("sky"), "A computed sky, and its sun.");
  environment.def_property_readonly(
      "sky", [](Environment& self) { return self.sky ? &*self.sky : nullptr; },
      py::return_value_policy::reference_internal, "Its sky; None: a map.");
  def_values<Environment>(environment);
  def_clear_keys(environment);
}

}  // namespace brume::python
