// View rays of a film: see CameraRays. Double precision up to the direction, since pixels of narrow
// views are closer than float resolves.
uniform dvec3 corner;
uniform dvec3 per_x;
uniform dvec3 per_y;
uniform ivec2 first_pixel;  // of the film on the whole one

dvec3 exact_direction(ivec2 pixel) {
  const dvec2 position = dvec2(first_pixel + pixel) + 0.5LF;
  return normalize(corner + position.x * per_x + position.y * per_y);
}

vec3 ray_direction(ivec2 pixel) { return vec3(exact_direction(pixel)); }
