#include "app/document/time/keyframe_tracks.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/document/object_titles.h"
#include "app/document/text/words.h"
#include "app/document/time/visit_keyed_part.h"
#include "core/number_domain.h"
#include "core/scene/animation/keys_in_domain.h"
#include "core/scene/imported_scene.h"

namespace brume {
namespace {

QString track_text(const char* text) {
  return QCoreApplication::translate("KeyRows", text);
}

// An object that can have keyframes: its title in lists, and where the scene has it.
struct Keyed {
  QString title;
  std::size_t part;
  std::size_t place = 0;  // among the part's
};

Track new_track(const Keyed& object, const QString& value, std::size_t first,
                std::size_t count = 1) {
  return {object.title, value, object.part, first, count, object.place};
}

// Calls visit(i, value, keys) for the values of a part that can have keys, in order.
void visit_values(auto& part, auto&& visit) {
  std::size_t i = 0;
  visit_keyed_part(part, [&](const char*, auto& value, auto& keys, const NumberDomain&) {
    visit(i++, value, keys);
  });
}

// Calls visit(value, keys), or visit(name, value, keys, domain), for the values of a row.
void visit_row(auto& part, const Track& row, auto&& visit) {
  std::size_t i = 0;
  visit_keyed_part(part,
                   [&](const char* name, auto& value, auto& keys, const NumberDomain& domain) {
                     const std::size_t index = i++;
                     if (!row.has_value(index)) return;
                     if constexpr (requires { visit(name, value, keys, domain); }) {
                       visit(name, value, keys, domain);
                     } else {
                       visit(value, keys);
                     }
                   });
}

bool is_same_domain(const NumberDomain& a, const NumberDomain& b) {
  return a.min_value == b.min_value && a.max_value == b.max_value && a.open == b.open;
}

// The tracks of values of core/scene/fields; those of values that are keyed jointly are neighbours.
// `value` is the index of the object's first among its part's.
void add_tracks(std::vector<Track>& rows, const Keyed& object, std::size_t& value,
                const auto& owner, const auto& all_keys) {
  bool is_joint = false;
  visit_keyed_fields(owner, all_keys, [&](const auto& field, const auto&) {
    const FieldInfo& info = field.info;
    const bool is_next = std::exchange(is_joint, info.is_keyed_jointly) && is_joint;
    if (is_next) {
      ++rows.back().count;
    } else if (is_joint) {
      rows.push_back(new_track(object, {}, value));
    } else if (!info.is_track_optional || is_set(field, owner, all_keys)) {
      rows.push_back(new_track(object, track_text(info.label), value));
    }
    ++value;
  });
}

// Moves the track of an object, at its first value, to the value of a name; behind the object if it
// has none.
void find_value(Track& track, std::string_view name, const auto& owner, const auto& all_keys) {
  bool is_found = false;
  visit_keyed_fields(owner, all_keys, [&](const auto& field, const auto&) {
    if (is_found) return;
    is_found = field.info.name == name;
    if (is_found) {
      track.value = track_text(field.info.label);
    } else {
      ++track.first;
    }
  });
}

// The tracks of surfaces, in the order of visit_keyed_surface().
std::vector<Track> surface_tracks(const Surfaces& surfaces) {
  std::vector<Track> rows;
  const QStringList names = surface_names(surfaces);
  std::size_t count = 0;
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    const Keyed object{names[static_cast<int>(k)], index_of<Surfaces>(), k};
    for (const char* value : {"Position", "Rotation", "Scale"}) {
      rows.push_back(new_track(object, track_text(value), count++));
    }
    add_tracks(rows, object, count, surfaces[k].material, surfaces[k].keys);
  }
  return rows;
}

// The track of a surface's value, by the names of visit_keyed_surface(); behind the surface if it
// has none.
Track surface_value(const Surfaces& surfaces, std::size_t index, std::string_view name) {
  std::size_t count = 0;
  const auto skip = [&count](const char*, const auto&...) { ++count; };
  for (std::size_t k = 0; k < index; ++k) visit_keyed_surface(surfaces[k], skip);
  std::size_t value = 0;
  bool is_found = false;
  visit_keyed_surface(surfaces[index], [&](const char* value_name, const auto&...) {
    is_found = is_found || value_name == name;
    if (!is_found) ++value;
  });
  std::vector<Track> rows = surface_tracks({surfaces[index]});
  Track track = value < rows.size() ? rows[value] : Track{{}, {}, index_of<Surfaces>()};
  track.object = surface_name(surfaces, index);
  track.first = count + value;
  track.place = index;
  return track;
}

// Calls visit(Keyed, object, its keys) for what can have keyframes, in the order of tracks
// and of the values of each part; with the medium for its density, and with all surfaces at once.
void visit_objects(const Scene& scene, auto&& visit) {
  const QString in_use =
      scene.cameras.empty() ? track_text("Camera") : QString::fromStdString(scene.camera_name);
  visit(Keyed{in_use, index_of<KeyedCamera>()}, scene.camera, scene.camera_keys);
  for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
    const NamedCamera& camera = scene.cameras[k];
    visit(Keyed{QString::fromStdString(camera.name), index_of<Cameras>(), k}, camera.camera,
          camera.keys);
  }
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const Light& light = scene.lights[k];
    visit(Keyed{light_title(light, k), index_of<Lights>(), k}, light, light.keys);
  }
  if (const auto& environment = scene.environment) {
    constexpr auto part = index_of<std::optional<Environment>>;
    visit(Keyed{track_text("Environment"), part()}, *environment, environment->keys);
    if (const auto& sky = environment->sky)
      visit(Keyed{track_text("Sky"), part(), 1}, *sky, sky->keys);
  }
  visit(Keyed{{}, index_of<KeyedDensity>()}, scene.medium, NoKeys());
  const MediumOptics& optics = scene.optics;
  visit(Keyed{{}, index_of<MediumOptics>()}, optics, optics.keys);
  visit(Keyed{track_text("Noise"), index_of<MediumOptics>(), 1}, optics.noise, optics.noise.keys);
  visit(Keyed{{}, index_of<Surfaces>()}, scene.surfaces, NoKeys());
  for (std::size_t k = 0; k < scene.groups.size(); ++k) {
    const Group& group = scene.groups[k];
    visit(Keyed{QString::fromStdString(group.name), index_of<Groups>(), k}, group, group.keys);
  }
  for (std::size_t k = 0; k < scene.emitters.size(); ++k) {
    const Emitter& emitter = scene.emitters[k];
    visit(Keyed{emitter_title(emitter, k), index_of<Emitters>(), k}, emitter, emitter.keys);
  }
}

