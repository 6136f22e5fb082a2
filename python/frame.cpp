#include "python/frame.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brume/error.h"
#include "brume/files.h"
#include "brume/render.h"
#include "python/interruptible.h"
#include "python/scene.h"
#include "python/warnings.h"

namespace py = pybind11;

namespace brume::python {
namespace {

struct TimedFrame : Frame {
  double request_milliseconds = 0.0;
};

// The channels of a layer as an array that does not copy, keeps the frame alive and cannot be
// written to: what is saved is what was rendered.
py::array_t<float> layer(const py::object& owner, const std::vector<float>& values, int channels) {
  const Film& film = owner.cast<const TimedFrame&>().film;
  std::vector<py::ssize_t> shape{film.height, film.width};
  if (channels > 1) shape.push_back(channels);
  py::array_t<float> array(shape, values.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

// N of "method:N".
int parameter(std::string_view text, const std::string& name) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw DomainError("airlight", "found '" + name + "'; allowed after the colon: a number");
  }
  return value;
}

void set_airlight(RenderRequest& request, const std::string& name) {
  const std::size_t colon = name.find(':');
  const std::string method = name.substr(0, colon);
  using enum AirlightMethod;
  for (const auto known : {auto_, paper, sliced, march, reference, path}) {
    if (method != to_string(known)) continue;
    request.airlight = known;
    if (colon == std::string::npos) return;
    const int count = parameter(std::string_view(name).substr(colon + 1), name);
    if (known == sliced) {
      request.slices = count;
    } else if (known == march) {
      request.march_steps = count;
    } else if (known == path) {
      request.paths = count;
    } else {
      break;
    }
    return;
  }
  throw DomainError("airlight", "found '" + name +
                                    "'; allowed: auto, paper, sliced, reference, sliced:N, "
                                    "march:N, path:N");
}

template <class Choice, std::size_t n>
Choice chosen(const char* name, const std::string& text,
              const std::array<std::pair<const char*, Choice>, n>& choices) {
  std::string allowed;
  for (const auto& [word, choice] : choices) {
    if (text == word) return choice;
    allowed += (allowed.empty() ? "" : ", ") + std::string(word);
  }
  throw DomainError(name, "found '" + text + "'; allowed: " + allowed);
}

OutputLayers layers_of(const py::iterable& names) {
  OutputLayers layers;
  for (const py::handle item : names) {
    const auto name = item.cast<std::string>();
    const auto known = std::ranges::find_if(
        layer_names, [&name](const LayerName& layer) { return name == layer.name; });
    if (known == layer_names.end()) {
      std::string allowed;
      for (const LayerName& layer : layer_names) {
        allowed += (allowed.empty() ? "" : ", ") + std::string(layer.name);
      }
      throw DomainError("layers", "found '" + name + "'; allowed: " + allowed);
    }
    layers.*known->layer = true;
  }
  return layers;
}

// Renders one frame at a time.
struct Renderer {
  SceneRenderer renderer;
  bool is_busy = false;
};

class Busy {
 public:
  explicit Busy(Renderer& renderer) : renderer_(renderer) {
    if (renderer_.is_busy) {
      throw std::runtime_error("this renderer is rendering; allowed: another, or afterwards");
    }
    renderer_.is_busy = true;
  }
  ~Busy() { renderer_.is_busy = false; }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

