#include "render/gl/sh_turns.h"

#include <iomanip>
#include <limits>
#include <sstream>

#include "core/math/spherical_harmonics.h"

namespace brume::gl {
namespace {

// The coefficients of one band as `before` names them, times the elements of a quarter turn, as
// `after` names them.
void write_quarter_turn(int band, bool is_inverse, char before, char after, std::ostream& out) {
  const auto first = sh_index(band, -band);
  const auto end = sh_index(band, band) + 1;
  for (std::size_t i = first; i < end; ++i) {
    out << "  vec3 " << after << i - first << " = vec3(0.0)";
    for (const ShElement& e : sh_quarter_turn()) {
      if ((is_inverse ? e.from : e.to) != i) continue;
      out << " + " << e.value << " * " << before << (is_inverse ? e.to : e.from) - first;
    }
    out << ";\n";
  }
}

void write_turn(int band, const char* angle, char name, std::ostream& out) {
  for (int m = 1; m <= band; ++m) {
    out << "  turn_back(" << angle << m << ", " << name << band + m << ", " << name << band - m
        << ");\n";
  }
}

void write_band(int band, std::ostream& out) {
  out << "vec3 reflected_band_" << band << "() {\n";
  for (int m = -band; m <= band; ++m) {
    out << "  vec3 a" << band + m << " = light_around(" << band << ", " << sh_index(band, m)
        << ");\n";
  }
  write_turn(band, "azimuth_", 'a', out);
  write_quarter_turn(band, false, 'a', 'b', out);
  write_turn(band, "polar_", 'b', out);
  write_quarter_turn(band, true, 'b', 'c', out);
  write_turn(band, "eye_", 'c', out);
  out << "  return vec3(0.0)";
  for (int m = 0; m <= band; ++m) {
    out << " + reflectance(" << band * (band + 1) / 2 + m << ") * c" << band + m;
  }
  out << ";\n}\n";
}

}  // namespace

std::string sh_turns() {
  std::ostringstream out;
  out << std::scientific << std::setprecision(std::numeric_limits<float>::max_digits10 - 1);
  for (const char* angle : {"azimuth_", "polar_", "eye_"}) {
    for (int m = 1; m < sh_max_bands; ++m) out << "vec2 " << angle << m << " = vec2(1.0, 0.0);\n";
  }
  for (int band = 0; band < sh_max_bands; ++band) write_band(band, out);
  out << "vec3 reflected_light(SurfaceFrame frame) {\n";
  for (const char* angle : {"azimuth", "polar", "eye"}) {
    out << "  " << angle << "_1 = frame." << angle << ";\n";
    for (int m = 2; m < sh_max_bands; ++m) {
      out << "  " << angle << '_' << m << " = turned_further(" << angle << '_' << m - 1
          << ", frame." << angle << ");\n";
    }
  }
  out << "  return vec3(0.0)";
  for (int band = 0; band < sh_max_bands; ++band) out << " + reflected_band_" << band << "()";
  out << ";\n}\n";
  return out.str();
}

}  // namespace brume::gl
