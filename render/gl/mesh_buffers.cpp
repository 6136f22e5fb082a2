#include "render/gl/mesh_buffers.h"

#include "render/gl/film_airlight.h"
#include "render/gl/shader_structs.h"

namespace brume::gl {
void MeshBuffers::update(const RayCaster& ray_caster) {
  if (revision_ == ray_caster.revision()) return;
  revision_ = 0;
  const std::vector<WorldTriangle> triangles = ray_caster.triangles();
  const TriangleBvh bvh(triangles);
  std::vector<TriangleCorner> corners;
  corners.reserve(6 * bvh.order.size());
  places_.clear();
  for (const std::uint32_t i : bvh.order) {
    const WorldTriangle& triangle = triangles[i];
    places_.push_back({triangle.surface, triangle.index});
    for (const glm::vec3& position : triangle.positions) {
      corners.push_back({position, static_cast<std::int32_t>(triangle.surface)});
    }
  }
  for (const std::uint32_t i : bvh.order) {
    for (std::size_t k = 0; k < 3; ++k) {
      corners.push_back({triangles[i].normals[k],
                         static_cast<std::int32_t>(triangles[i].vertices[static_cast<int>(k)])});
    }
  }
  nodes_.upload(std::span(bvh.nodes));
  corners_.upload(std::span<const TriangleCorner>(corners));
  node_count_ = bvh.nodes.size();
  center_ = ray_caster.center();
  radius_ = ray_caster.radius();
  revision_ = ray_caster.revision();
}

void MeshBuffers::bind(const Program& program) {
  program.set("node_count", static_cast<int>(node_count_));
  program.set("surfaces_radius", radius_);
  program.set("triangle_count", static_cast<int>(places_.size()));
  program.bind("Nodes", nodes_);
  program.bind("Corners", corners_);
}

void MeshBuffers::find_hits(Programs& programs, const CameraRays& rays, const Film& film,
                            Texture& depth) {
  pixels_ = static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  hits_.reserve(pixels_ * sizeof(PixelHit));
  const Program& program = programs.get("visibility", ray_definitions(rays));
  set_rays(program, rays);
  program.set("eye", rays.eye() - center_);
  bind(program);
  program.bind("Hits", hits_);
  program.set("film", glm::ivec2(film.width, film.height));
  program.bind("depths", depth);
  program.dispatch_over({film.width, film.height});
}

std::vector<SurfaceHit> MeshBuffers::download_hits() const {
  std::vector<PixelHit> found(pixels_);
  hits_.download(std::span<PixelHit>(found));
  std::vector<SurfaceHit> hits(pixels_);
  for (std::size_t i = 0; i < pixels_; ++i) {
    const PixelHit& hit = found[i];
    if (hit.triangle < 0) continue;
    const Place& place = places_[static_cast<std::size_t>(hit.triangle)];
    hits[i] = {static_cast<double>(hit.distance), static_cast<std::int32_t>(place.surface),
               place.index, hit.u, hit.v};
  }
  return hits;
}

}  // namespace brume::gl
