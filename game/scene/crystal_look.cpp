#include "game/scene/crystal_look.h"

#include <algorithm>

#include "game/scene/crystal_mesh.h"
#include "game/stations/crystal/crystal.h"
#include "game/stations/crystal/crystal_shape.h"
#include "render/colour.h"

namespace thaum::game::inline scene {
namespace {

constexpr int side = crystal_side;
constexpr std::array<int, 3> count{side, side, side};
/// Distance beyond which the coarse mesh is shown instead of voxels (m)
constexpr double voxels_shown_m = 7;
constexpr float mesh_glow = 0.5F;
/// Light of the crystal: above 1, because a crystal also emits a little light.
const fvec3 crystal_light(1.35F);
/// Colours of matter inside and outside the shape of the key that players carve from the crystal, as the
/// square root of the share of light.
constexpr field::Rgb8 right{96, 224, 246}, surplus{255, 150, 56};
constexpr float at_key = 0.1F;         ///< density of the wanted key up to which matter counts as surplus
constexpr float shell_opacity = 0.3F;  ///< opacity of one layer of the shell that shows the wanted key
/// Densities between which a faint shell shows the key that is to be carved. The shell lies inside the key's
/// surface, so that finished parts of the crystal hide it.
constexpr float shell_from = 0.55F, shell_to = 0.95F;

void fill_key_table(render::ScanTable& table) {
    for (std::size_t i = 0; i < table.size(); ++i) {
        const float at = static_cast<float>(i) / 255;
        table.at(i) = {.colour = 1.2F * render::colour(0xFFF0C0),
                       .opacity = at > shell_from && at < shell_to ? shell_opacity : 0};
    }
}

/// Creates the untouched crystal and the shape of the key that players carve from it. Marks all bricks
/// (blocks of voxels) as changed.
void begin_crystal(const CrystalPicture& crystal, CrystalLook& look) {
    auto rough = std::make_shared<CrystalVoxels>();
    look.wanted = key_density(crystal.seed, side);
    rough->density = rough_density(crystal.seed, look.wanted, side);
    rough->colour.assign(rough->density.size(), {255, 255, 255});
    look.rough = std::move(rough);
    look.seed = crystal.seed;
    look.shown = nullptr;
    look.made = true;
    look.paint.resize(look.wanted.size());
    ++look.key.version;
}

/// Colour of a voxel, combined with what the brush has painted: blue inside the key that is to be carved and
/// at its surface, amber outside.
field::Rgb8 colour_of(field::Rgb8 painted, float wanted) {
    const auto own = wanted >= at_key ? right : surplus;
    const auto part = [](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(static_cast<unsigned>(a) * b / 255U);
    };
    return {part(painted.r, own.r), part(painted.g, own.g), part(painted.b, own.b)};
}

/// Whether two states of the crystal differ in one row of a brick (a block of voxels).
bool differs(const CrystalVoxels& a, const CrystalVoxels& b, std::size_t from, std::size_t length) {
    const auto row = [&](const auto& all) { return std::span(all).subspan(from, length); };
    return !std::ranges::equal(row(a.density), row(b.density)) ||
           !std::ranges::equal(row(a.colour), row(b.colour));
}

/// Increments the version of each brick (block of voxels) in which the crystal differs from what was shown,
/// and repaints it. Returns the number of these bricks.
std::size_t follow(const CrystalVoxels& current, const CrystalVoxels* before, CrystalLook& look) {
    std::size_t changed = 0, brick = 0;
    const auto row_of = [](int x, int y, int z) {
        return static_cast<std::size_t>(x) +
               side * (static_cast<std::size_t>(y) + side * static_cast<std::size_t>(z));
    };
    constexpr auto size = static_cast<std::size_t>(render::scan_brick);
    const auto each_row = [&](const std::array<int, 3>& low, auto visit) {
        for (int z = low[2]; z < low[2] + render::scan_brick; ++z)
            for (int y = low[1]; y < low[1] + render::scan_brick; ++y)
                if (visit(row_of(low[0], y, z))) return true;
        return false;
    };
    for (int z = 0; z < side; z += render::scan_brick)
        for (int y = 0; y < side; y += render::scan_brick)
            for (int x = 0; x < side; x += render::scan_brick, ++brick) {
                const auto is_new = [&](std::size_t row) { return differs(current, *before, row, size); };
                if (before != nullptr && !each_row({x, y, z}, is_new)) continue;
                each_row({x, y, z}, [&](std::size_t row) {
                    for (std::size_t i = row; i < row + size; ++i)
                        look.paint[i] = colour_of(current.colour[i], look.wanted[i]);
                    return false;
                });
                ++look.bricks.at(brick);
                ++changed;
            }
    return changed;
}

fmat4 model_of(const CrystalPicture& crystal) {
    fmat4 model = glm::mat4_cast(fquat(rotation({0, 1, 0}, crystal.yaw)));
    model[3] = fvec4(fvec3(crystal.middle), 1);
    return model;
}

void place(const CrystalPicture& crystal, render::Scan& scan) {
    scan.spacing = fvec3(static_cast<float>(crystal.edge / side));
    scan.model = model_of(crystal);
}

}  // namespace

CrystalLook make_crystal_look(render::Renderer& renderer) {
    CrystalLook look;
    look.mesh.mesh = renderer.upload(render::MeshData{});
    const auto bricks = render::bricks_of(count);
    look.bricks.assign(static_cast<std::size_t>(bricks[0]) * static_cast<std::size_t>(bricks[1]) *
                           static_cast<std::size_t>(bricks[2]),
                       0);
    fill_key_table(look.table);
    look.body = {.id = renderer.make_scan(),
                 .count = count,
                 .samples = std::span<const float>(),
                 .look = render::ScanLook::surface,
                 .level = crystal_surface,
                 .colour = crystal_light};
    look.key = {.id = renderer.make_scan(), .count = count, .samples = std::span<const float>(), .step = 1};
    return look;
}

std::size_t show_crystal(const CrystalPicture& crystal, CrystalLook& look) {
    const bool anew = !look.made || look.seed != crystal.seed;
    if (anew) begin_crystal(crystal, look);
    place(crystal, look.body);
    place(crystal, look.key);
    look.key.unit = look.key.spacing.x;
    const auto current = crystal.voxels ? crystal.voxels : look.rough;
    if (!anew && current == look.shown) return 0;
    const auto changed = follow(*current, anew ? nullptr : look.shown.get(), look);
    look.shown = current;
    if (changed > 0) {
        ++look.body.version;
        ++look.mesh.version;
        look.mesh.triangles = crystal_mesh(current->density, look.paint, side, look.body.spacing.x);
    }
    look.body.samples = std::span<const float>(current->density);
    look.body.brick_versions = look.bricks;
    look.body.colours = look.paint;
    look.key.samples = std::span<const float>(look.wanted);
    look.key.table = &look.table;
    return changed;
}

bool sees_voxels(const CrystalPicture& crystal, vec3 eye) {
    return glm::distance(eye, crystal.middle) < voxels_shown_m;
}

void add_crystal(const CrystalPicture& crystal, const CrystalLook& look, std::vector<render::Instance>& out) {
    out.push_back({.mesh = look.mesh.mesh,
                   .model = model_of(crystal),
                   .tint = crystal_light,
                   .glow = mesh_glow,
                   .sun = look.body.sun});
}

}  // namespace thaum::game::inline scene
