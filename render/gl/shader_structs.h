#pragma once

#include <cstdint>
#include <glm/ext/vector_int4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>

#include "render/formulas/shared_struct.h"
#include "render/visibility/triangle_bvh.h"

namespace brume::gl {

// Structs that C++ and shaders share in storage buffers, laid out as std430 has it.

// A DirectionMap.
BRUME_SHARED_STRUCT(MapData, {
  glm::vec4 right{0.0f};   // w: scale.x
  glm::vec4 up{0.0f};      // w: scale.y
  glm::vec4 axis{0.0f};    // w: 1 if octahedral
  glm::vec4 offset{0.0f};  // x, y
  glm::ivec4 cells{0};     // columns and rows without the border; index of the first value
});

// A light of the sliced airlight or of surfaces.
BRUME_SHARED_STRUCT(LightData, {
  glm::vec3 position{0.0f};  // relative to the eye, or to the center of the surfaces
  float h_min = 0.0f;        // see PointLightRay
  glm::vec3 intensity{0.0f};
  float shadow_bias = 0.0f;  // see shadow_bias()
  // The radii of the table, see TableRadii.
  float first_radius = 0.0f;
  float radii_per_unit = 0.0f;
  float curvature = 0.0f;
  float max_depth = 0.0f;  // of the table
  std::int32_t radii = 0;
  std::int32_t has_table = 0;
  std::int32_t has_shadows = 0;
  std::int32_t falloff_shape = 0;  // LightFalloff::Shape
  glm::vec3 falloff_axis{0.0f};
  float dark_versine = 0.0f;
  float per_versine = 0.0f;
  float radius2 = 0.0f;  // see PointSource::distance2()
  // The place where the map of a profile or a picture begins.
  std::int32_t map_column = 0;
  std::int32_t map_row = 0;
  glm::vec3 azimuth_0{0.0f};   // of a cone
  float area_of_point = 0.0f;  // of an area light, see area_of_point()
  glm::vec3 azimuth_90{0.0f};
  float area_radius = 0.0f;  // of a sphere
  // The area light that it stands for: AreaOutline.
  glm::vec3 area_center{0.0f};
  std::int32_t area_points = 0;
  glm::vec3 area_u{0.0f};
  std::int32_t area_corners = 0;
  glm::vec3 area_v{0.0f};
  std::int32_t area_is_two_sided = 0;
  std::int32_t map_side = 0;
  float cotangent = 0.0f;  // of a picture
  float area_far2 = 0.0f;  // see AreaShape
  std::int32_t index = 0;  // see PointLight
  // The ball of homogeneous fog that its light passes, as the position is; radius 0: all the way.
  glm::vec3 fog_center{0.0f};
  float fog_radius = 0.0f;
  // See SliceLight.
  glm::vec4 map_origin{0.0f};
  glm::vec4 in_table{0.0f};
  glm::vec4 in_shadows{0.0f};  // w: shadow_depth
  MapData table;
  MapData shadows;
});

// A light of the paper's airlight.
BRUME_SHARED_STRUCT(PaperLightData, {
  glm::vec3 position{0.0f};  // relative to the eye
  float h_min = 0.0f;
  glm::vec3 intensity{0.0f};
  float transmittance = 0.0f;  // of the Gaussians from the light to the eye
  std::int32_t conserves_energy = 0;
  std::int32_t unused[3] = {};
});

// A Gaussian; see GaussianBatch.
BRUME_SHARED_STRUCT(GaussianShape, {
  float a = 0.0f;
  float scale = 0.0f;
  float max_e = 0.0f;
  float cutoff_radius = 0.0f;
});

// A Gaussian as the eye sees it.
BRUME_SHARED_STRUCT(SeenGaussian, {
  glm::vec3 center{0.0f};  // relative to the eye
  float a = 0.0f;
  float scale = 0.0f;
  float max_e = 0.0f;
  float max_undisplaced_e = 0.0f;  // before noise displaces the ray
  float cutoff_radius = 0.0f;
});

// Sums of tile binning.
BRUME_SHARED_STRUCT(TileTotals, {
  std::uint32_t used = 0;     // Gaussians in any list
  std::uint32_t entries = 0;  // of all lists
  std::uint32_t coarse = 0;   // entries / coarse_entries of each Gaussian, rounded up
});

// Sums of the upsampling.
BRUME_SHARED_STRUCT(UpsamplingTotals, {
  std::uint32_t batches = 0;
  std::uint32_t asked_pixels = 0;
  float mean_square = 0.0f;  // of the airlight's samples
  std::uint32_t curved_cells = 0;
});

// A work group's pixels, among those that the upsampling asks for.
BRUME_SHARED_STRUCT(PixelBatch, {
  std::uint32_t tile = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
});

// A corner of a triangle: its position and surface, or its normal and vertex.
BRUME_SHARED_STRUCT(TriangleCorner, {
  glm::vec3 vector{0.0f};
  std::int32_t index = 0;
});

// The hit of a view ray.
BRUME_SHARED_STRUCT(PixelHit, {
  float distance = 0.0f;  // < 0: nothing
  float u = 0.0f;
  float v = 0.0f;
  std::int32_t triangle = -1;
});

// The values of a surface, as floats among other values; places are indices of those or of the
// light at surfaces, < 0: none.
BRUME_SHARED_STRUCT(SurfaceRecord, {
  glm::vec3 diffuse{0.0f};  // reflectance / pi
  float exponent = 0.0f;    // Phong's
  glm::vec3 highlight{0.0f};
  float reflection_at = 0.0f;          // its ReflectionTable; 0: it is diffuse
  float has_transfer = 0.0f;           // 1: radiance transfer has been applied at its vertices
  float transferred_functions = 0.0f;  // basis functions still to be reflected
  float front_at = -1.0f;              // light at the vertices
  float back_at = -1.0f;
  glm::vec3 grid_corner{0.0f};  // of its average depths
  float average_depths_at = -1.0f;
  glm::vec3 cells_per_unit{0.0f};
  float measured_at = -1.0f;  // the table of a measured material
  glm::vec3 grid_nodes{0.0f};
});

// A metallic-roughness material, as words among others; textures are places of those, 0: none.
BRUME_SHARED_STRUCT(MaterialRecord, {
  glm::vec3 base_color{0.0f};
  float metallic = 0.0f;
  glm::vec3 emissive{0.0f};
  float roughness = 0.0f;
  float normal_scale = 0.0f;
  std::uint32_t is_metallic_roughness = 0;  // 0: the surface is of another material
  std::uint32_t base_color_texture = 0;
  std::uint32_t metallic_roughness_texture = 0;
  std::uint32_t normal_texture = 0;
  std::uint32_t emissive_texture = 0;
});
// The number of vectors that shaders/materials.glsl finds of a pixel.
inline constexpr int ggx_vectors = 4;

// GLSL source of these structs, and of the places of members of those that are read as floats
// (`NAME_member`) and their sizes (`NAME_size`).
std::string shader_structs();

}  // namespace brume::gl
