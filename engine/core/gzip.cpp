#include "core/gzip.h"

#define ZLIB_CONST  // makes zlib take its input as constant
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/assert.h"
#include "core/text.h"

namespace thaum {
namespace {

constexpr int gzip_window = 15 + 16;  // largest window (15 bits), with a gzip header (16)
constexpr std::size_t piece = std::size_t{1} << 18U;

}  // namespace

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

struct GzipReader::State {
    Source source;
    Rest rest;
    Inflater inflater{};  ///< zlib's state; it reads from `packed`, the bytes to unpack next
    Bytes packed = Bytes(piece);
    bool is_used_up = false;  ///< true: the source has no more bytes
    bool has_ended = false, is_followed = false;

    /// Makes at least `least` packed bytes available, unless the source ends before.
    Expected<void> refill(std::size_t least) {
        z_stream& stream = inflater.stream;
        while (stream.avail_in < least && !is_used_up) {
            if (stream.avail_in > 0) std::memmove(packed.data(), stream.next_in, stream.avail_in);
            const auto count = source(std::span(packed).subspan(stream.avail_in));
            if (!count) return count.error();
            is_used_up = *count == 0;
            stream.next_in = reinterpret_cast<const Bytef*>(packed.data());
            stream.avail_in += static_cast<uInt>(*count);
        }
        return {};
    }

    /// Called after the last byte of a gzip member, one of the compressed streams of which the data consist.
    /// Prepares zlib for the next member, or notes that there is none.
    Expected<void> end_member() {
        const z_stream& stream = inflater.stream;
        if (auto filled = refill(2); !filled) return filled;
        has_ended = stream.avail_in == 0;
        if (has_ended) return {};
        constexpr Bytef first = 0x1f, second = 0x8b;
        const bool goes_on =
            stream.avail_in >= 2 && stream.next_in[0] == first && stream.next_in[1] == second;
        if (rest == Rest::ignored && !goes_on) {
            has_ended = is_followed = true;
            return {};
        }
        if (inflateReset(&inflater.stream) != Z_OK) return fail("the gzip data are damaged");
        return {};
    }
};

GzipReader::GzipReader(Source source, Rest rest)
    : state_(new State{.source = std::move(source), .rest = rest}) {}
GzipReader::GzipReader(GzipReader&&) noexcept = default;
GzipReader::~GzipReader() = default;
bool GzipReader::is_followed() const { return state_->is_followed; }

Expected<std::size_t> GzipReader::read(std::span<std::byte> out) {
    if (!state_->inflater.started()) return fail("no memory to unpack the file");
    z_stream& stream = state_->inflater.stream;
    std::size_t done = 0;
    while (done < out.size() && !state_->has_ended) {
        if (auto filled = state_->refill(1); !filled) return filled.error();
        const std::size_t room = std::min(piece, out.size() - done);
        stream.next_out = reinterpret_cast<Bytef*>(out.data() + done);
        stream.avail_out = static_cast<uInt>(room);
        const int code = inflate(&stream, Z_NO_FLUSH);
        done += room - stream.avail_out;
        if (code == Z_STREAM_END) {
            if (auto ended = state_->end_member(); !ended) return ended.error();
        } else if (code == Z_BUF_ERROR) {  // there is no more input
            return fail("the gzip data are cut off; copy the file again");
        } else if (code != Z_OK) {
            return fail("the gzip data are damaged; copy the file again");
        }
    }
    return done;
}

Expected<std::string> unpack_gzip(std::span<const std::byte> packed, std::size_t limit) {
    GzipReader reader(
        [&](std::span<std::byte> out) -> Expected<std::size_t> {
            const auto next = packed.first(std::min(packed.size(), out.size()));
            std::ranges::copy(next, out.begin());
            packed = packed.subspan(next.size());
            return next.size();
        },
        GzipReader::Rest::damage);
    std::string out;
    for (bool more = true; more;) {
        const std::size_t before = out.size(), room = std::min(piece, limit + 1 - before);
        out.resize(before + room);
        const auto count = reader.read(std::as_writable_bytes(std::span(out)).subspan(before));
        if (!count) return count.error();
        more = *count == room;
        out.resize(before + *count);
        if (out.size() > limit) return fail(text("the gzip data hold more than ", limit, " bytes"));
    }
    return out;
}

Bytes pack_gzip(std::span<const std::byte> bytes) {
    z_stream stream{};
    const bool started =
        deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window, 8, Z_DEFAULT_STRATEGY) == Z_OK;
    THAUM_ASSERT(started, "no memory to pack a file");
    Bytes out;
    int code = Z_OK;
    while (code == Z_OK) {
        if (stream.avail_in == 0) {  // passed on in parts, because zlib counts bytes in 32 bits
            const auto next = bytes.first(std::min(bytes.size(), std::size_t{1} << 30U));
            stream.next_in = reinterpret_cast<const Bytef*>(next.data());
            stream.avail_in = static_cast<uInt>(next.size());
            bytes = bytes.subspan(next.size());
        }
        const std::size_t before = out.size();
        out.resize(before + piece);
        stream.next_out = reinterpret_cast<Bytef*>(out.data() + before);
        stream.avail_out = static_cast<uInt>(piece);
        code = deflate(&stream, bytes.empty() && stream.avail_in == 0 ? Z_FINISH : Z_NO_FLUSH);
        out.resize(before + piece - stream.avail_out);
    }
    deflateEnd(&stream);
    THAUM_ASSERT(code == Z_STREAM_END, "zlib has stopped before the end");
    return out;
}

}  // namespace thaum
