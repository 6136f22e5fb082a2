#include "brume/medium_sequence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "brume/at_time.h"
#include "core/fit/gaussian_numbers.h"

namespace brume {
namespace {

const glm::dvec3 white_albedo(1.0);
const SequenceFrame frame_11{{1, 4, 7},
                             {{{0, 0, 0}, 1.0, 2.0}, {{1, 0, 0}, 2.0, 1.0}, {{2, 0, 0}, 1.0, 4.0}}};
const SequenceFrame frame_12{{4, 7, 9},
                             {{{3, 0, 0}, 8.0, 3.0}, {{2, 2, 0}, 1.0, 0.0}, {{5, 0, 0}, 0.5, 8.0}}};

TEST(MediumSequence, InterpolatesByIdAndFadesTheRest) {
  const auto middle = between_frames(frame_11, frame_12, 0.25, white_albedo);
  ASSERT_EQ(middle.size(), 4u);
  EXPECT_EQ(middle[0], (Gaussian{{0, 0, 0}, 1.0, 1.5})) << "it dies where it was";
  EXPECT_EQ(middle[1].center, glm::dvec3(1.5, 0, 0));
  EXPECT_NEAR(middle[1].radius, 2.0 * std::sqrt(2.0), 1e-12) << "a quarter of the way from 2 to 8";
  EXPECT_EQ(middle[1].density, 1.5);
  EXPECT_EQ(middle[2], (Gaussian{{2, 0.5, 0}, 1.0, 3.0}));
  EXPECT_EQ(middle[3], (Gaussian{{5, 0, 0}, 0.5, 2.0})) << "it is born where it will be";
}

TEST(MediumSequence, InterpolatesAlbedoAndEmission) {
  const GaussianOptics red{glm::dvec3(1.0, 0.5, 0.5), {8, 4, 0}};
  const GaussianOptics blue{glm::dvec3(0.2, 0.5, 1.0), {0, 4, 4}};
  const SequenceFrame first{{1, 2, 3, 4},
                            {{{}, 1, 1, red}, {{}, 1, 1, red}, {{}, 1, 1}, {{}, 1, 1}}};
  const SequenceFrame second{{1, 2, 3}, {{{}, 1, 1, blue}, {{}, 1, 1}, {{}, 1, 1, blue}}};
  const glm::dvec3 medium(0.8);
  const auto optics = [&](std::size_t i) {
    return between_frames(first, second, 0.25, medium)[i].optics;
  };
  const auto expect_near = [](const glm::dvec3& a, const glm::dvec3& b) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-15);
  };
  expect_near(*optics(0).albedo, {0.8, 0.5, 0.625});
  expect_near(optics(0).emission, {6, 4, 1});
  // Where one has none of its own it is the medium's.
  expect_near(*optics(1).albedo, {0.95, 0.575, 0.575});
  expect_near(optics(1).emission, {6, 3, 0});
  expect_near(*optics(2).albedo, {0.65, 0.725, 0.85});
  EXPECT_EQ(optics(3), GaussianOptics());
}

MediumSequence smoke() {
  MediumSequence sequence;
  sequence.first = 11;
  sequence.last = 12;
  sequence.frames_per_second = 10.0;
  sequence.start = 2.0;
  sequence.frames = sequence_frames({frame_11, frame_12});
  return sequence;
}

TEST(MediumSequence, ShowsItsFramesAtTheirTimes) {
  const MediumSequence sequence = smoke();
  EXPECT_EQ(sequence_at(sequence, 0.0, white_albedo), frame_11.gaussians);
  EXPECT_EQ(sequence_at(sequence, 2.0, white_albedo), frame_11.gaussians);
  EXPECT_EQ(sequence_at(sequence, 2.1, white_albedo), frame_12.gaussians)
      << "2.1 is no exact number";
  EXPECT_EQ(sequence_at(sequence, 99.0, white_albedo), frame_12.gaussians);
  EXPECT_EQ(sequence_at(sequence, 2.05, white_albedo).size(), 4u);
  EXPECT_NEAR(end_of(sequence), 2.1, 1e-12);
}

TEST(MediumSequence, BelongsToTheSceneAtATime) {
  Scene scene;
  scene.medium.append({{0, 9, 0}, 1.0, 1.0});
  scene.sequences = {smoke(), smoke()};
  EXPECT_TRUE(is_animated(scene));
  EXPECT_NEAR(last_moment(scene), 2.1, 1e-12);
  const Scene shown = evaluate_at(scene, 2.05);
  EXPECT_EQ(shown.medium.size(), 9u);
  EXPECT_EQ(shown.medium.gaussian(0), scene.medium.gaussian(0));
  EXPECT_TRUE(shown.sequences.empty());
}

TEST(GaussianNumbers, AreNeverReused) {
  GaussianNumbers numbers;
  GaussianNumber counter = 0;
  numbers.begin(3, counter);
  EXPECT_EQ(numbers.relocate({false, true, false}, counter), 1u);
  EXPECT_EQ(numbers.relocate({false, true, true}, counter), 2u);
  EXPECT_EQ(std::vector(numbers.ids().begin(), numbers.ids().end()),
            (std::vector<GaussianNumber>{0, 4, 5}));
}

}  // namespace
}  // namespace brume
