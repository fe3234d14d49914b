#include "render/detail/patches.h"

#include <algorithm>
#include <cmath>

#include "render/detail/frustum.h"

namespace thaum::render::detail {
namespace {

// Width of the joints between the stones of the ground, and height of a wizard's eyes (m). Seen from that
// height, a joint starts to fade at the distance at which it is less than a pixel high.
constexpr float line_width = 0.06F, eye_height = 1.7F;

/// Half size of the box around the mesh.
fvec3 half_of(const MeshData& mesh) {
    const fvec3 centre = bounds(mesh).centre;
    fvec3 half(0);
    for (const auto& v : mesh.vertices) half = glm::max(half, glm::abs(v.position - centre));
    return half;
}

/// Normal of a triangle, with twice its area as length.
fvec3 across(const MeshData& mesh, std::size_t first) {
    const auto at = [&](std::size_t k) { return mesh.vertices[mesh.indices[first + k]].position; };
    return glm::cross(at(1) - at(0), at(2) - at(0));
}

float longest_edge(const MeshData& mesh) {
    float longest = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        longest = std::max(longest, glm::distance(mesh.vertices[mesh.indices[i]].position,
                                                  mesh.vertices[mesh.indices[next]].position));
    }
    return longest;
}

/// Fits a cone that contains all normals and whose apex is behind every triangle. No front face is visible
/// from the places in a second cone, at the other side of the apex (Shirman and Abi-Ezzi 1993).
void fit_cone(const MeshData& mesh, PlacedPatch& patch) {
    fvec3 sum(0);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) sum += across(mesh, i);
    const float length = glm::length(sum);
    if (length <= 0) return;
    const fvec3 axis = sum / length;
    float widest = 1, behind = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const fvec3 n = across(mesh, i);
        const float area = glm::length(n);
        if (area <= 0) continue;
        const float along = glm::dot(axis, n) / area;
        // A cone this wide is of no use: there is hardly a place from which all triangles face away.
        if (along < 0.2F) return;
        widest = std::min(widest, along);
        const fvec3 corner = mesh.vertices[mesh.indices[i]].position;
        behind = std::max(behind, glm::dot(patch.bounds.centre - corner, n) / (area * along));
    }
    patch.axis = axis;
    patch.apex = patch.bounds.centre - behind * axis;
    patch.backs = std::sqrt(1 - widest * widest);
}

IndexRange append_indices(const MeshData& part, std::uint32_t base, std::vector<std::uint32_t>& indices) {
    const IndexRange range{static_cast<std::uint32_t>(indices.size()),
                           static_cast<std::uint32_t>(part.indices.size())};
    for (const auto index : part.indices) indices.push_back(base + index);
    return range;
}

IndexRange append_part(const MeshData& part, JoinedPatches& out) {
    const auto base = static_cast<std::uint32_t>(out.mesh.vertices.size());
    out.mesh.vertices.insert(out.mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    return append_indices(part, base, out.table.indices);
}

bool shows_backs(const PlacedPatch& patch, fvec3 eye) {
    const fvec3 to = patch.apex - eye;
    return glm::dot(to, patch.axis) >= patch.backs * glm::length(to);
}

/// Returns true if the patch is behind other patches of the same large mesh.
bool is_behind(const PlacedPatch& patch) { return patch.full.count == 0; }

/// Returns true if a light reaches the patch and is so near that its light at the corners of a triangle does
/// not tell that between them.
bool is_near_light(const PlacedPatch& patch, std::span<const PointLight> lights) {
    constexpr float edges_away = 0.5F;
    return std::any_of(lights.begin(), lights.end(), [&](const PointLight& light) {
        const fvec3 beyond = glm::max(glm::abs(light.position - patch.bounds.centre) - patch.half, 0.0F);
        return glm::length(beyond) < std::min(light.radius, edges_away * patch.longest_edge);
    });
}

void append_chosen(const PatchTable& table, const Sight& sight, const PatchOrder& order, bool sunless,
                   bool near_light, std::vector<std::uint32_t>& out) {
    const float gone = fading_of(sight.pixel_angle).gone;
    for (const auto& [farthest, i] : order.near_first) {
        const auto& patch = table.patches[i];
        if (patch.sunless != sunless || is_near_light(patch, sight.lights) != near_light) continue;
        // The plain form of a patch (piece of a large mesh) lacks fine detail. The distance of a patch's
        // nearest point decides whether the plain form is drawn. A patch behind others may show as soon as
        // the farthest of those is drawn in its plain form, so its own farthest point decides.
        const float across = 2 * patch.bounds.radius;
        const float distance = farthest - (is_behind(patch) ? across / 2 : across);
        const bool fine = distance * sight.pixel_angle > patch.detail && distance > gone;
        const auto& range = fine && patch.plain.count > 0 ? patch.plain : patch.full;
        const auto first = table.indices.begin() + range.first;
        out.insert(out.end(), first, first + range.count);
    }
}

}  // namespace

