#include "render/lights/distant_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

namespace brume {
namespace {

using std::numbers::pi;

// The light of a part of the map. `moment` is the sum of the channels' irradiance, times direction.
struct MapLight {
  glm::dvec3 irradiance{0.0};
  glm::dvec3 moment{0.0};

  MapLight& operator+=(const MapLight& other) {
    irradiance += other.irradiance;
    moment += other.moment;
    return *this;
  }
  MapLight& operator-=(const MapLight& other) {
    irradiance -= other.irradiance;
    moment -= other.moment;
    return *this;
  }
  [[nodiscard]] double power() const { return irradiance.x + irradiance.y + irradiance.z; }
  // spread: variance of the direction, sum of irradiance |direction - mean direction|^2. reduction:
  // reduction of that variance by grouping, |moment|^2 / power.
  [[nodiscard]] double reduction() const {
    return power() > 0.0 ? glm::dot(moment, moment) / power() : 0.0;
  }
  [[nodiscard]] double spread() const { return std::max(power() - reduction(), 0.0); }
};

// A map on a raster of equal angles, each cell with all the light of its part of the map.
class MapRaster {
 public:
  MapRaster(const RadianceMap& map, int rows) : rows_(rows), columns_(2 * rows), cells_(size()) {
    // A coarse map is taken as it is between its pixels.
    const int fine_y = (rows + map.height - 1) / map.height;
    const int fine_x = (columns_ + map.width - 1) / map.width;
    const int height = fine_y * map.height;
    const int width = fine_x * map.width;
    const bool is_interpolated = fine_x > 1 || fine_y > 1;
    for (int y = 0; y < height; ++y) {
      const double solid_angle =
          2.0 * pi / width * (std::cos(pi * y / height) - std::cos(pi * (y + 1.0) / height));
      const int row = static_cast<int>(static_cast<std::int64_t>(y) * rows / height);
      for (int x = 0; x < width; ++x) {
        const glm::dvec3 direction = map_direction(map, {(x + 0.5) / fine_x, (y + 0.5) / fine_y});
        const glm::dvec3 radiance =
            is_interpolated ? map_radiance(map, direction) : glm::dvec3(map.pixel(x, y));
        const glm::dvec3 irradiance = solid_angle * radiance;
        const int column = static_cast<int>(static_cast<std::int64_t>(x) * columns_ / width);
        at(column, row) += {irradiance, (irradiance.x + irradiance.y + irradiance.z) * direction};
      }
    }
  }

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  MapLight& at(int column, int row) { return cells_[index(column, row)]; }
  [[nodiscard]] const MapLight& at(int column, int row) const { return cells_[index(column, row)]; }

 private:
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_);
  }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  int rows_;
  int columns_;
  std::vector<MapLight> cells_;
};

// A box of a raster: cells [x0, x1) x [y0, y1).
struct RasterBox {
  int x0, y0, x1, y1;
  MapLight light;
  double spread;
  int cluster = 0;

  bool operator<(const RasterBox& other) const { return spread < other.spread; }
};

RasterBox box_of(const MapRaster& raster, int x0, int y0, int x1, int y1) {
  RasterBox box{x0, y0, x1, y1, {}, 0.0};
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) box.light += raster.at(x, y);
  }
  box.spread = box.light.spread();
  return box;
}

// The split of a box with minimum variance; nullopt for a single cell.
std::optional<std::pair<RasterBox, RasterBox>> halves(const MapRaster& raster,
                                                      const RasterBox& box) {
  double max_reduction = -1.0;
  int cut_x = 0;
  int cut_y = 0;
  const auto try_cut = [&](const MapLight& before, int x, int y) {
    MapLight after = box.light;
    after -= before;
    const double reduction = before.reduction() + after.reduction();
    if (!(reduction > max_reduction)) return;
    max_reduction = reduction;
    cut_x = x;
    cut_y = y;
  };
  MapLight before;
  for (int x = box.x0; x + 1 < box.x1; ++x) {
    for (int y = box.y0; y < box.y1; ++y) before += raster.at(x, y);
    try_cut(before, x + 1, 0);
  }
  before = {};
  for (int y = box.y0; y + 1 < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) before += raster.at(x, y);
    try_cut(before, 0, y + 1);
  }
  if (max_reduction < 0.0) return std::nullopt;
  return cut_x > 0 ? std::pair{box_of(raster, box.x0, box.y0, cut_x, box.y1),
                               box_of(raster, cut_x, box.y0, box.x1, box.y1)}
                   : std::pair{box_of(raster, box.x0, box.y0, box.x1, cut_y),
                               box_of(raster, box.x0, cut_y, box.x1, box.y1)};
}

std::optional<DistantLight> distant(const MapLight& light) {
  if (!(light.power() > 0.0)) return std::nullopt;
  const double length = glm::length(light.moment);
  // A uniform map has no mean direction: any will do.
  return DistantLight{length > 0.0 ? light.moment / length : glm::dvec3(0, 1, 0), light.irradiance};
}

void append(const MapLight& light, std::vector<DistantLight>& lights) {
  if (const auto one = distant(light)) lights.push_back(*one);
}

// Splits the box of maximum variance until there are enough.
std::vector<RasterBox> split(const MapRaster& raster, const LightGrouping& grouping) {
  const int side = raster.rows() / grouping.min_rows;
  // A single box covers all longitudes.
  const int width = grouping.min_rows == 1 ? raster.columns() : side;
  std::vector<RasterBox> boxes;  // a heap, and behind it those that cannot be split
  for (int y = 0; y < raster.rows(); y += side) {
    for (int x = 0; x < raster.columns(); x += width) {
      boxes.push_back(box_of(raster, x, y, x + width, y + side));
    }
  }
  auto end = boxes.size();
  std::make_heap(boxes.begin(), boxes.end());
  for (;;) {
    if (boxes.size() <= grouping.clusters) {
      for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i].cluster = static_cast<int>(i);
    }
    if (end == 0 || boxes.size() >= grouping.groups || !(boxes.front().spread > 0.0)) return boxes;
    const auto heap_end = boxes.begin() + static_cast<std::ptrdiff_t>(end);
    std::pop_heap(boxes.begin(), heap_end);
    const RasterBox box = boxes[end - 1];
    if (const auto cut = halves(raster, box)) {
      boxes[end - 1] = cut->first;
      boxes[end - 1].cluster = box.cluster;
      boxes.insert(heap_end, cut->second)->cluster = box.cluster;
      std::push_heap(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(end));
      ++end;
      std::push_heap(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(end));
    } else {
      --end;
    }
  }
}

}  // namespace

std::vector<DistantLight> distant_lights(const RadianceMap& map, std::size_t count) {
  const MapRaster raster(map, distant_light_rows);
  std::vector<DistantLight> lights;
  for (const RasterBox& box : split(raster, {.groups = count})) append(box.light, lights);
  return lights;
}

std::vector<LightGroup> distant_light_groups(const RadianceMap& map,
                                             const LightGrouping& grouping) {
  const MapRaster raster(map, distant_light_rows);
  std::vector<LightGroup> groups;
  for (const RasterBox& box : split(raster, grouping)) {
    const auto combined = distant(box.light);
    if (!combined) continue;
    LightGroup& group = groups.emplace_back(LightGroup{*combined, {}, box.cluster});
    for (int y = box.y0; y < box.y1; ++y) {
      for (int x = box.x0; x < box.x1; ++x) append(raster.at(x, y), group.lights);
    }
  }
  return groups;
}

}  // namespace brume
