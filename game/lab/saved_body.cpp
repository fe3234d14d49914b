#include "game/lab/saved_body.h"

#include <algorithm>

#include "core/text.h"
#include "field/nrrd.h"
#include "field/volume_file.h"
#include "field/voxel_volume.h"

namespace thaum::game {
namespace {

namespace fs = std::filesystem;

/// "head.nrrd" -> "head.colour.nrrd"
fs::path beside(const fs::path& file, const char* property) {
    fs::path name = file;
    return name.replace_extension(std::string(".") + property + file.extension().string());
}

bool is_there(const fs::path& file) {
    std::error_code ignored;
    return fs::exists(file, ignored);
}

/// Writes a property if it was changed, or if the file of an older one would otherwise belong to the new body.
Expected<void> save_property(const fs::path& file, bool changed, const field::Volume& volume) {
    return changed || is_there(file) ? field::write_nrrd(file, volume) : Expected<void>();
}

template <class Take>
Expected<void> take_property(const fs::path& file, field::Voxels& body, Take take) {
    if (!is_there(file)) return {};
    const auto volume = field::read_volume(file);
    if (!volume) return tl::unexpected(volume.error());
    if (auto taken = take(body, *volume); !taken)
        return fail(text(file.string(), ": ", taken.error().message));
    return {};
}

}  // namespace

Expected<void> save_volume(const VolumeLab& lab, const fs::path& file) {
    if (auto saved = field::write_nrrd(file, volume_now(lab)); !saved || !lab.carvable()) return saved;
    const auto& body = lab.body;
    const bool coloured = std::ranges::any_of(body.colour, [](field::Rgb8 c) {
        return c != field::Rgb8{255, 255, 255};
    });
    const bool mixed = std::ranges::any_of(body.material, [](std::uint8_t m) { return m != 0; });
    const auto placed = [&](field::Volume volume) {
        volume.placement = lab.source.placement;
        return volume;
    };
    if (auto saved = save_property(beside(file, "colour"), coloured, placed(field::colour_volume(body)));
        !saved)
        return saved;
    return save_property(beside(file, "material"), mixed, placed(field::material_volume(body)));
}

Expected<void> take_saved_properties(VolumeLab& lab, const fs::path& file) {
    if (!lab.carvable()) return {};
    if (auto taken = take_property(beside(file, "colour"), lab.body, field::set_colours); !taken)
        return taken;
    return take_property(beside(file, "material"), lab.body, field::set_materials);
}

}  // namespace thaum::game