Fading fading_of(float pixel_angle) {
    const float from = std::sqrt(line_width * eye_height / std::max(pixel_angle, 1e-5F));
    // At 1.8 times the distance at which it starts to fade, a joint is a third of a pixel high and broken
    // into dashes.
    return {from, 1.8F * from};
}

JoinedPatches joined(const Patchwork& patchwork) {
    JoinedPatches out;
    std::size_t vertices = 0, indices = 0;
    for (const auto& patch : patchwork) {
        vertices += patch.full.vertices.size() + patch.plain.vertices.size();
        indices += patch.full.indices.size() + patch.plain.indices.size();
    }
    out.mesh.vertices.reserve(vertices);
    out.table.indices.reserve(indices);
    for (const auto& patch : patchwork) {
        const auto& shown = patch.full.indices.empty() ? patch.plain : patch.full;
        PlacedPatch placed{.bounds = bounds(shown),
                           .half = half_of(shown),
                           .detail = patch.detail,
                           .sunless = patch.sunless};
        placed.longest_edge = std::max(longest_edge(patch.full), longest_edge(patch.plain));
        fit_cone(shown, placed);
        placed.full = append_part(patch.full, out);
        out.table.patches.push_back(placed);
    }
    out.table.full_count = static_cast<std::uint32_t>(out.table.indices.size());
    for (std::size_t i = 0; i < patchwork.size(); ++i)
        out.table.patches[i].plain = append_part(patchwork[i].plain, out);
    out.mesh.indices = out.table.indices;
    return out;
}

ChosenPatches choose_patches(const PatchTable& table, const Sight& sight, PatchOrder& order,
                             std::vector<std::uint32_t>& out) {
    const auto planes = frustum_planes(sight.to_clip);
    auto& near_first = order.near_first;
    near_first.clear();
    for (std::uint32_t i = 0; i < table.patches.size(); ++i) {
        const auto& patch = table.patches[i];
        if (shows_backs(patch, sight.eye) || !within(planes, patch.bounds)) continue;
        if (is_hidden(sight.hidden, patch.bounds.centre, patch.half)) continue;
        // Patches are sorted by the distance of their farthest point, so a small block is drawn before a
        // large sheet behind it. Patches behind others get twice the radius, since those in front extend
        // beyond them.
        const float beyond = (is_behind(patch) ? 2 : 1) * patch.bounds.radius;
        near_first.emplace_back(glm::distance(patch.bounds.centre, sight.eye) + beyond, i);
    }
    std::sort(near_first.begin(), near_first.end());
    const auto append = [&](bool sunless, std::uint32_t& near_light) {
        const auto first = static_cast<std::uint32_t>(out.size());
        append_chosen(table, sight, order, sunless, true, out);
        near_light = static_cast<std::uint32_t>(out.size()) - first;
        append_chosen(table, sight, order, sunless, false, out);
        return IndexRange{first, static_cast<std::uint32_t>(out.size()) - first};
    };
    ChosenPatches chosen;
    chosen.sunlit = append(false, chosen.near_light_sunlit);
    chosen.sunless = append(true, chosen.near_light_sunless);
    return chosen;
}

}  // namespace thaum::render::detail