// Keys of a row at some times.
void visit_keys(ScenePart& part, const Track& row, std::span<const double> times, auto&& visit) {
  visit_row(part, row, [&](const auto&, auto& keys) {
    for (const double time : times) {
      const auto found = find_key(keys, time);
      if (found != keys.end()) visit(keys, static_cast<std::size_t>(found - keys.begin()));
    }
  });
}

// Calls visit(keys) for all that moves of what a surface shows of its imported scene.
void visit_imported(const Surface& surface, auto&& visit) {
  if (!surface.imported) return;
  const auto visit_moving = [&](const auto& keys) {
    if (keys.size() > 1) visit(keys);
  };
  for (const ImportedPart* part : chosen_parts(*surface.imported, surface.nodes)) {
    visit_moving(part->keys.translate);
    visit_moving(part->keys.rotate);
    visit_moving(part->keys.scale);
    if (part->deformation) visit_moving(part->deformation->poses);
  }
}

// The keys of all parts, which are as many as there are samples, a millisecond apart.
std::vector<Keyframe> imported_keyframes(const Surface& surface) {
  std::vector<double> times;
  std::vector<double> last;  // the times of the values before, which most share
  visit_imported(surface, [&](const auto& keys) {
    const auto same = [](const auto& key, double time) { return key.time == time; };
    if (std::ranges::equal(keys, last, same)) return;
    last.clear();
    for (const auto& key : keys) last.push_back(key.time);
    times.insert(times.end(), last.begin(), last.end());
  });
  std::ranges::sort(times);
  constexpr double resolution = 1e-3;
  std::vector<Keyframe> marks;
  for (const double time : times) {
    if (marks.empty() || time - marks.back().time > resolution) {
      marks.push_back({time, Interpolation::linear});
    }
  }
  return marks;
}

// Sorts keyframes, and keeps the first of those at one time.
void sort_keyframes(std::vector<Keyframe>& marks) {
  std::ranges::stable_sort(marks, {}, &Keyframe::time);
  const auto is_same = [](const Keyframe& a, const Keyframe& b) {
    return is_same_key_time(a.time, b.time);
  };
  const auto others = std::ranges::unique(marks, is_same);
  marks.erase(others.begin(), others.end());
}

void add_keyframes(std::vector<Keyframe>& marks, const auto& keys) {
  for (const auto& key : keys) marks.push_back({key.time, key.interpolation, tangents_of(key)});
}

}  // namespace

bool Track::operator==(const Track& other) const {
  return part == other.part && place == other.place && (count == 0) == (other.count == 0) &&
         value == other.value;
}

