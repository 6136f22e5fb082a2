#pragma once

#include <gtest/gtest.h>

#include <string>

namespace brume {

// Whether a text has a part; what failed says both.
inline testing::AssertionResult contains(const std::string& text, const std::string& part) {
  const bool is_there = text.find(part) != std::string::npos;
  return testing::AssertionResult(is_there) << '"' << part << "\", in: " << text;
}

}  // namespace brume
