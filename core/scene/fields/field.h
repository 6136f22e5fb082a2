#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "brume/keys.h"
#include "core/number_domain.h"

namespace brume {

// Every value of a scene described once: `fields<Owner>` is a tuple with a Field for each value of
// a type, in the order of the file. Reading, writing and checking, keyframes and their tracks,
// Python and its stub, rows of forms, the tables of the manual and the tests of malformed values
// follow from it. Written by hand stay files and references, budgets, and rules across fields.

// Describes a value, and how a form edits it.
struct FieldInfo {
  const char* name;   // in files and in Python
  const char* label;  // in forms and undo texts: "Field of view"
  const char* unit;   // "u", "degrees"; "" for a number without one
  const char* says;   // what it is, in one sentence
  double step;        // of a pixel of drag: added, or a share of the value if is_logarithmic
  bool is_logarithmic = false;
  const char* absent = "";         // what is taken in place of an optional value
  bool is_always_saved = true;     // else only where it is not the default or has keyframes
  bool is_required = false;        // files must have it
  bool is_track_optional = false;  // the timeline shows it only where files have it
  bool is_keyed_jointly = false;   // in one track with the others of its object that are
  // Values that count for nothing where this optional one is there.
  std::array<std::string_view, 2> replaces{};

  [[nodiscard]] constexpr bool does_replace(std::string_view value) const {
    return replaces[0] == value || replaces[1] == value;
  }
};

namespace domain {

// Domains of values that are no real numbers: any value is in them.
inline constexpr NumberDomain integer{-9223372036854775808.0, 9223372036854775807.0, "an integer"};
inline constexpr NumberDomain boolean{0.0, 1.0, "true or false"};

}  // namespace domain

struct NoKeys {};

// `get` is a pointer to a member, or a function from an object to the value within it; `keys` a
// pointer to a member that holds keyframes, or NoKeys.
template <class O, class G, class K>
struct Field {
  using Owner = O;
  using Value = std::remove_cvref_t<std::invoke_result_t<G, O&>>;
  static constexpr bool can_have_keys = !std::is_same_v<K, NoKeys>;

  G get;
  K keys;
  NumberDomain domain;  // of each component
  FieldInfo info;

