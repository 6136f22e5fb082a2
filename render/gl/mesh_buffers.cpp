#include "render/gl/mesh_buffers.h"

#include <bit>
#include <glm/vec4.hpp>

#include "render/gl/film_airlight.h"
#include "render/visibility/triangle_bvh.h"

namespace brume::gl {
namespace {

glm::ivec4 bits(const glm::vec3& v, std::int32_t w) {
  return {std::bit_cast<std::int32_t>(v.x), std::bit_cast<std::int32_t>(v.y),
          std::bit_cast<std::int32_t>(v.z), w};
}

}  // namespace

void MeshBuffers::update(const RayCaster& ray_caster) {
  if (revision_ == ray_caster.revision()) return;
  revision_ = 0;
  const std::vector<WorldTriangle> triangles = ray_caster.triangles();
  const TriangleBvh bvh(triangles);
  std::vector<glm::ivec4> nodes;
  nodes.reserve(4 * bvh.nodes.size());
  for (const TriangleBvh::Node& node : bvh.nodes) {
    for (const TriangleBvh::Child& child : node.children) {
      nodes.push_back(bits(child.low, child.first));
      nodes.push_back(bits(child.high, child.count));
    }
  }
  std::vector<glm::ivec4> corners;
  corners.reserve(6 * bvh.order.size());
  places_.clear();
  for (const std::uint32_t i : bvh.order) {
    const WorldTriangle& triangle = triangles[i];
    places_.push_back({triangle.surface, triangle.index});
    for (const glm::vec3& position : triangle.positions) {
      corners.push_back(bits(position, static_cast<std::int32_t>(triangle.surface)));
    }
  }
  for (const std::uint32_t i : bvh.order) {
    for (std::size_t k = 0; k < 3; ++k) {
      corners.push_back(
          bits(triangles[i].normals[k],
               static_cast<std::int32_t>(triangles[i].vertices[static_cast<int>(k)])));
    }
  }
  nodes_.upload(std::span<const glm::ivec4>(nodes));
  corners_.upload(std::span<const glm::ivec4>(corners));
  node_count_ = bvh.nodes.size();
  center_ = ray_caster.center();
  radius_ = ray_caster.radius();
  min_gap_ = ray_caster.min_gap();
  revision_ = ray_caster.revision();
}

void MeshBuffers::bind(const Program& program) {
  program.set("node_count", static_cast<int>(node_count_));
  program.set("surfaces_radius", radius_);
  program.set("triangle_count", static_cast<int>(places_.size()));
  nodes_.bind(4);
  corners_.bind(5);
}

void MeshBuffers::find_hits(Programs& programs, const CameraRays& rays, const Film& film,
                            Texture& depth) {
  pixels_ = static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  hits_.reserve(pixels_ * sizeof(glm::ivec4));
  const Program& program = programs["visibility"];
  set_rays(program, rays);
  program.set("eye", rays.eye() - center_);
  bind(program);
  hits_.bind(2);
  depth.bind_image(0);
  program.dispatch(static_cast<std::size_t>((film.width + 7) / 8),
                   static_cast<std::size_t>((film.height + 7) / 8));
}

std::vector<SurfaceHit> MeshBuffers::download_hits() const {
  std::vector<glm::ivec4> packed(pixels_);
  hits_.download(std::span<glm::ivec4>(packed));
  std::vector<SurfaceHit> hits(pixels_);
  for (std::size_t i = 0; i < pixels_; ++i) {
    if (packed[i].w < 0) continue;
    const Place& place = places_[static_cast<std::size_t>(packed[i].w)];
    hits[i] = {static_cast<double>(std::bit_cast<float>(packed[i].x)),
               static_cast<std::int32_t>(place.surface), place.index,
               std::bit_cast<float>(packed[i].y), std::bit_cast<float>(packed[i].z)};
  }
  return hits;
}

}  // namespace brume::gl
