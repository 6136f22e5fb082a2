// Reflection of light given as spherical harmonics: reflect() of render/simd/reflection_kernels. The
// light is turned into the frame of a surface band by band (sh_turns.glsl, which is written by
// render/gl/sh_turns): in one array of all bands, read and written at places that the compiler does
// not know, it would lie in memory.

// The frame of a surface is the world turned about z and y to the normal, and then about it to the
// eye: cosines and sines of these angles, the last of the eye's own angle to the normal.
struct SurfaceFrame {
  vec2 azimuth, polar, eye;
  float eye_cosine;
};

// x / r and y / r, where r is the length of (x, y): cosine and sine of an angle, 0 where there is
// none.
vec2 angle_of(float x, float y) {
  const float square = x * x + y * y;
  return square > tiny_sine_square ? vec2(x, y) / sqrt(square) : vec2(1.0, 0.0);
}

// A vector turned by the first two angles.
vec3 turned_to_normal(SurfaceFrame frame, vec3 w) {
  const float x = frame.azimuth.x * w.x + frame.azimuth.y * w.y;
  return vec3(frame.polar.x * x - frame.polar.y * w.z,
              frame.azimuth.x * w.y - frame.azimuth.y * w.x,
              frame.polar.y * x + frame.polar.x * w.z);
}

SurfaceFrame frame_of(vec3 n, vec3 to_eye) {
  SurfaceFrame frame;
  frame.azimuth = angle_of(n.x, n.y);
  frame.polar = angle_of(n.z, length(n.xy));
  const vec3 eye = turned_to_normal(frame, to_eye);
  frame.eye = angle_of(eye.x, eye.y);
  frame.eye_cosine = eye.z;
  return frame;
}

vec2 turned_further(vec2 angle, vec2 by) {
  return vec2(angle.x * by.x - angle.y * by.y, angle.y * by.x + angle.x * by.y);
}

// Turns the coefficients of m and -m back about z, by m times an angle.
void turn_back(vec2 angle, inout vec3 a, inout vec3 b) {
  const vec3 turned = angle.x * a + angle.y * b;
  b = angle.x * b - angle.y * a;
  a = turned;
}

// Where a row of a table of reflectances lies for the eye's angle, between two.
struct TableRow {
  int first;
  float fraction;
};

TableRow row_at(int table, int size, int intervals, float cosine) {
  const float coordinate = acos(clamp(cosine, 0.0, 1.0)) * (float(intervals) * 2.0 / pi);
  const float below = min(floor(coordinate), float(intervals - 1));
  return TableRow(table + int(below) * size, coordinate - below);
}

// Coefficient i of those m >= 0, which say how much of the light's a surface reflects.
TableRow reflection_table = TableRow(0, 0.0);

vec3 table_reflectance(int i) {
  const int place = reflection_table.first + 3 * i;
  return mix(values_rgb(place), values_rgb(place + reflection_row), reflection_table.fraction);
}
