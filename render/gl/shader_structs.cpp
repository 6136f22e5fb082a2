#include "render/gl/shader_structs.h"

#include <array>
#include <cstddef>
#include <span>
#include <sstream>
#include <type_traits>

namespace brume::gl {
namespace {

using BvhChild = TriangleBvh::Child;
using BvhNode = TriangleBvh::Node;

// What GLSL calls a type of C++, and how std430 aligns it.
template <class T>
struct Type;
template <>
struct Type<float> {
  static constexpr const char* name = "float";
  static constexpr std::size_t alignment = 4;
};
template <>
struct Type<std::int32_t> {
  static constexpr const char* name = "int";
  static constexpr std::size_t alignment = 4;
};
template <>
struct Type<std::uint32_t> {
  static constexpr const char* name = "uint";
  static constexpr std::size_t alignment = 4;
};
template <>
struct Type<glm::vec3> {
  static constexpr const char* name = "vec3";
  static constexpr std::size_t alignment = 16;
};
template <>
struct Type<glm::vec4> {
  static constexpr const char* name = "vec4";
  static constexpr std::size_t alignment = 16;
};
template <>
struct Type<glm::ivec4> {
  static constexpr const char* name = "ivec4";
  static constexpr std::size_t alignment = 16;
};
template <>
struct Type<MapData> {
  static constexpr const char* name = "DirectionMap";
  static constexpr std::size_t alignment = 16;
};
template <>
struct Type<BvhChild> {
  static constexpr const char* name = "BvhChild";
  static constexpr std::size_t alignment = 16;
};

struct Member {
  const char* type;
  const char* name;
  std::size_t alignment;
  std::size_t offset;
  std::size_t size;
  std::size_t count;  // of an array; 0: it is none
};

template <class T>
constexpr Member member(const char* name, std::size_t offset) {
  using Element = std::remove_extent_t<T>;
  return {Type<Element>::name, name, Type<Element>::alignment, offset, sizeof(T), std::extent_v<T>};
}
#define BRUME_MEMBER(Struct, name) member<decltype(Struct::name)>(#name, offsetof(Struct, name))

constexpr std::size_t round_up(std::size_t x, std::size_t unit) {
  return (x + unit - 1) / unit * unit;
}

// Whether std430 places the members where C++ does, and gives the struct the same size.
constexpr bool is_std430(std::span<const Member> members, std::size_t size) {
  std::size_t end = 0;
  std::size_t alignment = 1;
  for (const Member& m : members) {
    if (round_up(end, m.alignment) != m.offset) return false;
    // Elements of arrays lie at multiples of their alignment.
    if (m.count > 0 && m.size / m.count % m.alignment != 0) return false;
    end = m.offset + m.size;
    alignment = std::max(alignment, m.alignment);
  }
  return round_up(end, alignment) == size;
}

// Whether a struct consists of nothing but the members, each of whole floats.
constexpr bool is_packed(std::span<const Member> members, std::size_t size) {
  std::size_t end = 0;
  for (const Member& m : members) {
    if (m.offset != end || m.size % sizeof(float) != 0) return false;
    end += m.size;
  }
  return end == size;
}

constexpr std::array map_members{BRUME_MEMBER(MapData, right), BRUME_MEMBER(MapData, up),
                                 BRUME_MEMBER(MapData, axis), BRUME_MEMBER(MapData, offset),
                                 BRUME_MEMBER(MapData, cells)};
static_assert(is_std430(map_members, sizeof(MapData)));

constexpr std::array light_members{
    BRUME_MEMBER(LightData, position),       BRUME_MEMBER(LightData, h_min),
    BRUME_MEMBER(LightData, intensity),      BRUME_MEMBER(LightData, shadow_bias),
    BRUME_MEMBER(LightData, first_radius),   BRUME_MEMBER(LightData, radii_per_unit),
    BRUME_MEMBER(LightData, curvature),      BRUME_MEMBER(LightData, max_depth),
    BRUME_MEMBER(LightData, radii),          BRUME_MEMBER(LightData, has_table),
    BRUME_MEMBER(LightData, has_shadows),    BRUME_MEMBER(LightData, falloff_shape),
    BRUME_MEMBER(LightData, falloff_axis),   BRUME_MEMBER(LightData, dark_versine),
    BRUME_MEMBER(LightData, per_versine),    BRUME_MEMBER(LightData, radius2),
    BRUME_MEMBER(LightData, profile_column), BRUME_MEMBER(LightData, profile_row),
    BRUME_MEMBER(LightData, azimuth_0),      BRUME_MEMBER(LightData, unused_0),
    BRUME_MEMBER(LightData, azimuth_90),     BRUME_MEMBER(LightData, unused_90),
    BRUME_MEMBER(LightData, fog_center),     BRUME_MEMBER(LightData, fog_radius),
    BRUME_MEMBER(LightData, map_origin),     BRUME_MEMBER(LightData, in_table),
    BRUME_MEMBER(LightData, in_shadows),     BRUME_MEMBER(LightData, table),
    BRUME_MEMBER(LightData, shadows)};
static_assert(is_std430(light_members, sizeof(LightData)));

constexpr std::array paper_light_members{
    BRUME_MEMBER(PaperLightData, position),         BRUME_MEMBER(PaperLightData, h_min),
    BRUME_MEMBER(PaperLightData, intensity),        BRUME_MEMBER(PaperLightData, transmittance),
    BRUME_MEMBER(PaperLightData, conserves_energy), BRUME_MEMBER(PaperLightData, unused)};
static_assert(is_std430(paper_light_members, sizeof(PaperLightData)));

constexpr std::array shape_members{
    BRUME_MEMBER(GaussianShape, a), BRUME_MEMBER(GaussianShape, scale),
    BRUME_MEMBER(GaussianShape, max_e), BRUME_MEMBER(GaussianShape, cutoff_radius)};
static_assert(is_std430(shape_members, sizeof(GaussianShape)));

constexpr std::array seen_members{BRUME_MEMBER(SeenGaussian, center),
                                  BRUME_MEMBER(SeenGaussian, a),
                                  BRUME_MEMBER(SeenGaussian, scale),
                                  BRUME_MEMBER(SeenGaussian, max_e),
                                  BRUME_MEMBER(SeenGaussian, max_undisplaced_e),
                                  BRUME_MEMBER(SeenGaussian, cutoff_radius)};
static_assert(is_std430(seen_members, sizeof(SeenGaussian)));

constexpr std::array tile_totals_members{BRUME_MEMBER(TileTotals, used),
                                         BRUME_MEMBER(TileTotals, entries),
                                         BRUME_MEMBER(TileTotals, coarse)};
static_assert(is_std430(tile_totals_members, sizeof(TileTotals)));

constexpr std::array upsampling_totals_members{
    BRUME_MEMBER(UpsamplingTotals, batches), BRUME_MEMBER(UpsamplingTotals, asked_pixels),
    BRUME_MEMBER(UpsamplingTotals, mean_square), BRUME_MEMBER(UpsamplingTotals, curved_cells)};
static_assert(is_std430(upsampling_totals_members, sizeof(UpsamplingTotals)));

constexpr std::array child_members{BRUME_MEMBER(BvhChild, low), BRUME_MEMBER(BvhChild, first),
                                   BRUME_MEMBER(BvhChild, high), BRUME_MEMBER(BvhChild, count)};
static_assert(is_std430(child_members, sizeof(BvhChild)));

constexpr std::array node_members{BRUME_MEMBER(BvhNode, children)};
static_assert(is_std430(node_members, sizeof(BvhNode)));

constexpr std::array corner_members{BRUME_MEMBER(TriangleCorner, vector),
                                    BRUME_MEMBER(TriangleCorner, index)};
static_assert(is_std430(corner_members, sizeof(TriangleCorner)));

constexpr std::array hit_members{BRUME_MEMBER(PixelHit, distance), BRUME_MEMBER(PixelHit, u),
                                 BRUME_MEMBER(PixelHit, v), BRUME_MEMBER(PixelHit, triangle)};
static_assert(is_std430(hit_members, sizeof(PixelHit)));

constexpr std::array batch_members{BRUME_MEMBER(PixelBatch, tile), BRUME_MEMBER(PixelBatch, first),
                                   BRUME_MEMBER(PixelBatch, count)};
static_assert(is_packed(batch_members, sizeof(PixelBatch)));

constexpr std::array surface_members{
    BRUME_MEMBER(SurfaceRecord, diffuse),        BRUME_MEMBER(SurfaceRecord, exponent),
    BRUME_MEMBER(SurfaceRecord, highlight),      BRUME_MEMBER(SurfaceRecord, reflection_at),
    BRUME_MEMBER(SurfaceRecord, has_transfer),   BRUME_MEMBER(SurfaceRecord, transferred_functions),
    BRUME_MEMBER(SurfaceRecord, front_at),       BRUME_MEMBER(SurfaceRecord, back_at),
    BRUME_MEMBER(SurfaceRecord, grid_corner),    BRUME_MEMBER(SurfaceRecord, average_depths_at),
    BRUME_MEMBER(SurfaceRecord, cells_per_unit), BRUME_MEMBER(SurfaceRecord, measured_at),
    BRUME_MEMBER(SurfaceRecord, grid_nodes)};
static_assert(is_packed(surface_members, sizeof(SurfaceRecord)));

constexpr std::array material_members{BRUME_MEMBER(MaterialRecord, base_color),
                                      BRUME_MEMBER(MaterialRecord, metallic),
                                      BRUME_MEMBER(MaterialRecord, emissive),
                                      BRUME_MEMBER(MaterialRecord, roughness),
                                      BRUME_MEMBER(MaterialRecord, normal_scale),
                                      BRUME_MEMBER(MaterialRecord, is_metallic_roughness),
                                      BRUME_MEMBER(MaterialRecord, base_color_texture),
                                      BRUME_MEMBER(MaterialRecord, metallic_roughness_texture),
                                      BRUME_MEMBER(MaterialRecord, normal_texture),
                                      BRUME_MEMBER(MaterialRecord, emissive_texture)};
static_assert(is_packed(material_members, sizeof(MaterialRecord)));

constexpr std::array turn_members{BRUME_MEMBER(TurnElement, to), BRUME_MEMBER(TurnElement, from),
                                  BRUME_MEMBER(TurnElement, value)};
static_assert(is_packed(turn_members, sizeof(TurnElement)));

void add_struct(const char* name, std::span<const Member> members, std::ostream& out) {
  out << "struct " << name << " {\n";
  for (const Member& m : members) {
    out << "  " << m.type << ' ' << m.name;
    if (m.count > 0) out << '[' << m.count << ']';
    out << ";\n";
  }
  out << "};\n";
}

// Places in words of four bytes.
void add_places(const char* name, std::span<const Member> members, std::size_t size,
                std::ostream& out) {
  constexpr std::size_t word = sizeof(float);
  for (const Member& m : members) {
    out << "const int " << name << '_' << m.name << " = " << m.offset / word << ";\n";
  }
  out << "const int " << name << "_size = " << size / word << ";\n";
}

}  // namespace

std::string shader_structs() {
  std::ostringstream out;
  add_struct("DirectionMap", map_members, out);
  add_struct("Light", light_members, out);
  add_struct("PaperLight", paper_light_members, out);
  add_struct("GaussianShape", shape_members, out);
  add_struct("SeenGaussian", seen_members, out);
  add_struct("TileTotals", tile_totals_members, out);
  add_struct("UpsamplingTotals", upsampling_totals_members, out);
  add_struct("BvhChild", child_members, out);
  add_struct("BvhNode", node_members, out);
  add_struct("TriangleCorner", corner_members, out);
  add_struct("PixelHit", hit_members, out);
  add_places("batch", batch_members, sizeof(PixelBatch), out);
  add_places("surface", surface_members, sizeof(SurfaceRecord), out);
  add_places("material", material_members, sizeof(MaterialRecord), out);
  add_places("turn", turn_members, sizeof(TurnElement), out);
  return out.str();
}

}  // namespace brume::gl
