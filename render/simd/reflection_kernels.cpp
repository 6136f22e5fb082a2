#include "render/simd/reflection_kernels.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/scene/materials/ggx_sh.h"

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/simd/reflection_kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include "render/simd/coefficients.h"

#ifndef BRUME_REFLECTION_QUARTERS
#define BRUME_REFLECTION_QUARTERS
namespace brume {
// The quarter turn about x and its inverse.
struct Quarters {
  std::span<const ShElement> forward, inverse;
};
}  // namespace brume
#endif

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;

constexpr std::size_t functions = sh_size(sh_max_bands);

// Coefficients of a vector of points, R G B one after the other.
struct Coefficients {
  HWY_ALIGN float values[3 * functions * HWY_LANES(float)];

  HWY_INLINE V get(std::size_t i) const { return hn::Load(D(), values + i * hn::Lanes(D())); }
  HWY_INLINE void set(std::size_t i, V v) { hn::Store(v, D(), values + i * hn::Lanes(D())); }
};

struct Angle {
  V cosine, sine;
};

// x / r and y / r, where r is the length of (x, y); the angle 0 where there is none.
HWY_INLINE Angle Direction(V x, V y) {
  const D d;
  const V square = hn::MulAdd(x, x, hn::Mul(y, y));
  const auto is_long =
      hn::Gt(square, hn::Set(d, static_cast<float>(coefficient::tiny_sine_square)));
  const V inverse =
      hn::Div(hn::Set(d, 1.0f), hn::Sqrt(hn::IfThenElse(is_long, square, hn::Set(d, 1.0f))));
  return {hn::IfThenElse(is_long, hn::Mul(x, inverse), hn::Set(d, 1.0f)),
          hn::IfThenElseZero(is_long, hn::Mul(y, inverse))};
}

// A turn of all coefficients about z by the angle.
HWY_INLINE void TurnAboutZ(const Angle& angle, Coefficients& f) {
  V c = angle.cosine;
  V s = angle.sine;
  for (int m = 1; m < sh_max_bands; ++m) {
    for (int l = m; l < sh_max_bands; ++l) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t plus = 3 * sh_index(l, m) + k;
        const std::size_t minus = 3 * sh_index(l, -m) + k;
        const V a = f.get(plus);
        const V b = f.get(minus);
        f.set(plus, hn::MulSub(c, a, hn::Mul(s, b)));
        f.set(minus, hn::MulAdd(s, a, hn::Mul(c, b)));
      }
    }
    const V next = hn::MulSub(c, angle.cosine, hn::Mul(s, angle.sine));
    s = hn::MulAdd(s, angle.cosine, hn::Mul(c, angle.sine));
    c = next;
  }
}

// A quarter turn about x, or its inverse. `elements` are those of its matrix with `to` ascending.
struct Quarter {
  std::span<const ShElement> elements;

  HWY_INLINE void operator()(const Coefficients& f, Coefficients& result) const {
    const D d;
    std::size_t e = 0;
    for (std::size_t i = 0; i < functions; ++i) {
      V sum[3] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
      for (; e < elements.size() && elements[e].to == i; ++e) {
        const V value = hn::Set(d, static_cast<float>(elements[e].value));
        for (std::size_t k = 0; k < 3; ++k) {
          sum[k] = hn::MulAdd(value, f.get(3 * elements[e].from + k), sum[k]);
        }
      }
      for (std::size_t k = 0; k < 3; ++k) result.set(3 * i + k, sum[k]);
    }
  }
};

// Rows of a table for the polar angle of the eye, and how far it is between them.
struct Rows {
  hn::Vec<hn::RebindToSigned<D>> first;
  V fraction;

