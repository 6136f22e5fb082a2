// Ellipsoidal Gaussians against tools/goldens/ellipsoids.py.

#include <gtest/gtest.h>

#include <fstream>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "core/transport/optical_depth.h"
#include "render/reference/airlight_integral.h"

namespace brume {
namespace {

using Json = nlohmann::json;

glm::dvec3 vector(const Json& value) {
  return {value[0], value[1], value[2]};
}

GaussianTerms<double> terms_of(const Json& gaussians) {
  GaussianTerms<double> terms;
  for (const Json& json : gaussians) {
    Gaussian g{vector(json["center"]), 1.0, json["density"]};
    const Json& q = json["rotate"];
    g.set_radii(vector(json["radii"]), glm::normalize(glm::dquat(q[0], q[1], q[2], q[3])));
    terms.add(g);
  }
  return terms;
}

Json cases_of(const char* quantity) {
  std::ifstream stream(BRUME_GOLDEN_ELLIPSOIDS);
  Json chosen = Json::array();
  const Json all = Json::parse(stream);
  for (const Json& one : all.at("cases")) {
    if (one.at("quantity") == quantity) chosen.push_back(one);
  }
  return chosen;
}

// Inputs are rounded to double: of a needle 1000 : 1 that is 1e-13 of its radius at a distance of
// one length.
TEST(EllipsoidGoldens, OpticalDepths) {
  const Json cases = cases_of("depth");
  ASSERT_GE(cases.size(), 15u);
  for (const Json& one : cases) {
    const GaussianTerms<double> terms = terms_of(one["gaussians"]);
    const double value = one["value"];
    const double depth = optical_depth(terms[0], vector(one["from"]), vector(one["to"]));
    EXPECT_NEAR(depth, value, 1e-12 * value) << one["name"];
    // The other way round it is the same.
    const double back = optical_depth(terms[0], vector(one["to"]), vector(one["from"]));
    EXPECT_NEAR(back, value, 1e-12 * value) << one["name"];
  }
}

TEST(EllipsoidGoldens, Airlight) {
  const Json cases = cases_of("airlight");
  ASSERT_GE(cases.size(), 5u);
  for (const Json& one : cases) {
    const GaussianTerms<double> terms = terms_of(one["gaussians"]);
    const glm::dvec3 eye = vector(one["from"]);
    const glm::dvec3 q = vector(one["to"]) - eye;
    const double length = glm::length(q);
    const ViewRayMedium<double> ray(terms.all(), 0.0, eye, q / length, length);
    const LightSource<double> light{vector(one["light"]), 0.0, terms.all(), 0.0, std::nullopt};
    const double value = one["value"];
    EXPECT_NEAR(airlight_integral(ray, light, 1e-13), value, 1e-12 * value) << one["name"];
  }
}

}  // namespace
}  // namespace brume
