// The central ray of a work group.
shared float reduced[group_size];

float reduce_min(float value) {
  const int id = int(gl_LocalInvocationID.x);
  barrier();
  reduced[id] = value;
  for (int half_ = group_size / 2; half_ > 0; half_ /= 2) {
    barrier();
    if (id < half_) reduced[id] = min(reduced[id], reduced[id + half_]);
  }
  barrier();
  return reduced[0];
}

float reduce_max(float value) { return -reduce_min(-value); }

float reduce_sum(float value) {
  const int id = int(gl_LocalInvocationID.x);
  barrier();
  reduced[id] = value;
  for (int half_ = group_size / 2; half_ > 0; half_ /= 2) {
    barrier();
    if (id < half_) reduced[id] += reduced[id + half_];
  }
  barrier();
  return reduced[0];
}

// The central ray of a group of rays and the maximum distance of the others from it, at distance 1,
// or of parallel ones everywhere.
struct CenterRay {
  vec3 w;
  float spread;
  float max_length;  // of all rays; set by the shader that chooses slices
#ifdef PARALLEL
  vec3 origin;  // relative to the eye
  float width;
#endif
};

// A position relative to the eye, relative to where the ray starts.
vec3 from_center(CenterRay ray, vec3 position) {
#ifdef PARALLEL
  return position - ray.origin;
#else
  return position;
#endif
}

// TileCone::nearest_pass(): t and h, of a position relative to where the ray starts.
vec2 nearest_pass(CenterRay ray, vec3 q) {
#ifdef PARALLEL
  const float along = dot(q, ray.w);
  return vec2(along, max(length(q - along * ray.w) - ray.width, 0.0));
#else
  const float t = dot(q, ray.w);
  const float h = max(length(q - t * ray.w) - ray.spread * max(t, 0.0), 0.0);
  return vec2(t > 0.0 ? sqrt(max(dot(q, q) - h * h, t * t)) : t, h);
#endif
}

CenterRay center_ray(bool live, vec3 w) {
  CenterRay ray;
  const vec3 contribution = live ? w : vec3(0.0);
  ray.w = normalize(
      vec3(reduce_sum(contribution.x), reduce_sum(contribution.y), reduce_sum(contribution.z)));
  ray.spread = sqrt(reduce_max(live ? dot(w - ray.w, w - ray.w) : 0.0));
  ray.max_length = 0.0;
#ifdef PARALLEL
  const vec3 offset = live ? ray_offset : vec3(0.0);
  const float count = reduce_sum(live ? 1.0 : 0.0);
  ray.origin = vec3(reduce_sum(offset.x), reduce_sum(offset.y), reduce_sum(offset.z)) / count;
  ray.width = reduce_max(live ? length(offset - ray.origin) : 0.0);
#endif
  return ray;
}
