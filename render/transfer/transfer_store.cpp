#include "render/transfer/transfer_store.h"

#include <algorithm>
#include <cassert>

#include "core/scene/mesh.h"
#include "render/transfer/transfer_cache.h"

namespace brume {
namespace {

// A bowl that sees itself half around and has an albedo of 0.8 loses 0.4^4 of its light.
constexpr int bounces = 3;

}  // namespace

TransferRequest transfer_request(const Surface& surface) {
  assert(surface.transfer != Surface::Transfer::none);
  TransferSettings settings;
  if (surface.transfer == Surface::Transfer::interreflection) settings.bounces = bounces;
  return {surface.mesh, settings};
}

std::shared_ptr<const RadianceTransfer> TransferStore::find(const TransferRequest& request) const {
  const std::scoped_lock lock(mutex_);
  const auto it = std::ranges::find(entries_, request, &Entry::request);
  return it == entries_.end() ? nullptr : it->transfer;
}

bool TransferStore::has(std::span<const TransferRequest> requests) const {
  return std::ranges::all_of(
      requests, [&](const TransferRequest& request) { return find(request) != nullptr; });
}

bool TransferStore::make(std::span<const TransferRequest> requests,
                         const std::filesystem::path& folder, const Job& job,
                         std::vector<std::string>* warnings) {
  std::vector<TransferRequest> missing;
  {
    const std::scoped_lock lock(mutex_);
    std::erase_if(entries_, [&](const Entry& entry) {
      return std::ranges::find(requests, entry.request) == requests.end();
    });
  }
  const auto cost = [](const TransferRequest& request) {
    return 1.0 + static_cast<double>(request.mesh->n_vertices());
  };
  double total_cost = 0.0;
  for (const TransferRequest& request : requests) {
    if (find(request)) continue;
    missing.push_back(request);
    total_cost += cost(request);
  }
  double done = 0.0;
  for (const TransferRequest& request : missing) {
    const double done_before = done;
    done += cost(request);
    auto transfer = cached_radiance_transfer(
        request.mesh, request.settings, folder,
        job.subrange(done_before / total_cost, done / total_cost), warnings);
    if (!transfer) return false;
    const std::scoped_lock lock(mutex_);
    entries_.push_back({request, std::make_shared<const RadianceTransfer>(std::move(*transfer))});
  }
  return true;
}

}  // namespace brume
