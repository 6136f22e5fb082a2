// Evaluates every quantity of the golden file that Brume has, in double at tol64, in float at
// tol32, and at tol32 again by the SIMD kernels that frames are made with; prints "N passed,
// N failed". Quantities that Brume does not have yet are named.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "core/math/spherical_harmonics.h"
#include "core/transport/average_depth.h"
#include "core/transport/closed_form_airlight.h"
#include "core/transport/point_spread.h"
#include "render/cpu/paper_airlight.h"
#include "render/reference/airlight_integral.h"
#include "render/simd/gaussian_kernels.h"
#include "tests/core/transport/incident_light.h"

namespace brume {
namespace {

using Json = nlohmann::json;

template <class Real>
Real real(const Json& value) {
  return static_cast<Real>(value.get<double>());
}

template <class Real>
Vec3<Real> vec(const Json& value) {
  return {real<Real>(value[0]), real<Real>(value[1]), real<Real>(value[2])};
}

template <class Real>
GaussianTerm<Real> gaussian(const Json& value) {
  return {real<Real>(value.at("a")), value.contains("c") ? real<Real>(value.at("c")) : Real(1),
          vec<Real>(value.at("b"))};
}

template <class Real>
std::vector<GaussianTerm<Real>> gaussians(const Json& in) {
  std::vector<GaussianTerm<Real>> all;
  for (const Json& g : in.at("gaussians")) all.push_back(gaussian<Real>(g));
  return all;
}

// The view ray of a case: to a point "p", or along "dir" to infinity.
template <class Real>
struct Ray {
  Vec3<Real> v, w;
  Real d;