 private:
  Renderer& renderer_;
};

std::shared_ptr<TimedFrame> render_by(
    Renderer& renderer, const SharedScene& scene, const std::optional<std::pair<int, int>>& size,
    double max_error, const std::string& airlight, const std::string& scattering,
    std::uint32_t seed, double time, const std::shared_ptr<KeyedCamera>& camera,
    const std::optional<int>& samples, const std::optional<std::pair<double, double>>& shutter,
    const py::iterable& layers, bool measure_error, const std::string& backend, int threads,
    const py::object& progress) {
  const Busy busy(renderer);
  RenderRequest request;
  if (size) request.film = Film{size->first, size->second};
  request.time = time;
  set_airlight(request, airlight);
  request.max_error = max_error;
  request.scattering =
      chosen<Scattering, 2>("scattering", scattering,
                            {{{"single", Scattering::single}, {"multiple", Scattering::multiple}}});
  request.seed = seed;
  request.samples = samples;
  if (shutter) request.shutter = Shutter{shutter->first, shutter->second};
  request.layers = layers_of(layers);
  request.measure_error = measure_error;
  request.backend = chosen<Backend, 3>(
      "backend", backend, {{{"auto", Backend::auto_}, {"cpu", Backend::cpu}, {"gl", Backend::gl}}});
  request.threads = threads;
  // A copy: nothing that Python does meanwhile changes it.
  SceneFile file = scene.assembled();
  if (camera) {
    file.scene.camera = *camera;
    file.scene.camera_keys = camera->keys;
  }
  using Clock = std::chrono::steady_clock;
  std::chrono::duration<double, std::milli> taken{};
  std::optional<Frame> frame = interruptible(
      [&](const std::stop_token& stop, const std::function<void(double)>& fraction) {
        const Clock::time_point start = Clock::now();
        std::optional<Frame> rendered =
            renderer.renderer.render(file.scene, request, stop, fraction);
        taken = Clock::now() - start;
        return rendered;
      },
      progress);
  warn_of(frame->warnings);
  return std::make_shared<TimedFrame>(TimedFrame{std::move(*frame), taken.count()});
}

constexpr const char* render_doc =
    "Renders a frame, by default as `brume render` does.\n\n"
    "size: (width, height) [pixels]; None: the scene's.\n"
    "max_error: of 'auto', the relative RMSE of the airlight that it keeps.\n"
    "airlight: 'auto', 'paper', 'sliced', 'sliced:N', 'march:N', 'reference' or 'path:N'.\n"
    "scattering: 'multiple', all orders, or 'single'.\n"
    "seed: of 'path': each is another, independent picture, 0 to 4294967295.\n"
    "time: of the animation [s]; frame n is at n / scene.frames_per_second.\n"
    "camera: None: the scene's.\n"
    "samples: of pixels that need them; None: chosen.\n"
    "shutter: (open, close) [frames]; None: the scene's.\n"
    "layers: names of more layers, for Frame.layers.\n"
    "measure_error: of methods other than auto, too.\n"
    "backend: 'auto', 'cpu' or 'gl'. threads: at most; 0: all.\n"
    "progress: is called with the completed fraction, in [0, 1], some times a second, and at the "
    "end.\n\n"
    "Other threads of Python run meanwhile; Ctrl-C stops it.";

// Of a renderer that is there, or of one for this frame.
template <class Bound, class Function>
void def_render(Bound& bound, Function function) {
  bound.def("render", function, py::arg("scene"), py::kw_only(), py::arg("size") = py::none(),
            py::arg("max_error") = RenderRequest{}.max_error, py::arg("airlight") = "auto",
            py::arg("scattering") = "multiple", py::arg("seed") = 0, py::arg("time") = 0.0,
            py::arg("camera") = py::none(), py::arg("samples") = py::none(),
            py::arg("shutter") = py::none(), py::arg("layers") = py::tuple(),
            py::arg("measure_error") = false, py::arg("backend") = "auto", py::arg("threads") = 0,
            py::arg("progress") = py::none(), render_doc);
}

// render_by() with a renderer of its own.
template <class... Arguments>
auto once(std::shared_ptr<TimedFrame> (*)(Renderer&, Arguments...)) {
  return [](Arguments... arguments) {
    Renderer renderer;
    return render_by(renderer, arguments...);
  };
}

}  // namespace

void bind_frame(py::module_& module) {
  py::class_<ErrorEstimate>(module, "ErrorEstimate",
                            "Relative RMSE of the airlight, measured on a sample of pixels.")
      .def_readonly("rel_rmse", &ErrorEstimate::rel_rmse)
      .def_readonly("low", &ErrorEstimate::low, "Of the 95 % confidence interval.")
      .def_readonly("high", &ErrorEstimate::high, "Of the 95 % confidence interval.")
      .def_readonly("pixels", &ErrorEstimate::pixels)
      .def("__float__", [](const ErrorEstimate& self) { return self.rel_rmse; })
      .def("__repr__", [](const ErrorEstimate& self) {
        return "<brume.ErrorEstimate " + std::to_string(self.rel_rmse) + ", " +
               std::to_string(self.low) + " to " + std::to_string(self.high) + ">";
      });
  py::class_<TimedFrame, std::shared_ptr<TimedFrame>>(
      module, "Frame",
      "A rendered frame: arrays of float32, rows from the top, linear radiance. They do not copy, "
      "cannot be written to, and keep the frame alive.")
      .def_property_readonly(
          "beauty",
          [](const py::object& self) {
            return layer(self, self.cast<const TimedFrame&>().beauty, 4);
          },
          "(height, width, 4): RGBA; A is 1 on surfaces, else 1 - transmittance.")
      .def_property_readonly(
          "airlight",
          [](const py::object& self) {
            return layer(self, self.cast<const TimedFrame&>().airlight, 3);
          },
          "(height, width, 3): light that the medium scatters and emits towards the eye.")
      .def_property_readonly(
          "transmittance",
          [](const py::object& self) {
            return layer(self, self.cast<const TimedFrame&>().transmittance, 3);
          },
          "(height, width, 3): from the eye to the first surface, or through the medium.")
      .def_property_readonly(
          "depth",
          [](const py::object& self) {
            return layer(self, self.cast<const TimedFrame&>().depth, 1);
          },
          "(height, width): distance along the ray through the center [u]; inf: nothing is hit.")
      .def_property_readonly(
          "layers",
          [](const py::object& self) {
            py::dict layers;
            for (const auto& [name, values] : self.cast<const TimedFrame&>().layers.channels) {
              layers[name.c_str()] = layer(self, values, 1);
            }
            return layers;
          },
          "The channels of the layers asked for besides: name to (height, width).")
      .def_property_readonly(
          "size",
          [](const TimedFrame& self) { return std::pair(self.film.width, self.film.height); })
      .def_readonly("error", &TimedFrame::error, "An ErrorEstimate; None: not measured.")
      .def_property_readonly(
          "airlight_method", [](const TimedFrame& self) { return self.statistics.airlight; },
          "What rendered it, such as 'sliced:16'.")
      .def_property_readonly(
          "milliseconds", [](const TimedFrame& self) { return self.statistics.frame_milliseconds; },
          "That the frame itself took.")
      .def_readonly("request_milliseconds", &TimedFrame::request_milliseconds,
                    "That all of it took in C++: checks, the choice of settings, the measured "
                    "error, layers.")
      .def_property_readonly(
          "stages",
          [](const TimedFrame& self) {
            py::dict stages;
            for (const StageTime& stage : self.statistics.stages) {
              stages[to_string(stage.stage)] = stage.milliseconds;
            }
            return stages;
          },
          "Milliseconds by stage.")
      .def_property_readonly("backend",
                             [](const TimedFrame& self) { return self.statistics.backend; })
      .def(
          "save",
          [](const TimedFrame& self, const std::filesystem::path& file, double exposure) {
            save_frame(self, file, exposure);
          },
          py::arg("file"), py::arg("exposure") = 0.0,
          ".exr, linear with all layers, or .png, exposed by so many stops.")
      .def(
          "png",
          [](const TimedFrame& self, double exposure) {
            return py::bytes(encode_png(self, exposure));
          },
          py::arg("exposure") = 0.0, "The bytes of a .png.")
      .def("_repr_png_", [](const TimedFrame& self) { return py::bytes(encode_png(self)); })
      .def("__repr__", [](const TimedFrame& self) {
        return "<brume.Frame of " + std::to_string(self.film.width) + " x " +
               std::to_string(self.film.height) + " by " + self.statistics.airlight + ">";
      });
  py::class_<Renderer> renderer(
      module, "Renderer",
      "Renders frame after frame and keeps what is the same in the next. One at a time.");
  renderer.def(py::init<>());
  def_render(renderer, render_by);
  def_render(module, once(render_by));
}

}  // namespace brume::python
