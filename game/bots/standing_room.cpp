#include "game/bots/standing_room.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "game/bots/duel.h"

namespace thaum::game::inline bots {
namespace {

constexpr double clearance = 0.05;  ///< height of the tested body above the place (m)
constexpr double tested_share =
    0.8;  ///< radius of the tested body, as a share of a wizard's; smaller, because a ramp may be near
/// Ends of the search for ground, above and below the feet (m).
constexpr double above_feet = 0.25, below_feet = 0.5;

}  // namespace

StandingRoom::StandingRoom(std::shared_ptr<const MatchData> data)
    : data_(std::move(data)),
      match_(std::make_shared<Simulation>(
          data_, MatchSetup{.devices = {bot_device(0, "nobody"), bot_device(1, "nobody")}})) {}

Expected<StandingRoom> StandingRoom::load(const std::filesystem::path& assets, const std::string& arena) {
    DataChoice choice;
    choice.arena = arena;
    auto data = load_match_data(assets, choice);
    if (!data) return data.error();
    return StandingRoom(std::make_shared<const MatchData>(std::move(*data)));
}

bool StandingRoom::is_inside_walls(vec3 feet) const {
    const auto ground = ground_bounds(data_->arena);
    const double margin = data_->wizard.radius;
    return feet.x > ground.low.x + margin && feet.x < ground.high.x - margin &&
           feet.z > ground.low.z + margin && feet.z < ground.high.z - margin;
}

bool StandingRoom::is_in_bowl(vec3 feet) const {
    const auto& bowl = data_->arena.bowl;
    if (!bowl) return false;
    const vec3 away = feet - bowl->centre;
    return std::hypot(away.x, away.z) < bowl->size.radius + data_->wizard.radius &&
           std::abs(away.y) < bowl->size.height / 2 + data_->wizard.height;
}

bool StandingRoom::is_in_solid(vec3 feet) const {
    const auto& rules = data_->wizard;
    const auto& physics = match_->physics();
    std::array<physics::Nearby, 64> near;
    for (const double height : {rules.radius, rules.height / 2, rules.height - rules.radius}) {
        const vec3 middle = feet + vec3(0, height + clearance, 0);
        const auto found =
            physics.nearby(middle, tested_share * rules.radius, near, layer::ground | layer::prop);
        if (found.count > 0) return true;
    }
    return false;
}

bool StandingRoom::has_ground(vec3 feet) const {
    return match_->physics()
        .ray(feet + vec3(0, above_feet, 0), feet - vec3(0, below_feet, 0), layer::ground)
        .has_value();
}

std::string_view StandingRoom::fault_at(vec3 feet) const {
    if (!is_inside_walls(feet)) return "is outside the walls";
    if (is_in_bowl(feet)) return "is in the cauldron";
    if (is_in_solid(feet)) return "is inside a solid thing";
    if (!has_ground(feet)) return "has no ground below it";
    return {};
}

}  // namespace thaum::game::inline bots
