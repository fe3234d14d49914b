#include "game/settings/body_faders.h"

namespace thaum::game::inline settings {
namespace {

struct Words {
    std::string_view label, told;
};
constexpr std::array<Words, tactile::purpose_count> words{{
    {"Hits", "Bolts and thrown things strike the body."},
    {"Blasts", "A burst spreads over the body from its side."},
    {"Falls", "A hard landing runs up from the waist."},
    {"Own steps", "Each step taps the waist on its side."},
    {"Gifts and magic", "The body swells with what a brew or a shield gives."},
    {"Heart and warnings", "The heart beats when little health is left."},
    {"Own shots", "Each shot kicks the side of the wand."},
    {"Stirring", "The brew drags at the side of the wand."},
    {"Touched things", "What the wand touches is felt on the body."},
    {"Music", "The music is felt on the body."},
}};

}  // namespace

std::string_view label_of(tactile::Purpose purpose) { return words[static_cast<std::size_t>(purpose)].label; }
std::string_view effect_of(tactile::Purpose purpose) { return words[static_cast<std::size_t>(purpose)].told; }

tactile::Faders read_body_faders(const ConfigTable& table, tactile::Faders faders) {
    for (std::size_t i = 0; i < tactile::purpose_count; ++i)
        faders.values[i] = table.number(tactile::purpose_names()[i], {0, 1}, faders.values[i]);
    return faders;
}

}  // namespace thaum::game::inline settings
