// core/gzip.h: packs and unpacks gzip data (RFC 1952) in memory.
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "core/bytes.h"
#include "core/error.h"

namespace thaum {

/// Unpacks gzip data, which may have several members. The error says what is wrong: not gzip,
/// cut off, damaged, or larger than `limit` bytes unpacked. Memory stays below about twice
/// the limit, whatever the data claim.
Expected<std::string> unpack_gzip(std::span<const std::byte> packed, std::size_t limit);

/// The first bytes of unpacked gzip data.
struct UnpackedStart {
    std::string bytes;
    bool goes_on{};  ///< true: not all was unpacked, or other data follow the gzip data
};

/// Unpacks at most the first `most` bytes. Whatever follows them is not checked.
Expected<UnpackedStart> unpack_gzip_start(std::span<const std::byte> packed, std::size_t most);

/// Packs bytes as one member without name or time, so that equal bytes give equal data.
Bytes pack_gzip(std::span<const std::byte> bytes);

}  // namespace thaum
