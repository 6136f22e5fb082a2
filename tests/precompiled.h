#pragma once

// The tests' precompiled header: what core has and GoogleTest.

#include <gtest/gtest.h>

#include "core/precompiled.h"