  HWY_INLINE explicit Rows(V cosine, std::size_t row_size) {
    const D d;
    const V coordinate =
        hn::Mul(hn::Acos(d, hn::Min(hn::Max(cosine, hn::Zero(d)), hn::Set(d, 1.0f))),
                hn::Set(d, ReflectionTable::intervals * 2.0f / std::numbers::pi_v<float>));
    const V below = hn::Min(hn::Floor(coordinate), hn::Set(d, ReflectionTable::intervals - 1.0f));
    fraction = hn::Sub(coordinate, below);
    first = hn::ConvertTo(hn::RebindToSigned<D>(),
                          hn::Mul(below, hn::Set(d, static_cast<float>(row_size))));
  }
};

HWY_INLINE V Between(const float* table, hn::Vec<hn::RebindToSigned<D>> first, std::size_t row_size,
                     V fraction) {
  const D d;
  const V a = hn::GatherIndex(d, table, first);
  const V b = hn::GatherIndex(d, table + row_size, first);
  return hn::MulAdd(fraction, hn::Sub(b, a), a);
}

// Coefficients of a ReflectionTable, R G B.
struct TableRows {
  const float* table;
  Rows rows;

  HWY_INLINE TableRows(const float* of_material, V cosine)
      : table(of_material), rows(cosine, ReflectionTable::row_size) {}

  HWY_INLINE void operator()(std::size_t i, V (&rgb)[3]) const {
    for (std::size_t k = 0; k < 3; ++k) {
      rgb[k] = Between(table + 3 * i + k, rows.first, ReflectionTable::row_size, rows.fraction);
    }
  }
};

// Coefficients of GgxSh at the points of the vector that starts at `at`.
struct GgxRows {
  Rows rows;
  hn::Vec<hn::RebindToSigned<D>> first;  // of the tables over roughness
  V roughness_fraction;
  V diffuse[3], f0[3], lobe;
  const float* diffuse_table;
  const float* scaled_table;
  const float* added_table;

  HWY_INLINE GgxRows(const GgxSh& table, const GgxPoints& ggx, std::size_t at, V cosine)
      : rows(cosine, GgxSh::row_size),
        diffuse_table(table.diffuse().data()),
        scaled_table(table.scaled().data()),
        added_table(table.added().data()) {
    const D d;
    const V coordinate = hn::Mul(hn::Sqrt(hn::Load(d, ggx.alpha.data() + at)),
                                 hn::Set(d, float{GgxSh::roughness_intervals}));
    const V below = hn::Min(hn::Floor(coordinate), hn::Set(d, GgxSh::roughness_intervals - 1.0f));
    roughness_fraction = hn::Sub(coordinate, below);
    first = hn::Add(rows.first, hn::ConvertTo(hn::RebindToSigned<D>(),
                                              hn::Mul(below, hn::Set(d, float{layer_size}))));
    lobe = hn::Load(d, ggx.lobe.data() + at);
    const PointArray* diffuse_arrays[] = {&ggx.diffuse.x, &ggx.diffuse.y, &ggx.diffuse.z};
    const PointArray* f0_arrays[] = {&ggx.f0.x, &ggx.f0.y, &ggx.f0.z};
    for (std::size_t k = 0; k < 3; ++k) {
      diffuse[k] = hn::Load(d, diffuse_arrays[k]->data() + at);
      f0[k] = hn::Load(d, f0_arrays[k]->data() + at);
    }
  }

  HWY_INLINE void operator()(std::size_t i, V (&rgb)[3]) const {
    const V cosine = Between(diffuse_table + i, rows.first, GgxSh::row_size, rows.fraction);
    const V scaled = Layered(scaled_table + i);
    const V added = Layered(added_table + i);
    for (std::size_t k = 0; k < 3; ++k) {
      rgb[k] = hn::MulAdd(diffuse[k], cosine, hn::Mul(lobe, hn::MulAdd(f0[k], scaled, added)));
    }
  }

 private:
  static constexpr std::size_t layer_size = (GgxSh::angle_intervals + 1) * GgxSh::row_size;
  static_assert(std::size_t{GgxSh::angle_intervals} == ReflectionTable::intervals);

