#include <algorithm>
#include <array>
#include <new>
#include <span>

#include "brume/edits.h"
#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_columns.h"
#include "core/io/scene/cameras_and_output_json.h"
#include "core/io/scene/fields_json.h"
#include "core/io/scene/json_reader.h"
#include "core/io/scene/keys_json.h"
#include "core/io/scene/light_json.h"
#include "core/io/scene/medium_json.h"
#include "core/io/scene/scene_budget.h"
#include "core/io/scene/scene_file.h"
#include "core/io/scene/scene_names.h"
#include "core/io/scene/scene_references.h"
#include "core/io/scene/surface_json.h"
#include "core/number_domain.h"
#include "core/scene/animation/animation.h"
#include "core/scene/animation/particles.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

class SceneLoader {
 public:
  SceneLoader(const fs::path& file, std::vector<std::string>* warnings, MissingFiles* missing)
      : context_(file, warnings), references_(file, missing) {}

  SceneDocument load(const Json& root) {
    JsonObject object(context_, root, root_);
    check_version(object);
    read_cameras(context_, object, scene_, unknown_keys_);
    if (auto film = object.find_object("film")) load_film(*film);
    if (auto output = object.find_object("output")) {
      scene_.output = read_output(context_, *output, references_, unknown_keys_);
    }
    if (auto medium = object.find_object("medium")) load_medium(*medium);
    load_elements(object, "lights", limits::lights, &SceneLoader::load_light);
    if (auto environment = object.find_object("environment")) load_environment(*environment);
    load_elements(object, "surfaces", limits::surfaces, &SceneLoader::load_surface);
    surfaces_.reserve_scattered(object.path_of("surfaces"), scene_.surfaces);
    if (auto timeline = object.find_object("timeline")) load_timeline(*timeline);
    unknown_keys_.add("", object.unknown_keys());
    context_.finish_warnings();
    return std::move(document_);
  }

 private:
  using LoadElement = void (SceneLoader::*)(JsonObject&);

