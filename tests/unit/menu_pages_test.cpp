// Tests of menus: the pages of settings, random events on all pages, the help texts of rows, and where rows
// are drawn and clicked.
#include <utility>

#include "core/random.h"
#include "core/text.h"
#include "game/menu/page.h"
#include "render/font.h"
#include "unit/menu_rig.h"
#include "unit/overlay_items.h"

namespace thaum::game::menu_tests {
namespace {

// ---- pages of settings ------------------------------------------------------------------------------------

/// Indices in all_settings() of the settings that a page shows.
std::vector<std::size_t> settings_of(SettingPage page) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < all_settings().size(); ++i)
        if (all_settings()[i].page == page) found.push_back(i);
    return found;
}

/// Changes each row of the page and expects that its setting changes, and no other.
void expect_rows_change(const MenuState& page, const std::vector<std::size_t>& settings) {
    for (std::size_t row = 0; row < settings.size(); ++row) {
        const MenuEvent less{.kind = Kind::left, .device = keyboard, .row = row};
        const MenuEvent more{.kind = Kind::right, .device = keyboard, .row = row};
        auto changed = step(page, more, context());
        // The value was already at the end of its range, so it is changed the other way.
        if (changed.settings == page.settings) changed = step(page, less, context());
        const auto edits = changes(page.settings, changed.settings);
        const auto& setting = all_settings()[settings[row]];
        ASSERT_EQ(edits.size(), 1U) << setting.key;
        EXPECT_EQ(edits[0].key, setting.key);
        EXPECT_EQ(edits[0].table, "");
    }
}

TEST(SettingsPage, EveryRowChangesItsSettingAndNoOther) {
    const auto s = choose(start_page(), "Settings");
    EXPECT_EQ(picture_of(s, context()).rows.size(), settings_of(SettingPage::main).size() + 5)
        << "sound, a player's page, forces and body, reset and back";
    expect_rows_change(s, settings_of(SettingPage::main));
    EXPECT_EQ(choose(s, "Back").pages.size(), 1U);
}

TEST(SoundPage, EveryRowChangesItsSettingAndNoOther) {
    const auto s = choose(choose(start_page(), "Settings"), "Sound");
    EXPECT_EQ(picture_of(s, context()).rows.size(), settings_of(SettingPage::sound).size() + 2)
        << "reset and back";
    expect_rows_change(s, settings_of(SettingPage::sound));
    EXPECT_EQ(choose(s, "Back").pages.size(), 2U);
}

TEST(SettingsPage, ResetsItsOwnValuesAndNoOthers) {
    auto s = choose(start_page(), "Settings");
    s.settings.players[0].name = "Zoë";
    s.settings.last.match = "standard";
    s.settings.cauldron[1][0].on = false;
    s.settings.session[0].clear();
    const auto kept = s.settings;
    for (const auto& setting : all_settings())
        change(setting, s.settings, setting.page == SettingPage::sound ? -1 : 1);
    EXPECT_NE(s.settings, kept);
    s = choose(s, "Reset to defaults");
    EXPECT_NE(s.settings, kept) << "sounds have a page of their own";
    s = choose(choose(s, "Sound"), "Reset to defaults");
    EXPECT_EQ(s.settings, kept);
    EXPECT_EQ(s.note, "settings of this page reset to defaults");
}

// ---- pages of a player's own settings ---------------------------------------------------------------------

TEST(PlayerPage, EveryRowChangesTheSettingOfThePlayerShown) {
    auto s = player_page();
    EXPECT_EQ(value_of(s, "Whose settings"), "Ember");
    for (const std::size_t player : {0UL, 1UL}) {
        for (const auto& setting : player_settings()) {
            if (setting.page != SettingPage::main) continue;
            auto changed = choose(s, setting.label, Kind::right);
            if (changed.settings == s.settings) changed = choose(s, setting.label, Kind::left);
            const auto edits = changes(s.settings, changed.settings);
            ASSERT_EQ(edits.size(), 1U) << setting.key;
            EXPECT_EQ(edits[0].key, setting.key);
            EXPECT_EQ(edits[0].table, player_tables[player]);
        }
        s = choose(s, "Whose settings", Kind::right);
    }
}

