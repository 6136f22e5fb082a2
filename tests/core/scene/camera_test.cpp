#include "core/scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace brume {
namespace {

TEST(CameraRays, CenterOfTheFilmLooksAtTheTarget) {
  const CameraRays rays({{1, 2, 3}, {4, 0, -1}, {0, 1, 0}, 50.0}, {640, 480});
  const glm::dvec3 forward = glm::normalize(glm::dvec3(3, -2, -4));
  EXPECT_LT(glm::length(rays.direction(320, 240) - forward), 1e-12);
}

TEST(CameraRays, VerticalFieldOfViewIsTheFullAngle) {
  const CameraRays rays({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 40.0}, {800, 600});
  const double cosine = glm::dot(rays.direction(400, 0), rays.direction(400, 600));
  EXPECT_NEAR(std::acos(cosine), 40.0 / 180.0 * std::acos(-1.0), 1e-12);
  EXPECT_GT(rays.direction(400, 0).y, 0.0);  // rows from the top
  EXPECT_GT(rays.direction(800, 300).x, 0.0);
}

TEST(CameraRays, ProjectUndoesDirection) {
  const CameraRays rays({{1, 2, 3}, {4, 0, -1}, {0.1, 1, 0}, 70.0}, {640, 480});
  for (const auto& [x, y] : {std::pair{0.5, 0.5}, {320.0, 17.0}, {639.0, 479.0}}) {
    const glm::dvec3 p = rays.project(rays.eye() + 7.0 * rays.direction(x, y));
    EXPECT_NEAR(p.x, x, 1e-9);
    EXPECT_NEAR(p.y, y, 1e-9);
    EXPECT_GT(p.z, 0.0);
  }
  EXPECT_LT(rays.project(rays.eye() - rays.forward()).z, 0.0);
}

TEST(CameraRays, UpAlongTheViewStillHasAFrame) {
  const CameraRays rays({{0, 5, 0}, {0, 0, 0}, {0, 1, 0}, 40.0}, {8, 8});
  const glm::dvec3 d = rays.direction(1, 1);
  EXPECT_NEAR(glm::length(d), 1.0, 1e-12);
  EXPECT_LT(d.y, 0.0);
}

}  // namespace
}  // namespace brume
