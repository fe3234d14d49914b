// Tests of the menu's seams, at which pages and requests can be added without a change elsewhere: a page and
// a request that no file of the game knows, and that every row that opens a page finds it.
#include <gtest/gtest.h>

#include <set>

#include "core/text.h"
#include "game/live/match_requests.h"
#include "game/menu/page.h"
#include "unit/menu_rig.h"

namespace thaum::game::menu_tests {
namespace {

constexpr std::size_t usual_bells = 2;

/// A request that only this test has: it counts how often it is carried out, in a number of the caller.
struct RingBells {
    std::size_t* rung{};
    void carry_out(Practice&) const { ++*rung; }
};

std::size_t rung = 0;

void add_bell_rows(const MenuState& s, const MenuContext&, Rows& rows) {
    rows.push_back({.look = {.label = "Bells", .value = text(s.profile), .adjustable = true},
                    .turn = [](const RowPress& press, int way) {
                        press.state.profile = turned(press.state.profile, 10, way);
                    }});
    rows.push_back({.look = {.label = "Ring"},
                    .confirm = [](const RowPress& press) { ask_match(press.state, RingBells{&rung}); }});
}

/// A page that only this test has. The registration is all that a new page needs.
const PageRegistration bells_page{{
    .name = "bells",
    .title = [](const MenuState&, const MenuContext&) { return std::string("Bells of the tower"); },
    .add_rows = add_bell_rows,
    .reset =
        [](MenuState& s) {
            s.profile = usual_bells;
            return std::string("bells");
        },
}};
/// A page with a row that opens bells_page.
const PageRegistration tower_page{{
    .name = "tower",
    .title = [](const MenuState&, const MenuContext&) { return std::string("Tower"); },
    .add_rows = [](const MenuState&, const MenuContext&,
                   Rows& rows) { rows.push_back(link_to("bells", "Bells", "Opens the bells.")); },
}};

std::vector<std::string> labels_of(const MenuState& s) {
    std::vector<std::string> labels;
    for (const auto& row : picture_of(s, context()).rows) labels.push_back(row.label);
    return labels;
}

TEST(MenuSeams, APageThatOnlyATestHasOpensTurnsResetsAndGoesBack) {
    auto s = opened({}, "tower");
    EXPECT_EQ(labels_of(s), (std::vector<std::string>{"Bells", "Back"}));
    s = choose(s, "Bells");
    EXPECT_EQ(picture_of(s, context()).title, "Bells of the tower");
    EXPECT_EQ(labels_of(s), (std::vector<std::string>{"Bells", "Ring", "Reset to defaults", "Back"}));
    s = choose(s, "Bells", Kind::left);
    EXPECT_EQ(value_of(s, "Bells"), "9");
    s = choose(s, "Bells");
    EXPECT_EQ(value_of(s, "Bells"), "0") << "a press turns on";
    s = choose(s, "Reset to defaults");
    EXPECT_EQ(value_of(s, "Bells"), "2");
    EXPECT_EQ(s.note, "bells reset to defaults");
    EXPECT_EQ(window_title(s, context()), "Thaum: Bells of the tower / Reset to defaults");
    EXPECT_EQ(picture_of(with(s, Kind::back), context()).title, "Tower");
}

TEST(MenuSeams, ItsRequestReachesTheRange) {
    const auto data = game::load_range(THAUM_SOURCE_DIR "/assets", {});
    ASSERT_TRUE(data) << data.error().message;
    Practice practice(*data, {input::DeviceSpec{}}, game::DummyKind::still, 1);
    const auto s = choose(opened({}, "bells"), "Ring");
    ASSERT_EQ(s.request, MenuRequest::ask_match);
    MatchRequests requests;
    requests.ask(s.match_request);
    std::uint32_t buttons = 0;
    requests.carry_out({&practice, buttons});
    EXPECT_EQ(rung, 1U);
}

TEST(MenuSeams, EveryRowThatOpensAPageFindsIt) {
    std::set<std::string_view> names, opened_ones;
    auto offered = context();
    offered.mutators = {{"fog", "Fog"}};
    for (const auto& page : registry_of<game::Page>().all()) names.insert(page.name);
    for (const auto name : names)
        for (const auto& row : rows_of(opened({}, name), offered))
            if (!row.opens.empty()) opened_ones.insert(row.opens);
    for (const auto name : opened_ones) EXPECT_TRUE(names.contains(name)) << name;
    // No row opens these three pages: a session opens the pages start and pause, and this test the page
    // tower.
    for (const auto name : names)
        EXPECT_TRUE(opened_ones.contains(name) || name == page_name::start || name == page_name::pause ||
                    name == "tower")
            << name << " is never opened";
}

}  // namespace
}  // namespace thaum::game::menu_tests