void follow_places(std::vector<Track>& tracks, const ObjectPlaces& places) {
  std::erase_if(tracks, [&places](Track& track) {
    if (track.part != places.part) return false;
    const auto place = places.of(track.place);
    if (place) track.place = *place;
    return !place;
  });
}

QString Track::title() const {
  if (object.isEmpty() || value.isEmpty()) return object + value;
  return object + ' ' + in_sentence(value);
}

std::vector<Track> tracks(const Scene& scene) {
  std::vector<Track> rows;
  std::size_t last_part = 0;
  std::size_t value = 0;  // its index among those of its part
  visit_objects(scene, [&](const Keyed& object, const auto& owner, const auto& all_keys) {
    if (std::exchange(last_part, object.part) != object.part) value = 0;
    if constexpr (std::is_same_v<decltype(owner), const Medium&>) {
      rows.push_back({{}, track_text("Homogeneous density"), object.part, 0, 1});
    } else if constexpr (std::is_same_v<decltype(owner), const Surfaces&>) {
      for (Track& row : surface_tracks(owner)) rows.push_back(std::move(row));
    } else {
      add_tracks(rows, object, value, owner, all_keys);
    }
  });
  return rows;
}

Track value_track(const Scene& scene, std::size_t part, std::size_t object, std::string_view name) {
  Track track{{}, {}, part, 0, 1};
  std::size_t i = 0;
  visit_objects(scene, [&]<class T>(const Keyed& keyed, const T& owner, const auto& all_keys) {
    if (keyed.part != part) return;
    if constexpr (std::is_same_v<T, Surfaces>) {
      track = surface_value(owner, object, name);
    } else if constexpr (std::is_same_v<T, Medium>) {
      track.value = track_text("Homogeneous density");
    } else if (i <= object) {
      track.object = keyed.title;
      track.place = keyed.place;
      find_value(track, i == object ? name : std::string_view(), owner, all_keys);
      ++i;
    }
  });
  return track;
}

// Each part is visited once: there may be many surfaces.
std::vector<KeyedTrack> keyed_tracks(const Scene& scene) {
  std::vector<KeyedTrack> keyed;
  std::map<std::size_t, std::vector<std::vector<Keyframe>>> all_marks;  // by part and value
  for (Track& track : tracks(scene)) {
    const auto [found, is_new] = all_marks.try_emplace(track.part);
    std::vector<std::vector<Keyframe>>& part_marks = found->second;
    if (is_new) {
      visit_scene_values(scene, track.part,
                         [&](const char*, const auto&, const auto& keys, const NumberDomain&) {
                           add_keyframes(part_marks.emplace_back(), keys);
                         });
    }
    std::vector<Keyframe> marks;
    std::vector<std::size_t> values;
    for (std::size_t k = track.first; k < track.first + track.count; ++k) {
      if (!part_marks[k].empty()) values.push_back(k);
      marks.insert(marks.end(), part_marks[k].begin(), part_marks[k].end());
    }
    if (marks.empty()) continue;
    sort_keyframes(marks);
    keyed.push_back({std::move(track), std::move(marks), std::move(values)});
  }
  return keyed;
}

std::vector<Track> imported_tracks(const Scene& scene) {
  std::vector<Track> rows;
  const QStringList names = surface_names(scene.surfaces);
  for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
    bool moves = false;
    visit_imported(scene.surfaces[k], [&moves](const auto&) { moves = true; });
    if (!moves) continue;
    const Keyed object{names[static_cast<int>(k)], index_of<Surfaces>(), k};
    rows.push_back(new_track(object, track_text("Animation"), 0, 0));
  }
  return rows;
}

std::vector<Keyframe> keyframes_of(const Scene& scene, const Track& row) {
  if (row.count == 0) return imported_keyframes(scene.surfaces[row.place]);
  std::vector<Keyframe> marks;
  std::size_t i = 0;
  visit_scene_values(scene, row.part,
                     [&](const char*, const auto&, const auto& keys, const NumberDomain&) {
                       const std::size_t index = i++;
                       if (row.has_value(index)) add_keyframes(marks, keys);
                     });
  sort_keyframes(marks);
  return marks;
}

bool may_have_tangents(const Scene& scene, const Track& row) {
  const ScenePart part = scene_part(scene, row.part);
  bool may = false;
  visit_row(part, row, [&may]<class T>(const T&, const Keys<T>&) {
    may = may || !std::is_same_v<T, glm::dquat>;
  });
  return may;
}

void set_keys(ScenePart& part, const Track& row, double time) {
  visit_row(part, row, [time]<class T>(const T& value, Keys<T>& keys) {
    const auto found = find_key(keys, time);
    Key<T> key = found != keys.end() ? *found : Key<T>{.time = time};
    key.value = value;
    // It goes on as the values did.
    for (const Key<T>& other : keys) {
      if (other.time < time + min_key_distance) key.interpolation = other.interpolation;
    }
    set_key(keys, key);
  });
}

