#include "core/math/rounded.h"

#include <array>
#include <charconv>

namespace brume {

double rounded(double value, int digits) {
  std::array<char, 32> text;
  char* const begin = text.data();
  const char* const end =
      std::to_chars(begin, begin + text.size(), value, std::chars_format::scientific, digits - 1)
          .ptr;
  double result = value;
  std::from_chars(begin, end, result);
  return result;
}

}  // namespace brume
