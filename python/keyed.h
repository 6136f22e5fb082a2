#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <type_traits>

#include "brume/error.h"
#include "brume/keys.h"

namespace brume::python {

// Frames show what a value's keyframes say: set beside them, it would change nothing. Throws
// DomainError.
template <class T>
void check_unkeyed(const char* name, const Keys<T>& keys) {
  if (keys.empty()) return;
  throw DomainError(name,
                    "its keyframes say what is rendered; allowed: to set it after clear_keys()");
}

// A property that is a member of an object, and may have keyframes among those in its `keys`.
template <class Bound, class Get, class Key, class AllKeys>
void def_keyed(Bound& bound, const char* name, Get value, Keys<Key> AllKeys::*keys,
               const char* doc) {
  using Self = typename Bound::type;
  using Value = std::remove_cvref_t<std::invoke_result_t<Get, Self&>>;
  bound.def_property(
      name, [value](const Self& self) -> Value { return std::invoke(value, self); },
      [=](Self& self, const Value& replacement) {
        check_unkeyed(name, self.keys.*keys);
        std::invoke(value, self) = replacement;
      },
      doc);
}

template <class Bound>
void def_clear_keys(Bound& bound) {
  bound.def(
      "clear_keys", [](typename Bound::type& self) { self.keys = {}; },
      "Removes the keyframes of all values, which are then constant and can be set.");
}

}  // namespace brume::python
