// unit/volume_files.h: a folder for tests of volume files, and samples for them.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>

#include "core/file.h"
#include "core/gzip.h"
#include "core/text.h"
#include "field/nrrd.h"

namespace thaum::field {

namespace fs = std::filesystem;

/// Samples 0, 1, 2 and so on, as bytes of int16.
inline std::string shorts(int n, bool big = false) {
    std::string out;
    for (int i = 0; i < n; ++i) {
        const auto low = static_cast<char>(i & 255), high = static_cast<char>(i >> 8);
        out += big ? high : low;
        out += big ? low : high;
    }
    return out;
}

inline std::string gzipped(std::string_view words) {
    const Bytes bytes = pack_gzip(std::as_bytes(std::span(words)));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

class VolumeFiles : public ::testing::Test {
protected:
    fs::path in_folder(std::string_view name) const { return folder_.path() / name; }

    fs::path put(std::string_view name, std::string_view content) const {
        EXPECT_TRUE(write_text_file(in_folder(name), content));
        return in_folder(name);
    }

    /// Reads an NRRD file with these lines between its first line and the data.
    Expected<Volume> read(std::string_view lines, std::string_view data,
                          std::size_t limit = max_samples) const {
        return read_nrrd(put("v.nrrd", text("NRRD0004\n", lines, "\n\n", data)), {.limit = limit});
    }

    /// Reads 2 x 3 x 4 samples of int16 with the values 0 to 23, with additional header fields.
    Volume read_short(std::string_view more) const {
        return read(text("type: short\ndimension: 3\nsizes: 2 3 4\nendian: little\nencoding: raw\n", more),
                    shorts(24))
            .value();
    }

    /// Expects an error of one line that begins with the path and contains `what`.
    void expect_refused(const Expected<Volume>& volume, std::string_view what) const {
        ASSERT_FALSE(volume) << what;
        const std::string& message = volume.error().message;
        EXPECT_TRUE(message.starts_with(folder_.path().string())) << message;
        EXPECT_NE(message.find(what), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }

private:
    TemporaryFolder folder_;
};

}  // namespace thaum::field