TEST(PlayerPage, ResetsThePlayerShown) {
    auto s = player_page();
    s.settings.players[0].name = s.settings.players[1].name = "Zoë";
    s = choose(choose(s, "Whose settings", Kind::right), "Reset to defaults");
    EXPECT_EQ(s.settings.players[0].name, "Zoë");
    EXPECT_EQ(s.settings.players[1], PlayerSettings{});
    EXPECT_EQ(value_of(s, "Whose settings"), "Tide");
}

TEST(PlayerPage, TellsOfARowThatWaitsForTheNextMatch) {
    const auto note_at = [](MenuState s, std::string_view row) {
        return picture_of(choose(std::move(s), row, Kind::right), context()).note;
    };
    auto during = opened(start_page(), "pause");
    during.pages.push_back({"player", 0, 0});
    EXPECT_EQ(note_at(during, "Cast without a button"),
              "Applies from the next match, or after \"Restart the match\"");
    EXPECT_EQ(note_at(during, "Mouse speed"), "") << "acts at once";
    auto before = opened(start_page(), "start");
    before.pages.push_back({"player", 0, 0});
    EXPECT_EQ(note_at(before, "Cast without a button"), "") << "the next match is the first one";
}

TEST(PlayerPage, ANameStandsInTheSeatsAndOnThePages) {
    auto s = choose(player_page(), "Name");
    for (const char32_t c : std::u32string(U"Zoë"))
        s = step(s, {.kind = Kind::character, .device = keyboard, .typed = c}, context());
    EXPECT_EQ(picture_of(s, context()).hint, "type the name    Enter: take it    Esc: leave it as it was");
    EXPECT_EQ(with(s, Kind::down).typing, s.typing) << "nothing else happens meanwhile";
    s = with(s, Kind::confirm);
    EXPECT_EQ(value_of(s, "Whose settings"), "Zoë");
    EXPECT_EQ(value_of(s, "Name"), "Zoë");
    s = with(opened(s, "start"), Kind::other, first_pad);
    EXPECT_EQ(picture_of(s, context()).seats[0].head, "Zoë: joined");
    EXPECT_EQ(picture_of(s, context()).seats[1].head, "Tide");
}

// ---- pages of forces and of effects on the body -----------------------------------------------------------

TEST(MixerPage, EveryRowChangesItsValueOfThePlayerShown) {
    auto s = mixer_page();
    EXPECT_EQ(value_of(s, "Who feels it"), "Ember");
    for (const std::size_t player : {0UL, 1UL}) {
        const auto expect_one = [&](std::string_view row, std::string_view table, std::string_view key) {
            auto changed = choose(s, row, Kind::right);
            if (changed.settings == s.settings) changed = choose(s, row, Kind::left);
            const auto edits = changes(s.settings, changed.settings);
            ASSERT_EQ(edits.size(), 1U) << row;
            EXPECT_EQ(edits[0].key, key);
            EXPECT_EQ(edits[0].table, table);
        };
        for (const auto& setting : player_settings())
            if (setting.page == SettingPage::mixer)
                expect_one(setting.label, player_tables[player], setting.key);
        for (const auto purpose : context().body)
            expect_one(text("Body: ", label_of(purpose)), body_tables[player],
                       tactile::purpose_names()[static_cast<std::size_t>(purpose)]);
        s = choose(s, "Who feels it", Kind::right);
    }
}

TEST(MixerPage, APressOnAFaderOfTheBodyAsksToPlayItsEffect) {
    auto s = choose(mixer_page(), "Who feels it", Kind::right);
    EXPECT_FALSE(s.tries);
    s = choose(s, "Body: Falls");
    ASSERT_TRUE(s.tries);
    EXPECT_EQ(s.tries->player, 1U);
    EXPECT_EQ(s.tries->purpose, tactile::Purpose::fall);
    EXPECT_EQ(s.settings, mixer_page().settings) << "a press changes nothing";
    EXPECT_FALSE(with(s, Kind::down).tries) << "it is asked once";
}

