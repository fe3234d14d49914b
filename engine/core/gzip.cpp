#include "core/gzip.h"

#define ZLIB_CONST  // makes zlib take its input as constant
#include <zlib.h>

#include <algorithm>
#include <utility>

#include "core/assert.h"
#include "core/text.h"

namespace thaum {
namespace {

constexpr int gzip_window = 15 + 16;  // largest window (15 bits), with a gzip header (16)
constexpr std::size_t piece = std::size_t{1} << 18U;

/// Passes input to zlib in parts, because zlib counts bytes in 32 bits.
class Feed {
public:
    explicit Feed(std::span<const std::byte> bytes) : left_(bytes) {}

    void refill(z_stream& stream) {
        if (stream.avail_in > 0) return;
        const auto next = left_.first(std::min(left_.size(), std::size_t{1} << 30U));
        stream.next_in = reinterpret_cast<const Bytef*>(next.data());
        stream.avail_in = static_cast<uInt>(next.size());
        left_ = left_.subspan(next.size());
    }
    /// Whether another gzip member begins at the next byte.
    bool begins_member(const z_stream& stream) const {
        constexpr Bytef first = 0x1f, second = 0x8b;
        if (stream.avail_in >= 2) return stream.next_in[0] == first && stream.next_in[1] == second;
        return left_.size() >= 2 && left_[0] == std::byte{first} && left_[1] == std::byte{second};
    }
    bool is_used_up(const z_stream& stream) const { return left_.empty() && stream.avail_in == 0; }

private:
    std::span<const std::byte> left_;
};

/// Ends zlib's inflater (inflateEnd) in its destructor.
class Inflater {
public:
    Inflater() { started_ = inflateInit2(&stream, gzip_window) == Z_OK; }
    ~Inflater() {
        if (started_) inflateEnd(&stream);
    }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
    bool started() const { return started_; }

    z_stream stream{};

private:
    bool started_ = false;
};

}  // namespace

namespace {

enum class Beyond : std::uint8_t { refused, left };

/// Unpacks at most `limit` bytes. If there are more, or if other data follow the last member, `beyond`
/// decides whether that is an error or is ignored.
Expected<UnpackedStart> unpack(std::span<const std::byte> packed, std::size_t limit, Beyond beyond) {
    Inflater inflater;
    if (!inflater.started()) return fail("no memory to unpack the file");
    auto& stream = inflater.stream;
    Feed feed(packed);
    std::string out;
    for (;;) {
        const std::size_t before = out.size(), room = std::min(piece, limit + 1 - before);
        out.resize(before + room);
        stream.next_out = reinterpret_cast<Bytef*>(out.data() + before);
        stream.avail_out = static_cast<uInt>(room);
        feed.refill(stream);
        const int code = inflate(&stream, Z_NO_FLUSH);
        out.resize(before + room - stream.avail_out);
        if (out.size() > limit) {
            if (beyond == Beyond::refused)
                return fail(text("the gzip data hold more than ", limit, " bytes"));
            out.resize(limit);
            return UnpackedStart{std::move(out), true};
        }
        if (code == Z_STREAM_END) {
            if (feed.is_used_up(stream)) return UnpackedStart{std::move(out), false};
            if (beyond == Beyond::left && !feed.begins_member(stream))
                return UnpackedStart{std::move(out), true};
            if (inflateReset(&stream) != Z_OK) return fail("the gzip data are damaged");
        } else if (code == Z_BUF_ERROR || (code == Z_OK && feed.is_used_up(stream) && stream.avail_out > 0)) {
            return fail("the gzip data are cut off; copy the file again");
        } else if (code != Z_OK) {
            return fail("the gzip data are damaged; copy the file again");
        }
    }
}

}  // namespace

Expected<std::string> unpack_gzip(std::span<const std::byte> packed, std::size_t limit) {
    auto whole = unpack(packed, limit, Beyond::refused);
    if (!whole) return whole.error();
    return std::move(whole->bytes);
}

Expected<UnpackedStart> unpack_gzip_start(std::span<const std::byte> packed, std::size_t most) {
    return unpack(packed, most, Beyond::left);
}

Bytes pack_gzip(std::span<const std::byte> bytes) {
    z_stream stream{};
    const bool started =
        deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window, 8, Z_DEFAULT_STRATEGY) == Z_OK;
    THAUM_ASSERT(started, "no memory to pack a file");
    Feed feed(bytes);
    Bytes out;
    int code = Z_OK;
    while (code == Z_OK) {
        const std::size_t before = out.size();
        out.resize(before + piece);
        stream.next_out = reinterpret_cast<Bytef*>(out.data() + before);
        stream.avail_out = static_cast<uInt>(piece);
        feed.refill(stream);
        code = deflate(&stream, feed.is_used_up(stream) ? Z_FINISH : Z_NO_FLUSH);
        out.resize(before + piece - stream.avail_out);
    }
    deflateEnd(&stream);
    THAUM_ASSERT(code == Z_STREAM_END, "zlib has stopped before the end");
    return out;
}

}  // namespace thaum
