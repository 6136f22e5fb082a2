#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "brume/scene.h"
#include "render/transfer/radiance_transfer.h"

namespace brume {

// A mesh and the requested transfer settings.
struct TransferRequest {
  std::shared_ptr<const TriangleMesh> mesh;
  TransferSettings settings;

  // Compares mesh identity: meshes are immutable.
  bool operator==(const TransferRequest&) const = default;
};

// The request of a surface; not for Surface::Transfer::none.
TransferRequest transfer_request(const Surface& surface);

// Radiance transfer in memory. Thread-safe.
class TransferStore {
 public:
  // Null if missing.
  [[nodiscard]] std::shared_ptr<const RadianceTransfer> find(const TransferRequest& request) const;
  [[nodiscard]] bool has(std::span<const TransferRequest> requests) const;

  // Computes missing transfer and drops what is not requested. `folder` and `warnings`: see
  // cached_radiance_transfer(). False if stopped; completed results stay.
  bool make(std::span<const TransferRequest> requests, const std::filesystem::path& folder,
            const Job& job = {}, std::vector<std::string>* warnings = nullptr);

 private:
  struct Entry {
    TransferRequest request;
    std::shared_ptr<const RadianceTransfer> transfer;
  };
  mutable std::mutex mutex_;
  std::vector<Entry> entries_;
};

}  // namespace brume
