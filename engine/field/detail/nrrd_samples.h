// field/detail/nrrd_samples.h: the bytes of the samples that an NRRD header describes.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "core/bytes.h"
#include "core/error.h"
#include "field/detail/nrrd_header.h"

namespace thaum::field {

/// All samples that a header describes, and the buffers that hold their bytes.
struct NrrdSamples {
    Bytes file{}, joined{};
    std::string from_gzip{};
    std::span<const std::byte> all{};  ///< the samples, a part of one of the buffers above
};

/// Reads the samples behind the header in `out.file`, or those of the files that it names: bytes of the
/// header's type, or doubles if they stand in text. Sets files and notes of the volume. The error names the
/// header's line, and says so if the bytes are of another encoding.
Expected<void> read_nrrd_samples(const NrrdHeader& header, const std::filesystem::path& path,
                                 std::size_t max_bytes, NrrdSamples& out, Volume& volume);

}  // namespace thaum::field
