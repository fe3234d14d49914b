// Fuzzes the readers of tools, materials and snapshots of voxels. Each accepted tool must carve without a
// fault.
#include <cmath>

#include "core/file.h"
#include "core/text.h"
#include "field/carving.h"
#include "field/voxel_state.h"
#include "fuzz/fuzz.h"

namespace thaum::fuzz {
namespace {

using field::Voxels;

/// A small solid body for trying tools.
Voxels small_body() {
    Voxels body = field::make_voxels({17, 9, 12}, {0.01, 0.02, 0.015});
    std::ranges::fill(body.density, 1.0F);
    return body;
}

field::Materials some_materials() {
    return {{.name = "bone"}, {.name = "wax"}, {.name = "ink"}, {.name = "invisible"}};
}

/// Fault that occurs when carving with the tool; empty: none.
std::string fault_of(const field::Tool& tool) {
    Voxels body = small_body();
    for (int i = 0; i < 4; ++i) {
        const field::Dab dab{.place = 0.02 * vec3(i, 1 - i, i),
                             .motion = {0.01 * i, 0.02, 0},
                             .seconds = 0.1 * i,
                             .seed = static_cast<std::uint64_t>(i)};
        const field::Edit e = edit(body.view(), tool, dab);
        if (!std::isfinite(e.removed) || !std::isfinite(e.added)) return "a mass that is not finite";
    }
    for (const float density : body.density) {
        if (!(density >= 0 && density <= 1)) return text("a density of ", density);
    }
    return "";
}

Outcome read_carving_tool(const std::string& input, const Places&) {
    const auto config = Config::parse(input, "tool.toml", field::tool_file_version);
    if (!config) return {.refusal = config.error().message};
    const auto tool = field::read_tool(*config, some_materials());
    if (!tool) return {.refusal = tool.error().message};
    if (auto fault = fault_of(*tool); !fault.empty()) return {.fault = fault};
    return {.accepted = true};
}

Outcome read_material_table(const std::string& input, const Places&) {
    const auto config = Config::parse(input, "materials.toml", field::materials_file_version);
    if (!config) return {.refusal = config.error().message};
    const auto materials = field::read_materials(*config);
    if (!materials) return {.refusal = materials.error().message};
    for (const auto& m : *materials) {
        if (field::material_index(*materials, m.name) != &m - materials->data())
            return {.fault = "a material without its index"};
    }
    return {.accepted = true};
}

Outcome read_voxel_snapshot(const std::string& input, const Places&) {
    Voxels body = small_body();
    field::BrickHashes kept, none;
    voxel_hash(body.view(), kept);
    ByteReader reader(std::as_bytes(std::span(input.data(), input.size())));
    const auto restored = restore(body.view(), reader);
    // A reader may have changed the body before it refused its input. Bricks (blocks of voxels) that it
    // changed must have new versions, so that their hashes are computed anew: the hash from remembered hashes
    // of bricks must equal the hash without them.
    if (voxel_hash(body.view(), kept) != voxel_hash(body.view(), none)) return {.fault = "a stale hash"};
    if (!restored) return {.refusal = restored.error().message};
    return {.accepted = true};
}

std::vector<std::string> tool_seeds(const Places& places) {
    std::vector<std::string> seeds;
    for (const char* name : {"squirt", "stamp", "annotate", "cut", "paint"}) {
        auto file =
            read_text_file(places.assets / "carving" / (std::string(name) + ".toml"), field::max_tool_bytes);
        seeds.push_back(file.value_or(""));
    }
    return seeds;
}

std::vector<std::string> material_seeds(const Places& places) {
    return {read_text_file(places.assets / "materials.toml", 1U << 20U).value_or("")};
}

std::vector<std::string> snapshot_seeds(const Places&) {
    Voxels body = small_body();
    body.material[3] = 7;
    Bytes saved;
    save(body.view(), saved);
    return {std::string(reinterpret_cast<const char*>(saved.data()), saved.size())};
}

}  // namespace

const Reader carving_tool_reader{"carving_tool", tool_seeds, mutate_text, read_carving_tool};
const Reader materials_reader{"materials", material_seeds, mutate_text, read_material_table};
const Reader voxels_reader{"voxels", snapshot_seeds, mutate_bytes, read_voxel_snapshot};

}  // namespace thaum::fuzz
