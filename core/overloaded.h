#pragma once

namespace brume {

// One function of several: what std::visit() calls, an overload for each alternative.
template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};

}  // namespace brume
