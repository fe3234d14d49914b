// unit/copied_assets.h: a copy of the shipped data files, which a test may change.
#pragma once
#include "core/file.h"

namespace thaum {

/// A copy of the data folder, removed by the destructor.
struct CopiedAssets {
    CopiedAssets() {
        std::filesystem::copy(THAUM_SOURCE_DIR "/assets", path, std::filesystem::copy_options::recursive);
    }

    const TemporaryFolder folder{};
    const std::filesystem::path path = folder.path() / "assets";
};

}  // namespace thaum
