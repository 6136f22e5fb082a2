#include "brume/request_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "brume/limits.h"
#include "core/io/scene/scene_names.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"
#include "render/request.h"

namespace brume {
namespace {

using Type = RequestOption::Type;

constexpr std::array scatterings{std::pair("single", Scattering::single),
                                 std::pair("multiple", Scattering::multiple)};
constexpr std::array measurements{std::pair("none", ErrorMeasurement::none),
                                  std::pair("quick", ErrorMeasurement::quick),
                                  std::pair("full", ErrorMeasurement::full)};
const std::array denoisings{std::pair(scene_names::denoisings[0].c_str(), Denoising::none),
                            std::pair(scene_names::denoisings[1].c_str(), Denoising::solved)};
constexpr std::array scales{std::pair("1", 1), std::pair("2", 2), std::pair("4", 4)};
constexpr std::array backends{std::pair("auto", Backend::auto_), std::pair("cpu", Backend::cpu),
                              std::pair("gl", Backend::gl)};

std::string refusal(std::string_view found, const std::string& allowed) {
  return "found " + quoted_text(found) + "; allowed: " + allowed;
}

std::string range_text(double low, double high) {
  return "from " + quoted_text(low) + " to " + quoted_text(high);
}

// The items of a list.
std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> items;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    items.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return items;
}

template <class Items>
std::string names_of(const Items& items, const char* separator) {
  std::string names;
  for (const auto& item : items) {
    names += (names.empty() ? "" : separator) + std::string(item.first);
  }
  return names;
}

template <class Value>
struct Held {
  using Type = Value;
  static std::optional<Type> in(const Value& value) { return value; }
};
template <class Value>
struct Held<std::optional<Value>> {
  using Type = Value;
  static std::optional<Type> in(const std::optional<Value>& value) { return value; }
};

template <class Value>
RequestOption number(const char* name, Value RenderRequest::*member, double low, double high,
                     const char* sentence) {
  using Number = typename Held<Value>::Type;
  constexpr bool is_whole = std::is_integral_v<Number>;
  const std::string range = range_text(low, high);
  const auto set = [=](RenderRequest& request, std::string_view text, const Film&) {
    const std::optional<double> value =
        is_whole ? std::optional<double>(parse_integer(text)) : parse_number(text);
    if (!value || !(*value >= low && *value <= high)) {
      return refusal(text, (is_whole ? "a whole number " : "a number ") + range);
    }
    request.*member = static_cast<Number>(*value);
    return std::string();
  };
  const auto get = [member](const RenderRequest& request) {
    const std::optional<Number> value = Held<Value>::in(request.*member);
    if (!value) return std::string();
    if constexpr (is_whole) return std::to_string(*value);
    return quoted_text(static_cast<double>(*value));
  };
  return {name, is_whole ? Type::whole_number : Type::number, range, sentence, set, get};
}

template <class Value, class Names>
RequestOption choice(const char* name, Value RenderRequest::*member, const Names& names,
                     const char* sentence) {
  const auto set = [=](RenderRequest& request, std::string_view text, const Film&) {
    const auto known = std::ranges::find(names, text, [](const auto& it) { return it.first; });
    if (known == names.end()) return refusal(text, names_of(names, ", "));
    request.*member = known->second;
    return std::string();
  };
  const auto get = [=](const RenderRequest& request) {
    const auto value = Held<Value>::in(request.*member);
    const auto known =
        std::ranges::find_if(names, [&](const auto& it) { return value == it.second; });
    if (known != names.end()) return std::string(known->first);
    return value ? std::to_string(static_cast<int>(*value)) : std::string();
  };
  const bool is_number = std::is_integral_v<typename Held<Value>::Type>;
  return {name,
          is_number ? Type::whole_number : Type::text,
          '{' + names_of(names, ",") + '}',
          sentence,
          set,
          get};
}

RequestOption flag(const char* name, bool RenderRequest::*member, const char* sentence) {
  const auto set = [member](RenderRequest& request, std::string_view text, const Film&) {
    if (text != "true") return refusal(text, "true");
    request.*member = true;
    return std::string();
  };
  const auto get = [member](const RenderRequest& request) {
    return std::string(request.*member ? "true" : "");
  };
  return {name, Type::flag, "", sentence, set, get};
}

// N of "method:N", in [low, high].
bool set_count(std::string_view text, int low, int high, int& count) {
  const auto number = parse_integer(text.substr(text.find(':') + 1));
  if (!number || *number < low || *number > high) return false;
  count = static_cast<int>(*number);
  return true;
}

// Whether it is one; sets it.
bool set_method(RenderRequest& request, std::string_view text) {
  using enum AirlightMethod;
  const std::string_view method = text.substr(0, text.find_first_of(":+"));
  const auto is = [method](AirlightMethod it) { return method == to_string(it); };
  const std::string_view more = text.substr(method.size());
  const auto set = [&](AirlightMethod it, bool is_right) {
    if (is_right) request.airlight = it;
    return is_right;
  };
  if (is(sliced) && !more.empty()) {
    return set(sliced, more[0] == ':' && set_count(more, min_slices, max_slices, request.slices));
  }
  if (is(path)) {
    return set(path, more.starts_with(':') && set_count(more, 1, limits::paths, request.paths));
  }
  if (is(paper) && !more.empty()) {
    request.paper_mean = more.starts_with("+mean");
    request.paper_energy = more.ends_with("+energy");
    return set(paper, more == "+mean" || more == "+energy" || more == "+mean+energy");
  }
  for (const AirlightMethod it : {auto_, paper, sliced, reference}) {
    if (is(it)) return set(it, more.empty());
  }
  return false;
}

RequestOption airlight() {
  const auto set = [](RenderRequest& request, std::string_view text, const Film&) {
    if (set_method(request, text)) return std::string();
    const auto counted = [](const char* method, int low, int high) {
      return std::string(", ") + method + ":N with N from " + std::to_string(low) + " to " +
             std::to_string(high);
    };
    return refusal(text, "auto, paper, sliced, reference" + counted("path", 1, limits::paths) +
                             counted("sliced", min_slices, max_slices));
  };
  const auto get = [](const RenderRequest& request) { return airlight_name(settings_of(request)); };
  return {"airlight",
          Type::text,
          "{auto,paper,sliced,reference,path:PATHS}",
          "how the airlight is computed; sliced:SLICES has its number of slices",
          set,
          get};
}

RequestOption size() {
  const auto set = [](RenderRequest& request, std::string_view text, const Film& film) {
    const std::size_t cross = text.find('x');
    const auto side = [](std::string_view part) -> std::optional<int> {
      const auto value = parse_integer(part);
      if (!value || *value < 1 || *value > limits::film_side) return std::nullopt;
      return static_cast<int>(*value);
    };
    const std::optional<int> first = side(text.substr(0, cross));
    const std::optional<int> second =
        cross == std::string_view::npos ? first : side(text.substr(cross + 1));
    if (!first || !second) {
      return refusal(text, "WIDTHxHEIGHT or one number, the longer side, each 1 to " +
                               std::to_string(limits::film_side));
    }
    if (cross != std::string_view::npos) {
      request.film = Film{*first, *second};
      return std::string();
    }
    const double scale = static_cast<double>(*first) / std::max(film.width, film.height);
    const auto scaled = [scale](int length) {
      return std::max(1, static_cast<int>(std::lround(scale * length)));
    };
    request.film = Film{scaled(film.width), scaled(film.height)};
    return std::string();
  };
  RequestOption option{"size", Type::list, "",
                       "WIDTHxHEIGHT in pixels, instead of the scene's film, or its longer side "
                       "alone",
                       set};
  option.separator = 'x';
  return option;
}

// Fractions of the sides of the film, which size() may have set.
RequestOption region() {
  const auto set = [](RenderRequest& request, std::string_view text, const Film& film) {
    const std::vector<std::string_view> items = split(text);
    std::array<double, 4> numbers{};
    bool is_good = items.size() == numbers.size();
    for (std::size_t k = 0; is_good && k < numbers.size(); ++k) {
      const std::optional<double> number = parse_number(items[k]);
      is_good = number && *number >= 0.0 && *number <= 1.0;
      numbers[k] = number.value_or(0.0);
    }
    const auto& [x0, y0, x1, y1] = numbers;
    if (!is_good || !(x0 < x1) || !(y0 < y1)) {
      return refusal(text, "x0,y0,x1,y1, each from 0 to 1, with x0 < x1 and y0 < y1");
    }
    request.film = film_region(request.film.value_or(film), {x0, y0}, {x1, y1});
    return std::string();
  };
  return {"region", Type::list, "",
          "x0,y0,x1,y1: renders this part of the picture only; fractions of its sides, from the "
          "upper left corner",
          set};
}

RequestOption shutter() {
  const auto set = [](RenderRequest& request, std::string_view text, const Film&) {
    if (text == "none") {
      request.shutter = no_shutter;
      return std::string();
    }
    const std::vector<std::string_view> items = split(text);
    const auto open = parse_number(items[0]);
    const auto close = items.size() == 2 ? parse_number(items[1]) : std::nullopt;
    if (!open || !close || !domain::shutter.contains(*open) || !domain::shutter.contains(*close) ||
        !(*open < *close)) {
      return refusal(text,
                     "OPEN,CLOSE, two numbers of frames from -2 to 2 with OPEN < CLOSE, or none");
    }
    request.shutter = Shutter{*open, *close};
    return std::string();
  };
  const auto get = [](const RenderRequest& request) -> std::string {
    if (!request.shutter) return {};
    if (request.shutter == no_shutter) return "none";
    return quoted_text(request.shutter->open) + ',' + quoted_text(request.shutter->close);
  };
  return {"shutter",
          Type::list,
          "",
          "OPEN,CLOSE: motion blur, from and to so many frames after the time, or none; default: "
          "the scene's",
          set,
          get};
}

std::string layer_list(std::span<const LayerName> layers, const char* separator) {
  std::string names;
  for (const LayerName& layer : layers) {
    names += (names.empty() ? "" : separator) + std::string(layer.name);
  }
  return names;
}

RequestOption layers() {
  const auto set = [](RenderRequest& request, std::string_view text, const Film&) {
    OutputLayers layers;
    for (const std::string_view name : split(text)) {
      const auto* known = std::ranges::find_if(
          layer_names, [name](const LayerName& layer) { return name == layer.name; });
      if (known == layer_names.end()) return refusal(name, layer_list(layer_names, ", "));
      layers.*known->layer = true;
    }
    request.layers = layers;
    return std::string();
  };
  const auto more = std::span(layer_names).subspan(3);  // those before are there by default
  return {"layers", Type::list, '{' + layer_list(more, ",") + '}',
          "more layers of an .exr, one or several with commas between them", set};
}

// When an option says something of a frame that was rendered.
bool always(const RenderRequest&) {
  return true;
}
template <AirlightMethod... methods>
bool with(const RenderRequest& request) {
  return ((request.airlight == methods) || ...);
}

RequestOption told(bool (*when)(const RenderRequest&), RequestOption option) {
  option.is_in_header = when;
  return option;
}

std::vector<RequestOption> make_options() {
  using enum AirlightMethod;
  using Request = RenderRequest;
  return {
      size(),
      region(),
      told(always, number("time", &Request::time, -1e9, 1e9,
                          "time to render [s], for keyframes, emitters and noise")),
      told(with<sliced>, number("slices", &Request::slices, min_slices, max_slices,
                                "slices per view ray, for sliced without their number")),
      told(always, airlight()),
      told(with<sliced>, choice("scattering", &Request::scattering, scatterings,
                                "of sliced; multiple: all orders of scattering and reflection")),
      told(with<path>, number("seed", &Request::seed, 0, 4'294'967'295.0,
                              "of path: another seed is another, independent picture")),
      told(
          [](const Request& request) { return request.denoise != Denoising::none; },
          choice("denoise", &Request::denoise, denoisings,
                 "of path: solved: begin with the picture that sliced solves for, and keep of what "
                 "paths add only what stands out from their noise; the more paths, the less "
                 "depends on that picture")),
      told(with<paper, sliced>,
           choice("airlight-scale", &Request::airlight_scale, scales,
                  "compute the airlight at 1/1, 1/2 or 1/4 of the width and height and upsample "
                  "it; default: 4 for auto, else 1")),
      flag("paper-mean", &Request::paper_mean,
           "paper: evaluate the light of a Gaussian at its mean on the ray"),
      flag("paper-energy", &Request::paper_energy,
           "paper: scale the airlight of a ray to conserve energy"),
      told(always, flag("paper-spread", &Request::paper_spread,
                        "light scattered onto surfaces: use the paper's single point spread "
                        "function")),
      number("max-error", &Request::max_error, 1e-4, 10.0,
             "the relative RMSE of the airlight that auto must meet"),
      choice("error", &Request::error, measurements,
             "whether the error of the airlight is measured: none: no, and auto only chooses; "
             "quick: for at most what the picture cost; full: until its interval is narrow, and "
             "auto takes finer settings where it needs them; default: quick for auto, else none"),
      told(with<reference>, number("tolerance", &Request::tolerance, 1e-12, 1.0,
                                   "relative tolerance of the reference")),
      told(always, number("samples", &Request::samples, 1, limits::samples,
                          "samples of pixels at edges, filtered; 1: the centers of all pixels; "
                          "default: the scene's, else 16 with surfaces or visible lights, 64 "
                          "where a lens or a shutter blurs")),
      told(always, shutter()),
      layers(),
      told(always, number("deep-error", &Request::deep_error, 1e-5, 0.5,
                          "of a .deep.exr: how far its alpha and airlight may be off wherever "
                          "they are held out")),
      choice("backend", &Request::backend, backends,
             "gl: OpenGL 4.5; auto uses it if a GPU answers"),
      number("threads", &Request::threads, 1, 1024,
             "maximum number of worker threads; default: all"),
  };
}

}  // namespace

std::string RequestOption::keyword() const {
  return replaced(name, "-", "_");
}

const std::vector<RequestOption>& request_options() {
  static const std::vector<RequestOption> options = make_options();
  return options;
}

}  // namespace brume
