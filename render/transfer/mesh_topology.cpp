#include "render/transfer/mesh_topology.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <array>
#include <map>
#include <mutex>

namespace brume {
namespace {

using OpenMesh::VertexHandle;

VertexHandle handle(std::size_t vertex) {
  return VertexHandle(static_cast<int>(vertex));
}

// OpenMesh reports each triangle that does not fit on its error stream, one for all threads.
class QuietErrors {
 public:
  QuietErrors() : lock_(mutex_) { omerr().disable(); }
  ~QuietErrors() {
    if (was_enabled_) omerr().enable();
  }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  static inline std::mutex mutex_;
  const std::lock_guard<std::mutex> lock_;
  const bool was_enabled_ = omerr().is_enabled();
};

}  // namespace

struct MeshTopology::Impl {
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  std::vector<std::uint32_t> triangle_of_face;
  std::multimap<std::size_t, std::uint32_t> apart;  // triangles that do not fit, by vertex
};

MeshTopology::MeshTopology(const MeshArrays& mesh) : impl_(std::make_unique<Impl>()) {
  for (std::size_t v = 0; v < mesh.points.size(); ++v) impl_->mesh.add_vertex({});
  const QuietErrors quiet;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::uvec3& corners = mesh.triangles[t];
    const std::array vertices{handle(corners.x), handle(corners.y), handle(corners.z)};
    if (impl_->mesh.add_face(vertices.data(), 3).is_valid()) {
      impl_->triangle_of_face.push_back(t);
    } else {
      for (int k = 0; k < 3; ++k) impl_->apart.emplace(corners[k], t);
    }
  }
}

MeshTopology::~MeshTopology() = default;

std::vector<std::uint32_t> MeshTopology::triangles_at(std::size_t vertex) const {
  std::vector<std::uint32_t> triangles;
  for (const auto face : impl_->mesh.vf_range(handle(vertex))) {
    triangles.push_back(impl_->triangle_of_face[static_cast<std::size_t>(face.idx())]);
  }
  const auto [begin, end] = impl_->apart.equal_range(vertex);
  for (auto entry = begin; entry != end; ++entry) triangles.push_back(entry->second);
  std::ranges::sort(triangles);
  return triangles;
}

bool MeshTopology::is_on_border(std::size_t vertex) const {
  return impl_->apart.contains(vertex) || impl_->mesh.is_boundary(handle(vertex));
}

}  // namespace brume
