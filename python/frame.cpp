#include "python/frame.h"

#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "brume/error.h"
#include "brume/files.h"
#include "brume/render.h"
#include "brume/request_options.h"
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

// A Python value of an option, as its text. Throws TypeError.
std::optional<std::string> text_of(const RequestOption& option, const py::handle& value) {
  using Type = RequestOption::Type;
  const auto is_number = [](const py::handle& it) {
    return !py::isinstance<py::bool_>(it) && PyNumber_Check(it.ptr()) != 0;
  };
  const auto refuse = [&](const char* allowed) {
    return py::type_error(option.keyword() + ": found a " + Py_TYPE(value.ptr())->tp_name +
                          "; allowed: " + allowed);
  };
  if (option.type == Type::flag) {
    if (!py::isinstance<py::bool_>(value)) throw refuse("a bool");
    return value.cast<bool>() ? std::optional<std::string>("true") : std::nullopt;
  }
  if (option.type == Type::whole_number || option.type == Type::number) {
    const bool is_right =
        option.type == Type::number ? is_number(value) : PyIndex_Check(value.ptr()) != 0;
    if (!is_right) throw refuse(option.type == Type::number ? "a number" : "an int");
    return py::str(value).cast<std::string>();
  }
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (option.type == Type::text) throw refuse("a str");
  if (!py::isinstance<py::iterable>(value)) throw refuse("a sequence");
  std::string text;
  bool is_first = true;
  for (const py::handle item : value) {
    if (!py::isinstance<py::str>(item) && !is_number(item))
      throw refuse("strings or numbers in it");
    if (!std::exchange(is_first, false)) text += option.separator;
    text += py::str(item).cast<std::string>();
  }
  return is_first ? std::nullopt : std::optional(text);
}

// Deep frames go into files, which the command line writes.
bool is_offered(const RequestOption& option) {
  return option.keyword() != "deep_error";
}

// Sets options by their keywords, which are taken out of `given`.
void set_options(RenderRequest& request, py::dict& given, const Film& film) {
  for (const RequestOption& option : request_options()) {
    const std::string keyword = option.keyword();
    if (!is_offered(option) || !given.contains(keyword)) continue;
    const py::object value = given.attr("pop")(keyword);
    const std::optional<std::string> text = value.is_none() ? std::nullopt : text_of(option, value);
    if (!text) continue;
    const std::string why = option.set(request, *text, film);
    if (!why.empty()) throw DomainError(keyword, why);
  }
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

std::shared_ptr<TimedFrame> render_by(Renderer& renderer, const SharedScene& scene,
                                      const py::kwargs& keywords) {
  const Busy busy(renderer);
  // A copy: nothing that Python does meanwhile changes it.
  SceneFile file = scene.assembled();
  py::dict given(keywords.attr("copy")());
  const py::object camera = given.attr("pop")("camera", py::none());
  const py::object progress = given.attr("pop")("progress", py::none());
  RenderRequest request;
  set_options(request, given, file.scene.film);
  if (!given.empty()) {
    const auto name = py::str(given.begin()->first).cast<std::string>();
    throw py::type_error("render() got an unexpected keyword argument '" + name + "'");
  }
  if (!camera.is_none()) {
    if (!py::isinstance<KeyedCamera>(camera)) {
      throw py::type_error("camera: allowed: a brume.Camera or None");
    }
    const auto& keyed = camera.cast<const KeyedCamera&>();
    file.scene.camera = keyed;
    file.scene.camera_keys = keyed.keys;
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

// A default as Python writes it.
std::string default_text(const RequestOption& option) {
  using Type = RequestOption::Type;
  if (option.type == Type::flag) return "False";
  const std::string text = option.get ? option.get({}) : "";
  if (text.empty()) return "None";
  return option.type == Type::whole_number || option.type == Type::number
             ? text
             : py::repr(py::str(text)).cast<std::string>();
}

// The signature, which follows from the options as the keywords do, and what they do.
std::string render_doc() {
  std::string signature = "render(scene, *, ";
  std::string sentences;
  for (const RequestOption& option : request_options()) {
    if (!is_offered(option)) continue;
    const std::string keyword = option.keyword();
    signature += keyword + '=' + default_text(option) + ", ";
    sentences += keyword + ": " + (option.values.empty() ? "" : option.values + "; ") +
                 option.sentence + ".\n";
  }
  return signature +
         "camera=None, progress=None)\n\n"
         "Renders a frame as `brume render` does, whose options these are. None: as if it were not "
         "given. Lists of the command line are tuples: size=(640, 480).\n\n" +
         sentences +
         "camera: None: the scene's.\n"
         "progress: is called with the completed fraction, in [0, 1], some times a second, and at "
         "the end.\n\n"
         "Other threads of Python run meanwhile; Ctrl-C stops it.";
}

}  // namespace

void bind_frame(py::module_& module) {
  py::class_<ErrorEstimate>(
      module, "ErrorEstimate",
      "Relative RMSE of the airlight or the picture, measured on a sample of pixels.")
      .def_readonly("rel_rmse", &ErrorEstimate::rel_rmse)
      .def_readonly("low", &ErrorEstimate::low, "Of the 95 % confidence interval.")
      .def_readonly("high", &ErrorEstimate::high, "Of the 95 % confidence interval.")
      .def_readonly("pixels", &ErrorEstimate::pixels)
      .def_readonly("block_median", &ErrorEstimate::block_median,
                    "Median of blocks of 8 x 8 pixels, each relative to its own light.")
      .def_readonly("block_low", &ErrorEstimate::block_low, "Of its 95 % confidence interval.")
      .def_readonly("block_high", &ErrorEstimate::block_high, "Of its 95 % confidence interval.")
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
      .def_readonly("error", &TimedFrame::error,
                    "An ErrorEstimate of the airlight; None: not measured.")
      .def_readonly(
          "picture_error", &TimedFrame::picture_error,
          "The same of the beauty: surfaces, mirrors, panes and all that shines included.")
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
  py::options signatures;
  signatures.disable_function_signatures();
  const std::string doc = render_doc();
  renderer.def("render", render_by, py::arg("scene"), doc.c_str());
  const auto render_once = [](const SharedScene& scene, const py::kwargs& keywords) {
    Renderer once;
    return render_by(once, scene, keywords);
  };
  module.def("render", render_once, py::arg("scene"), doc.c_str());
}

}  // namespace brume::python
