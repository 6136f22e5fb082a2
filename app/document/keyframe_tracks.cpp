#include "app/document/keyframe_tracks.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/document/surface_names.h"
#include "app/document/visit_keyed_part.h"
#include "core/number_domain.h"
#include "core/scene/animation/keys_in_domain.h"
#include "core/scene/imported_scene.h"

namespace brume {
namespace {

QString track_text(const char* text) {
  return QCoreApplication::translate("KeyRows", text);
}

// Calls visit(i, value, keys) for the values of a part that can have keys, in order.
void visit_values(auto& part, auto&& visit) {
  std::size_t i = 0;
  visit_keyed_part(part, [&](const char*, auto& value, auto& keys, const NumberDomain&) {
    visit(i++, value, keys);
  });
}

// The same for the values of a row.
void visit_row(auto& part, const Track& row, auto&& visit) {
  visit_values(part, [&](std::size_t i, auto& value, auto& keys) {
    if (i >= row.first && i < row.first + row.count) visit(value, keys);
  });
}

// "Camera focus distance"
QString track_title(const QString& object, const FieldInfo& info) {
  const QString label = track_text(info.label);
  return object.isEmpty() ? label : object + ' ' + label.toLower();
}

// The tracks of values of core/scene/fields; those of values that are keyed jointly are neighbours.
// `value`: index of the object's first among its part's.
void add_tracks(std::vector<Track>& rows, const QString& object, std::size_t part,
                std::size_t& value, const auto& owner, const auto& all_keys) {
  bool is_joint = false;
  visit_keyed_fields(owner, all_keys, [&](const auto& field, const auto&) {
    const FieldInfo& info = field.info;
    const bool is_next = std::exchange(is_joint, info.is_keyed_jointly) && is_joint;
    if (is_next) {
      ++rows.back().count;
    } else if (is_joint) {
      rows.push_back({object, part, value, 1});
    } else if (!info.is_track_optional || is_set(field, owner, all_keys)) {
      rows.push_back({track_title(object, info), part, value, 1});
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
      track.title = track_title(track.title, field.info);
    } else {
      ++track.first;
    }
  });
}

// In the order of visit_keyed_surface().
void add_surface_tracks(std::vector<Track>& rows, const Surfaces& surfaces) {
  const QStringList names = surface_names(surfaces);
  std::size_t count = 0;
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    const auto add = [&](const QString& title) {
      rows.push_back({title.arg(names[static_cast<int>(k)]), index_of<Surfaces>(), count++, 1,
                      ObjectRef{ObjectRef::Kind::surface, k}});
    };
    add(track_text("%1 position"));
    add(track_text("%1 rotation"));
    add(track_text("%1 scale"));
    const std::size_t first = rows.size();
    add_tracks(rows, names[static_cast<int>(k)], index_of<Surfaces>(), count, surfaces[k].material,
               surfaces[k].keys);
    for (Track& row : std::span(rows).subspan(first)) row.surface = {ObjectRef::Kind::surface, k};
  }
}

// Calls visit(title, part, object, its keys) for what can have keyframes, in the order of tracks
// and of the values of each part; with the medium for its density, and with all surfaces at once.
void visit_objects(const Scene& scene, auto&& visit) {
  visit(track_text("Camera"), index_of<KeyedCamera>(), scene.camera, scene.camera_keys);
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const Light& light = scene.lights[k];
    visit(track_text("Light %1").arg(k + 1), index_of<Lights>(), light, light.keys);
  }
  if (const auto& environment = scene.environment) {
    visit(track_text("Environment"), index_of<std::optional<Environment>>(), *environment,
          environment->keys);
    if (const auto& sky = environment->sky) {
      visit(track_text("Sky"), index_of<std::optional<Environment>>(), *sky, sky->keys);
    }
  }
  visit(track_text("Homogeneous density"), index_of<KeyedDensity>(), scene.medium, NoKeys());
  const MediumOptics& optics = scene.optics;
  visit(QString(), index_of<MediumOptics>(), optics, optics.keys);
  visit(track_text("Noise"), index_of<MediumOptics>(), optics.noise, optics.noise.keys);
  visit(QString(), index_of<Surfaces>(), scene.surfaces, NoKeys());
  for (const Group& group : scene.groups) {
    visit(QString::fromStdString(group.name), index_of<Groups>(), group, group.keys);
  }
  for (std::size_t k = 0; k < scene.emitters.size(); ++k) {
    const Emitter& emitter = scene.emitters[k];
    visit(track_text("Emitter %1").arg(k + 1), index_of<Emitters>(), emitter, emitter.keys);
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
  std::vector<double> last;  // of the values before; most have the same
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

}  // namespace

std::vector<Track> tracks(const Scene& scene) {
  std::vector<Track> rows;
  std::size_t last_part = 0;
  std::size_t value = 0;  // of its part
  visit_objects(
      scene, [&](const QString& title, std::size_t part, const auto& owner, const auto& all_keys) {
        if (std::exchange(last_part, part) != part) value = 0;
        if constexpr (std::is_same_v<decltype(owner), const Medium&>) {
          rows.push_back({title, part, 0, 1});
        } else if constexpr (std::is_same_v<decltype(owner), const Surfaces&>) {
          add_surface_tracks(rows, owner);
        } else {
          add_tracks(rows, title, part, value, owner, all_keys);
        }
      });
  return rows;
}

Track value_track(const Scene& scene, std::size_t part, std::size_t object, std::string_view name) {
  Track track{{}, part, 0, 1};
  std::size_t i = 0;
  visit_objects(scene, [&]<class T>(const QString& title, std::size_t objects_part, const T& owner,
                                    const auto& all_keys) {
    if constexpr (!std::is_same_v<T, Medium> && !std::is_same_v<T, Surfaces>) {
      if (objects_part != part || i > object) return;
      track.title = title;
      find_value(track, i == object ? name : std::string_view(), owner, all_keys);
      ++i;
    }
  });
  return track;
}

// Copies each part once: there may be many surfaces.
std::vector<Track> tracks_with_keys(const Scene& scene) {
  std::vector<Track> rows = tracks(scene);
  std::map<std::size_t, std::vector<bool>> keyed;  // by part, of its values
  std::erase_if(rows, [&](const Track& row) {
    const auto [at, is_new] = keyed.try_emplace(row.part);
    std::vector<bool>& values = at->second;
    if (is_new) {
      const ScenePart part = scene_part(scene, row.part);
      visit_values(part, [&values](std::size_t, const auto&, const auto& keys) {
        values.push_back(!keys.empty());
      });
    }
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(row.first);
    return std::none_of(first, first + static_cast<std::ptrdiff_t>(row.count),
                        [](bool has_keys) { return has_keys; });
  });
  return rows;
}

std::vector<Track> imported_tracks(const Scene& scene) {
  std::vector<Track> rows;
  const QStringList names = surface_names(scene.surfaces);
  for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
    bool moves = false;
    visit_imported(scene.surfaces[k], [&moves](const auto&) { moves = true; });
    if (!moves) continue;
    rows.push_back({track_text("%1 animation").arg(names[static_cast<int>(k)]),
                    index_of<Surfaces>(), 0, 0, ObjectRef{ObjectRef::Kind::surface, k}});
  }
  return rows;
}

std::vector<Keyframe> keyframes_of(const Scene& scene, const Track& row) {
  if (row.count == 0) return imported_keyframes(scene.surfaces[row.surface->index]);
  std::vector<Keyframe> marks;
  const ScenePart part = scene_part(scene, row.part);
  visit_row(part, row, [&marks](const auto&, const auto& keys) {
    for (const auto& key : keys) {
      const auto is_same = [&key](const Keyframe& mark) {
        return std::abs(mark.time - key.time) < min_key_distance;
      };
      if (std::any_of(marks.begin(), marks.end(), is_same)) continue;
      marks.push_back({key.time, key.interpolation, tangents_of(key)});
    }
  });
  std::sort(marks.begin(), marks.end(),
            [](const Keyframe& a, const Keyframe& b) { return a.time < b.time; });
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
  for (const std::size_t i : changed) set_keys(after, {{}, after.index(), i, 1}, time);
}

}  // namespace brume