  [[nodiscard]] constexpr auto& of(auto& owner) const { return std::invoke(get, owner); }
};

template <class O, class T>
constexpr auto field(T O::*value, const NumberDomain& domain, const FieldInfo& info) {
  return Field<O, T O::*, NoKeys>{value, {}, domain, info};
}

// The same for a value within a member.
template <class O, class G>
constexpr auto field_within(G get, const NumberDomain& domain, const FieldInfo& info) {
  return Field<O, G, NoKeys>{get, {}, domain, info};
}
template <class O, class G, class K, class AllKeys>
constexpr auto field_within(G get, Keys<K> AllKeys::*keys, const NumberDomain& domain,
                            const FieldInfo& info) {
  return Field<O, G, Keys<K> AllKeys::*>{get, keys, domain, info};
}

template <class O, class T, class K, class AllKeys>
constexpr auto field(T O::*value, Keys<K> AllKeys::*keys, const NumberDomain& domain,
                     const FieldInfo& info) {
  return Field<O, T O::*, Keys<K> AllKeys::*>{value, keys, domain, info};
}

template <class Owner>
inline constexpr std::tuple fields{};

template <class T>
inline constexpr bool may_be_absent = false;
template <class T>
inline constexpr bool may_be_absent<std::optional<T>> = true;

// Numbers in a value.
template <class T>
inline constexpr int components = 1;
template <int n>
inline constexpr int components<glm::vec<n, double>> = n;
template <class T>
inline constexpr int components<std::optional<T>> = components<T>;

// Calls visit(field) for each field of a type.
template <class Owner>
constexpr void visit_fields(auto&& visit) {
  constexpr const auto& all = fields<std::remove_const_t<Owner>>;
  static_assert(std::tuple_size_v<std::remove_cvref_t<decltype(all)>> > 0,
                "the table of this type is missing, or not included");
  std::apply([&visit](const auto&... field) { (visit(field), ...); }, all);
}

// The same for those of an object; light_fields.h has another for lights, whose fields depend on
// their kind.
template <class Owner>
constexpr void visit_fields_of(const Owner&, auto&& visit) {
  visit_fields<Owner>(visit);
}

// An object like another one, with its usual values.
template <class Owner>
Owner usual(const Owner&) {
  return {};
}

// The value that is there in place of this one; nullptr: none is.
template <class F>
const FieldInfo* replacement(const F& field, const typename F::Owner& owner) {
  const FieldInfo* found = nullptr;
  visit_fields_of(owner, [&]<class Other>(const Other& other) {
    if constexpr (may_be_absent<typename Other::Value>) {
      if (other.info.does_replace(field.info.name) && other.of(owner)) found = &other.info;
    }
  });
  return found;
}

// Calls visit(field, keys) for each field that can have keyframes and is there.
template <class Owner>
void visit_keyed_fields(Owner& owner, auto& all_keys, auto&& visit) {
  visit_fields_of(owner, [&]<class F>(const F& field) {
    if constexpr (F::can_have_keys) {
      if constexpr (may_be_absent<typename F::Value>) {
        if (!field.of(owner)) return;
      }
      if (!replacement(field, owner)) visit(field, all_keys.*field.keys);
    }
  });
}

// The same as visit(name, value, keys, domain), see core/scene/animation/animation.h.
template <class Owner>
void visit_keyed(Owner& owner, auto& all_keys, auto&& visit) {
  visit_keyed_fields(owner, all_keys, [&]<class F>(const F& field, auto& keys) {
    auto& value = field.of(owner);
    if constexpr (may_be_absent<typename F::Value>) {
      visit(field.info.name, *value, keys, field.domain);
    } else {
      visit(field.info.name, value, keys, field.domain);
    }
  });
}

// The same for an object that has its keyframes in it.
void visit_keyed(auto& owner, auto&& visit) {
  visit_keyed(owner, owner.keys, visit);
}

// Calls visit(field, value) for each value that is there.
template <class Owner>
void visit_present(Owner& owner, auto&& visit) {
  visit_fields_of(owner, [&]<class F>(const F& field) {
    auto& value = field.of(owner);
    if (replacement(field, owner)) return;
    if constexpr (!may_be_absent<typename F::Value>) {
      visit(field, value);
    } else if (value) {
      visit(field, *value);
    }
  });
}

inline bool contains(const NumberDomain& domain, double value) {
  return domain.contains(value);
}
constexpr bool contains(const NumberDomain&, bool) {
  return true;
}
constexpr bool contains(const NumberDomain&, std::int64_t) {
  return true;
}
inline bool contains(const NumberDomain& domain, const glm::dvec2& v) {
  return domain.contains(v.x) && domain.contains(v.y);
}
inline bool contains(const NumberDomain& domain, const glm::dvec3& v) {
  return domain.contains(v.x) && domain.contains(v.y) && domain.contains(v.z);
}

// Whether all values are in their domains.
template <class Owner>
bool is_in_domain(const Owner& owner) {
  bool is_in = true;
  visit_present(owner, [&is_in](const auto& field, const auto& value) {
    is_in = is_in && contains(field.domain, value);
  });
  return is_in;
}

// Removes keyframes of values that are not there or replaced: they would be unknown keys in a file.
template <class Owner, class AllKeys>
void clear_keys_of_absent(const Owner& owner, AllKeys& all_keys) {
  visit_fields<Owner>([&]<class F>(const F& field) {
    if constexpr (F::can_have_keys) {
      bool is_there = !replacement(field, owner);
      if constexpr (may_be_absent<typename F::Value>) is_there = is_there && field.of(owner);
      if (!is_there) (all_keys.*field.keys).clear();
    }
  });
}

// Whether a value is the default.
template <class F>
bool is_usual(const F& field, const typename F::Owner& owner) {
  const typename F::Owner other = usual(owner);
  return field.of(owner) == field.of(other);
}

// Whether a value says more than its absence in a file would.
template <class F, class AllKeys>
bool is_set(const F& field, const typename F::Owner& owner, const AllKeys& all_keys) {
  if constexpr (F::can_have_keys) {
    if (!(all_keys.*field.keys).empty()) return true;
  }
  return field.info.is_always_saved || !is_usual(field, owner);
}

}  // namespace brume
