#pragma once

#include <ImfHeader.h>
#include <ImfInputPart.h>

#include <exception>
#include <filesystem>
#include <new>

#include "brume/error.h"
#include "core/io/text_scanner.h"

namespace brume {

// Shared by the readers of OpenEXR files.

// OpenEXR throws many kinds of exceptions on hostile files; all of them mean a bad file.
template <typename Work>
auto guarded_exr(const std::filesystem::path& file, Work&& work) {
  try {
    return work();
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw InputError(file, "", "the image does not fit into memory");
  } catch (const std::exception& error) {
    throw InputError(file, "", "not a readable OpenEXR file: " + quoted_text(error.what(), 200));
  }
}

// Throws InputError unless the file begins as one, and its attributes are no longer than it is.
// Call before OpenEXR opens it.
void check_exr_file(const std::filesystem::path& file);

// Whether a part is an image of one value per pixel and channel.
bool is_flat(const Imf::Header& header);

// Throws where a part lacks its last row, as one does that claims more rows than there are: before
// memory is taken for all of them.
void read_last_row(Imf::InputPart& part, const Imf::Header& header);

// Checks the sizes that an OpenEXR file declares against its length, since OpenEXR allocates memory
// for them first. All throw InputError.

// No attribute of any header is longer than the file. Call before OpenEXR opens it.
void check_exr_attributes(const std::filesystem::path& file);

// Size, channels and blocks of a flat image are within limits, and no more than a file of this
// length and compression can hold.
void check_exr_image(const std::filesystem::path& file, const Imf::Header& header);

// No channel is subsampled.
void check_exr_sampling(const std::filesystem::path& file, const Imf::Header& header);

}  // namespace brume
