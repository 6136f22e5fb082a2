#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "brume/error.h"
#include "tests/contains.h"

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

// Whether `work` throws an InputError whose text has these parts.
template <typename Work>
void expect_error(Work&& work, std::initializer_list<std::string> parts) {
  const std::string error = error_of(work);
  for (const std::string& part : parts) EXPECT_TRUE(contains(error, part));
}
template <typename Work>
void expect_error(Work&& work, const std::string& part) {
  expect_error(work, {part});
}

// Whether there is one warning, which has this part.
inline void expect_only(const std::vector<std::string>& warnings, const std::string& part) {
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(contains(warnings[0], part));
}

// Whether `read` refuses each beginning of a file that lacks more than `spare` bytes.
template <typename Read>
void expect_truncations_refused(const std::string& whole, Read&& read, std::size_t step = 1,
                                std::size_t spare = 0) {
  for (std::size_t size = 0; size + spare < whole.size(); size += step) {
    EXPECT_THROW(read(whole.substr(0, size)), InputError) << size << " bytes";
  }
}

// Reads a file with one byte after the other changed. A change may go unseen, but nothing other
// than an InputError may come of it. Returns how many are refused.
template <typename Read>
std::size_t refused_damages(const std::string& whole, Read&& read, int change = 0xff) {
  std::size_t refused = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ change);
    try {
      read(damaged);
    } catch (const InputError&) {
      ++refused;
    }
  }
  return refused;
}

}  // namespace brume