TEST(MixerPage, APressOnAFaderOfTheForcesAsksForItOnTheRange) {
    auto s = choose(mixer_page(), "Recoil of the wands");
    EXPECT_EQ(s.note, "in the pause of the range a press lets you feel it");
    EXPECT_EQ(s.settings, Settings{});
    auto range = context();
    range.practice = true;
    const auto row = row_named(s, "Carried weight");
    s = step(s, {.kind = Kind::confirm, .device = keyboard, .row = row}, range);
    EXPECT_EQ(s.request, MenuRequest::ask_match);
    const auto felt = s.match_request.as<FeelForce>();
    ASSERT_TRUE(felt);
    EXPECT_EQ(felt->fader, input::HandFader::weight);
    EXPECT_EQ(s.settings, Settings{});
}

TEST(MixerPage, PresetsSetAllThatIsFeltAndNothingElse) {
    auto s = mixer_page();
    s.settings.players[0].name = "Zoë";
    s.settings.players[0].jacket = "bhaptics";
    s.settings.players[0].sensitivity = 2;
    const auto before = s.settings;
    EXPECT_EQ(value_of(s, "Preset"), "gentle");
    s = choose(s, "Preset", Kind::right);
    EXPECT_EQ(value_of(s, "Preset"), "full");
    EXPECT_EQ(s.settings.players[0].force, full_force);
    EXPECT_EQ(s.settings.players[0].body.of(tactile::Purpose::walk), 1);
    s = choose(s, "Preset", Kind::right);
    EXPECT_EQ(value_of(s, "Preset"), "silent");
    EXPECT_EQ(force_percent_of(s.settings.players[0]), 0U);
    EXPECT_EQ(s.settings.players[0].rumble, 0);
    for (const double share : s.settings.players[0].body.values) EXPECT_EQ(share, 0);
    EXPECT_EQ(s.settings.players[1], before.players[1]);
    s = choose(s, "Body: Hits", Kind::right);
    EXPECT_EQ(value_of(s, "Preset"), "own");
    s = choose(s, "Preset", Kind::right);
    EXPECT_EQ(s.settings, before) << "own values come before the first preset";
    s = choose(choose(s, "Preset", Kind::left), "Reset to defaults");
    EXPECT_EQ(s.settings, before);
}

TEST(MixerPage, AProfileIsSavedUnderATypedNameAndLoaded) {
    auto s = choose(mixer_page(), "Preset", Kind::right);
    s = choose(s, "Save as a profile");
    ASSERT_TRUE(s.typing);
    EXPECT_EQ(value_of(s, "Save as a profile"), "Ember_");
    EXPECT_EQ(value_of(player_page(), "Name"), "none");
    s = with(step(s, {.kind = Kind::character, .device = keyboard, .typed = U'2'}, context()), Kind::confirm);
    ASSERT_TRUE(s.saves);
    EXPECT_EQ(s.saves->name, "Ember2");
    EXPECT_EQ(s.saves->felt.force, full_force);
    EXPECT_EQ(s.settings.players[0].name, "") << "the player keeps the name";
    EXPECT_FALSE(with(s, Kind::down).saves) << "it is asked once";

    EXPECT_EQ(choose(mixer_page(), "Load a profile").note, "no profile was saved yet");
    auto saved = context();
    saved.profiles = {feel_presets()[2], *s.saves};
    auto other = choose(mixer_page(), "Who feels it", Kind::right);
    const auto rows = picture_of(other, saved).rows;
    const auto row = row_named(other, "Load a profile");
    EXPECT_EQ(rows[row].value, "silent");
    other = step(other, {.kind = Kind::right, .device = keyboard, .row = row}, saved);
    EXPECT_EQ(other.settings, Settings{}) << "a profile is loaded by a press";
    other = step(other, {.kind = Kind::confirm, .device = keyboard, .row = row}, saved);
    EXPECT_TRUE(feels_alike(feel_of(other.settings, 1), *s.saves));
    EXPECT_EQ(other.settings.players[0], PlayerSettings{});
}

