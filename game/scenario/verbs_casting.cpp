// Verbs (functions of scenario scripts) for strokes: a pad's stick and strokes of generated users.
#include <cmath>
#include <string>

#include "game/scenario/detail/verb.h"
#include "gesture/generated_users.h"

namespace thaum::game::inline scenario {
namespace {

namespace arg = arguments;
using arg::fault;

int verb_stick(lua_State* lua, void* context) {
    auto& hand = began(context).hands[arg::player(lua, 1)];
    hand.stick_right = static_cast<std::int32_t>(std::lround(127 * arg::number(lua, 2, "right", {-1, 1})));
    hand.stick_up = static_cast<std::int32_t>(std::lround(127 * arg::number(lua, 3, "up", {-1, 1})));
    return 0;
}

int verb_draw(lua_State* lua, void* context) {
    auto& hand = began(context).hands[arg::player(lua, 1)];
    hand.drawn_right = static_cast<std::int32_t>(arg::integer(lua, 2, "right", {-1e4, 1e4}));
    hand.drawn_up = static_cast<std::int32_t>(arg::integer(lua, 3, "up", {-1e4, 1e4}));
    return 0;
}

gesture::Effort read_effort(lua_State* lua, int index) {
    const auto name = arg::string(lua, index, "effort");
    if (name == "gentle") return gesture::Effort::gentle;
    if (name == "harsh") return gesture::Effort::harsh;
    if (name != "normal") fault("effort: '", name, "' is none of gentle, normal and harsh");
    return gesture::Effort::normal;
}

/// Draws a figure, or a scribble, as a generated user (a simulated person) would with a mouse.
std::vector<gesture::StrokePoint> draw(const std::string& shape, std::uint64_t user, gesture::Effort effort,
                                       Random& random) {
    Random user_random = random_stream(user, 1);
    auto style = gesture::random_style(user_random);
    style.flat = true;
    if (shape == "scribble") return gesture::draw_scribble(style, random);
    const auto names = gesture::figure_names();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == shape)
            return gesture::draw_figure(static_cast<gesture::Figure>(i), style, effort, random);
    fault("there is no figure '", shape, "'");
}

int verb_generated_stroke(lua_State* lua, void*) {
    const auto shape = std::string(arg::string(lua, 1, "a figure or scribble"));
    const auto user = static_cast<std::uint64_t>(arg::integer(lua, 2, "user", {0, 1e9}));
    const auto number = static_cast<std::uint64_t>(arg::integer(lua, 3, "number", {0, 1e9}));
    const auto effort = read_effort(lua, 4);
    Random random = random_stream(number, 2 + user);
    const auto points = draw(shape, user, effort, random);
    lua_createtable(lua, static_cast<int>(points.size()), 0);
    lua_Integer count = 0;
    for (const auto& point : points) {
        lua_createtable(lua, 0, 3);
        arg::set_number(lua, "t", point.t - points.front().t);
        arg::set_number(lua, "x", point.at.x);
        arg::set_number(lua, "y", point.at.y);
        lua_rawseti(lua, -2, ++count);
    }
    return 1;
}

constexpr VerbName casting_list[] = {
    {"raw_stick", verb_stick},
    {"raw_draw", verb_draw},
    {"generated_stroke", verb_generated_stroke},
};

}  // namespace

std::span<const VerbName> casting_verbs() { return casting_list; }

}  // namespace thaum::game::inline scenario
