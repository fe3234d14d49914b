// The game's assets with one file more: the data of the hail wand.
#pragma once
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace thaum::game::test {

/// A folder of links to all assets, and to hail.toml among the wands. Removed at the end.
class SixthWandAssets {
public:
    SixthWandAssets() {
        namespace fs = std::filesystem;
        const fs::path source = fs::path(THAUM_SOURCE_DIR) / "assets";
        auto pattern = (fs::temp_directory_path() / "sixth_wand_XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) std::abort();
        folder_ = pattern;
        fs::create_directory(folder_ / "wands");
        for (const auto& entry : fs::directory_iterator(source)) {
            if (entry.path().filename() != "wands")
                fs::create_symlink(entry.path(), folder_ / entry.path().filename());
        }
        for (const auto& entry : fs::directory_iterator(source / "wands"))
            fs::create_symlink(entry.path(), folder_ / "wands" / entry.path().filename());
        fs::create_symlink(fs::path(THAUM_SOURCE_DIR) / "tests/sixth_wand/hail.toml",
                           folder_ / "wands" / "hail.toml");
    }
    ~SixthWandAssets() { std::filesystem::remove_all(folder_); }
    SixthWandAssets(const SixthWandAssets&) = delete;
    SixthWandAssets& operator=(const SixthWandAssets&) = delete;

    const std::filesystem::path& path() const { return folder_; }

private:
    std::filesystem::path folder_;
};

}  // namespace thaum::game::test