TEST(MixerPage, TheJacketIsShownAndNoPressOrResetChangesIt) {
    auto s = mixer_page();
    EXPECT_EQ(value_of(s, "Jacket"), "none");
    s.settings.players[0].jacket = "osc:vest.local:1027";
    EXPECT_EQ(value_of(s, "Jacket"), "osc:vest.local:1027");
    for (const auto kind : {Kind::left, Kind::right, Kind::confirm})
        EXPECT_EQ(choose(s, "Jacket", kind).settings, s.settings);
    EXPECT_EQ(choose(s, "Reset to defaults").settings, s.settings);
    s.settings.players[0].jacket = "osc:a.very.long.name.of.a.vest:1027";
    EXPECT_EQ(value_of(s, "Jacket"), "osc:a.very.long.name....");
}

// ---- the page of the cauldron's forces --------------------------------------------------------------------

constexpr std::string_view cauldron_row = "Cauldron feedback";

TEST(CauldronPage, EachSourceHasAFaderAndASwitchForEachPlayer) {
    const auto fresh = cauldron_page();
    EXPECT_EQ(picture_of(fresh, context()).title, "Cauldron feedback");
    for (std::size_t player = 0; player < 2; ++player) {
        for (std::size_t i = 0; i < haptics::fluid_modes.size(); ++i) {
            const auto label = label_of_fader(i);
            auto s = fresh;
            for (std::size_t p = 0; p < player; ++p) s = choose(s, "Whose hand", Kind::right);
            s = choose(choose(s, label, Kind::left), label, Kind::left);
            EXPECT_EQ(value_of(s, label), "90 %");
            EXPECT_EQ(picture_of(s, context()).rows[row_named(s, label)].help, effect_of_fader(i));
            s = choose(s, label);
            EXPECT_EQ(value_of(s, label), "off (90 %)");
            EXPECT_TRUE(picture_of(s, context()).rows[row_named(s, label)].dim);
            const auto name = std::string(haptics::fluid_modes[i].name);
            const std::string table(cauldron_tables[player]);
            EXPECT_EQ(changes({}, s.settings),
                      (std::vector<SettingEdit>{{table, name, "0.9"}, {table, "off", '"' + name + '"'}}));
            s = choose(s, label, Kind::right);
            EXPECT_EQ(value_of(s, label), "off (95 %)") << "a fader that is moved stays off";
            s = choose(s, label);
            EXPECT_EQ(value_of(s, label), "95 %");
            EXPECT_EQ(choose(s, "Reset to defaults").settings, Settings{});
        }
    }
    EXPECT_EQ(choose(fresh, "Back").pages.size(), 3U);
    const auto tide = choose(mixer_page(), "Who feels it", Kind::right);
    EXPECT_EQ(value_of(choose(tide, cauldron_row), "Whose hand"), "Tide") << "the player shown before";
}

TEST(MixerPage, OpensForThePlayerWhoAsks) {
    auto s = with(with(start_page(), Kind::other, first_pad), Kind::other, keyboard);
    s = choose(opened(s, "pause"), "Settings");
    const auto row = row_named(s, "Forces and body");
    const auto opened_by = [&](const Device& device) {
        return value_of(step(s, {.kind = Kind::confirm, .device = device, .row = row}, context()),
                        "Who feels it");
    };
    EXPECT_EQ(opened_by(first_pad), "Ember");
    EXPECT_EQ(opened_by(keyboard), "Tide");
    EXPECT_EQ(opened_by(second_pad), "Ember") << "a device without a seat opens the first page";
}

// ---- random events on all pages ---------------------------------------------------------------------------

