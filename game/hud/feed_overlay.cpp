#include "game/hud/feed_overlay.h"

#include <algorithm>
#include <span>

#include "game/data/event_words.h"
#include "game/data/teams.h"
#include "game/hud/overlay.h"

namespace thaum::game::inline hud {

using render::Align;
using render::Overlay;

void add_feed(Overlay& out, const Picture& picture, const PlayerNames& names, std::uint32_t player,
              const ViewLayout& l) {
    const float u = l.unit, line = 20 * u;
    const auto room = static_cast<std::uint32_t>((l.feed.high.y - l.feed.low.y) / line);
    const auto gives_way = [&](const FeedLine& fed) {
        const bool foes = fed.event.kind == EventKind::recipe_told && fed.event.subject != player;
        return foes && picture.feed_lines > room;
    };
    const auto lines = std::span(picture.feed).first(picture.feed_lines);
    const auto wanted =
        lines.size() - static_cast<std::size_t>(std::count_if(lines.begin(), lines.end(), gives_way));
    std::size_t left_out = wanted - std::min<std::size_t>(room, wanted);
    const bool left = l.feed.low.x - static_cast<float>(l.view.x) < static_cast<float>(l.view.width) / 4;
    float top = l.feed.low.y;
    for (const auto& fed : lines) {
        if (gives_way(fed) || left_out > 0) {
            if (!gives_way(fed)) --left_out;
            continue;
        }
        const auto& row = row_of(picture.shown->events, fed.event.kind);
        const bool alone = is_alone(fed.event);
        const auto words =
            event_words(feed_pattern(row, fed.event), fed.event, names, fed.thing, *picture.shown);
        const auto who = alone ? fed.event.subject : fed.event.by;
        add_text_on_plate(out, {{l.feed.low.x, top}, {l.feed.high.x, top + line}}, words, 14 * u,
                          opaque(team_colours(who).light), left ? Align::left : Align::right);
        top += line;
    }
}

}  // namespace thaum::game::inline hud
