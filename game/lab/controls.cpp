#include "game/lab/controls.h"

#include <algorithm>

#include "core/text.h"

namespace thaum::game::inline lab {
namespace {

using Rules = CauldronRules;

constexpr double root_of_ten = 3.1622776601683795;
constexpr double thin = 1e-6;  // smallest viscosity other than 0 (m^2/s)
constexpr double weight_step = 0.05, min_weight = -1, max_weight = 2;

/// Next viscosity up or down, in steps of half a decade; below the smallest comes 0 (m^2/s).
double other_viscosity(double current, int way) {
    if (way > 0) return current < thin ? thin : std::min(current * root_of_ten, fluid::max_viscosity);
    return current <= 1.01 * thin ? 0 : current / root_of_ten;
}

std::string of_viscosity(double viscosity) { return text(static_cast<float>(viscosity), " m2/s"); }

Ingredient* chosen(LabHands& hands) {
    return hands.chosen < hands.settings.substances.size() ? &hands.settings.substances[hands.chosen]
                                                           : nullptr;
}
const Ingredient* chosen(const LabHands& hands) {
    return hands.chosen < hands.settings.substances.size() ? &hands.settings.substances[hands.chosen]
                                                           : nullptr;
}

void turn_cells(LabHands& hands, const Rules&, int way) {
    const auto at = std::ranges::find(lab_cells, hands.settings.cells) - lab_cells.begin();
    const auto last = static_cast<std::ptrdiff_t>(lab_cells.size()) - 1;
    hands.settings.cells = lab_cells[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at + way, 0, last))];
}

/// Replaces the chosen substance by the next ingredient in the rules that is not yet one of the substances.
void turn_ingredient(LabHands& hands, const Rules& rules, int) {
    Ingredient* current = chosen(hands);
    const auto& all = rules.ingredients;
    if (current == nullptr || all.empty()) return;
    const auto named = [](const std::string& name) {
        return [&name](const Ingredient& i) { return i.name == name; };
    };
    auto at = static_cast<std::size_t>(std::ranges::find_if(all, named(current->name)) - all.begin());
    for (std::size_t tries = 0; tries < all.size(); ++tries) {
        at = at + 1 < all.size() ? at + 1 : 0;
        if (std::ranges::any_of(hands.settings.substances, named(all[at].name))) continue;
        *current = all[at];
        return;
    }
}

std::string yes_or_no(bool yes) { return yes ? "on" : "off"; }

constexpr std::array controls{
    LabControl{"", "S", "solver",
               [](const LabHands& h, const Rules&) {
                   return std::string(h.settings.solver == fluid::Solver::thaum ? "thaum"
                                                                                : "classic (a box)");
               },
               [](LabHands& h, const Rules&, int) {
                   auto& solver = h.settings.solver;
                   solver = solver == fluid::Solver::thaum ? fluid::Solver::classic : fluid::Solver::thaum;
               }},
    LabControl{"Minus", "Equal", "cells across",
               [](const LabHands& h, const Rules&) { return text(h.settings.cells); }, turn_cells},
    LabControl{"", "O", "order", [](const LabHands& h, const Rules&) { return text(h.settings.order); },
               [](LabHands& h, const Rules&, int) { h.settings.order = 6 - h.settings.order; }},
    LabControl{"", "B", "walls",
               [](const LabHands& h, const Rules&) { return std::string(h.settings.bowl ? "bowl" : "box"); },
               [](LabHands& h, const Rules&, int) { h.settings.bowl = !h.settings.bowl; }},
    LabControl{"", "E", "edges",
               [](const LabHands& h, const Rules&) {
                   return std::string(h.settings.no_slip ? "no slip" : "free slip");
               },
               [](LabHands& h, const Rules&, int) { h.settings.no_slip = !h.settings.no_slip; }},
    LabControl{"Comma", "Period", "viscosity",
               [](const LabHands& h, const Rules&) { return of_viscosity(h.settings.viscosity); },
               [](LabHands& h, const Rules&, int way) {
                   h.settings.viscosity = other_viscosity(h.settings.viscosity, way);
               }},
    LabControl{
        "", "G", "gravity", [](const LabHands& h, const Rules&) { return text(h.settings.gravity, " m/s2"); },
        [](LabHands& h, const Rules&, int) { h.settings.gravity = h.settings.gravity != 0 ? 0 : 9.81; }},
    LabControl{"", "Tab", "substance",
               [](const LabHands& h, const Rules&) {
                   return chosen(h) != nullptr ? text(h.chosen + 1, ": ", chosen(h)->name) : "none";
               },
               [](LabHands& h, const Rules&, int) {
                   h.chosen = h.chosen + 1 < h.settings.substances.size() ? h.chosen + 1 : 0;
               }},
    LabControl{"", "I", "  what it is",
               [](const LabHands& h, const Rules&) { return chosen(h) != nullptr ? chosen(h)->name : ""; },
               turn_ingredient},
    LabControl{"LeftBracket", "RightBracket", "  thickens by",
               [](const LabHands& h, const Rules&) {
                   return chosen(h) != nullptr ? of_viscosity(chosen(h)->substance.viscosity) : "";
               },
               [](LabHands& h, const Rules&, int way) {
                   if (Ingredient* i = chosen(h))
                       i->substance.viscosity = other_viscosity(i->substance.viscosity, way);
               }},
    LabControl{"K", "L", "  weighs more by",
               [](const LabHands& h, const Rules&) {
                   return chosen(h) != nullptr ? fixed(chosen(h)->substance.weight, 2) : "";
               },
               [](LabHands& h, const Rules&, int way) {
                   if (Ingredient* i = chosen(h))
                       i->substance.weight =
                           std::clamp(i->substance.weight + way * weight_step, min_weight, max_weight);
               }},
    LabControl{"D", "F", "  spreads by",
               [](const LabHands& h, const Rules&) {
                   return chosen(h) != nullptr ? of_viscosity(chosen(h)->substance.diffusion) : "";
               },
               [](LabHands& h, const Rules&, int way) {
                   if (Ingredient* i = chosen(h))
                       i->substance.diffusion = std::min(1.0, other_viscosity(i->substance.diffusion, way));
               }},
    LabControl{"", "A", "arrows", [](const LabHands& h, const Rules&) { return yes_or_no(h.arrows); },
               [](LabHands& h, const Rules&, int) { h.arrows = !h.arrows; }},
    LabControl{"", "T", "streamlines",
               [](const LabHands& h, const Rules&) { return yes_or_no(h.streamlines); },
               [](LabHands& h, const Rules&, int) { h.streamlines = !h.streamlines; }},
    LabControl{"", "P", "paused", [](const LabHands& h, const Rules&) { return yes_or_no(h.paused); },
               [](LabHands& h, const Rules&, int) { h.paused = !h.paused; }},
    LabControl{"", "H", "this list", [](const LabHands& h, const Rules&) { return yes_or_no(h.list); },
               [](LabHands& h, const Rules&, int) { h.list = !h.list; }},
};

}  // namespace

std::span<const LabControl> lab_controls() { return controls; }

bool turn_control(std::string_view key, LabHands& hands, const CauldronRules& rules) {
    for (const LabControl& control : controls) {
        if (key.empty() || (key != control.less && key != control.more)) continue;
        control.turn(hands, rules, key == control.less ? -1 : 1);
        return true;
    }
    return false;
}

}  // namespace thaum::game::inline lab
