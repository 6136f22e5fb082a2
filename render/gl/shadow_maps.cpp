#include "render/gl/shadow_maps.h"

#include <algorithm>

#include "render/geometry/rounding.h"
#include "render/gl/optical_depth_tables.h"
#include "render/slices/shadow_map.h"

namespace brume::gl {

void ShadowMaps::make(Programs& programs, MeshBuffers& mesh, std::span<const SlicedLight> lights,
                      std::span<const DirectionMap> directions) {
  std::size_t max_value = slot_;
  for (const DirectionMap& map : directions) max_value = std::max(max_value, map.cells());
  const std::size_t bytes = lights.size() * max_value * sizeof(float);
  if (max_value > slot_ || bytes > values_.bytes() || revision_ != mesh.revision()) maps_.clear();
  slot_ = max_value;
  values_.reserve(bytes);
  revision_ = mesh.revision();
  maps_.resize(lights.size());
  for (std::size_t l = 0; l < lights.size(); ++l) {
    Map& map = maps_[l];
    if (map.made && map.light == lights[l].position && map.directions == directions[l]) continue;
    map = {lights[l].position, directions[l],
           shadow_start(directions[l], lights[l].position, mesh.center()), true};
    const Program& program = programs["shadow_map"];
    set_map(program, map_data(map.directions, first(l)));
    program.set("light", map.light - mesh.center());
    program.set("start", map.start);
    program.set("nearest", static_cast<float>(rounding_at(map.light - mesh.center())));
    mesh.bind(program);
    program.bind("Shadows", values_);
    program.dispatch_over({map.directions.columns + 2, map.directions.rows + 2});
  }
}

}  // namespace brume::gl
