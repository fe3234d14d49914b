#include "gesture/stroke_files.h"

#include "core/file.h"
#include "core/gzip.h"
#include "core/text.h"

namespace thaum::gesture {
namespace {

Error in_file(const std::filesystem::path& path, const Error& error) {
    return fail(text(path.string(), ": ", error.message));
}

}  // namespace

Expected<std::string> load_text(const std::filesystem::path& path) {
    const auto bytes = read_file(path, max_stroke_bytes);
    if (!bytes) return bytes.error();
    if (bytes->size() < 2 || (*bytes)[0] != std::byte{0x1f} || (*bytes)[1] != std::byte{0x8b})
        return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    auto unpacked = unpack_gzip(*bytes, max_stroke_bytes);
    if (!unpacked) return in_file(path, unpacked.error());
    return unpacked;
}

Expected<StrokeSet> load_strokes(const std::filesystem::path& path) {
    const auto csv = load_text(path);
    if (!csv) return csv.error();
    return read_strokes(*csv, path.string());
}

Expected<SessionSet> load_sessions(const std::filesystem::path& path) {
    const auto csv = load_text(path);
    if (!csv) return csv.error();
    return read_sessions(*csv, path.string());
}

Expected<std::vector<SessionLabel>> load_labels(const std::filesystem::path& path) {
    const auto csv = load_text(path);
    if (!csv) return csv.error();
    return read_labels(*csv, path.string());
}

}  // namespace thaum::gesture
