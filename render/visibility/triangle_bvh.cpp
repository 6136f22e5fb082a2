#include "render/visibility/triangle_bvh.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <memory>
#include <new>

#include "render/visibility/embree.h"

namespace brume {
namespace {

constexpr std::size_t max_in_leaf = 4;
constexpr float farthest = 1.8e18f;  // that Embree takes

// The nodes as the builder's threads make them.
struct BuiltNode {
  std::array<std::uint32_t, max_in_leaf> triangles;
  std::uint32_t count;  // of them; 0: two children
  std::array<const BuiltNode*, 2> children;
  std::array<RTCBounds, 2> bounds;
};

void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
  return new (rtcThreadLocalAlloc(allocator, sizeof(BuiltNode), 16)) BuiltNode{};
}

void set_children(void* node, void** children, unsigned count, void*) {
  for (unsigned k = 0; k < count; ++k) {
    static_cast<BuiltNode*>(node)->children[k] = static_cast<const BuiltNode*>(children[k]);
  }
}

void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
  for (unsigned k = 0; k < count; ++k) static_cast<BuiltNode*>(node)->bounds[k] = *bounds[k];
}

void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives,
                  std::size_t count, void*) {
  auto* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(BuiltNode), 16)) BuiltNode{};
  leaf->count = static_cast<std::uint32_t>(count);
  for (std::size_t k = 0; k < count; ++k) leaf->triangles[k] = primitives[k].primID;
  return leaf;
}

std::vector<RTCBuildPrimitive> boxes(std::span<const WorldTriangle> triangles) {
  std::vector<RTCBuildPrimitive> result;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i].positions;
    const glm::vec3 low = glm::min(glm::min(a, b), c);
    const glm::vec3 high = glm::max(glm::max(a, b), c);
    bool is_near = true;
    for (int k = 0; k < 3; ++k) is_near &= low[k] > -farthest && high[k] < farthest;
    if (!is_near) continue;
    result.push_back({low.x, low.y, low.z, 0, high.x, high.y, high.z, static_cast<unsigned>(i)});
  }
  return result;
}

struct Flattened {
  TriangleBvh& to;

  std::int32_t add_leaf(const BuiltNode& leaf) {
    const auto first = static_cast<std::int32_t>(to.order.size());
    to.order.insert(to.order.end(), leaf.triangles.begin(), leaf.triangles.begin() + leaf.count);
    return first;
  }

  std::int32_t add(const BuiltNode& source) {
    const std::size_t index = to.nodes.size();
    to.nodes.emplace_back();
    for (std::size_t k = 0; k < 2; ++k) {
      const RTCBounds& box = source.bounds[k];
      const BuiltNode& child = *source.children[k];
      to.nodes[index].children[k] = {{box.lower_x, box.lower_y, box.lower_z},
                                     0,
                                     {box.upper_x, box.upper_y, box.upper_z},
                                     static_cast<std::int32_t>(child.count)};
      const std::int32_t first = child.count > 0 ? add_leaf(child) : add(child);
      to.nodes[index].children[k].first = first;
    }
    return static_cast<std::int32_t>(index);
  }
};

}  // namespace

TriangleBvh::TriangleBvh(std::span<const WorldTriangle> triangles) {
  std::vector<RTCBuildPrimitive> primitives = boxes(triangles);
  if (primitives.empty()) return;
  RTCBounds all{primitives[0].lower_x, primitives[0].lower_y, primitives[0].lower_z, 0.0f,
                primitives[0].upper_x, primitives[0].upper_y, primitives[0].upper_z, 0.0f};
  for (const RTCBuildPrimitive& p : primitives) {
    all.lower_x = std::min(all.lower_x, p.lower_x);
    all.lower_y = std::min(all.lower_y, p.lower_y);
    all.lower_z = std::min(all.lower_z, p.lower_z);
    all.upper_x = std::max(all.upper_x, p.upper_x);
    all.upper_y = std::max(all.upper_y, p.upper_y);
    all.upper_z = std::max(all.upper_z, p.upper_z);
  }
  const std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device(rtcNewDevice(nullptr),
                                                                         &rtcReleaseDevice);
  if (!device) throw std::bad_alloc();
  const std::unique_ptr<RTCBVHTy, decltype(&rtcReleaseBVH)> tree(rtcNewBVH(device.get()),
                                                                 &rtcReleaseBVH);
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.maxDepth = max_levels;
  arguments.maxLeafSize = max_in_leaf;
  arguments.bvh = tree.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_bounds;
  arguments.createLeaf = create_leaf;
  const auto* root = static_cast<const BuiltNode*>(rtcBuildBVH(&arguments));
  if (!root) throw std::bad_alloc();
  Flattened flattened{*this};
  if (root->count == 0) {
    flattened.add(*root);
    return;
  }
  // A root that is a leaf has no box.
  nodes.emplace_back().children[0] = {{all.lower_x, all.lower_y, all.lower_z},
                                      0,
                                      {all.upper_x, all.upper_y, all.upper_z},
                                      static_cast<std::int32_t>(root->count)};
  flattened.add_leaf(*root);
}

}  // namespace brume
