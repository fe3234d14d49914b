#include "game/app/stroke_files.h"

#include <zlib.h>

#include <algorithm>

#include "core/file.h"
#include "core/text.h"

namespace thaum::app {
namespace {

constexpr int any_gzip = 15 + 16;  // largest window, gzip header
constexpr std::size_t piece = std::size_t{1} << 18U;

/// Ends the inflater when it leaves the scope.
class Inflater {
public:
    Inflater() { started_ = inflateInit2(&stream, any_gzip) == Z_OK; }
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

tl::unexpected<Error> in_file(const std::filesystem::path& path, const Error& error) {
    return fail(text(path.string(), ": ", error.message));
}

}  // namespace

Expected<std::string> unpack_gzip(std::span<const std::byte> packed, std::size_t limit) {
    Inflater inflater;
    if (!inflater.started()) return fail("no memory to unpack the file");
    auto& stream = inflater.stream;
    Bytes input(packed.begin(), packed.end());  // zlib takes no constant input
    stream.next_in = reinterpret_cast<Bytef*>(input.data());
    stream.avail_in = static_cast<uInt>(input.size());
    std::string out;
    for (;;) {
        const std::size_t before = out.size(), room = std::min(piece, limit + 1 - before);
        out.resize(before + room);
        stream.next_out = reinterpret_cast<Bytef*>(out.data() + before);
        stream.avail_out = static_cast<uInt>(room);
        const int code = inflate(&stream, Z_NO_FLUSH);
        out.resize(before + room - stream.avail_out);
        if (out.size() > limit) return fail(text("more than ", limit, " bytes unpacked; split the file"));
        if (code == Z_STREAM_END) {
            if (stream.avail_in == 0) return out;
            if (inflateReset(&stream) != Z_OK) return fail("the gzip data are damaged");
        } else if (code == Z_BUF_ERROR || (code == Z_OK && stream.avail_in == 0 && stream.avail_out > 0)) {
            return fail("the gzip data are cut off; copy the file again");
        } else if (code != Z_OK) {
            return fail("the gzip data are damaged; copy the file again");
        }
    }
}

Expected<std::string> load_text(const std::filesystem::path& path) {
    const auto bytes = read_file(path, most_stroke_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    if (bytes->size() < 2 || (*bytes)[0] != std::byte{0x1f} || (*bytes)[1] != std::byte{0x8b})
        return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    auto unpacked = unpack_gzip(*bytes, most_stroke_bytes);
    if (!unpacked) return in_file(path, unpacked.error());
    return unpacked;
}

Expected<gesture::StrokeSet> load_strokes(const std::filesystem::path& path) {
    const auto csv = load_text(path);
    if (!csv) return tl::unexpected(csv.error());
    return gesture::read_strokes(*csv, path.string());
}

Expected<gesture::SessionSet> load_sessions(const std::filesystem::path& path) {
    const auto csv = load_text(path);
    if (!csv) return tl::unexpected(csv.error());
    return gesture::read_sessions(*csv, path.string());
}

Expected<std::vector<gesture::SessionLabel>> load_labels(const std::filesystem::path& path) {
    const auto csv = load_text(path);
    if (!csv) return tl::unexpected(csv.error());
    return gesture::read_labels(*csv, path.string());
}

}  // namespace thaum::app
