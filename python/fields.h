#pragma once

#include <string>
#include <utility>

#include "core/scene/fields/description.h"
#include "python/keyed.h"
#include "python/vectors.h"

namespace brume::python {

template <class Owner, std::size_t... k>
void def_constructor(auto& bound, std::index_sequence<k...>) {
  using Self = typename std::remove_reference_t<decltype(bound)>::type;
  constexpr const auto& all = fields<Owner>;
  const Owner usual{};
  bound.def(pybind11::init([](const typename std::tuple_element_t<
                               k, std::remove_cvref_t<decltype(all)>>::Value&... values) {
              Self self{};
              ((std::get<k>(fields<Owner>).of(self) = values), ...);
              return self;
            }),
            (pybind11::arg(std::get<k>(all).info.name) = std::get<k>(all).of(usual))...);
}

// A property for each value of core/scene/fields.
template <class Owner>
void def_values(auto& bound) {
  visit_fields<Owner>([&bound]<class F>(const F& field) {
    std::string doc = description(field);
    if (*field.info.absent) doc.append("; None: ").append(field.info.absent);
    if constexpr (F::can_have_keys) {
      def_keyed(bound, field.info.name, field.get, field.keys, doc.c_str());
    } else {
      bound.def_readwrite(field.info.name, field.get, doc.c_str());
    }
  });
}

// The same, and a constructor that takes them by name.
template <class Owner>
void def_fields(auto& bound) {
  def_constructor<Owner>(
      bound,
      std::make_index_sequence<std::tuple_size_v<std::remove_cvref_t<decltype(fields<Owner>)>>>());
  def_values<Owner>(bound);
}

}  // namespace brume::python
