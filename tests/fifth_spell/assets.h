// The game's assets with two files more: the data of the mend spell, and its gesture.
#pragma once
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace thaum::game::test {

/// A folder of links to all assets, and to mend.toml and w.toml among the spells and the gestures. Removed at the end.
class FifthSpellAssets {
public:
    FifthSpellAssets() {
        namespace fs = std::filesystem;
        const fs::path source = fs::path(THAUM_SOURCE_DIR) / "assets";
        auto pattern = (fs::temp_directory_path() / "fifth_spell_XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) std::abort();
        folder_ = pattern;
        for (const auto& entry : fs::directory_iterator(source)) {
            const auto name = entry.path().filename();
            if (name != "spells" && name != "gestures") fs::create_symlink(entry.path(), folder_ / name);
        }
        add(source, "spells", "mend.toml");
        add(source, "gestures", "w.toml");
    }
    ~FifthSpellAssets() { std::filesystem::remove_all(folder_); }
    FifthSpellAssets(const FifthSpellAssets&) = delete;
    FifthSpellAssets& operator=(const FifthSpellAssets&) = delete;

    const std::filesystem::path& path() const { return folder_; }

private:
    void add(const std::filesystem::path& source, const char* name, const char* file) {
        namespace fs = std::filesystem;
        fs::create_directory(folder_ / name);
        for (const auto& entry : fs::directory_iterator(source / name))
            fs::create_symlink(entry.path(), folder_ / name / entry.path().filename());
        fs::create_symlink(fs::path(THAUM_SOURCE_DIR) / "tests/fifth_spell" / file, folder_ / name / file);
    }

    std::filesystem::path folder_;
};

}  // namespace thaum::game::test
