// Tables of all settings: keys, labels, ranges and pages, with functions that work on any setting.
#include <algorithm>
#include <cmath>

#include "core/config.h"
#include "core/text.h"
#include "game/settings/settings.h"

namespace thaum::game::inline settings {

const std::vector<std::string_view>& force_names() {
    static const auto names = [] {
        std::vector<std::string_view> all;
        for (const auto& choice : force_choices) all.push_back(choice.name);
        return all;
    }();
    return names;
}

namespace {

ChoiceOf<Settings> quality_setting() {
    std::vector<std::string_view> names{"auto"};
    names.insert(names.end(), render::quality_names.begin(), render::quality_names.end());
    return {std::move(names),
            [](const Settings& s) { return s.quality ? static_cast<std::size_t>(*s.quality) + 1 : 0; },
            [](Settings& s, std::size_t i) {
                s.quality.reset();
                if (i > 0) s.quality = static_cast<render::Quality>(i - 1);
            }};
}

ChoiceOf<PlayerSettings> heard_setting() {
    return {{"off", "important", "all"},
            [](const PlayerSettings& p) { return static_cast<std::size_t>(p.heard); },
            [](PlayerSettings& p, std::size_t i) { p.heard = static_cast<HeardWish>(i); }};
}

ChoiceOf<PlayerSettings> felt_groups_setting() {
    return {{"music", "effects", "both"},
            [](const PlayerSettings& p) { return static_cast<std::size_t>(p.jacket_sound_of); },
            [](PlayerSettings& p, std::size_t i) { p.jacket_sound_of = static_cast<FeltGroups>(i); }};
}

ChoiceOf<PlayerSettings> prompts_setting() {
    return {{prompt_wishes.begin(), prompt_wishes.end()},
            [](const PlayerSettings& p) { return static_cast<std::size_t>(p.prompts); },
            [](PlayerSettings& p, std::size_t i) { p.prompts = static_cast<PromptWish>(i); }};
}

ChoiceOf<PlayerSettings> force_setting() {
    return {force_names(), [](const PlayerSettings& p) { return p.force; },
            [](PlayerSettings& p, std::size_t i) { p.force = i; }};
}

std::vector<Setting> general_settings() {
    using Number = NumberOf<Settings>;
    using Flag = FlagOf<Settings>;
    return {
        {"split", "Split", "Puts the two views one above the other, or side by side.",
         ChoiceOf<Settings>{
             {"top_bottom", "side_by_side"},
             [](const Settings& s) { return s.split == render::Split::top_bottom ? 0UL : 1UL; },
             [](Settings& s, std::size_t i) {
                 s.split = i == 0 ? render::Split::top_bottom : render::Split::side_by_side;
             }}},
        {"fullscreen", "Full screen", "Fills the whole screen, or plays in a window.",
         Flag{&Settings::fullscreen}},
        {"fov_deg", "Field of view", "Shows more to the sides, and all of it smaller.",
         Number{&Settings::fov, 60, 130, 5, 1, "\u00B0"}},
        {"text_scale", "Text size", "Makes words and signs larger.",
         Number{&Settings::text_scale, 1, 2.5, 0.25, 100, " %"}},
        {"quality", "Picture quality", "Draws finer pictures; auto chooses what draws 30 pictures a second.",
         quality_setting()},
        {"bloom", "Bloom at high quality", "Lets bright light shine beyond its edges.",
         Flag{&Settings::bloom}},
        {"frames_per_second", "Frame rate limit", "Draws at most this many pictures a second.",
         Number{&Settings::frames_per_second, 10, 360, 5, 1, ""}},
        {"countdown_s", "Countdown", "Counts down these seconds before a match begins.",
         WholeOf<Settings>{&Settings::countdown_s, 0, 10, 1, " s"}, true},
        {"logs_kept", "Recordings to keep", "Keeps this many recorded matches, and deletes older ones.",
         WholeOf<Settings>{&Settings::logs_kept, 1, 100000, 10, ""}},
    };
}

std::vector<Setting> sound_settings() {
    using Number = NumberOf<Settings>;
    using Flag = FlagOf<Settings>;
    return {
        {"sound_master", "All sounds", "Makes everything louder or softer.",
         Number{&Settings::sound_master, 0, 1, 0.1, 100, " %"}, false, SettingPage::sound},
        {"sound_effects", "Effects", "Makes the sounds of the match louder or softer.",
         Number{&Settings::sound_effects, 0, 1, 0.1, 100, " %"}, false, SettingPage::sound},
        {"sound_music", "Music", "Makes the music louder or softer.",
         Number{&Settings::sound_music, 0, 1, 0.1, 100, " %"}, false, SettingPage::sound},
        {"sound_interface", "Menus and signals",
         "Makes the sounds of menus and of the clock louder or softer.",
         Number{&Settings::sound_interface, 0, 1, 0.1, 100, " %"}, false, SettingPage::sound},
        {"headphones", "Headphones", "Lets one player hear above, below and behind; for headphones only.",
         Flag{&Settings::headphones}, false, SettingPage::sound},
        {"ears_apart", "Players apart", "Gives player 1 the left loudspeaker and player 2 the right one.",
         Flag{&Settings::ears_apart}, false, SettingPage::sound},
    };
}

}  // namespace

std::span<const Setting> all_settings() {
    static const std::vector<Setting> settings = [] {
        auto all = general_settings();
        const auto sounds = sound_settings();
        all.insert(all.end(), sounds.begin(), sounds.end());
        return all;
    }();
    return settings;
}

namespace {

std::vector<PlayerSetting> seen_and_aimed_settings() {
    using Number = NumberOf<PlayerSettings>;
    using Flag = FlagOf<PlayerSettings>;
    return {
        {"captions", "Captions", "Tells in words what the hand feels, the brew does and gifts give.",
         Flag{&PlayerSettings::captions}},
        {"heard", "Heard and felt in words", "Tells in words what is heard and felt, and from where.",
         heard_setting()},
        {"figure", "Figure of the body", "Shows where a hit, a fall or the heart is felt.",
         Flag{&PlayerSettings::figure}},
        {"prompts", "Control prompts", "Names the control for what can be done at this place.",
         prompts_setting()},
        {"sensitivity", "Mouse speed", "Turns the view further for the same way of the mouse.",
         Number{&PlayerSettings::sensitivity, 0.05, 20, 0.05, 1, ""}},
        {"invert_y", "Invert look (vertical)", "Looks down when mouse or stick are pushed away.",
         Flag{&PlayerSettings::invert_y}},
        {"turn_deg_per_s", "Stick and arrow speed", "Turns the view faster with a stick or the arrow keys.",
         Number{&PlayerSettings::turn_deg_per_s, 20, 1000, 10, 1, "\u00B0/s"}, true},
        {"turn_ramp_s", "Slow start of turns",
         "Begins a turn by stick or arrows slowly, so that a short press turns a little.",
         Number{&PlayerSettings::turn_ramp_s, 0, 0.5, 0.05, 1, " s"}},
        {"stick_dead_zone", "Stick dead zone", "Ignores small pushes of a pad's sticks.",
         Number{&PlayerSettings::stick_dead_zone, 0, 0.9, 0.05, 100, " %"}},
        {"stick_curve", "Stick curve", "Turns finer near the stick's middle, or evenly at 0 %.",
         Number{&PlayerSettings::stick_curve, 0, 1, 0.1, 100, " %"}},
        {"aim_assist_pad", "Aim assist: pad", "Slows turns at the foe, and turns near misses into hits.",
         Number{&PlayerSettings::aim_assist_pad, 0, 1, 0.1, 100, " %"}, true},
        {"aim_assist_keys", "Aim assist: keypad",
         "Slows turns by keypad and arrows at the foe, and turns near misses into hits.",
         Number{&PlayerSettings::aim_assist_keys, 0, 1, 0.1, 100, " %"}, true},
        {"aim_assist_mouse", "Aim assist: mouse",
         "Slows turns by mouse at the foe, and turns near misses into hits.",
         Number{&PlayerSettings::aim_assist_mouse, 0, 1, 0.1, 100, " %"}, true},
        {"free_casting", "Cast without a button",
         "Casts a spell when the hand draws its gesture, although Trace is not held.",
         Flag{&PlayerSettings::free_casting}, true},
    };
}

std::vector<PlayerSetting> felt_settings() {
    using Number = NumberOf<PlayerSettings>;
    return {
        {"force", "Force on the hand", "Sets the largest force that the hand feels.", force_setting(), false,
         SettingPage::mixer},
        {"own_force_percent", "Own largest force",
         "Sets what \"own\" means, of the most that the device can do.",
         WholeOf<PlayerSettings>{&PlayerSettings::own_force_percent, 5, 100, 5, " %"}, false,
         SettingPage::mixer},
        {"carried_weight", "Carried weight",
         "Lets the hand feel less of the weight; the match stays the same.",
         Number{&PlayerSettings::carried_weight, 0, 1, 0.25, 100, " %"}, false, SettingPage::mixer},
        {"carried_blows", "Carried blows", "Lets the hand feel less of the blows; the match stays the same.",
         Number{&PlayerSettings::carried_blows, 0, 1, 0.25, 100, " %"}, false, SettingPage::mixer},
        {"recoil", "Recoil of the wands",
         "Lets the hand feel less of the kick of each shot; the match stays the same.",
         Number{&PlayerSettings::recoil, 0, 1, 0.25, 100, " %"}, false, SettingPage::mixer},
        {"roughness", "Roughness of touched things",
         "Lets the wand's tip slide more easily over what it touches.",
         Number{&PlayerSettings::roughness, 0, 1, 0.25, 100, " %"}, false, SettingPage::mixer},
        {"rumble", "Rumble", "Makes a pad's motors stronger or weaker; the match stays the same.",
         Number{&PlayerSettings::rumble, 0, 1, 0.1, 100, " %"}, false, SettingPage::mixer},
        {"jacket_sound", "Sound on the jacket",
         "Plays sounds on a jacket: low ones at the belly, high above.",
         Number{&PlayerSettings::jacket_sound, 0, 1, 0.1, 100, " %"}, false, SettingPage::mixer},
        {"jacket_sound_of", "Kind of jacket sounds", "Says which sounds the jacket plays.",
         felt_groups_setting(), false, SettingPage::mixer},
    };
}

}  // namespace

std::span<const PlayerSetting> player_settings() {
    static const std::vector<PlayerSetting> settings = [] {
        auto all = seen_and_aimed_settings();
        const auto felt = felt_settings();
        all.insert(all.end(), felt.begin(), felt.end());
        return all;
    }();
    return settings;
}

template <class Of>
void read(const ConfigTable& table, const SettingOf<Of>& setting, Of& values) {
    if (const auto* n = std::get_if<NumberOf<Of>>(&setting.kind))
        values.*n->value = table.number(setting.key, {n->low, n->high}, values.*n->value);
    if (const auto* w = std::get_if<WholeOf<Of>>(&setting.kind)) {
        const Range range{static_cast<double>(w->low), static_cast<double>(w->high)};
        values.*w->value = static_cast<int>(table.integer(setting.key, range, values.*w->value));
    }
    if (const auto* f = std::get_if<FlagOf<Of>>(&setting.kind))
        values.*f->value = table.boolean(setting.key, values.*f->value);
    if (const auto* c = std::get_if<ChoiceOf<Of>>(&setting.kind))
        c->set(values, table.choice(setting.key, c->names, c->get(values)));
}

template <class Of>
std::string written(const SettingOf<Of>& setting, const Of& values) {
    if (const auto* n = std::get_if<NumberOf<Of>>(&setting.kind)) return text(values.*n->value);
    if (const auto* w = std::get_if<WholeOf<Of>>(&setting.kind)) return text(values.*w->value);
    if (const auto* f = std::get_if<FlagOf<Of>>(&setting.kind)) return text(values.*f->value);
    const auto& c = std::get<ChoiceOf<Of>>(setting.kind);
    return text('"', c.names[c.get(values)], '"');
}

template <class Of>
std::string shown(const SettingOf<Of>& setting, const Of& values) {
    if (const auto* n = std::get_if<NumberOf<Of>>(&setting.kind)) {
        const double value = std::round(values.*n->value * n->shown_times * 100) / 100;
        return text(value, n->unit);
    }
    if (const auto* w = std::get_if<WholeOf<Of>>(&setting.kind)) return text(values.*w->value, w->unit);
    if (const auto* f = std::get_if<FlagOf<Of>>(&setting.kind)) return values.*f->value ? "yes" : "no";
    if (const auto* c = std::get_if<ChoiceOf<Of>>(&setting.kind)) {
        std::string name(c->names[c->get(values)]);
        std::replace(name.begin(), name.end(), '_', ' ');
        return name;
    }
    return written(setting, values);
}

template <class Of>
void change(const SettingOf<Of>& setting, Of& values, int steps) {
    if (const auto* n = std::get_if<NumberOf<Of>>(&setting.kind)) {
        // Rounds to a whole number of steps. Dividing by the inverse step, instead of multiplying by the
        // step, gives 0.3 and not 0.30000000000000004.
        const double per_unit = std::round(1 / n->step);
        const double whole = std::round(values.*n->value / n->step) + steps;
        const double value = n->step < 1 ? whole / per_unit : whole * n->step;
        values.*n->value = std::clamp(value, n->low, n->high);
    }
    if (const auto* w = std::get_if<WholeOf<Of>>(&setting.kind))
        values.*w->value = std::clamp(values.*w->value + steps * w->step, w->low, w->high);
    if (const auto* f = std::get_if<FlagOf<Of>>(&setting.kind))
        values.*f->value = (steps % 2 != 0) != values.*f->value;
    if (const auto* c = std::get_if<ChoiceOf<Of>>(&setting.kind)) {
        const auto count = static_cast<int>(c->names.size());
        const int at = static_cast<int>(c->get(values)) + steps % count + count;
        c->set(values, static_cast<std::size_t>(at % count));
    }
}

template <class Of>
void copy_value(const SettingOf<Of>& setting, const Of& from, Of& to) {
    if (const auto* n = std::get_if<NumberOf<Of>>(&setting.kind)) to.*n->value = from.*n->value;
    if (const auto* w = std::get_if<WholeOf<Of>>(&setting.kind)) to.*w->value = from.*w->value;
    if (const auto* f = std::get_if<FlagOf<Of>>(&setting.kind)) to.*f->value = from.*f->value;
    if (const auto* c = std::get_if<ChoiceOf<Of>>(&setting.kind)) c->set(to, c->get(from));
}

template <class Of>
void reset(const SettingOf<Of>& setting, Of& values) {
    copy_value(setting, Of{}, values);
}

template void read(const ConfigTable&, const Setting&, Settings&);
template void read(const ConfigTable&, const PlayerSetting&, PlayerSettings&);
template std::string written(const Setting&, const Settings&);
template std::string written(const PlayerSetting&, const PlayerSettings&);
template std::string shown(const Setting&, const Settings&);
template std::string shown(const PlayerSetting&, const PlayerSettings&);
template void change(const Setting&, Settings&, int);
template void change(const PlayerSetting&, PlayerSettings&, int);
template void copy_value(const Setting&, const Settings&, Settings&);
template void copy_value(const PlayerSetting&, const PlayerSettings&, PlayerSettings&);
template void reset(const Setting&, Settings&);
template void reset(const PlayerSetting&, PlayerSettings&);

}  // namespace thaum::game::inline settings
