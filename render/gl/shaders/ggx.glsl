// Metallic-roughness reflection: add_ggx_light() of render/simd and GgxSh of core/scene, whose tables
// begin among the values of shade_surfaces.glsl.

uniform int ggx_at;

// A GgxReflection.
struct Ggx {
  bool is_set;  // else the surface is of another material
  vec3 diffuse, f0, emitted;
  float alpha;
};

// As materials.glsl leaves it behind the pixels; sets the normal.
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

// Outgoing radiance of `light`, which turn_to_eye() has turned.
vec3 ggx_reflected(Ggx ggx, float cosine) {
  const int layer = (ggx_angles + 1) * ggx_row;
  const float angle = acos(clamp(cosine, 0.0, 1.0)) * (float(ggx_angles) * 2.0 / pi);
  const float row = min(floor(angle), float(ggx_angles - 1));
  const float roughness = sqrt(ggx.alpha) * float(ggx_roughnesses);
  const float below = min(floor(roughness), float(ggx_roughnesses - 1));
  const int diffuse_at = ggx_at + int(row) * ggx_row;
  const int scaled_at = ggx_at + layer + int(below) * layer + int(row) * ggx_row;
  const int added_at = scaled_at + (ggx_roughnesses + 1) * layer;
  vec3 sum = vec3(0.0);
  int i = 0;
  for (int l = 0; l < sh_bands; ++l) {
    for (int m = 0; m <= l; ++m) {
      const float scaled = mix(ggx_between(scaled_at + i, angle - row),
                               ggx_between(scaled_at + layer + i, angle - row), roughness - below);
      const float added = mix(ggx_between(added_at + i, angle - row),
                              ggx_between(added_at + layer + i, angle - row), roughness - below);
      sum += (ggx.diffuse * ggx_between(diffuse_at + i, angle - row) + ggx.f0 * scaled + added) *
             light[l * (l + 1) + m];
      ++i;
    }
  }
  return sum;
}
