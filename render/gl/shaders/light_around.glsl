// Light from around a point of a surface, as spherical harmonics: of the environment, of what a grid
// holds, or of what radiance transfer has brought to the vertices. Coefficients are read one by one
// where they are needed, see reflection.glsl.

// They are those of up to eight nodes (or three vertices), weighted, and of the environment, of
// each of whose bands so much arrives.
int around_functions = 0;  // of the nodes
bool is_of_vertices = false;
int around_firsts[8];
float around_weights[8];
float around_scale = 1.0;
vec3 environment_shares[sh_bands];

void clear_environment_shares() {
  for (int k = 0; k < sh_bands; ++k) environment_shares[k] = vec3(0.0);
}

vec3 around_node(int node, int i) {
  return around_weights[node] * incident_values[around_firsts[node] + i].rgb;
}

// Coefficient i of all, of band l.
vec3 light_around(int l, int i) {
  vec3 sum = vec3(0.0);
  if (i < around_functions) {
    sum = around_node(0, i) + around_node(1, i) + around_node(2, i);
    if (!is_of_vertices) {
      sum += around_node(3, i) + around_node(4, i) + around_node(5, i) + around_node(6, i) +
             around_node(7, i);
    }
    sum *= around_scale;
  }
  if (environment_shares[l] != vec3(0.0)) {
    sum += environment_shares[l] * values_rgb(environment_at + 4 * i);
  }
  return sum;
}

void find_light_of_vertices(ivec3 firsts, vec3 weights, int functions) {
  around_functions = functions;
  is_of_vertices = true;
  around_firsts = int[](firsts.x, firsts.y, firsts.z, 0, 0, 0, 0, 0);
  around_weights = float[](weights.x, weights.y, weights.z, 0.0, 0.0, 0.0, 0.0, 0.0);
  clear_environment_shares();
}

// Mean incident light relative to that of the environment without medium, at most 1.
vec3 dimming(vec3 mean) {
  const vec3 all = values_rgb(environment_at);
  const vec3 fraction = min(mean / max(all, vec3(tiny_square)), vec3(1.0));
  return mix(vec3(0.0), fraction, greaterThan(all, vec3(0.0)));
}

// The nodes of the grid's cell around the point. The environment has bands that the grid lacks.
void find_light_in_grid(SurfacePoint point, vec3 to_eye) {
  const vec3 p = point.position;
  int level = 0;
  vec3 coordinate = incident_first[0].w * (p - incident_first[0].xyz);
  while (level + 1 < incident_levels &&
         (any(lessThan(coordinate, vec3(0.0))) ||
          any(greaterThan(coordinate, vec3(incident_count[level].xyz - 1))))) {
    ++level;
    coordinate = incident_first[level].w * (p - incident_first[level].xyz);
  }
  if (incident_is_all != 0) {
    coordinate += 0.5 * dot(abs(point.normal), vec3(1.0)) * point.normal;
  }
  const ivec4 count = incident_count[level];
  const vec3 last = vec3(count.xyz - 2);
  const vec3 inside = clamp(coordinate, vec3(0.0), last + 1.0);
  const vec3 low = min(floor(inside), last);
  const vec3 f = inside - low;
  for (int c = 0; c < 8; ++c) {
    const ivec3 corner_ = ivec3(c & 1, (c >> 1) & 1, c >> 2);
    const vec3 weight = mix(1.0 - f, f, vec3(corner_));
    const ivec3 node = ivec3(low) + corner_;
    around_weights[c] = weight.x * weight.y * weight.z;
    around_firsts[c] =
        count.w + ((node.z * count.y + node.y) * count.x + node.x) * grid_functions;
  }
  if (incident_is_all != 0) {
    hide_corners(eye_corner(to_eye, ivec3(low), incident_eye_layers[level]), around_firsts,
                 around_weights);
  }
  around_functions = grid_functions;
  around_scale = incident_scale;
  clear_environment_shares();
  if (has_environment == 0) return;
  const vec3 share = dimming(light_around(0, 0));
  for (int k = grid_bands; k < sh_bands; ++k) environment_shares[k] = share;
}

// AverageDepthGrid of render/lighting.
float average_depth(SurfacePoint point) {
  const int surface = surface_size * point.surface;
  const int first = int(values[surface + surface_average_depths_at]);
  if (first < 0) return 0.0;
  const ivec3 nodes_ = ivec3(values_rgb(surface + surface_grid_nodes));
  const vec3 coordinate = clamp((point.position - values_rgb(surface + surface_grid_corner)) *
                                    values_rgb(surface + surface_cells_per_unit),
                                vec3(0.0), vec3(nodes_ - 1));
  const ivec3 cell = min(ivec3(coordinate), max(nodes_ - 2, 0));
  const vec3 f = coordinate - vec3(cell);
  float sum = 0.0;
  for (int c = 0; c < 8; ++c) {
    const ivec3 corner_ = ivec3(c & 1, (c >> 1) & 1, c >> 2);
    const vec3 weights = mix(1.0 - f, f, vec3(corner_));
    const ivec3 node = min(cell + corner_, nodes_ - 1);
    const int i = (node.z * nodes_.y + node.y) * nodes_.x + node.x;
    sum += weights.x * weights.y * weights.z * incident_values[first + i / 4][i % 4];
  }
  return sum;
}

// Beyond so many radii of a ball of fog the logarithm cancels, and two terms of its series do.
const float series_from = 10.0;
const float second_term = 0.2;

// SurfaceLighting::fog_depth_at().
float average_fog_depth(vec3 position) {
  if (fog_radius == 0.0) return fog_depth;
  // Nearer to the center the logarithm loses digits.
  const float s = max(length(position - fog_center) / fog_radius, small_exponent);
  if (s > series_from) {
    return b0 * fog_radius / (3.0 * s * s) * (1.0 + second_term / (s * s));
  }
  const float inside = (1.0 - s * s) / (2.0 * s) * log((1.0 + s) / max(abs(1.0 - s), tiny));
  return 0.5 * b0 * fog_radius * (1.0 + inside);
}

// EnvironmentLight::incident(), without a grid.
void find_light_of_environment(SurfacePoint point) {
  const float depth = average_fog_depth(point.position) + average_depth(point);
  const float unscattered = exp(-depth);
  const float x = scatter_position(depth);
  const bool passes = depth > 0.0 && depth < scatter_opaque;
  const int first = environment_at + 4 * sh_count;
  for (int l = 0; l < sh_bands; ++l) {
    const float spread = scatter_polynomial(first + l * scatter_terms, x);
    environment_shares[l] =
        vec3(unscattered + (passes ? albedo * depth * unscattered * spread : 0.0));
  }
}

void find_light_around(SurfacePoint point, vec3 to_eye) {
  if (incident_levels > 0) {
    find_light_in_grid(point, to_eye);
  } else {
    find_light_of_environment(point);
  }
}

// Reflected by a diffuse surface of reflectance 1: nothing of the fourth and sixth band.
vec3 diffuse_light(vec3 normal) {
  float y[sh_count];
  sh_basis(normal, y);
  vec3 sum = vec3(0.0);
  for (int l = 0; l < sh_bands; ++l) {
    if (cosine_factors[l] == 0.0) continue;
    vec3 band = vec3(0.0);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) band += y[i] * light_around(l, i);
    sum += cosine_factors[l] * band;
  }
  return max(sum, vec3(0.0));
}
