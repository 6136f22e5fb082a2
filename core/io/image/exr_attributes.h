#pragma once

#include <ImfHeader.h>

#include <map>
#include <optional>
#include <string>

#include "core/io/image/exr_view.h"

namespace brume {

// Adds what all pictures of ours have: chromaticities (Rec. 709, D65), texts and the view.
void add_attributes(const std::map<std::string, std::string>& texts,
                    const std::optional<ExrView>& view, Imf::Header& header);

}  // namespace brume
