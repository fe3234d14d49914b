// The game's assets with one file more: the data of the hail wand.
#pragma once
#include "core/file.h"

namespace thaum::game::test {

/// A folder of links to all assets, and to hail.toml among the wands. Removed at the end.
class SixthWandAssets {
public:
    SixthWandAssets() {
        namespace fs = std::filesystem;
        const fs::path source = fs::path(THAUM_SOURCE_DIR) / "assets";
        fs::create_directory(path() / "wands");
        for (const auto& entry : fs::directory_iterator(source)) {
            if (entry.path().filename() != "wands")
                fs::create_symlink(entry.path(), path() / entry.path().filename());
        }
        for (const auto& entry : fs::directory_iterator(source / "wands"))
            fs::create_symlink(entry.path(), path() / "wands" / entry.path().filename());
        fs::create_symlink(fs::path(THAUM_SOURCE_DIR) / "tests/sixth_wand/hail.toml",
                           path() / "wands" / "hail.toml");
    }
    const std::filesystem::path& path() const { return folder_.path(); }

private:
    const TemporaryFolder folder_;
};

}  // namespace thaum::game::test
