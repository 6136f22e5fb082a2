// The formulas of render/formulas for shaders; render/simd/formulas-inl.h has them for vectors of
// the CPU, and says what the words mean.
#include "constants.glsl"

#define FORMULA_OF(Type)
#define FORMULA
#define FORMULA_STRUCT struct
#define OF(Struct) Struct
#define Real float
#define Uniform float
#define Vec2 vec2
#define Vec3 vec3
#define Bool bool
#define Bits uint
#define BITS uint
#define TO_BITS(x) uint(int(x))
#define REAL(x) float(x)
#define SHIFT_LEFT(x, n) ((x) << (n))
#define SHIFT_RIGHT(x, n) ((x) >> (n))
#define ALL(condition) (condition)
#define ANY(condition) (condition)
#define BY_PRECISION(single, twice) (single)

float mul_add(float a, float b, float c) { return a * b + c; }
vec3 mul_add(float s, vec3 a, vec3 b) { return s * a + b; }
float mul_sub(float a, float b, float c) { return a * b - c; }
float neg_mul_add(float a, float b, float c) { return c - a * b; }
vec3 neg_mul_add(float s, vec3 a, vec3 b) { return b - s * a; }
float copy_sign(float magnitude, float sign_) { return sign_ < 0.0 ? -magnitude : magnitude; }
float flip_sign(float value, uint bits) {
  return uintBitsToFloat(floatBitsToUint(value) ^ (bits & 0x80000000u));
}
float select(bool condition, float yes, float no) { return condition ? yes : no; }
vec3 select(bool condition, vec3 yes, vec3 no) { return condition ? yes : no; }
float where(bool condition, float x) { return condition ? x : 0.0; }
bool both(bool a, bool b) { return a && b; }

// Rays that hit nothing end at `endless`, not infinity, so sums stay finite; nothing is left of
// erfc beyond this, where squares are still floats.
const float erfc_end = 1e4;
float bounded(float x) { return clamp(x, -erfc_end, erfc_end); }

#include "erf.inl"
#include "falloff.inl"
#include "ggx.inl"
#include "maps.inl"
#include "noise.inl"
#include "phase.inl"
#include "slices.inl"
#include "surfaces.inl"
#include "area.inl"
#include "fog.inl"
#include "line.inl"
