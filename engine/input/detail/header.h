// input/detail/header.h: encoding of the log's header, independent of files. FORMAT.md is the reference.
#pragma once
#include <span>

#include "core/bytes.h"
#include "input/log.h"

namespace thaum::input::detail {

/// Format in which logs are written. Formats 1 to this one can be read.
inline constexpr std::uint32_t format_version = 2;

inline constexpr std::size_t preamble_size = 24;
inline constexpr std::size_t string_limit = 65536;
inline constexpr std::size_t player_limit = 16;
inline constexpr std::size_t list_limit = 1000;
inline constexpr std::size_t kind_table_limit = 16;

/// Largest body of a header (bytes).
constexpr std::size_t header_limit(std::uint32_t format) {
    return format == 1 ? std::size_t{1} << 20U : std::size_t{16} << 20U;
}

/// Encodes the whole header. The error names the value beyond the format's limits, without a path.
Expected<Bytes> encode_header(const LogHeader& header);

struct Preamble {
    std::uint32_t format{};
    std::size_t body_size{};
    std::uint64_t salt{};
};

/// Decodes the first preamble_size bytes of a file. Errors are without a path.
Expected<Preamble> decode_preamble(std::span<const std::byte> bytes);
/// Decodes the header. `file` starts with the preamble and holds the whole body.
Expected<LogHeader> decode_header(std::span<const std::byte> file, const Preamble& preamble);

// Bodies of headers, by format. Only encode_header and decode_header call these functions. decode_body does
// not check values; the checksum of the body has been checked already.
Bytes encode_body(const LogHeader& header);
Expected<LogHeader> decode_body_1(std::span<const std::byte> body);
Expected<LogHeader> decode_body_2(std::span<const std::byte> body);

}  // namespace thaum::input::detail
