// Metallic-roughness reflection: add_ggx_light() of render/simd and GgxSh of core/scene, whose tables
// begin among the values of shade_surfaces.glsl.

uniform int ggx_at;

// A GgxReflection.
struct Ggx {
  bool is_set;  // else the surface is of another material
  vec3 diffuse, f0, emitted;
  float alpha;
};

// Reads the reflection that materials.glsl leaves behind the pixels; sets the normal.
Ggx ggx_of(int place, inout vec3 normal) {
  const vec4 vectors[ggx_vectors] =
      vec4[](behind[place], behind[place + 1], behind[place + 2], behind[place + 3]);
  const bool is_set = vectors[0].w > 0.0;
  if (is_set) normal = vectors[0].xyz;
  return Ggx(is_set, vectors[1].rgb, vec3(vectors[1].w, vectors[2].w, vectors[3].x), vectors[2].rgb,
             vectors[0].w);
}

vec3 ggx_brdf(Ggx ggx, vec3 wi, vec3 wo, vec3 n) {
  const float cos_light = dot(wi, n);
  const float cos_eye = max(dot(wo, n), min_ggx_cosine);
  const vec3 sum = wi + wo;
  const float length_ = length(sum);
  const vec3 h = length_ > tiny ? sum / length_ : vec3(0.0);
  const float s = schlick(length_);
  const float specular = length_ > tiny ? microfacets(n, h, cos_light, cos_eye, ggx.alpha) : 0.0;
  return (1.0 - s) / pi * ggx.diffuse + specular * (ggx.f0 * (1.0 - s) + s);
}

float ggx_between(int place, float fraction) {
  return mix(values[place], values[place + ggx_row], fraction);
}

// Where the tables lie for a material and the eye's angle: of its diffuse part, and of the parts of
// its specular one that are multiplied by f0 and added, for the roughness below.
TableRow ggx_diffuse = TableRow(0, 0.0);
int ggx_scaled_at = 0;
int ggx_added_at = 0;
float ggx_rougher = 0.0;

const int ggx_layer = (ggx_angles + 1) * ggx_row;

void find_ggx_rows(Ggx ggx, float cosine) {
  ggx_diffuse = row_at(ggx_at, ggx_row, ggx_angles, cosine);
  const float roughness = sqrt(ggx.alpha) * float(ggx_roughnesses);
  const float below = min(floor(roughness), float(ggx_roughnesses - 1));
  ggx_rougher = roughness - below;
  ggx_scaled_at = ggx_diffuse.first + (1 + int(below)) * ggx_layer;
  ggx_added_at = ggx_scaled_at + (ggx_roughnesses + 1) * ggx_layer;
}

// The same as table_reflectance(), from these rows.
vec3 ggx_reflectance(Ggx ggx, int i) {
  const float angle = ggx_diffuse.fraction;
  const float scaled = mix(ggx_between(ggx_scaled_at + i, angle),
                           ggx_between(ggx_scaled_at + ggx_layer + i, angle), ggx_rougher);
  const float added = mix(ggx_between(ggx_added_at + i, angle),
                          ggx_between(ggx_added_at + ggx_layer + i, angle), ggx_rougher);
  return ggx.diffuse * ggx_between(ggx_diffuse.first + i, angle) + ggx.f0 * scaled + added;
}
