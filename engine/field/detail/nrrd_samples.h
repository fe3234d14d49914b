// field/detail/nrrd_samples.h: the bytes of the samples that an NRRD header describes.
#pragma once
#include <filesystem>

#include "core/error.h"
#include "core/file_reader.h"
#include "field/detail/nrrd_header.h"
#include "field/detail/sample_decoder.h"

namespace thaum::field {

/// Gives the decoder all samples: those behind the header in `file`, or those in the files that the header
/// names. They are bytes of the header's type, or doubles if they stand in text. Each named file may have
/// `max_bytes`, or more if the header says where its samples end. Sets the files and notes of the volume. The
/// error names the header's line, and says so if the bytes are of another encoding.
Expected<void> read_nrrd_samples(const NrrdHeader& header, const std::filesystem::path& path,
                                 FileReader& file, std::size_t max_bytes, SampleDecoder& decoder,
                                 Volume& volume);

/// Gives the decoder the next `count` bytes of a file. Returns how many there were.
Expected<std::size_t> decode_bytes(FileReader& file, std::size_t count, SampleDecoder& decoder);

}  // namespace thaum::field
