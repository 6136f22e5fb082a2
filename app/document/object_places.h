#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/document/scene_part.h"

namespace brume {

// The places of a scene part's objects after an edit by which some of them came, went or changed
// places.
struct ObjectPlaces {
  std::size_t part = 0;                            // index of ScenePart
  std::vector<std::optional<std::size_t>> places;  // by the place before; nullopt: it went

  [[nodiscard]] std::optional<std::size_t> of(std::size_t place_before) const {
    return place_before < places.size() ? places[place_before] : std::nullopt;
  }
};

// Finds the objects of a list in another one. If one of several that are alike went, any of them
// may have: none of these is found.
template <class T>
std::vector<std::optional<std::size_t>> places_in(const std::vector<T>& objects_now,
                                                  const std::vector<T>& objects_before) {
  const std::size_t now = objects_now.size();
  const std::size_t before = objects_before.size();
  const auto first = std::ranges::mismatch(objects_before, objects_now).in1;
  const auto same_first = static_cast<std::size_t>(first - objects_before.begin());
  std::size_t same_last = 0;
  while (same_last < std::min(now, before) &&
         objects_before[before - same_last - 1] == objects_now[now - same_last - 1]) {
    ++same_last;
  }
  std::vector<std::optional<std::size_t>> places(before);
  const std::size_t first_of_last = now - same_last;
  const bool went = before > now;
  const std::size_t kept = went ? std::min(same_first, first_of_last) : same_first;
  const std::size_t moved =
      went ? before - now + std::max(same_first, first_of_last) : before - same_last;
  for (std::size_t k = 0; k < before; ++k) {
    if (k < kept) {
      places[k] = k;
    } else if (k >= moved) {
      places[k] = k + now - before;
    }
  }
  return places;
}

// Finds the places that the objects of a part will have, if some come, go or change places.
std::vector<ObjectPlaces> places_after(const Scene& scene, const ScenePart& part);

}  // namespace brume