/// After random events the state can still be drawn, no control is bound to two conflicting actions, and the
/// settings can be written.
TEST(MenuUnderWildHands, StaysWhole) {
    Random dice = random_stream(7, 1);
    const auto roll = [&](std::uint64_t n) { return static_cast<int>(dice.next() % n); };
    auto s = start_page();
    for (int i = 0; i < 20000; ++i) {
        MenuEvent event{.kind = static_cast<Kind>(roll(14)),
                        .device = {static_cast<DeviceKind>(roll(3)), roll(4)}};
        if (roll(4) == 0) event.row = static_cast<std::size_t>(roll(60));
        if (event.kind == Kind::control) {
            const auto source = static_cast<Control::Source>(roll(5));
            event.control = {source, 0, roll(2) * 2 - 1};
            if (source == Control::Source::key)
                event.control = key(std::string(1, static_cast<char>('a' + roll(26))));
            if (source == Control::Source::pad_button) event.control = {source, roll(15), 0};
            if (source == Control::Source::mouse_button) event.control = {source, roll(5), 0};
            if (source == Control::Source::pad_axis) event.control.code = roll(6);
        }
        if (event.kind == Kind::character) event.typed = static_cast<char32_t>(roll(0x600));
        s = step(std::move(s), event, context());
        ASSERT_FALSE(s.pages.empty());
        const auto picture = picture_of(s, context());
        ASSERT_LT(picture.cursor, picture.rows.size());
        ASSERT_TRUE(!s.seats[0] || s.seats[0] != s.seats[1]);
        if (roll(400) == 0) s = opened(std::move(s), roll(2) == 0 ? "start" : "pause");
    }
    const auto edited = edit_settings("version = 1\n", "s", changes({}, s.settings)).value();
    EXPECT_EQ(changes(parse_settings(edited, "s").value(), s.settings), std::vector<SettingEdit>{});
    for (std::size_t action = 0; action < input::actions; ++action) {
        auto again = s.settings;
        const auto controls = controls_of(again, {0, action});
        for (const auto& control : controls)
            EXPECT_TRUE(assign(again, {0, action}, control).empty()) << action;
    }
}

// ---- how pages are drawn and clicked ----------------------------------------------------------------------

/// A state for each page of the menu.
std::vector<MenuState> all_pages() {
    auto pause = opened({}, "pause");
    pause.head = "Pad 1 of Ember and pad 2 of WWWWWWWWWWWWWWWW are not plugged in";
    pause.line = "plug it in and press a button on it or on a free pad, or Keypad 0 for half of the keyboard";
    std::vector<MenuState> all{start_page(),
                               with(with(start_page(), Kind::other, first_pad), Kind::other, keyboard),
                               pause,
                               choose(start_page(), "Controls"),
                               choose(start_page(), "Settings"),
                               player_page(),
                               choose(player_page(), "Name"),
                               mixer_page(),
                               choose(mixer_page(), "Save as a profile"),
                               cauldron_page(),
                               choose(choose(start_page(), "Controls"), "Set up Stick of wood and string")};
    for (std::size_t sheet = 0; sheet < sheets; ++sheet) all.push_back(bindings_of(label_of_sheet(sheet)));
    return all;
}

TEST(MenuHelp, EveryRowOfEveryPageSaysWhatItDoesInOneSentence) {
    auto range = context();
    range.practice = true;
    range.arenas.push_back({"the_well", "The Well"});
    range.wands[0] = "Bolt";
    for (const auto& state : all_pages()) {
        for (const auto& row : picture_of(state, range).rows) {
            EXPECT_TRUE(row.help.ends_with('.')) << row.label << ": " << row.help;
            EXPECT_LE(row.help.size(), 80U) << row.help;
            EXPECT_GE(row.help.size(), 6U) << row.label;
        }
    }
}

struct Box {
    fvec2 low, high;
};

/// Whether two boxes overlap by more than the empty edge of a line.
bool overlap(const Box& a, const Box& b) {
    const auto shared = glm::min(a.high, b.high) - glm::max(a.low, b.low);
    return shared.x > 1 && shared.y > 0.25F * std::min(a.high.y - a.low.y, b.high.y - b.low.y);
}

std::vector<Box> boxes_of_text(const render::Overlay& overlay, render::Font& font) {
    std::vector<Box> boxes;
    const render::TextItem* before = nullptr;
    for (const auto& item : overlay.items) {
        const auto* words = std::get_if<render::TextItem>(&item);
        const auto* shade = std::exchange(before, words);
        if (words == nullptr) continue;
        // The dark copy below a text overlaps it on purpose.
        if (shade != nullptr && shade->text == words->text) boxes.pop_back();
        const auto size = font.measure(words->text, words->size);
        const float share = words->align == render::Align::left    ? 0
                            : words->align == render::Align::right ? 1
                                                                   : 0.5F;
        const fvec2 low = words->position - fvec2(share * size.x, 0);
        boxes.push_back({low, low + size});
    }
    return boxes;
}