  HWY_INLINE V Layered(const float* table) const {
    const V a = Between(table, first, GgxSh::row_size, rows.fraction);
    const V b = Between(table + layer_size, first, GgxSh::row_size, rows.fraction);
    return hn::MulAdd(roughness_fraction, hn::Sub(b, a), a);
  }
};

// read(i, f) reads the light of the vector of points that starts at i; rows_of(i, cosine) are the
// coefficients of their materials for the angle of the eye.
template <class Read, class RowsOf>
HWY_INLINE void ReflectRead(const SurfacePoints& points, const Quarters& quarters,
                            PointRadiance& outgoing, Read read, RowsOf rows_of) {
  const D d;
  const auto negative = [](const Angle& a) HWY_ATTR { return Angle{a.cosine, hn::Neg(a.sine)}; };
  Coefficients f;
  Coefficients turned;
  for (std::size_t i = 0; i < points.padded_size(); i += hn::Lanes(d)) {
    read(i, f);
    const auto load = [i](const PointArray& a) HWY_ATTR { return hn::Load(D(), a.data() + i); };
    const V nx = load(points.normal.x);
    const V ny = load(points.normal.y);
    const V nz = load(points.normal.z);
    // The frame of the surface is the world turned about z and y to the normal, and then about it
    // to the eye.
    const Angle azimuth = Direction(nx, ny);
    const Angle polar = Direction(nz, hn::Sqrt(hn::MulAdd(nx, nx, hn::Mul(ny, ny))));
    const V ox = load(points.to_eye.x);
    const V oy = load(points.to_eye.y);
    const V oz = load(points.to_eye.z);
    const V x = hn::MulAdd(azimuth.cosine, ox, hn::Mul(azimuth.sine, oy));
    const V y = hn::MulSub(azimuth.cosine, oy, hn::Mul(azimuth.sine, ox));
    const Angle eye = Direction(hn::MulSub(polar.cosine, x, hn::Mul(polar.sine, oz)), y);
    const V cosine = hn::MulAdd(polar.sine, x, hn::Mul(polar.cosine, oz));

    TurnAboutZ(negative(azimuth), f);
    Quarter{quarters.forward}(f, turned);
    TurnAboutZ(negative(polar), turned);
    Quarter{quarters.inverse}(turned, f);
    TurnAboutZ(negative(eye), f);

    const auto rows = rows_of(i, cosine);
    V sum[3] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    std::size_t index = 0;
    for (int l = 0; l < sh_max_bands; ++l) {
      for (int m = 0; m <= l; ++m) {
        V rgb[3];
        rows(index++, rgb);
        for (std::size_t k = 0; k < 3; ++k) {
          sum[k] = hn::MulAdd(rgb[k], f.get(3 * sh_index(l, m) + k), sum[k]);
        }
      }
    }
    hn::Store(sum[0], d, outgoing.r.data() + i);
    hn::Store(sum[1], d, outgoing.g.data() + i);
    hn::Store(sum[2], d, outgoing.b.data() + i);
  }
}

HWY_INLINE void LoadLight(const IncidentLight& light, std::size_t i, Coefficients& f) {
  for (std::size_t k = 0; k < 3 * functions; ++k) {
    f.set(k, hn::Load(D(), light.values[k].data() + i));
  }
}

void Reflect(const SurfacePoints& points, const float* table, const Quarters& quarters,
             const IncidentLight& light, PointRadiance& outgoing) {
  ReflectRead(
      points, quarters, outgoing,
      [&](std::size_t i, Coefficients& f) HWY_ATTR { LoadLight(light, i, f); },
      [&](std::size_t, V cosine) HWY_ATTR { return TableRows(table, cosine); });
}

void ReflectGgx(const SurfacePoints& points, const GgxSh& table, const Quarters& quarters,
                const IncidentLight& light, PointRadiance& outgoing) {
  ReflectRead(
      points, quarters, outgoing,
      [&](std::size_t i, Coefficients& f) HWY_ATTR { LoadLight(light, i, f); },
      [&](std::size_t i, V cosine) HWY_ATTR { return GgxRows(table, points.ggx, i, cosine); });
}