  void load_elements(JsonObject& object, const char* key, std::size_t longest,
                     LoadElement load_element) {
    const Json::array_t& elements = object.array(key, longest);
    const JsonPath path = object.path_of(key);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      JsonObject element(context_, elements[i], path.element(i));
      (this->*load_element)(element);
    }
  }

  static void check_version(JsonObject& object) {
    const Json& format = object.required("format");
    if (format != scene_names::format) {
      object.fail("format", "found " + quoted_json(format) + "; allowed: \"brume-scene\"");
    }
    const Json& version = object.required("version");
    if (!version.is_number() || version != scene_names::version) {
      const bool newer = version.is_number() && version > scene_names::version;
      object.fail("version",
                  "found " + quoted_json(version) + "; allowed: 1" +
                      (newer ? " (the scene was written by a newer version of Brume)" : ""));
    }
  }

  std::string load_keys(JsonObject& owner, auto&& visit_all) {
    return read_keys_member(context_, owner, unknown_keys_, visit_all);
  }

  void load_rest(JsonObject& object, ObjectId& id, auto&& visit_all, const char* part = "") {
    read_rest(context_, object, id, unknown_keys_, visit_all, part);
  }

  void load_film(JsonObject& object) {
    Film& film = scene_.film;
    film.width = static_cast<int>(object.integer("width", 1, limits::film_side, film.width));
    film.height = static_cast<int>(object.integer("height", 1, limits::film_side, film.height));
    unknown_keys_.add("film", object.unknown_keys());
  }

  void load_timeline(JsonObject& object) {
    Playback playback;
    const std::int64_t first = object.integer("first", 0, limits::frame, 0);
    playback.first = static_cast<int>(first);
    static_cast<void>(object.required("last"));
    playback.last = static_cast<int>(object.integer("last", first, limits::frame, first));
    playback.loops = object.boolean("loop", playback.loops);
    playback.frames_per_second =
        object.number("frames_per_second", domain::frame_rate, playback.frames_per_second);
    unknown_keys_.add("timeline", object.unknown_keys());
    scene_.playback = playback;
  }

  void load_medium(JsonObject& object) {
    scene_.medium.set_homogeneous_density(object.number("density", domain::density, 0.0));
    load_elements(object, "groups", limits::groups, &SceneLoader::load_group);
    read_parents(context_, object.array("groups", limits::groups), object.path_of("groups"),
                 scene_.groups);
    load_elements(object, "splines", limits::splines, &SceneLoader::load_spline);
    const JsonPath gaussians = object.path_of("gaussians");
    budget_.reserve_gaussians(gaussians, object.array("gaussians", limits::gaussians).size());
    load_elements(object, "gaussians", limits::gaussians, &SceneLoader::load_gaussian);
    if (object.find("file") != nullptr) load_medium_file(object);

    MediumOptics& optics = scene_.optics;
    read_fields(object, optics);
    if (auto noise = object.find_object("noise")) load_noise(*noise);
    load_elements(object, "emitters", limits::emitters, &SceneLoader::load_emitter);
    load_elements(object, "sequences", limits::sequences, &SceneLoader::load_sequence);
    unknown_keys_.add("medium.keys", load_keys(object, [&](auto&& visit) {
                        visit_keyed_density(scene_.medium, scene_.density_keys, visit);
                        visit_keyed(optics, visit);
                      }));
    unknown_keys_.add("medium", object.unknown_keys());
  }

  void load_gaussian(JsonObject& object) {
    Gaussian gaussian;
    gaussian.center = object.vector("center", domain::coordinate, {});
    load_radii(object, gaussian);
    gaussian.density = object.number("density", domain::density, {});
    gaussian.optics = load_optics(object);
    gaussian.group = read_group_name(object, "group", scene_.groups);
    PaintedSpline* spline = read_spline_name(object, scene_.splines);
    const std::array ids{read_id(object)};
    const GaussianId id = ids[0];
    if (id == scene_.medium.next_id()) {
      scene_.medium.append(gaussian);
    } else {
      MediumEdit::add(scene_.medium, std::span(&gaussian, 1), ids).apply(scene_.medium);
    }
    if (spline != nullptr) spline->gaussians.push_back(id);
    unknown_keys_.add_of_gaussian(id, object.unknown_keys());
  }

  // The id of the next Gaussian: one more than that of the last, or a larger one that it has. What
  // else the key holds is another program's, and unknown.
  GaussianId read_id(JsonObject& object) const {
    const GaussianId next = scene_.medium.next_id();
    const Json* found = object.peek("id");
    if (found == nullptr || !found->is_number_unsigned()) return next;
    const auto id = found->get<GaussianId>();
    if (id < next || !gaussian_columns::is_id(static_cast<double>(id))) return next;
    static_cast<void>(object.find("id"));
    return id;
  }

  void load_group(JsonObject& object) {
    Group group = read_group(object, scene_.groups);
    load_rest(object, group.object_id, [&](auto&& visit) { visit_keyed(group, visit); });
    scene_.groups.push_back(std::move(group));
  }

  void load_spline(JsonObject& object) {
    PaintedSpline spline = read_spline(context_, object, scene_.splines);
    spline.optics = load_optics(object);
    unknown_keys_.add(spline.object_id, "", object.unknown_keys());
    scene_.splines.push_back(std::move(spline));
  }

  void load_radii(JsonObject& object, Gaussian& gaussian) {
    if (!object.find("radii")) {
      gaussian.radius = object.number("radius", domain::length, {});
      return;
    }
    const JsonPath path = object.path_of("radii");
    if (object.find("radius")) context_.fail(path, "found beside radius; allowed: one of the two");
    const glm::dvec3 radii = object.vector("radii", domain::length, {});
    if (const std::string why = refused_radii(radii); !why.empty()) context_.fail(path, why);
    glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
    if (const Json* rotate = object.find("rotate")) {
      rotation = read_unit_quaternion(context_, *rotate, object.path_of("rotate"));
    }
    gaussian.set_radii(radii, rotation);
  }

  // The optics of a Gaussian or of a spline's.
  static GaussianOptics load_optics(JsonObject& object) {
    GaussianOptics optics;
    if (object.find("albedo")) optics.albedo = object.vector("albedo", domain::albedo, {});
    optics.emission = object.vector("emission", domain::intensity, optics.emission);
    return optics;
  }

  void load_medium_file(JsonObject& object) {
    const JsonPath path = object.path_of("file");
    auto source = std::make_shared<MediumFile>();
    source->file = references_.resolve(context_, path, object.text("file", {}));
    std::vector<GaussianNumber> numbers;
    const std::vector<Gaussian> gaussians = references_.gaussians(
        context_, path, source->file, budget_.gaussians_left(), scene_.groups.size(), numbers);
    budget_.reserve_gaussians(path, gaussians.size());
    Medium& medium = scene_.medium;
    source->first_id = medium.next_id();
    if (are_free_ids(numbers)) {
      source->first_id = std::ranges::min(numbers);
      add_with_ids(gaussians, numbers);
    } else {
      medium.reserve(medium.size() + gaussians.size());
      for (const Gaussian& g : gaussians) medium.append(g);
    }
    source->loaded = medium;
    document_.extras.medium_file = std::move(source);
  }

  // Whether the ids of a file are above those of the Gaussians so far, and all different.
  [[nodiscard]] bool are_free_ids(std::vector<GaussianNumber> numbers) const {
    std::ranges::sort(numbers);
    return !numbers.empty() && numbers.front() >= scene_.medium.next_id() &&
           std::ranges::adjacent_find(numbers) == numbers.end();
  }

  void add_with_ids(const std::vector<Gaussian>& gaussians,
                    const std::vector<GaussianNumber>& numbers) {
    std::vector<std::pair<GaussianId, std::size_t>> order;
    for (std::size_t i = 0; i < numbers.size(); ++i) order.emplace_back(numbers[i], i);
    std::ranges::sort(order);
    std::vector<GaussianId> ids;
    std::vector<Gaussian> sorted;
    for (const auto& [id, i] : order) {
      ids.push_back(id);
      sorted.push_back(gaussians[i]);
    }
    MediumEdit::add(scene_.medium, sorted, ids).apply(scene_.medium);
  }

  void load_noise(JsonObject& object) {
    Noise& noise = scene_.optics.noise;
    read_fields(object, noise);
    unknown_keys_.add("medium.noise.keys",
                      load_keys(object, [&](auto&& visit) { visit_keyed(noise, visit); }));
    unknown_keys_.add("medium.noise", object.unknown_keys());
  }

  void load_emitter(JsonObject& object) {
    Emitter emitter;
    emitter.name = object.name("");
    read_fields(object, emitter);
    if (object.find("emission_at_death") == nullptr) {
      emitter.emission_at_death = emitter.optics.emission;
    }
    load_rest(object, emitter.id, [&](auto&& visit) { visit_keyed(emitter, visit); });
    budget_.reserve_gaussians(object.path(), max_particles(emitter));
    scene_.emitters.push_back(emitter);
  }

  void load_sequence(JsonObject& object) {
    MediumSequence sequence;
    const JsonPath file = object.path_of("file");
    sequence.file = references_.resolve_pattern(context_, file, object.text("file", {}));
    constexpr std::int64_t max_value = 999'999'999;
    const std::int64_t first = object.integer("first", 0, max_value, 0);
    const std::int64_t last = object.integer(
        "last", first, std::min(max_value, first + limits::sequence_frames - 1), first);
    sequence.first = static_cast<int>(first);
    sequence.last = static_cast<int>(last);
    sequence.frames_per_second =
        object.number("frames_per_second", domain::rate, sequence.frames_per_second);
    sequence.start = object.number("start", domain::seconds, sequence.start);
    sequence.frames = references_.sequence(context_, file, sequence, budget_.gaussians_left());
    budget_.reserve_gaussians(file, gaussian_count(sequence));
    unknown_keys_.add(sequence.id, "", object.unknown_keys());
    scene_.sequences.push_back(std::move(sequence));
  }

  void load_light(JsonObject& object) {
    scene_.lights.push_back(read_light(context_, object, references_, budget_, unknown_keys_));
  }

  void load_surface(JsonObject& object) { scene_.surfaces.push_back(surfaces_.read(object)); }

  Sky load_sky(JsonObject& object, ObjectId& environment) {
    Sky sky;
    read_fields(object, sky);
    if (sky.sun && scene_.lights.size() == limits::lights) {
      object.fail("sun", "found true beside " + std::to_string(limits::lights) +
                             " lights; allowed: one light less, or false");
    }
    load_rest(
        object, environment, [&](auto&& visit) { visit_keyed(sky, visit); }, "sky");
    return sky;
  }

  void load_environment(JsonObject& object) {
    Environment environment;
    read_fields(object, environment);
    if (auto sky = object.find_object("sky")) {
      if (object.find("file") != nullptr) object.fail("sky", found_beside("file"));
      environment.sky = load_sky(*sky, environment.id);
    } else {
      const JsonPath file = object.path_of("file");
      environment.file = references_.resolve(context_, file, object.text("file", {}));
      environment.map = references_.radiance_map(context_, file, environment.file);
      budget_.reserve(file, *environment.map);
    }
    load_rest(object, environment.id, [&](auto&& visit) { visit_keyed(environment, visit); });
    scene_.environment = std::move(environment);
  }

  JsonContext context_;
  SceneBudget budget_{context_};
  JsonPath root_;
  SceneReferences references_;
  SceneDocument document_;
  Scene& scene_ = document_.scene;
  UnknownKeys& unknown_keys_ = document_.extras.unknown_keys;
  SurfaceReader surfaces_{context_, references_, budget_, unknown_keys_};
};

SceneDocument load(const fs::path& file, std::vector<std::string>* warnings,
                   MissingFiles* missing) {
  try {
    const Json json = parse_json(file, read_bytes(file));
    return SceneLoader(file, warnings, missing).load(json);
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw InputError(file, "", "does not fit into memory");
  } catch (const std::exception& error) {  // of the file system, or a limit of the library's
    throw InputError(file, "", error.what());
  }
}

}  // namespace

SceneDocument load_document(const fs::path& file, std::vector<std::string>* warnings) {
  return load(file, warnings, nullptr);
}

SceneDocument load_document(const fs::path& file, std::vector<std::string>* warnings,
                            MissingFiles& missing) {
  return load(file, warnings, &missing);
}

Scene load_scene(const fs::path& file, std::vector<std::string>* warnings) {
  return load_document(file, warnings).scene;
}

}  // namespace brume
