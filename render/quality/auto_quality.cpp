#include "render/quality/auto_quality.h"

#include <algorithm>
#include <span>
#include <utility>

#include "render/quality/work.h"
#include "render/samples/brightness.h"
#include "render/util/job.h"

namespace brume {
namespace {

// Settings are chosen for a small picture of about so many pixels.
constexpr double choice_pixels = 10'000.0;

constexpr std::uint64_t seed_of_choice = 1;

// An error of this share of the bound on a small frame is likely to be below the bound.
constexpr double likely_fraction = 0.8;

// The same where nothing is tried after the frame was measured.
constexpr double safe_fraction = 0.65;

// Errors within this factor of the minimum count as equal.
constexpr double negligible_gain = 1.1;

// Number of consecutive finer settings without a larger gain that end the search.
constexpr int max_vain_trials = 3;

// Many times the light that is there: the view is black but for what no settings resolve. Smaller
// errors may stay for long and then fall, once the slices are as short as what they miss.
constexpr double hopeless_error = 10.0;

// Whether the last errors found are no better than what was found before them.
bool is_vain(std::span<const double> found) {
  if (found.size() <= max_vain_trials) return false;
  const auto last = found.end() - max_vain_trials;
  return negligible_gain * *std::min_element(last, found.end()) >=
         *std::min_element(found.begin(), last);
}

// Work of a choice that is not `full`: a fifth of a second. See work.h.
constexpr double quick_choice_work = 2e8;

// Settings with an error above the bound by so much are far too coarse: the next ones are, too.
constexpr double far_above = 2.5;

// The share of a picture's work that a quick measurement may take: what both cost is known roughly.
constexpr double quick_share = 0.75;

// The next finer settings, if any.
std::optional<Settings> better_settings(const Settings& settings) {
  const std::vector<Settings> ladder = quality_ladder(settings);
  const auto it = std::find(ladder.begin(), ladder.end(), settings);
  if (it == ladder.end() || it + 1 == ladder.end()) return std::nullopt;
  return *(it + 1);
}

}  // namespace

std::vector<Settings> quality_ladder(const Settings& settings) {
  // `paper` is not among them: with the same error it is never cheaper.
  std::vector<Settings> ladder;
  for (const int slices : {8, 12, 16, 24, 32, 48, 64, 128}) {
    ladder.push_back(sliced_settings(settings, slices));
  }
  return ladder;
}

std::optional<Settings> choose_settings(FrameRenderer& renderer, const Scene& scene,
                                        const Camera& camera, const Film& film,
                                        const Settings& settings, const std::stop_token& stop,
                                        const std::function<void(double)>& progress,
                                        ErrorMeasurement effort) {
  // The sample takes most of the time, then each trial about as much as all before it.
  const Job job{stop, progress};
  const Job measuring = job.subrange(0.0, 0.6);
  double begin = 0.6;
  const Film small = small_film(film, choice_pixels);
  const std::vector<Settings> ladder = quality_ladder(settings);
  FrameErrors errors(scene, camera, seed_of_choice);
  const bool is_full = effort == ErrorMeasurement::full;
  std::vector<double> found;
  std::vector<Settings> all_tried;
  for (std::size_t step = 0;;) {
    const Settings& tried = ladder[step];
    // Differences of settings show in light that is scattered once, whose reference is exact.
    Settings single = tried;
    single.scattering = Scattering::single;
    single.samples = 1;  // errors are those of centers
    const std::optional<Frame> frame = renderer.render(scene, camera, small, single, stop);
    if (!frame) return std::nullopt;
    const auto reported = begin > 0.6 ? nullptr : measuring.progress;
    const std::optional<FrameError> measured =
        is_full ? errors.measure(*frame, std::nullopt, stop, reported)
                : errors.measure_within(quick_choice_work, *frame, std::nullopt, stop, reported);
    if (!measured) return std::nullopt;
    const ErrorEstimate& error = measured->airlight;
    begin += 0.5 * (1.0 - begin);
    if (progress) progress(begin);
    // By the estimate and not by its interval, which is wide on a few pixels and would make finer
    // settings look needed; the frame is judged by the interval.
    const double fraction = is_full ? likely_fraction : safe_fraction;
    if (error.rel_rmse <= fraction * settings.max_error) return tried;
    found.push_back(error.rel_rmse);
    all_tried.push_back(tried);
    if (is_vain(found) && *std::ranges::min_element(found) > hopeless_error) break;
    if (step + 1 == ladder.size()) break;
    const bool skips = !is_full && error.rel_rmse > far_above * settings.max_error;
    step = std::min(step + (skips ? 2 : 1), ladder.size() - 1);
  }
  // A large frame is interpolated between nearer rays and may still meet the bound: where
  // finer settings gain nothing they are not begun with.
  const double good = negligible_gain * *std::ranges::min_element(found);
  return all_tried[static_cast<std::size_t>(
      std::ranges::find_if(found, [=](double error) { return error <= good; }) - found.begin())];
}

std::optional<FrameError> measure_error(const Scene& scene, const Camera& camera,
                                        const Frame& frame, const std::stop_token& stop,
                                        const std::function<void(double)>& progress,
                                        Measured measured) {
  return FrameErrors(scene, camera, evaluation_seed, measured)
      .measure(frame, std::nullopt, stop, progress);
}

std::optional<FrameError> measure_error_quickly(const Scene& scene, const Camera& camera,
                                                const Frame& frame, const Settings& settings,
                                                bool has_bound, const std::stop_token& stop,
                                                const std::function<void(double)>& progress,
                                                Measured measured) {
  return FrameErrors(scene, camera, evaluation_seed, measured)
      .measure_within(quick_share * picture_work(frame, settings), frame,
                      has_bound ? std::optional(settings.max_error) : std::nullopt, stop, progress);
}

namespace {

// Frames of a small picture of the whole film, rendered with the settings and measured: while the
// error exceeds max_error, with finer ones. nullopt if stopped.
std::optional<RequestedFrame> render_within_error(FrameRenderer& renderer, const Scene& scene,
                                                  const Camera& camera, const Film& film,
                                                  const Film& small, const Settings& settings,
                                                  FrameErrors& errors, const Job& job) {
  const double max_error = settings.max_error;
  double begin = 0.0;
  std::optional<Settings> tried = settings;
  std::optional<RequestedFrame> result;
  std::vector<double> found;
  while (tried) {
    tried->brightness.reset();  // perhaps of coarser ones
    tried = with_brightness(renderer, scene, camera, film, std::move(*tried), {job.stop, {}});
    if (!tried) return std::nullopt;
    // Seldom is more than one frame needed.
    const double end = begin + 0.8 * (1.0 - begin);
    const double center = 0.5 * (begin + end);
    std::optional<Frame> frame = renderer.render(scene, camera, small, *tried, job.stop,
                                                 job.subrange(begin, center).progress);
    if (!frame) return std::nullopt;
    const std::optional<FrameError> measured =
        errors.measure(*frame, max_error, job.stop, job.subrange(center, end).progress);
    if (!measured) return std::nullopt;
    const ErrorEstimate& error = measured->airlight;
    // Finer settings that are no surer of the bound are only slower.
    const bool may_keep = result && result->error->airlight.rel_rmse <= max_error;
    if (error.high <= max_error || !may_keep) {
      result = RequestedFrame{std::move(*frame), *tried, *measured};
    }
    if (error.high <= max_error) break;
    found.push_back(error.rel_rmse);
    if (error.low > max_error && is_vain(found)) break;
    tried = better_settings(*tried);
    begin = end;
  }
  return result;
}

}  // namespace

std::optional<RequestedFrame> render_requested(FrameRenderer& renderer, const Scene& scene,
                                               const Camera& camera, const Film& film,
                                               const Settings& settings,
                                               const std::stop_token& stop,
                                               const std::function<void(double)>& progress,
                                               Measured measured) {
  const Job job{stop, progress};
  if (settings.airlight != AirlightMethod::auto_) {
    std::optional<Frame> frame = renderer.render(scene, camera, film, settings, stop, progress);
    if (!frame) return std::nullopt;
    return RequestedFrame{std::move(*frame), settings, std::nullopt};
  }
  std::optional<Settings> chosen = choose_settings(renderer, scene, camera, film, settings, stop,
                                                   job.subrange(0.0, 0.3).progress);
  if (!chosen) return std::nullopt;
  // All regions get the settings that a small picture of the whole needs.
  const Film small = small_film(film, choice_pixels);
  chosen->samples = 1;  // errors are those of centers
  const bool is_small = small == film;
  FrameErrors small_errors(scene, camera, evaluation_seed,
                           is_small ? measured : Measured::airlight);
  std::optional<RequestedFrame> result = render_within_error(
      renderer, scene, camera, film, small, *chosen, small_errors, job.subrange(0.3, 0.6));
  if (!result || (is_small && settings.samples == 1)) return result;
  result->settings.samples = settings.samples;
  // With more samples than one a frame may need it although the small one did not.
  std::optional<Settings> final_settings =
      with_brightness(renderer, scene, camera, film, result->settings, {stop, {}});
  if (!final_settings) return std::nullopt;
  result->settings = std::move(*final_settings);
  std::optional<Frame> frame =
      renderer.render(scene, camera, film, result->settings, stop, job.subrange(0.6, 0.8).progress);
  if (!frame) return std::nullopt;
  result->frame = std::move(*frame);
  FrameErrors own_errors(scene, camera, evaluation_seed, measured);
  FrameErrors& errors = is_small ? small_errors : own_errors;
  result->error =
      errors.measure(result->frame, settings.max_error, stop, job.subrange(0.8, 1.0).progress);
  if (!result->error) return std::nullopt;
  return result;
}

}  // namespace brume
