#include "tools/bench/report/cache_table.h"

#include <algorithm>
#include <string>

#include "tools/bench/measure/report_text.h"

namespace brume {
namespace {

std::string with_quartiles(const Quartiles& q, double scale, int digits, const char* unit) {
  return formatted("%.*f%s (%.*f to %.*f)", digits, scale * q.median, unit, digits, scale * q.lower,
                   digits, scale * q.upper);
}

// A cache over all scenes.
struct BestGain {
  const CacheGain* best;
  double change;
};

std::vector<BestGain> best_gains(const std::vector<CacheGain>& gains) {
  std::vector<BestGain> caches;
  for (const CacheGain& gain : gains) {
    const auto known = std::ranges::find_if(
        caches, [&](const BestGain& cache) { return cache.best->cache == gain.cache; });
    if (known == caches.end()) {
      caches.push_back({&gain, gain.change});
      continue;
    }
    if (gain.gain.median > known->best->gain.median) known->best = &gain;
    known->change = std::max(known->change, gain.change);
  }
  return caches;
}

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : "; ") + name;
  return text.empty() ? "none" : text;
}

std::string verdict(const std::vector<CacheGain>& gains) {
  std::vector<std::string> too_little;
  std::vector<std::string> small;
  for (const BestGain& cache : best_gains(gains)) {
    if (cache.best->gain.median >= min_cache_gain) continue;
    const bool may_stay = cache.best->code.lines < small_cache_lines && cache.change == 0.0;
    (may_stay ? small : too_little).push_back(cache.best->cache);
  }
  return formatted(
             "A cache has to give %.0f%% in one scene, unless it takes less than %d lines and no "
             "picture differs. Too little: ",
             100.0 * min_cache_gain, small_cache_lines) +
         list(too_little) + ". Less, but small and without effect: " + list(small) + '.';
}

}  // namespace

ReportTable cache_table(const std::vector<CacheGain>& gains) {
  ReportTable table{
      "Caches between frames",
      "What a renderer keeps from frame to frame while the camera orbits scenes like those of "
      "Table 1, and a bank of small Gaussians; where edits are followed, a hundredth of them is "
      "thinned between two frames. A pair of frames, with and without one cache: before the "
      "second, a frame with "
      "another setting, light or placement replaces that cache. Without, the frame takes longer by "
      "what the stage that makes the cache takes longer; what other stages then make again is not "
      "counted. Medians, with quartiles in parentheses. Lines: code that the cache costs. "
      "Difference: the largest of any pixel, relative to the maximum.",
      {"cache", "scene", "with, ms", "without, ms", "more frames per second", "lines", "in",
       "difference"},
      {},
      ""};
  for (const CacheGain& gain : gains) {
    table.rows.push_back(
        {gain.cache, gain.scene, with_quartiles(gain.with_ms, 1.0, 1, ""),
         with_quartiles(gain.without_ms, 1.0, 1, ""), with_quartiles(gain.gain, 100.0, 0, "%"),
         formatted("%d", gain.code.lines), gain.code.files, formatted("%.0g", gain.change)});
  }
  if (!gains.empty()) table.remark = verdict(gains);
  return table;
}

}  // namespace brume