  explicit Ray(const Json& in) : v(vec<Real>(in.at("v"))) {
    const Vec3<Real> q = in.contains("p") ? vec<Real>(in.at("p")) - v : vec<Real>(in.at("dir"));
    w = glm::normalize(q);
    d = in.contains("p") ? glm::length(q) : std::numeric_limits<Real>::infinity();
  }
};

template <class Real>
Real exact_airlight(const Json& in, ScatteredBy scattered_by) {
  const Ray<Real> ray(in);
  const auto all = gaussians<Real>(in);
  const ViewRayMedium<Real> medium(all, real<Real>(in.at("b0")), ray.v, ray.w, ray.d);
  const LightSource<Real> light{vec<Real>(in.at("s")), 0, all, 0, std::nullopt};
  const Real tolerance = sizeof(Real) == 4 ? Real(1e-4) : Real(1e-10);
  return real<Real>(in.at("I0")) * airlight_integral(medium, light, tolerance, scattered_by);
}

// Tbar_i(s, b_i) + Tbar_i(v, b_i), b0 included.
template <class Real>
std::vector<Real> frozen_depths(const std::vector<GaussianTerm<Real>>& all, Real b0,
                                const Vec3<Real>& s, const Vec3<Real>& v) {
  std::vector<Real> frozen;
  for (std::size_t i = 0; i < all.size(); ++i) {
    frozen.push_back(b0 * (glm::length(all[i].b - s) + glm::length(all[i].b - v)));
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (j == i) continue;
      frozen[i] += optical_depth(all[j], s, all[i].b) + optical_depth(all[j], v, all[i].b);
    }
  }
  return frozen;
}

template <class Real>
Real paper_gaussians(const Json& in) {
  const Ray<Real> ray(in);
  const auto all = gaussians<Real>(in);
  const Real b0 = real<Real>(in.at("b0"));
  const Vec3<Real> s = vec<Real>(in.at("s"));
  const PointLightRay<Real> path(s, ray.v, ray.w, Real(0));
  Real sum = 0;
  const std::vector<Real> frozen = frozen_depths(all, b0, s, ray.v);
  for (std::size_t i = 0; i < all.size(); ++i) {
    sum += gaussian_airlight(all[i], ray.v, ray.w, ray.d, s, path, frozen[i]);
  }
  return real<Real>(in.at("I0")) * sum;
}

template <class Real>
Real paper_homogeneous(const Json& in) {
  const Ray<Real> ray(in);
  const Vec3<Real> s = vec<Real>(in.at("s"));
  Real between = 0;
  for (const auto& g : gaussians<Real>(in)) between += optical_depth(g, s, ray.v);
  const PointLightRay<Real> path(s, ray.v, ray.w, Real(0));
  return real<Real>(in.at("I0")) * std::exp(-between) *
         homogeneous_airlight(real<Real>(in.at("b0")), path, ray.d);
}

// Point spread functions are tabulated, and always in double.
template <class Real>
ZonalSh<Real> point_spread_of(double T) {
  const ZonalSh<double> exact = point_spread_sh(T);
  ZonalSh<Real> result{};
  std::transform(exact.begin(), exact.end(), result.begin(), [](double c) { return Real(c); });
  return result;
}

template <class Real>
std::vector<Real> first_bands(double T, const Json& order) {
  const ZonalSh<Real> all = point_spread_of<Real>(T);
  return {all.begin(), all.begin() + order.get<int>()};
}

template <class Real>
std::vector<Real> coefficients(const ShVector<Real>& f) {
  return {f.values().begin(), f.values().end()};
}

template <class Real>
std::vector<Real> point_light(const Json& in) {
  const auto light = incident_point_light<Real>(in["order"], glm::normalize(vec<Real>(in["dir"])),
                                                real<Real>(in["T_sp"]), point_spread_of<Real>(1.0));
  std::vector<Real> values = coefficients(light);
  const Real d = real<Real>(in["d_ps"]);
  for (Real& value : values) value *= real<Real>(in["I0"]) / (d * d);
  return values;
}

template <class Real>
std::vector<Real> environment(const Json& in) {
  const Json& values = in["L"];
  ShVector<Real> L(static_cast<int>(std::lround(std::sqrt(values.size()))));
  for (std::size_t i = 0; i < L.size(); ++i) L[i] = real<Real>(values[i]);
  return coefficients(incident_environment(L, real<Real>(in["Tbar"]), point_spread_of<Real>(1.0)));
}

template <class Real>
using Quantity = std::function<std::vector<Real>(const Json&)>;

template <class Real>
std::map<std::string, Quantity<Real>> quantities() {
  using R = std::vector<Real>;
  return {
      {"tau_segment",
       [](const Json& in) {
         return R{optical_depth(gaussian<Real>(in), vec<Real>(in["A"]), vec<Real>(in["B"]))};
       }},
      {"tau_ray_inf",
       [](const Json& in) {
         const auto g = gaussian<Real>(in);
         const auto w = glm::normalize(vec<Real>(in["dir"]));
         return R{optical_depth(g, line_profile(g, vec<Real>(in["A"]), w),
                                std::numeric_limits<Real>::infinity())};
       }},
      {"airlight_homog",
       [](const Json& in) {
         const Ray<Real> ray(in);
         const PointLightRay<Real> path(vec<Real>(in["s"]), ray.v, ray.w, Real(0));
         return R{real<Real>(in["I0"]) * homogeneous_airlight(real<Real>(in["b0"]), path, ray.d)};
       }},
      {"airlight_gauss_exact",
       [](const Json& in) { return R{exact_airlight<Real>(in, ScatteredBy::gaussians)}; }},
      {"airlight_homog_exact",
       [](const Json& in) { return R{exact_airlight<Real>(in, ScatteredBy::homogeneous)}; }},
      {"airlight_gauss_paper", [](const Json& in) { return R{paper_gaussians<Real>(in)}; }},
      {"airlight_homog_paper", [](const Json& in) { return R{paper_homogeneous<Real>(in)}; }},
      {"tau_ellipsoid",
       [](const Json& in) {
         // |L^T (x - b)| for M = L L^T: what turns the ball into it is the inverse of L^T.
         glm::dmat3 L(0.0);
         for (int i = 0; i < 3; ++i) {
           for (int j = 0; j <= i; ++j) {
             double sum = in["M"][static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
             for (int k = 0; k < j; ++k) sum -= L[k][i] * L[k][j];
             L[j][i] = i == j ? std::sqrt(sum) : sum / L[j][j];
           }
         }
         Gaussian g{vec<double>(in["b"]), 1.0, in["c"]};
         transform(g, glm::inverse(glm::transpose(L)));
         GaussianTerms<Real> terms;
         terms.add(g);
         return R{optical_depth(terms[0], vec<Real>(in["A"]), vec<Real>(in["B"]))};
       }},
      {"trunc_mean",
       [](const Json& in) {
         const Ray<Real> ray(in);
         const auto g = gaussian<Real>(in["g"]);
         return R{truncated_mean(line_profile(g, ray.v, ray.w), ray.d)};
       }},
      {"npsf", [](const Json& in) { return R{Real(point_spread(1.0, in["gamma"]))}; }},
      {"npsf_sh", [](const Json& in) { return first_bands<Real>(1.0, in["order"]); }},
      {"psf_sh_T", [](const Json& in) { return first_bands<Real>(in["T"], in["order"]); }},
      {"tbar_unit", [](const Json& in) { return R{unit_average_depth(real<Real>(in["u"]))}; }},
      {"tbar",
       [](const Json& in) {
         const GaussianTerm<Real> g(real<Real>(in["a"]), real<Real>(in["c"]), Vec3<Real>(0));
         return R{average_depth(g, Vec3<Real>(real<Real>(in["dist"]), 0, 0))};
       }},
      {"lin_point_sh", point_light<Real>},
      {"lin_env_sh", environment<Real>},
      {"sh_triple",
       [](const Json& in) {
         const auto is_asked = [&](const ShTriple& it) {
           return it.i == in["i"] && it.j == in["j"] && it.k == in["k"];
         };
         const auto found = std::ranges::find_if(sh_triples(sh_max_bands), is_asked);
         return R{found == sh_triples(sh_max_bands).end() ? Real(0) : Real(found->value)};
       }},
      {"cull",
       [](const Json& in) {
         // Culling bounds are made once per Gaussian and always in double.
         const Gaussian g{vec<double>(in["b"]), 1.0 / in["a"].get<double>(), in["c"]};
         const double r = cutoff_radius(g.radius, g.density, in["eps"]);
         const double distance = glm::length(g.center - vec<double>(in["o"]));
         // The cone of rays that the bound lets through has this half angle.
         return R{Real(r), Real(r < distance ? std::asin(r / distance) : std::numbers::pi)};
       }},
  };
}

// The kernels, with a single path or ray.
std::map<std::string, Quantity<float>> kernels() {
  using R = std::vector<float>;
  const auto medium_of = [](const Json& gaussians) {
    Medium medium;
    for (const Json& in : gaussians) {
      medium.append({vec<double>(in.at("b")), 1.0 / in.at("a").get<double>(), in.at("c")});
    }
    return medium;
  };
  const auto depth = [medium_of](const Json& in, const glm::dvec3& w, double length) {
    const MediumIndex medium(medium_of(Json::array({in})), 1e-300);
    GaussianBatch batch;
    batch.assign(medium, vec<double>(in.at("A")), std::array{0u});
    PathBatch path;
    path.assign(std::array{w}, std::array{length});
    std::vector<float> depths(path.padded_size(), 0.0f);
    accumulate_path_depths(batch, path, depths.data());
    return R{depths[0]};
  };
  return {
      {"tau_segment",
       [depth](const Json& in) {
         const glm::dvec3 q = vec<double>(in.at("B")) - vec<double>(in.at("A"));
         return depth(in, glm::normalize(q), glm::length(q));
       }},
      {"tau_ray_inf",
       [depth](const Json& in) {
         return depth(in, glm::normalize(vec<double>(in.at("dir"))),
                      std::numeric_limits<double>::infinity());
       }},
      {"airlight_homog",
       [](const Json& in) {
         const Ray<double> ray(in);
         PathBatch path;
         path.assign(std::array{ray.w}, std::array{ray.d});
         std::vector<float> radiance(path.padded_size(), 0.0f);
         accumulate_homogeneous_airlight(BatchFog(real<float>(in.at("b0"))), 1.0f,
                                         glm::vec3(vec<double>(in.at("s")) - ray.v), 0.0f, 0.0f,
                                         path, radiance.data());
         return R{real<float>(in.at("I0")) * radiance[0]};
       }},
      {"airlight_gauss_paper",
       [medium_of](const Json& in) {
         const Ray<double> ray(in);
         const auto all = gaussians<double>(in);
         // b0 has its own term; here it is only in the way of the light.
         const MediumIndex medium(medium_of(in.at("gaussians")), 1e-300);
         PaperLights paper;
         PaperLight& light = paper.lights.emplace_back();
         light.position = vec<double>(in.at("s"));
         light.intensity = glm::dvec3(in.at("I0").get<double>());
         light.frozen = frozen_depths(all, in.at("b0").get<double>(), light.position, ray.v);
         std::vector<std::uint32_t> indices(all.size());
         std::iota(indices.begin(), indices.end(), 0u);
         glm::vec3 airlight;
         double depth_to_end = 0.0;
         paper_airlight(medium, indices, paper,
                        {ray.v, std::array{ray.w}, std::array{ray.d}, 0, {}},
                        Settings::Precision::simd_float,
                        {std::span(&airlight, 1), std::span(&depth_to_end, 1)});
         return R{airlight.x};
       }},
  };
}

std::vector<double> expected(const Json& value) {
  if (value.is_array()) return value.get<std::vector<double>>();
  return {value.get<double>()};
}

struct Score {
  int passed = 0;
  int failed = 0;
};

template <class Real>
void evaluate(const Json& test, const std::map<std::string, Quantity<Real>>& how,
              const char* tolerance, Score& score) {
  const std::vector<Real> got = how.at(test.at("quantity"))(test.at("inputs"));
  const std::vector<double> want = expected(test.at("value"));
  const double relative = test.at(tolerance).at("rel");
  const double absolute = test.at(tolerance).at("abs");
  bool pass = got.size() == want.size();
  for (std::size_t i = 0; pass && i < want.size(); ++i) {
    pass =
        std::abs(static_cast<double>(got[i]) - want[i]) <= relative * std::abs(want[i]) + absolute;
  }
  ++(pass ? score.passed : score.failed);
  if (pass) return;
  std::printf("FAILED %s at %s:", test.at("id").get<std::string>().c_str(), tolerance);
  for (std::size_t i = 0; i < want.size() && i < got.size(); ++i) {
    const double value = got[i];
    std::printf(" %.15g should be %.15g (relative error %.2g, allowed %.2g);", value, want[i],
                std::abs(value / want[i] - 1.0), relative);
  }
  std::printf(" %s\n", test.value("note", "").c_str());
}

int run(const char* file) {
  std::ifstream stream(file);
  if (!stream) {
    std::printf("cannot read %s\n", file);
    return 2;
  }
  const Json golden = Json::parse(stream);
  const auto known = quantities<double>();
  const auto known32 = quantities<float>();
  const auto by_kernel = kernels();
  std::set<std::string> skipped;
  std::set<std::string> seen;
  Score score;
  for (const Json& test : golden.at("cases")) {
    const std::string quantity = test.at("quantity");
    if (!known.contains(quantity)) {
      skipped.insert(quantity);
      continue;
    }
    seen.insert(quantity);
    evaluate<double>(test, known, "tol64", score);
    evaluate<float>(test, known32, "tol32", score);
    if (by_kernel.contains(quantity)) evaluate<float>(test, by_kernel, "tol32", score);
  }
  // A quantity that Brume has must not get lost in a file that lacks or misspells it.
  for (const auto& [quantity, evaluate_it] : known) {
    if (!seen.contains(quantity)) {
      std::printf("FAILED: no case of %s in the file\n", quantity.c_str());
      ++score.failed;
    }
  }
  for (const std::string& quantity : skipped) {
    std::printf("skipped: %s is not implemented yet\n", quantity.c_str());
  }
  std::printf("%d passed, %d failed\n", score.passed, score.failed);
  return score.failed == 0 && score.passed > 0 ? 0 : 1;
}

}  // namespace
}  // namespace brume

int main() {
  const char* file = std::getenv("BRUME_GOLDEN");
  return brume::run(file ? file : BRUME_GOLDEN_DEFAULT);
}
