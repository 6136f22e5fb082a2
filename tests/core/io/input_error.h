#pragma once

#include <gtest/gtest.h>

#include <string>

#include "brume/error.h"

namespace brume {

// The text of the InputError that `work` throws; a test failure if it throws none.
template <typename Work>
std::string error_of(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError was thrown";
  return {};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace brume
