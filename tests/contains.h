#pragma once

#include <gtest/gtest.h>

#include <string>

namespace brume {

// Tells whether a text has all parts; what failed says the first that it lacks, or the last that it has.
template <class... Parts>
testing::AssertionResult contains(const std::string& text, const Parts&... parts) {
  std::string told;
  const bool are_there = ((told = parts, text.find(told) != std::string::npos) && ...);
  return testing::AssertionResult(are_there) << '"' << told << "\", in: " << text;
}

}  // namespace brume
