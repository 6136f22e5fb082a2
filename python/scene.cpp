#include "python/scene.h"

#include <string>
#include <utility>
#include <vector>

#include "brume/at_time.h"
#include "brume/edits.h"
#include "brume/error.h"
#include "core/scene/fields/description.h"
#include "core/scene/fields/medium_fields.h"
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

std::shared_ptr<SharedScene> load(const std::filesystem::path& file) {
  std::vector<std::string> warnings;
  SceneFile loaded = [&] {
    const py::gil_scoped_release release;
    return load_scene_file(file, &warnings);
  }();
  warn_of(warnings);
  return std::make_shared<SharedScene>(std::move(loaded));
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

  py::class_<SharedScene, std::shared_ptr<SharedScene>> scene(
      module, "Scene",
      "What is rendered. Parts are changed in place; `lights` and `surfaces` are lists. Groups, "
      "emitters, sequences and keyframes are kept as the file has them; a value with keyframes is "
      "set after clear_keys() of the object that has it.");
  visit_fields<MediumOptics>([&scene](const auto& field) {
    const char* name = field.info.name;
    scene.def_property(
        name, [field](const SharedScene& self) { return field.of(self.rest.scene.optics); },
        [name, field](SharedScene& self,
                      const typename std::remove_cvref_t<decltype(field)>::Value& value) {
          MediumOptics& optics = self.rest.scene.optics;
          check_unkeyed(name, optics.keys.*field.keys);
          field.of(optics) = value;
        },
        description(field).c_str());
  });
  scene.def(py::init([] { return std::make_shared<SharedScene>(); }))
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
      .def(
          "clear_keys", [](SharedScene& self) { self.rest.scene.optics.keys = {}; },
          "Removes the keyframes of albedo, anisotropy and extent, which are then constant.")
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
