#pragma once

// OpenVDB keeps names of types in static members and whether they are set in variables of inline
// functions. Hidden, this program would have members of its own and the library's variables.
#pragma GCC visibility push(default)
#include <openvdb/openvdb.h>
#pragma GCC visibility pop

namespace brume {

// A new grid, zero everywhere. It comes from OpenVDB's registry: Grid::create() would compile all
// virtual functions of the grid and its tree again, for a quarter of a minute in each file.
template <class Grid>
typename Grid::Ptr new_grid() {
  openvdb::initialize();
  return openvdb::StaticPtrCast<Grid>(openvdb::GridBase::createGrid(Grid::gridType()));
}

}  // namespace brume
