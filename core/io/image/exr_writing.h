#pragma once

#include <ImfHeader.h>

#include <ImfIO.h>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <string>

#include "core/io/image/image_file.h"

namespace brume {

// Adds what all pictures of ours have: chromaticities (Rec. 709, D65), texts and the view.
void add_attributes(const std::map<std::string, std::string>& texts,
                    const std::optional<ExrView>& view, Imf::Header& header);

// OpenEXR writes its table of lines in the file's destructor, which cannot report errors: the
// stream does.
class ExrOutput final : public Imf::OStream {
 public:
  ExrOutput(const std::filesystem::path& file, std::ostream& out)
      : OStream(file.c_str()), out_(out) {}
  void write(const char* bytes, int count) override { out_.write(bytes, count); }
  // Asked in the destructor too, which no exception may leave.
  std::uint64_t tellp() override {
    return out_ ? static_cast<std::uint64_t>(out_.tellp()) : std::uint64_t{0};
  }
  void seekp(std::uint64_t place) override { out_.seekp(static_cast<std::streamoff>(place)); }

 private:
  std::ostream& out_;
};

}  // namespace brume
