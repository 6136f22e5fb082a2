#include "app/document/object_places.h"

#include <string>

namespace brume {
namespace {

// Finds the places that cameras will have in use and among the others: one that comes
// in use goes from the others.
std::vector<ObjectPlaces> camera_places(const Scene& scene, const CameraList& list) {
  const auto names_of = [](const std::string& in_use, const Cameras& others) {
    std::vector<std::string> names{in_use};
    for (const NamedCamera& camera : others) names.push_back(camera.name);
    return names;
  };
  const std::vector<std::string> before = names_of(scene.camera_name, scene.cameras);
  const std::vector<std::string> now = names_of(list.in_use.name, list.others);
  ObjectPlaces in_use{index_of<KeyedCamera>(), {}};
  ObjectPlaces others{index_of<Cameras>(), {}};
  for (std::size_t k = 0; k < before.size(); ++k) {
    auto place = static_cast<std::size_t>(std::ranges::find(now, before[k]) - now.begin());
    const bool is_gone = place == now.size();
    // An edit renames one camera, in its place, or none.
    const bool is_renamed =
        is_gone && now.size() == before.size() && std::ranges::find(before, now[k]) == before.end();
    if (is_renamed) place = k;
    if (k == 0) {
      in_use.places.push_back(place == 0 ? std::optional(place) : std::nullopt);
    } else {
      const bool is_other = place > 0 && place < now.size();
      others.places.push_back(is_other ? std::optional(place - 1) : std::nullopt);
    }
  }
  return {in_use, others};
}

}  // namespace

std::vector<ObjectPlaces> places_after(const Scene& scene, const ScenePart& part) {
  if (const auto* list = std::get_if<CameraList>(&part)) return camera_places(scene, *list);
  std::vector<ObjectPlaces> places;
  const auto find = [&part, &places]<class T>(const std::vector<T>& objects) {
    const auto* list = std::get_if<std::vector<T>>(&part);
    if (!list || list->size() == objects.size()) return;
    places.push_back({part.index(), places_in(*list, objects)});
  };
  find(scene.lights);
  find(scene.surfaces);
  find(scene.emitters);
  find(scene.groups);
  return places;
}

}  // namespace brume