void delete_keys(ScenePart& part, const Track& row, std::span<const double> times) {
  visit_keys(part, row, times, [](auto& keys, std::size_t i) {
    keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(i));
  });
}

void move_keys(ScenePart& part, const Track& row, std::span<const KeyMove> moves) {
  visit_row(part, row, [moves]<class T>(const T&, Keys<T>& keys) {
    Keys<T> moved;
    for (const KeyMove& move : moves) {
      const auto found = find_key(keys, move.from);
      if (found == keys.end()) continue;
      moved.push_back(*found);
      moved.back().time = move.to;
      keys.erase(found);
    }
    for (const Key<T>& key : moved) set_key(keys, key);
  });
}

void paste_keys(ScenePart& part, const Track& row, const ScenePart& copied, const Track& copied_row,
                std::span<const KeyMove> moves) {
  struct Source {
    std::variant<const Keys<double>*, const Keys<glm::dvec2>*, const Keys<glm::dvec3>*,
                 const Keys<glm::dquat>*>
        keys;
    NumberDomain domain;
  };
  std::vector<Source> sources;
  visit_row(copied, copied_row,
            [&sources](const char*, const auto&, const auto& keys, const NumberDomain& domain) {
              sources.push_back({&keys, domain});
            });
  std::size_t i = 0;
  visit_row(part, row,
            [&]<class T>(const char* name, const T&, Keys<T>& keys, const NumberDomain& domain) {
              if (i >= sources.size()) return;
              const Source& source = sources[i++];
              const auto* source_keys = std::get_if<const Keys<T>*>(&source.keys);
              if (!source_keys) return;
              for (const KeyMove& move : moves) {
                const auto found = find_key(**source_keys, move.from);
                if (found == (*source_keys)->end()) continue;
                Key<T> key = *found;
                key.time = move.to;
                key.value = nearest(domain, key.value);
                if (!may_be_value(name, key.value)) continue;
                if (!is_same_domain(source.domain, domain)) {
                  key.in.reset();
                  key.out.reset();
                }
                set_key(keys, key);
              }
            });
}

void set_interpolation(ScenePart& part, const Track& row, std::span<const double> times,
                       Interpolation interpolation) {
  visit_keys(part, row, times,
             [interpolation](auto& keys, std::size_t i) { keys[i].interpolation = interpolation; });
}

void set_tangents(ScenePart& part, const Track& row, std::span<const double> times,
                  Tangents tangents) {
  visit_keys(part, row, times, [tangents]<class T>(Keys<T>& keys, std::size_t i) {
    if constexpr (!std::is_same_v<T, glm::dquat>) {
      auto [in, out] = slopes_at(keys, i);
      Key<T>& key = keys[i];
      key.interpolation = Interpolation::smooth;
      key.aligned = tangents == Tangents::aligned;
      if (key.aligned) in = out = 0.5 * (in + out);
      key.in = in;
      key.out = out;
      if (tangents != Tangents::automatic) return;
      key.in.reset();
      key.out.reset();
    }
  });
}

void apply_keys(ScenePart& part, double time) {
  visit_keyed_part(part,
                   [time](const char*, auto& value, const auto& keys, const NumberDomain& domain) {
                     if (!keys.empty()) value = value_at(keys, time, domain);
                   });
}

void key_changes(const ScenePart& before, ScenePart& after, double time) {
  if (before.index() != after.index()) return;
  using Visited = std::variant<std::pair<const double*, const Keys<double>*>,
                               std::pair<const glm::dvec2*, const Keys<glm::dvec2>*>,
                               std::pair<const glm::dvec3*, const Keys<glm::dvec3>*>,
                               std::pair<const glm::dquat*, const Keys<glm::dquat>*>>;
  std::vector<Visited> were;
  visit_values(before, [&were]<class T>(std::size_t, const T& value, const Keys<T>& keys) {
    were.emplace_back(std::pair(&value, &keys));
  });
  std::vector<std::size_t> changed;
  std::size_t count = 0;
  visit_values(after, [&]<class T>(std::size_t i, const T& value, const Keys<T>& keys) {
    ++count;
    if (i >= were.size() || keys.empty()) return;
    const auto* was = std::get_if<std::pair<const T*, const Keys<T>*>>(&were[i]);
    if (was && *was->first != value && *was->second == keys) changed.push_back(i);
  });
  if (count != were.size()) return;  // a light came or went
  for (const std::size_t i : changed) set_keys(after, {{}, {}, after.index(), i, 1}, time);
}

}  // namespace brume