TEST(MenuDrawing, WordsStayInTheWindowAtEverySize) {
    auto font = render::Font::load().value();
    auto states = all_pages();
    states.push_back(press(choose(bindings_of("Mouse and keyboard"), "Fire"), key("kp_8")));
    for (const auto& state : states) {
        for (const render::Size size :
             {render::Size{1280, 720}, {640, 480}, {320, 200}, {3840, 2160}, {500, 900}}) {
            for (const double scale : {1.0, 1.75, 2.5}) {
                render::Overlay overlay;
                add_menu(overlay, picture_of(state, context()), size, scale);
                auto boxes = boxes_of_text(overlay, font);
                for (std::size_t a = 0; a < boxes.size(); ++a) {
                    for (std::size_t b = a + 1; b < boxes.size(); ++b)
                        EXPECT_FALSE(overlap(boxes[a], boxes[b])) << size.width << ' ' << scale;
                }
                for (const auto* mark : game::hud_tests::items_of<render::TriangleItem>(overlay))
                    boxes.push_back({glm::min(mark->a, glm::min(mark->b, mark->c)),
                                     glm::max(mark->a, glm::max(mark->b, mark->c))});
                for (const auto& box : boxes) {
                    EXPECT_GE(box.low.x, 0) << size.width << ' ' << scale;
                    EXPECT_GE(box.low.y, 0) << size.width << ' ' << scale;
                    EXPECT_LE(box.high.x, size.width + 3) << size.width << ' ' << scale;
                    EXPECT_LE(box.high.y, size.height + 3) << size.width << ' ' << scale;
                }
            }
        }
    }
}

TEST(MenuDrawing, PointingAtARowOfALongPageLeavesItWhereItIs) {
    constexpr render::Size size{1280, 720};
    auto s = mixer_page();
    const auto row_at = [&](fvec2 point) { return game::place_at(picture_of(s, context()), size, 2, point); };
    for (int i = 0; i < 6; ++i) s = with(s, Kind::down);  // scrolls the page
    int pointed = 0;
    for (float y = 0; y < 720; y += 7) {
        const fvec2 point(640, y);
        const auto before = row_at(point);
        if (!before) continue;
        s = step(s, {.kind = Kind::point, .device = keyboard, .row = before->row}, context());
        const auto after = row_at(point);
        ASSERT_TRUE(after);
        EXPECT_EQ(after->row, before->row) << y;
        EXPECT_EQ(picture_of(s, context()).cursor, before->row);
        ++pointed;
    }
    EXPECT_GT(pointed, 20);
    const auto shown_before = row_at({640, 400});
    s = with(s, Kind::down);
    s = with(s, Kind::down);
    s = with(s, Kind::down);
    EXPECT_NE(row_at({640, 400})->row, shown_before->row) << "keys scroll the page";
}

/// Size of the text with these words, in a menu at 640 x 480 and 250 % text size (px).
float size_of(const game::MenuPicture& picture, std::string_view words) {
    render::Overlay overlay;
    add_menu(overlay, picture, {640, 480}, 2.5);
    if (const auto* one = game::hud_tests::text_item(overlay, words)) return one->size;
    ADD_FAILURE() << words << " is not shown";
    return 0;
}

TEST(MenuDrawing, AMatchStaysReadableInASmallWindow) {
    auto choices = context();
    choices.rules = {{"quick", "quick: first to 3, 4:00"},
                     {"standard", "standard: best of 3, first to 5, 6:00"}};
    for (const auto& [rules, share] : {std::pair(0UL, 1.0F), {1UL, 0.75F}}) {
        auto s = start_page();
        s.rules = rules;
        const auto picture = picture_of(s, choices);
        const float usual = size_of(picture, "Bot");
        EXPECT_NEAR(size_of(picture, "Match"), usual, 0.01);
        EXPECT_GE(size_of(picture, choices.rules[rules].label) + 0.01F, share * usual) << rules;
    }
}

