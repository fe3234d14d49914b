// core/gzip.h: packs and unpacks gzip data (RFC 1952).
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "core/bytes.h"
#include "core/error.h"

namespace thaum {

/// Unpacks gzip data piece by piece; they may have several members (compressed streams in a row). It needs
/// little memory, whatever size the data claim to have.
class GzipReader {
public:
    /// Puts the next packed bytes into `out` and returns their number; 0 at the end of the data.
    using Source = std::function<Expected<std::size_t>(std::span<std::byte> out)>;
    /// How other data after the last gzip member are treated: as damage, or ignored.
    enum class Rest : std::uint8_t { damage, ignored };

    GzipReader(Source source, Rest rest);
    GzipReader(GzipReader&&) noexcept;
    GzipReader& operator=(GzipReader&&) = delete;
    ~GzipReader();

    /// Unpacks the next bytes and returns their number. It is less than `out` has room for only at the end of
    /// the gzip data. The error is that of the source, or says what is wrong: not gzip, cut off or damaged.
    Expected<std::size_t> read(std::span<std::byte> out);
    /// Whether data follow that are no gzip data. Known once `read` has reached the end.
    bool is_followed() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Unpacks gzip data, which may have several members (compressed streams in a row). The error says what is
/// wrong: not gzip, cut off, damaged, or larger than `limit` bytes unpacked. Memory stays below about twice
/// the limit, whatever size the data claim to have.
Expected<std::string> unpack_gzip(std::span<const std::byte> packed, std::size_t limit);

/// Packs bytes as one compressed stream without file name or time, so that equal bytes give equal data.
Bytes pack_gzip(std::span<const std::byte> bytes);

}  // namespace thaum
