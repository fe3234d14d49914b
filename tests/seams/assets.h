// A copy of the game's assets to which tests add files, or lines in files.
#pragma once
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/file.h"
#include "core/text.h"
namespace thaum::game::test {

/// A folder of links to all assets. Removed at the end.
class SeamAssets {
public:
    SeamAssets() {
        for (const auto& entry : std::filesystem::directory_iterator(source()))
            std::filesystem::create_symlink(entry.path(), path() / entry.path().filename());
    }
    const std::filesystem::path& path() const { return folder_.path(); }

    /// Puts a file into a folder of the assets, such as "potions".
    void add(const std::string& in, const std::string& file, std::string_view words) {
        const auto folder = path() / in;
        if (std::filesystem::is_symlink(folder)) {
            std::filesystem::remove(folder);
            std::filesystem::create_directory(folder);
            for (const auto& entry : std::filesystem::directory_iterator(source() / in))
                std::filesystem::create_symlink(entry.path(), folder / entry.path().filename());
        }
        std::filesystem::remove(folder / file);  // else the file of the game would be written
        if (!write_text_file(folder / file, words)) std::abort();
    }
    /// Appends words to a file in a folder of the assets, or in "." for their own folder.
    void append(const std::string& in, const std::string& file, std::string_view words) {
        add(in, file, text(read_text_file(source() / in / file, 1U << 20U).value(), words));
    }

private:
    static std::filesystem::path source() { return std::filesystem::path(THAUM_SOURCE_DIR) / "assets"; }

    TemporaryFolder folder_;
};

}  // namespace thaum::game::test
