#include "game/lab/body_feel.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"

namespace thaum::game::inline lab {
namespace {

constexpr double max_number = 1e6;

constexpr std::array<FeelForm, 6> forms{{
    {"opacity", 1, 2, 1, {"force (N)", "drag (N s/m)"}},
    {"attract", 1, 2, 1, {"force (N)", "drag (N s/m)"}},
    {"shell", 3, 4, 1, {"low", "high", "force (N)", "drag (N s/m)"}},
    {"wall", 2, 3, haptics::max_walls_felt, {"density", "force (N)", "friction"}},
    {"gravity", 3, 3, 1, {"x (N)", "y (N)", "z (N)"}},
    {"plane",
     7,
     7,
     haptics::max_guides,
     {"x (m)", "y (m)", "z (m)", "normal x", "normal y", "normal z", "force (N)"}},
}};

/// The numbers of a part of a body's feel that must not be negative: forces, drags, friction.
std::span<const double> strengths_of(const FeelPart& part) {
    const std::span<const double> all = part.numbers;
    switch (part.kind) {
        case FeelKind::opacity:
        case FeelKind::attract: return all.first(2);
        case FeelKind::shell: return all.subspan(2, 2);
        case FeelKind::wall: return all.subspan(1, 2);
        case FeelKind::gravity: return {};
        case FeelKind::plane: return all.subspan(6, 1);
    }
    return {};
}

vec3 normal_of(const FeelPart& part) { return {part.numbers[3], part.numbers[4], part.numbers[5]}; }

Expected<void> check(const FeelPart& part) {
    const auto& form = form_of(part.kind);
    for (const double number : part.numbers)
        if (!(std::abs(number) <= max_number))
            return fail(text(form.name, ": numbers must be within +-", max_number));
    for (const double strength : strengths_of(part))
        if (strength < 0) return fail(text(form.name, ": a force, drag or friction must not be negative"));
    if (part.kind == FeelKind::shell && !(part.numbers[0] < part.numbers[1]))
        return fail("shell: the low density must be below the high one");
    if (part.kind == FeelKind::plane && !(glm::length(normal_of(part)) > 1e-6))
        return fail("plane: the normal must have a length");
    return {};
}

void put(const FeelPart& part, const field::TransferFunction& opacity, double reach,
         haptics::VolumeFeel& feel) {
    const auto& n = part.numbers;
    switch (part.kind) {
        case FeelKind::opacity:
        case FeelKind::attract:
            feel.opacity = {.density = opacity,
                            .gradient = field::constant(1),
                            .stiffness = n[0],
                            .retarding = n[1],
                            .attracts = part.kind == FeelKind::attract};
            break;
        case FeelKind::shell:
            feel.shell = {.low = n[0], .high = n[1], .stiffness = n[2], .retarding = n[3]};
            break;
        case FeelKind::wall:
            feel.walls[feel.wall_count++] = {
                .density = n[0], .strength = n[1], .friction = n[2], .reach = reach};
            break;
        case FeelKind::gravity: feel.gravity = {n[0], n[1], n[2]}; break;
        case FeelKind::plane:
            feel.guides[feel.guide_count++] = {
                .place = {n[0], n[1], n[2]}, .normal = glm::normalize(normal_of(part)), .strength = n[6]};
            break;
    }
}

}  // namespace

std::span<const FeelForm> feel_forms() { return forms; }
const FeelForm& form_of(FeelKind kind) { return forms.at(static_cast<std::size_t>(kind)); }

Expected<FeelPart> feel_part(std::string_view name, std::span<const double> numbers) {
    const auto form = std::ranges::find(forms, name, &FeelForm::name);
    if (form == forms.end()) {
        std::string names;
        for (const auto& each : forms) names += text(names.empty() ? "" : ", ", each.name);
        return fail(text("'", name, "': there are ", names));
    }
    if (numbers.size() < form->least || numbers.size() > form->count)
        return fail(text(name, ": takes ", form->least,
                         form->least == form->count ? std::string() : text(" to ", form->count), " numbers"));
    FeelPart part{.kind = static_cast<FeelKind>(form - forms.begin())};
    std::ranges::copy(numbers, part.numbers.begin());
    if (auto sound = check(part); !sound) return sound.error();
    return part;
}

Expected<haptics::VolumeFeel> feel_of_parts(std::span<const FeelPart> parts,
                                            const field::TransferFunction& opacity, double reach) {
    std::array<std::size_t, forms.size()> counts{};
    haptics::VolumeFeel feel;
    for (const FeelPart& part : parts) {
        if (auto sound = check(part); !sound) return sound.error();
        const auto& form = form_of(part.kind);
        if (++counts[static_cast<std::size_t>(part.kind)] > form.max_parts)
            return fail(
                text(form.name, ": at most ", form.max_parts, form.max_parts == 1 ? " acts" : " act"));
        put(part, opacity, reach, feel);
    }
    if (counts[0] > 0 && counts[1] > 0) return fail("opacity and attract do not act together");
    return feel;
}

haptics::MaterialTable feel_of_materials(const field::Materials& materials) {
    haptics::MaterialTable table{};
    if (materials.empty()) return table;
    const auto& first = materials.front();
    const auto factor = [](double mine, double firsts) { return firsts > 0 ? mine / firsts : 1; };
    for (std::size_t i = 0; i < std::min(materials.size(), table.size()); ++i)
        table[i] = {.stiffness = factor(materials[i].stiffness, first.stiffness),
                    .viscosity = factor(materials[i].viscosity, first.viscosity)};
    return table;
}

std::uint8_t BodyMaterials::material(vec3 place) const {
    const vec3 own = field::to_own(placement, place) / spacing;
    std::size_t at = 0, stride = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const int n = count[static_cast<std::size_t>(axis)];
        const double nearest = std::round(own[axis] + 0.5 * (n - 1));
        if (!(nearest >= 0 && nearest < n)) return 0;
        at += stride * static_cast<std::size_t>(nearest);
        stride *= static_cast<std::size_t>(n);
    }
    return at < indices.size() ? indices[at] : std::uint8_t{0};
}

}  // namespace thaum::game::inline lab
