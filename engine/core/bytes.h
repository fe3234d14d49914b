// core/bytes.h: writes and reads little-endian bytes.
//
// The reader never reads past its end. After a failed read it returns zeros and `ok()` is false, so a parser
// checks once at the end of each record.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace thaum {

static_assert(std::endian::native == std::endian::little, "files are little-endian, written as they lie");

/// Bytes of a file, a message or a state.
using Bytes = std::vector<std::byte>;

/// Appends values to a vector of bytes, little-endian and without padding.
class ByteWriter {
public:
    explicit ByteWriter(Bytes& out) : out_(out) {}

    /// Writes the bytes of one number, truth value or enumerator.
    template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void put(T value) {
        put_bytes(std::as_bytes(std::span(&value, 1)));
    }

    /// Appends bytes. It is not inlined: when GCC 12 inlines the whole vector insertion, it warns of an
    /// overflow that cannot happen.
    [[gnu::noinline]] void put_bytes(std::span<const std::byte> bytes) {
        out_.insert(out_.end(), bytes.begin(), bytes.end());
    }

    /// Writes the length of a text as 32 bits, then its characters.
    void put_string(std::string_view s) {
        put(static_cast<std::uint32_t>(s.size()));
        put_bytes(std::as_bytes(std::span(s.data(), s.size())));
    }

    /// Writes an unsigned integer as LEB128, 7 bits per byte.
    void put_varint(std::uint64_t value) {
        for (; value >= 0x80U; value >>= 7U) put(static_cast<std::uint8_t>(value | 0x80U));
        put(static_cast<std::uint8_t>(value));
    }

private:
    Bytes& out_;
};

/// Reads what a ByteWriter wrote. The bytes may come from an untrusted source: a read beyond the end, or of
/// an impossible value, makes `ok()` false and all later reads return zeros.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    /// Whether every read so far succeeded and the parser has found no impossible value.
    bool ok() const { return ok_; }
    /// Number of bytes that have not been read yet.
    std::size_t left() const { return bytes_.size() - at_; }
    /// Marks the input as faulty, so that `ok()` is false. A parser calls it if a value that it has read is
    /// impossible.
    void reject() { ok_ = false; }
    /// Number of bytes that were read.
    std::size_t position() const { return at_; }

    /// Reads one number, truth value or enumerator. The caller must check that an enumerator is one of its
    /// type.
    template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) T get() {
        if constexpr (std::is_same_v<T, bool>) {
            const auto byte = get<std::uint8_t>();
            ok_ = ok_ && byte <= 1;  // a bool made from any other byte would be undefined behaviour
            return ok_ && byte == 1;
        } else {
            T value{};
            const auto from = get_bytes(sizeof(T));
            if (ok_) std::memcpy(&value, from.data(), sizeof(T));
            return value;
        }
    }

    /// Returns a view into the input. On failure the view is empty and `ok()` is false.
    std::span<const std::byte> get_bytes(std::size_t n) {
        if (!ok_ || n > left()) {
            ok_ = false;
            return {};
        }
        const auto result = bytes_.subspan(at_, n);
        at_ += n;
        return result;
    }

    /// Reads a text: its length as 32 bits, then as many characters.
    std::string get_string() {
        const auto chars = get_bytes(get<std::uint32_t>());
        return {reinterpret_cast<const char*>(chars.data()), chars.size()};
    }

    /// Reads an unsigned integer in LEB128. Fails if it has more than 64 bits.
    std::uint64_t get_varint() {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64; shift += 7) {
            const auto byte = get<std::uint8_t>();
            if (shift == 63 && byte > 1) break;  // the value has more than 64 bits
            value |= static_cast<std::uint64_t>(byte & 0x7fU) << shift;
            if ((byte & 0x80U) == 0) return value;
        }
        ok_ = false;
        return 0;
    }

private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
    bool ok_ = true;
};

}  // namespace thaum
