#include "game/lab/saved_body.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "core/file_writer.h"
#include "core/hash.h"
#include "core/text.h"
#include "field/nrrd.h"
#include "field/volume_file.h"
#include "field/voxel_volume.h"

namespace thaum::game::inline lab {
namespace {

namespace fs = std::filesystem;

/// Name of the file of another property of a body: "head.nrrd" -> "head.colour.nrrd".
fs::path beside(const fs::path& file, const char* property) {
    fs::path name = file;
    return name.replace_extension(std::string(".") + property + file.extension().string());
}

bool is_there(const fs::path& file) {
    std::error_code ignored;
    return fs::exists(file, ignored);
}

/// Identifier of a saved body. It is the same in all files of that body, and almost certainly different in
/// those of any other.
std::string name_of(const field::Voxels& body) {
    std::uint64_t hash = hash_value(body.count);
    for (const auto bytes : {std::as_bytes(std::span(body.density)), std::as_bytes(std::span(body.colour)),
                             std::as_bytes(std::span(body.material))})
        hash = hash_bytes(bytes, hash);
    return hex(hash);
}

template <class Take>
Expected<void> take_property(const fs::path& file, VolumeLab& lab, Take take) {
    if (!is_there(file)) return {};
    const auto volume = field::read_volume(file, {.colours_as_vectors = true});
    if (!volume) return volume.error();
    if (volume->save_name != lab.source.save_name)
        return fail(text(file.string(),
                         ": belongs to another body than the file of densities beside it; "
                         "move one of them elsewhere"));
    if (auto taken = take(lab.body, *volume); !taken)
        return fail(text(file.string(), ": ", taken.error().message));
    return {};
}

/// The volumes that save a body, with their file paths. Colours or materials are among them if they were
/// changed. They also are if an older file of them exists, which would otherwise seem to belong to this body.
std::vector<std::pair<fs::path, field::Volume>> parts_of(const VolumeLab& lab, const fs::path& file) {
    const auto& body = lab.body;
    std::vector<std::pair<fs::path, field::Volume>> parts;
    parts.emplace_back(file, volume_now(lab));
    if (!lab.carvable()) return parts;
    const bool coloured = std::ranges::any_of(body.colour, [](field::Rgb8 c) {
        return c != field::Rgb8{255, 255, 255};
    });
    const bool mixed = std::ranges::any_of(body.material, [](std::uint8_t m) { return m != 0; });
    const auto [colours, materials] = companions_of(file);
    if (coloured || is_there(colours)) parts.emplace_back(colours, field::colour_volume(body));
    if (mixed || is_there(materials)) parts.emplace_back(materials, field::material_volume(body));
    const auto name = name_of(body);
    for (auto& [path, volume] : parts) {
        field::lie_as(volume, lab.source);
        volume.save_name = name;
    }
    return parts;
}

}  // namespace

std::array<fs::path, 2> companions_of(const fs::path& file) {
    return {beside(file, "colour"), beside(file, "material")};
}

Expected<void> save_volume(const VolumeLab& lab, const fs::path& file) {
    std::vector<FileWriter> finished;
    for (const auto& [path, volume] : parts_of(lab, file)) {
        auto part = field::start_nrrd(path, volume);
        if (!part) return part.error();
        finished.push_back(std::move(*part));
    }
    for (auto& part : finished)
        if (auto closed = part.close(); !closed) return closed;
    return {};
}

Expected<void> take_saved_properties(VolumeLab& lab, const fs::path& file) {
    if (!lab.carvable()) return {};
    const auto [colours, materials] = companions_of(file);
    if (auto taken = take_property(
            colours, lab, [](auto& body, const auto& volume) { return field::set_colours(body, volume); });
        !taken)
        return taken;
    return take_property(materials, lab,
                         [](auto& body, const auto& volume) { return field::set_materials(body, volume); });
}

}  // namespace thaum::game::inline lab
