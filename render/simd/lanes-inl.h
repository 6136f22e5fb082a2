// Vectors of lanes with the operators and names that formulas are written in (render/formulas).
// Included once per instruction set by the files that Highway compiles for each.

#if defined(BRUME_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRUME_LANES_INL_H
#undef BRUME_LANES_INL_H
#else
#define BRUME_LANES_INL_H
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
concept Lanes = requires {
  typename hn::DFromV<V>;
};
template <class T>
concept Number = std::is_arithmetic_v<T>;

// A number in all lanes; lanes as they are.
template <Lanes V, class T>
HWY_INLINE V lanes(T x) {
  if constexpr (Number<T>) {
    return hn::Set(hn::DFromV<V>(), static_cast<hn::TFromV<V>>(x));
  } else {
    return x;
  }
}

// Highway's vectors have operators among themselves; these are with numbers.
#define BRUME_OPERATOR(op)                \
  template <Lanes V, Number T>            \
  HWY_INLINE auto operator op(V a, T b) { \
    return a op lanes<V>(b);              \
  }                                       \
  template <Number T, Lanes V>            \
  HWY_INLINE auto operator op(T a, V b) { \
    return lanes<V>(a) op b;              \
  }
BRUME_OPERATOR(+)
BRUME_OPERATOR(-)
BRUME_OPERATOR(*)
BRUME_OPERATOR(/)
BRUME_OPERATOR(&)
BRUME_OPERATOR(<)
BRUME_OPERATOR(>)
BRUME_OPERATOR(<=)
BRUME_OPERATOR(>=)
BRUME_OPERATOR(!=)
#undef BRUME_OPERATOR

#define BRUME_FUNCTION(name, Name) \
  template <Lanes V>               \
  HWY_INLINE V name(V x) {         \
    return hn::Name(x);            \
  }
BRUME_FUNCTION(operator-, Neg)
BRUME_FUNCTION(abs, Abs)
BRUME_FUNCTION(floor, Floor)
BRUME_FUNCTION(sqrt, Sqrt)
#undef BRUME_FUNCTION

#define BRUME_FUNCTION(name, Name)       \
  template <Lanes V>                     \
  HWY_INLINE V name(V x) {               \
    return hn::Name(hn::DFromV<V>(), x); \
  }
BRUME_FUNCTION(atan, Atan)
BRUME_FUNCTION(cos, Cos)
BRUME_FUNCTION(exp, Exp)
BRUME_FUNCTION(log, Log)
BRUME_FUNCTION(sin, Sin)
#undef BRUME_FUNCTION

template <class V>
struct V2 {
  V x, y;

  V2() = default;
  HWY_INLINE V2(V x_, V y_) : x(x_), y(y_) {}
};
template <class V>
struct V3 {
  V x, y, z;

  V3() = default;
  HWY_INLINE V3(V x_, V y_, V z_) : x(x_), y(y_), z(z_) {}
};

// The lanes among types, others of which may be numbers.
template <class... T>
struct LanesAmong {};
template <class T, class... Rest>
struct LanesAmong<T, Rest...> : LanesAmong<Rest...> {};
template <Lanes V, class... Rest>
struct LanesAmong<V, Rest...> : std::type_identity<V> {};
template <class... T>
using LanesOf = typename LanesAmong<T...>::type;

#define BRUME_FUNCTION(name, Name)                                    \
  template <class A, class B, class C, class V = LanesOf<A, B, C>>    \
  HWY_INLINE V name(A a, B b, C c) {                                  \
    return hn::Name(lanes<V>(a), lanes<V>(b), lanes<V>(c));           \
  }                                                                   \
  template <class A, class V>                                         \
  HWY_INLINE V3<V> name(A a, const V3<V>& b, const V3<V>& c) {        \
    return {name(a, b.x, c.x), name(a, b.y, c.y), name(a, b.z, c.z)}; \
  }
BRUME_FUNCTION(mul_add, MulAdd)         // a b + c
BRUME_FUNCTION(mul_sub, MulSub)         // a b - c
BRUME_FUNCTION(neg_mul_add, NegMulAdd)  // c - a b
#undef BRUME_FUNCTION

#define BRUME_FUNCTION(name, Name)                           \
  template <class A, class B, class V = LanesOf<A, B>>       \
  HWY_INLINE V name(A a, B b) {                              \
    return hn::Name(lanes<V>(a), lanes<V>(b));               \
  }                                                          \
  template <class V>                                         \
  HWY_INLINE V3<V> name(const V3<V>& a, const V3<V>& b) {    \
    return {name(a.x, b.x), name(a.y, b.y), name(a.z, b.z)}; \
  }
BRUME_FUNCTION(copy_sign, CopySign)  // |a|, with b's sign
BRUME_FUNCTION(max, Max)
BRUME_FUNCTION(min, Min)
#undef BRUME_FUNCTION

template <Lanes V, class A, class B>
HWY_INLINE V clamp(V x, A low, B high) {
  return min(max(x, low), high);
}
// Where a condition holds `yes`, else `no`.
template <class M, class A, class B, class V = LanesOf<A, B>>
HWY_INLINE V select(M condition, A yes, B no) {
  return hn::IfThenElse(condition, lanes<V>(yes), lanes<V>(no));
}
template <class M, class V>
HWY_INLINE V3<V> select(M condition, const V3<V>& yes, const V3<V>& no) {
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y),
          select(condition, yes.z, no.z)};
}
// x where a condition holds, else 0.
template <class M, Lanes V>
HWY_INLINE V where(M condition, V x) {
  return hn::IfThenElseZero(condition, x);
}
template <class M>
HWY_INLINE M both(M a, M b) {
  return hn::And(a, b);
}
// Lanes have infinities, so nothing need be bounded to keep squares finite.
template <Lanes V>
HWY_INLINE V bounded(V x) {
  return x;
}
// `value`, with its sign flipped where the highest of `bits` is set.
template <Lanes V>
HWY_INLINE V flip_sign(V value, hn::VFromD<hn::RebindToUnsigned<hn::DFromV<V>>> bits) {
  const hn::DFromV<V> d;
  const hn::RebindToUnsigned<hn::DFromV<V>> du;
  return hn::BitCast(d, hn::BitCast(du, value) ^ (bits & 0x80000000U));
}

template <class V>
HWY_INLINE V3<V> abs(const V3<V>& v) {
  return {abs(v.x), abs(v.y), abs(v.z)};
}
template <class V>
HWY_INLINE V3<V> operator+(const V3<V>& a, const V3<V>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
HWY_INLINE V3<V> operator-(const V3<V>& a, const V3<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
HWY_INLINE V3<V> operator*(V s, const V3<V>& v) {
  return {s * v.x, s * v.y, s * v.z};
}
template <class V>
HWY_INLINE V dot(const V3<V>& a, const V3<V>& b) {
  return mul_add(a.x, b.x, mul_add(a.y, b.y, a.z * b.z));
}
template <class V>
HWY_INLINE V3<V> cross(const V3<V>& a, const V3<V>& b) {
  return {mul_sub(a.y, b.z, a.z * b.y), mul_sub(a.z, b.x, a.x * b.z), mul_sub(a.x, b.y, a.y * b.x)};
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // BRUME_LANES_INL_H