void ReflectMixed(const SurfacePoints& points, const float* table, const Quarters& quarters,
                  std::span<const MixedLight> light, std::size_t size, PointRadiance& outgoing) {
  constexpr std::size_t lanes = HWY_LANES(float);
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
  const auto mix = [&](std::size_t i, Coefficients& f) HWY_ATTR {
    std::fill(f.values + 3 * size * lanes, std::end(f.values), 0.0f);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const MixedLight& mixed = light[std::min(i + lane, light.size() - 1)];
      if (!mixed.corners[0]) {
        for (std::size_t k = 0; k < 3 * size; ++k) f.values[k * lanes + lane] = 0.0f;
        continue;
      }
      const float* a = &mixed.corners[0]->x;
      const float* b = &mixed.corners[1]->x;
      const float* c = &mixed.corners[2]->x;
      float sum[3 * functions];
      for (std::size_t k = 0; k < 3 * size; ++k) {
        sum[k] = mixed.weights.x * a[k] + mixed.weights.y * b[k] + mixed.weights.z * c[k];
      }
      for (std::size_t k = 0; k < 3 * size; ++k) f.values[k * lanes + lane] = sum[k];
    }
  };
  ReflectRead(points, quarters, outgoing, mix,
              [&](std::size_t, V cosine) HWY_ATTR { return TableRows(table, cosine); });
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace brume {
namespace {

std::span<const ShElement> inverse_quarter_turn() {
  static const std::vector<ShElement> transposed = [] {
    std::vector<ShElement> result;
    for (const ShElement& e : sh_quarter_turn()) result.push_back({e.from, e.to, e.value});
    std::ranges::stable_sort(result, {}, &ShElement::to);
    return result;
  }();
  return transposed;
}

}  // namespace

HWY_EXPORT(Reflect);
HWY_EXPORT(ReflectMixed);
HWY_EXPORT(ReflectGgx);

void IncidentLight::clear() {
  for (PointArray& coefficient : values) coefficient.fill(0.0f);
}

void IncidentLight::add(std::size_t point, const ShVector<glm::dvec3>& light) {
  for (std::size_t i = 0; i < light.size(); ++i) add(point, i, glm::vec3(light[i]));
}

ReflectionTable::ReflectionTable(const BrdfSh& brdf) {
  for (int i = 0; i <= intervals; ++i) {
    const ShVector<glm::dvec3> row = brdf(std::cos(0.5 * std::numbers::pi * i / intervals));
    for (int l = 0; l < sh_max_bands; ++l) {
      for (int m = 0; m <= l; ++m) {
        const glm::dvec3 value = l < row.order() ? row[sh_index(l, m)] : glm::dvec3(0.0);
        for (int c = 0; c < 3; ++c) values_.push_back(static_cast<float>(value[c]));
      }
    }
    values_.resize(static_cast<std::size_t>(i + 1) * row_size, 0.0f);
  }
}

void reflect(const SurfacePoints& points, const ReflectionTable& table, const IncidentLight& light,
             PointRadiance& outgoing) {
  HWY_DYNAMIC_DISPATCH(Reflect)
  (points, table.rows(), {sh_quarter_turn(), inverse_quarter_turn()}, light, outgoing);
}

void reflect_ggx(const SurfacePoints& points, const IncidentLight& light, PointRadiance& outgoing) {
  HWY_DYNAMIC_DISPATCH(ReflectGgx)
  (points, GgxSh::table(), {sh_quarter_turn(), inverse_quarter_turn()}, light, outgoing);
}

void reflect(const SurfacePoints& points, const ReflectionTable& table,
             std::span<const MixedLight> light, std::size_t size, PointRadiance& outgoing) {
  HWY_DYNAMIC_DISPATCH(ReflectMixed)
  (points, table.rows(), {sh_quarter_turn(), inverse_quarter_turn()}, light, size, outgoing);
}

}  // namespace brume
#endif
