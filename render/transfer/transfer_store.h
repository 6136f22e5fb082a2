#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "render/transfer/radiance_transfer.h"

namespace brume {

// A mesh with the transfer that is wanted of it.
struct TransferRequest {
  std::shared_ptr<const TriangleMesh> mesh;
  TransferSettings settings;

  // By the mesh's identity: meshes of scenes are never changed.
  bool operator==(const TransferRequest&) const = default;
};

// What a surface asks for; Surface::Transfer::none does not.
TransferRequest transfer_request(const Surface& surface);

// Radiance transfer in memory. Thread-safe: one thread may make what another looks for.
class TransferStore {
 public:
  // Null if it is not there.
  [[nodiscard]] std::shared_ptr<const RadianceTransfer> find(const TransferRequest& request) const;
  [[nodiscard]] bool has(std::span<const TransferRequest> requests) const;

  // Makes what is missing and forgets what is not asked for. `folder` and `warnings` as of
  // cached_radiance_transfer(). False if stopped: what was made until then is there.
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
