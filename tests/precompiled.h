#pragma once

// The tests' precompiled header: what core has, GoogleTest and the meshes.

#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "core/precompiled.h"
