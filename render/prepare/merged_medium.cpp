#include "render/prepare/merged_medium.h"

#include <algorithm>
#include <limits>
#include <span>

namespace brume {
namespace {

// With more of them left the time that frames save does not make up for the merging.
constexpr double max_share = 0.8;

// All are merged anew when this share has changed.
constexpr std::size_t max_changed = 8;  // 1 / 8

constexpr std::uint32_t not_merged = std::numeric_limits<std::uint32_t>::max();

// Compares two media by their columns, which are the same memory where nothing was changed.
class Comparison {
 public:
  Comparison(const Medium& before, const Medium& after) : before_(before), after_(after) {
    each_common_range(
        [this](std::size_t i, std::size_t j, std::size_t count) { compare(i, j, count); });
  }
  // Indices of Gaussians that are not the same, or not there, in the other; sorted.
  [[nodiscard]] const std::vector<std::uint32_t>& gone() const { return gone_; }
  [[nodiscard]] const std::vector<std::uint32_t>& more() const { return more_; }

 private:
  // Calls visit(before, after, count) for ranges of the same ids; notes all others.
  template <class Visit>
  void each_common_range(Visit visit) {
    const std::span<const GaussianId> a = before_.ids();
    const std::span<const GaussianId> b = after_.ids();
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() || j < b.size()) {
      const std::size_t most = std::min(a.size() - i, b.size() - j);
      const auto end = a.data() == b.data() && i == j
                           ? a.begin() + static_cast<std::ptrdiff_t>(i + most)
                           : std::mismatch(a.begin() + static_cast<std::ptrdiff_t>(i),
                                           a.begin() + static_cast<std::ptrdiff_t>(i + most),
                                           b.begin() + static_cast<std::ptrdiff_t>(j))
                                 .first;
      const std::size_t count = static_cast<std::size_t>(end - a.begin()) - i;
      visit(i, j, count);
      i += count;
      j += count;
      while (i < a.size() && (j == b.size() || a[i] < b[j])) gone_.push_back(index(i++));
      while (j < b.size() && (i == a.size() || b[j] < a[i])) more_.push_back(index(j++));
    }
  }

  // Ranges of Gaussians with the same ids.
  void compare(std::size_t i, std::size_t j, std::size_t count) {
    constexpr std::size_t block = 1024;
    for (std::size_t first = 0; first < count; first += block) {
      const std::size_t size = std::min(block, count - first);
      if (are_same(i + first, j + first, size)) continue;
      for (std::size_t k = first; k < first + size; ++k) {
        if (are_same(i + k, j + k, 1)) continue;
        gone_.push_back(index(i + k));
        more_.push_back(index(j + k));
      }
    }
  }

  [[nodiscard]] bool are_same(std::size_t i, std::size_t j, std::size_t count) const {
    const auto same = [&](const auto& a, const auto& b) {
      const auto own = a.subspan(i, count);
      const auto other = b.subspan(j, count);
      return own.data() == other.data() || std::ranges::equal(own, other);
    };
    if (!same(before_.centers(), after_.centers()) || !same(before_.radii(), after_.radii()) ||
        !same(before_.densities(), after_.densities())) {
      return false;
    }
    if (!has_optics_) return true;
    for (std::size_t k = 0; k < count; ++k) {
      if (!(before_.optics(i + k) == after_.optics(j + k))) return false;
    }
    return true;
  }

  static std::uint32_t index(std::size_t i) { return static_cast<std::uint32_t>(i); }

  const Medium& before_;
  const Medium& after_;
  bool has_optics_ = before_.has_albedos() || before_.has_emission() || after_.has_albedos() ||
                     after_.has_emission();
  std::vector<std::uint32_t> gone_, more_;
};

// Groups are the editor's, and nothing to frames.
Gaussian without_group(Gaussian gaussian) {
  gaussian.group = 0;
  return gaussian;
}

}  // namespace

bool MergedMedium::update(const Medium& medium, double max_error, const std::stop_token& stop) {
  if (made_from_ == medium.revision() && max_error_ == max_error) return true;
  made_from_.reset();
  if (!(max_error > 0.0) || !may_merge(medium)) {
    *this = {};
    medium_ = medium;
  } else if (max_error_ != max_error || source_.empty()) {
    if (!merge(medium, max_error, stop)) return false;
  } else {
    const Comparison change(source_, medium);
    const std::size_t changed = std::max(change.gone().size(), change.more().size());
    if (changed * max_changed > medium.size()) {
      if (!merge(medium, max_error, stop)) return false;
    } else if (is_merged_) {
      assemble(medium, change.gone(), change.more());
    } else {
      medium_ = medium;
    }
  }
  made_from_ = medium.revision();
  max_error_ = max_error;
  return true;
}

bool MergedMedium::merge(const Medium& medium, double max_error, const std::stop_token& stop) {
  std::vector<Gaussian> gaussians;
  gaussians.reserve(medium.size());
  for (std::size_t i = 0; i < medium.size(); ++i) {
    gaussians.push_back(without_group(medium.gaussian(i)));
  }
  const bool pays = estimated_share(gaussians, max_error) <= max_share;
  std::optional<Simplified> simplified;
  if (pays) {
    simplified = simplify(gaussians, max_error, stop);
    if (!simplified) return false;
  }
  source_ = medium;
  is_merged_ = pays;
  if (!pays) {
    medium_ = medium;
    return true;
  }
  simplified_ = std::move(*simplified);
  merged_into_.assign(medium.size(), not_merged);
  for (std::size_t k = 0; k < simplified_.merged.size(); ++k) {
    for (const std::uint32_t i : simplified_.members_of(k)) {
      merged_into_[i] = static_cast<std::uint32_t>(k);
    }
  }
  assemble(medium, {}, {});
  return true;
}

void MergedMedium::assemble(const Medium& now, const std::vector<std::uint32_t>& gone,
                            const std::vector<std::uint32_t>& more) {
  std::vector<bool> is_apart(simplified_.merged.size());
  for (const std::uint32_t i : gone) {
    if (merged_into_[i] != not_merged) is_apart[merged_into_[i]] = true;
  }
  const auto is_gone = [&](std::uint32_t i) { return std::ranges::binary_search(gone, i); };
  medium_ = {};
  medium_.set_homogeneous_density(now.homogeneous_density());
  medium_.reserve(simplified_.kept.size() + simplified_.merged.size() + more.size());
  const auto keep = [&](std::uint32_t i) {
    if (!is_gone(i)) medium_.append(without_group(source_.gaussian(i)));
  };
  for (const std::uint32_t i : simplified_.kept) keep(i);
  for (std::size_t k = 0; k < simplified_.merged.size(); ++k) {
    if (is_apart[k]) {
      for (const std::uint32_t i : simplified_.members_of(k)) keep(i);
    } else {
      medium_.append(simplified_.merged[k]);
    }
  }
  for (const std::uint32_t j : more) medium_.append(without_group(now.gaussian(j)));
}

}  // namespace brume