/// In every row of every page, label and value are at least 0.6 times as large as in a short row.
TEST(MenuDrawing, LabelsAndValuesStayReadableInASmallWindow) {
    int rows = 0;
    for (auto s : all_pages()) {
        for (std::size_t row = 0; row < rows_of(s, context()).size(); ++row) {
            s.pages.back().cursor = row;
            auto picture = picture_of(s, context());
            const auto [label, value] = std::pair(picture.rows[row].label, picture.rows[row].value);
            const float of_label = size_of(picture, label);
            const float of_value = value.empty() ? of_label : size_of(picture, value);
            picture.rows[row] = {.label = "Bot"};
            const float usual = size_of(picture, "Bot");
            EXPECT_GE(std::min(of_label, of_value), 0.6F * usual) << label << ": " << value;
            ++rows;
        }
    }
    EXPECT_GT(rows, 150);
}

TEST(MenuDrawing, ArrowsStayWhileAValueChanges) {
    auto choices = context();
    choices.rules = {{"quick", "quick: first to 3"}, {"standard", "standard: best of 3, first to 5, 6:00"}};
    std::vector<float> less;
    for (auto s : {start_page(), choose(start_page(), "Match", Kind::right)}) {
        s.pages.back().cursor = 2;
        const auto picture = picture_of(s, choices);
        for (float y = 0; y < 480; ++y) {
            for (float x = 0; x < 640; ++x) {
                const auto place = game::place_at(picture, {640, 480}, 2.5, {x, y});
                if (!place || place->row != row_named(s, "Match") || place->part != game::MenuPart::less)
                    continue;
                less.push_back(x);
                x = 640;
                y = 480;
            }
        }
    }
    ASSERT_EQ(less.size(), 2U);
    EXPECT_EQ(less[0], less[1]);
    EXPECT_LT(less[0], 320) << "the value needs more than half of the row";
}

/// Tries points all over the window. Each visible row is found where it is drawn, in order, and the chosen
/// row is always visible.
TEST(MenuDrawing, RowsAreFoundWhereTheyAreDrawn) {
    auto s = bindings_of("Mouse and keyboard");
    for (const double scale : {1.0, 2.5}) {
        for (const std::size_t cursor : {0UL, 15UL, 31UL}) {
            s.pages.back().cursor = cursor;
            const auto picture = picture_of(s, context());
            std::vector<std::size_t> seen;
            for (float y = 0; y < 480; ++y) {
                const auto place = game::place_at(picture, {640, 480}, scale, {320, y});
                if (place && (seen.empty() || seen.back() != place->row)) seen.push_back(place->row);
            }
            ASSERT_GE(seen.size(), 4U);
            EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
            EXPECT_EQ(seen.back() - seen.front() + 1, seen.size());
            EXPECT_NE(std::find(seen.begin(), seen.end(), picture.cursor), seen.end());
        }
    }
    EXPECT_FALSE(game::place_at(picture_of(s, context()), {640, 480}, 1, {2, 240}));
    EXPECT_FALSE(game::place_at({}, {640, 480}, 1, {320, 240}));
}

TEST(MenuDrawing, ArrowsAroundAValueAreLessAndMore) {
    const auto picture = picture_of(choose(start_page(), "Settings"), context());
    int less = 0, more = 0, row = 0;
    float top = 0;
    while (top < 720 && !game::place_at(picture, {1280, 720}, 1, {640, top})) ++top;
    for (float x = 0; x < 1280; ++x) {
        const auto place = game::place_at(picture, {1280, 720}, 1, {x, top + 8});
        if (!place) continue;
        less += place->part == game::MenuPart::less ? 1 : 0;
        more += place->part == game::MenuPart::more ? 1 : 0;
        row += place->part == game::MenuPart::row ? 1 : 0;
    }
    EXPECT_EQ(less, 30);
    EXPECT_EQ(more, 30);
    EXPECT_GT(row, 400);
}

}  // namespace
}  // namespace thaum::game::menu_tests
