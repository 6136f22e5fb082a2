// Reflection of light given as spherical harmonics: reflect() of render/simd/reflection_kernels. The
// table and the elements of a quarter turn about x are among the values of shade_surfaces.glsl.

uniform int turn_at, turn_count;

// x / r and y / r, where r is the length of (x, y): cosine and sine of an angle, 0 where there is
// none.
vec2 angle_of(float x, float y) {
  const float square = x * x + y * y;
  return square > tiny_sine_square ? vec2(x, y) / sqrt(square) : vec2(1.0, 0.0);
}

// Turns `light` about z by the angle.
void turn_about_z(vec2 angle) {
  vec2 turned = angle;  // by m times
  for (int m = 1; m < sh_bands; ++m) {
    for (int l = m; l < sh_bands; ++l) {
      const vec3 a = light[l * (l + 1) + m];
      const vec3 b = light[l * (l + 1) - m];
      light[l * (l + 1) + m] = turned.x * a - turned.y * b;
      light[l * (l + 1) - m] = turned.y * a + turned.x * b;
    }
    turned = vec2(turned.x * angle.x - turned.y * angle.y, turned.y * angle.x + turned.x * angle.y);
  }
}

// Turns it by a quarter about x, or back: the inverse is the transpose. Copied one by one: of a copy
// of all, Mesa 25 reads what was written to `light` since.
vec3 unturned[sh_count];

void quarter_turn(bool inverse_) {
  for (int i = 0; i < sh_count; ++i) {
    unturned[i] = light[i];
    light[i] = vec3(0.0);
  }
  for (int e = turn_at; e < turn_at + turn_size * turn_count; e += turn_size) {
    const int a = int(values[e + turn_to]);
    const int b = int(values[e + turn_from]);
    light[inverse_ ? b : a] += values[e + turn_value] * unturned[inverse_ ? a : b];
  }
}

// Turns `light` into the frame of a surface of normal n; the cosine of the angle of the eye.
float turn_to_eye(vec3 n, vec3 to_eye) {
  // The frame of the surface is the world turned about z and y to the normal, and then about it to
  // the eye.
  const vec2 azimuth = angle_of(n.x, n.y);
  const vec2 polar = angle_of(n.z, length(n.xy));
  const float x = azimuth.x * to_eye.x + azimuth.y * to_eye.y;
  const float y = azimuth.x * to_eye.y - azimuth.y * to_eye.x;
  const vec2 eye = angle_of(polar.x * x - polar.y * to_eye.z, y);
  const float cosine = polar.y * x + polar.x * to_eye.z;
  const vec2 turns[3] = vec2[](azimuth, polar, eye);
  for (int k = 0; k < turns.length(); ++k) {
    if (k > 0) quarter_turn(k == 2);
    turn_about_z(vec2(1.0, -1.0) * turns[k]);
  }
  return cosine;
}

// Outgoing radiance of a surface whose table begins at `table`, under `light`, turned.
vec3 reflected(int table, float cosine) {
  const float coordinate = acos(clamp(cosine, 0.0, 1.0)) * (float(reflection_intervals) * 2.0 / pi);
  const float row_below = min(floor(coordinate), float(reflection_intervals - 1));
  int row = table + int(row_below) * reflection_row;
  vec3 sum = vec3(0.0);
  for (int l = 0; l < sh_bands; ++l) {
    for (int m = 0; m <= l; ++m) {
      sum += mix(values_rgb(row), values_rgb(row + reflection_row), coordinate - row_below) *
             light[l * (l + 1) + m];
      row += 3;
    }
  }
  return sum;
}
