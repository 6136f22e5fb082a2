// View rays of a film: see CameraRays. Double precision up to the direction, since pixels of narrow
// views are closer than float resolves. With PARALLEL defined, those of an orthographic camera.
uniform dvec3 corner;
uniform dvec3 per_x;
uniform dvec3 per_y;
uniform ivec2 first_pixel;  // of the film on the whole one

dvec2 position_of(ivec2 pixel) { return dvec2(first_pixel + pixel) + 0.5LF; }

#ifdef PARALLEL
uniform dvec3 parallel_direction;

dvec3 exact_direction(ivec2 pixel) { return parallel_direction; }

// Where a ray starts, from the eye.
dvec3 exact_offset(ivec2 pixel) {
  const dvec2 position = position_of(pixel);
  return corner + position.x * per_x + position.y * per_y;
}

vec3 ray_offset = vec3(0.0);  // of this invocation's ray

void set_ray_offset(ivec2 pixel) { ray_offset = vec3(exact_offset(pixel)); }

// A position relative to the eye, relative to where this invocation's ray starts.
vec3 from_ray(vec3 position) { return position - ray_offset; }

// The point at t on this invocation's ray, relative to the eye.
vec3 on_ray(float t, vec3 w) { return ray_offset + t * w; }
#else
dvec3 exact_direction(ivec2 pixel) {
  const dvec2 position = position_of(pixel);
  return normalize(corner + position.x * per_x + position.y * per_y);
}

dvec3 exact_offset(ivec2 pixel) { return dvec3(0.0LF); }

void set_ray_offset(ivec2 pixel) {}

vec3 from_ray(vec3 position) { return position; }

vec3 on_ray(float t, vec3 w) { return t * w; }
#endif

vec3 ray_direction(ivec2 pixel) { return vec3(exact_direction(pixel)); }
