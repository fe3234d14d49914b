// The game's assets with two files more: the data of the mend spell, and its gesture.
#pragma once
#include "core/file.h"

namespace thaum::game::test {

/// A folder of links to all assets, and to mend.toml and w.toml among the spells and
/// the gestures. Removed at the end.
class FifthSpellAssets {
public:
    FifthSpellAssets() {
        namespace fs = std::filesystem;
        const fs::path source = fs::path(THAUM_SOURCE_DIR) / "assets";
        for (const auto& entry : fs::directory_iterator(source)) {
            const auto name = entry.path().filename();
            if (name != "spells" && name != "gestures") fs::create_symlink(entry.path(), path() / name);
        }
        add(source, "spells", "mend.toml");
        add(source, "gestures", "w.toml");
    }
    const std::filesystem::path& path() const { return folder_.path(); }

private:
    void add(const std::filesystem::path& source, const char* name, const char* file) {
        namespace fs = std::filesystem;
        fs::create_directory(path() / name);
        for (const auto& entry : fs::directory_iterator(source / name))
            fs::create_symlink(entry.path(), path() / name / entry.path().filename());
        fs::create_symlink(fs::path(THAUM_SOURCE_DIR) / "tests/fifth_spell" / file, path() / name / file);
    }

    const TemporaryFolder folder_;
};

}  // namespace thaum::game::test
