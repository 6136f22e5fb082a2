#pragma once

#include <gtest/gtest.h>

#include "tests/core/io/temporary_folder.h"

namespace brume {

// A test that has a folder of its own.
class FolderTest : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
};

}  // namespace brume
