// Changes values in the text of a settings file line by line, so that comments and layout are kept. A line
// editor cannot handle all of TOML, so the edited text is parsed again and used only if it has exactly the
// requested changes.
#include <algorithm>

#include "core/file.h"
#include "core/text.h"
#include "game/settings/settings.h"

namespace thaum::game::inline settings {
namespace {

constexpr std::size_t max_edited_file = 1U << 20U;

void add_player(std::string_view table, const PlayerSettings& player, std::vector<SettingEdit>& values) {
    values.push_back({std::string(table), "name", in_quotes(player.name)});
    values.push_back({std::string(table), "jacket", in_quotes(player.jacket)});
    values.push_back({std::string(table), "jacket_layout", in_quotes(player.jacket_layout)});
    for (const auto& setting : player_settings())
        values.push_back({std::string(table), std::string(setting.key), written(setting, player)});
}

void add_hand(const input::Bindings& bindings, std::vector<SettingEdit>& values) {
    const std::string table(input::name_of(bindings.kind));
    for (std::size_t i = 0; i < input::actions; ++i) {
        const auto action = static_cast<input::Action>(i);
        values.push_back({table, std::string(input::name_of(action)),
                          in_quotes(input::words_of(bindings.controls[i], key_name_of))});
    }
    values.push_back({table, "toggle", in_quotes(input::toggles_of(bindings))});
    values.push_back({table, "trigger_press", text(bindings.trigger_press)});
}

void add_faders(std::string_view table, const Faders& faders, std::vector<SettingEdit>& values) {
    for (std::size_t i = 0; i < faders.size(); ++i)
        values.push_back(
            {std::string(table), std::string(haptics::fluid_modes[i].name), text(faders[i].share)});
    values.push_back({std::string(table), "off", in_quotes(off_words(faders))});
}

void add_body(std::string_view table, const tactile::Faders& body, std::vector<SettingEdit>& values) {
    for (std::size_t i = 0; i < tactile::purpose_count; ++i)
        values.push_back(
            {std::string(table), std::string(tactile::purpose_names()[i]), text(body.values[i])});
}

/// All values in a settings file, as text.
std::vector<SettingEdit> all_values(const Settings& settings) {
    std::vector<SettingEdit> values;
    for (const auto& setting : all_settings())
        values.push_back({"", std::string(setting.key), written(setting, settings)});
    std::string mutators;
    for (const auto& name : settings.last.mutators) mutators += text(mutators.empty() ? "" : ", ", name);
    values.push_back({"", "mutators", in_quotes(mutators)});
    values.push_back({"", "bot", in_quotes(settings.last.bot)});
    values.push_back({"", "match", in_quotes(settings.last.match)});
    values.push_back({"", "arena", in_quotes(settings.last.arena)});
    for (std::size_t p = 0; p < settings.players.size(); ++p)
        add_player(player_tables[p], settings.players[p], values);
    for (std::size_t p = 0; p < settings.cauldron.size(); ++p)
        add_faders(cauldron_tables[p], settings.cauldron[p], values);
    for (std::size_t p = 0; p < settings.players.size(); ++p)
        add_body(body_tables[p], settings.players[p].body, values);
    for (const auto kind : settings_hands) add_hand(settings.bindings_of(kind), values);
    for (std::size_t i = 0; i < session_keys; ++i) {
        const auto key = static_cast<SessionKey>(i);
        values.push_back({"session", std::string(name_of(key)),
                          in_quotes(input::words_of(settings.of(key), key_name_of))});
    }
    return values;
}

// The text --------------------------------------------------------------------------------------------------

std::vector<std::string> lines_of(std::string_view source) {
    std::vector<std::string> lines;
    while (!source.empty()) {
        const auto end = std::min(source.find('\n'), source.size());
        lines.emplace_back(source.substr(0, end));
        source.remove_prefix(std::min(end + 1, source.size()));
    }
    return lines;
}

std::string_view without_spaces(std::string_view s) {
    constexpr std::string_view spaces = " \t\r";
    const auto first = s.find_first_not_of(spaces);
    if (first == std::string_view::npos) return {};
    return s.substr(first, s.find_last_not_of(spaces) - first + 1);
}

/// Name in a table's header "[name]  # comment"; std::nullopt for any other line.
std::optional<std::string> header_of(std::string_view line) {
    line = without_spaces(line);
    const auto end = line.find(']');
    if (!line.starts_with('[') || end == std::string_view::npos) return {};
    return std::string(without_spaces(line.substr(1, end - 1)));
}

/// Position of the value in `key = value`; std::nullopt if the line has another key.
std::optional<std::size_t> value_in(std::string_view line, std::string_view key) {
    const auto equals = line.find('=');
    if (equals == std::string_view::npos || without_spaces(line.substr(0, equals)) != key) return {};
    const auto at = line.find_first_not_of(" \t", equals + 1);
    return at == std::string_view::npos ? line.size() : at;
}

std::size_t end_of_value(std::string_view line, std::size_t at) {
    const char quote = at < line.size() ? line[at] : ' ';
    if (quote == '"' || quote == '\'') {
        for (auto i = at + 1; i < line.size(); ++i) {
            if (line[i] == '\\' && quote == '"')
                ++i;
            else if (line[i] == quote)
                return i + 1;
        }
    }
    const auto comment = std::min(line.find('#', at), line.size());
    const auto last = line.substr(0, comment).find_last_not_of(" \t\r");
    return last == std::string_view::npos || last < at ? at : last + 1;
}

/// Replaces a value. A comment after the value keeps its column if there is room.
void replace_value(std::string& line, std::size_t at, const std::string& value) {
    const auto end = end_of_value(line, at);
    const auto next = line.find_first_not_of(" \t", end);
    const bool comment = next != std::string::npos && line[next] == '#';
    auto room = comment ? next - at : end - at;
    std::string put = value;
    if (comment) put.append(room > value.size() ? room - value.size() : 1, ' ');
    line.replace(at, room, put);
}

void apply(const SettingEdit& edit, std::vector<std::string>& lines) {
    std::string table;
    std::optional<std::size_t> last;  // number of the line after the table's last line with a key or header
    if (edit.table.empty()) last = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (const auto header = header_of(lines[i])) table = *header;
        if (table != edit.table) continue;
        if (const auto at = value_in(lines[i], edit.key)) return replace_value(lines[i], *at, edit.value);
        const auto words = without_spaces(lines[i]);
        if (!words.empty() && !words.starts_with('#')) last = i + 1;
    }
    const auto line = text(edit.key, " = ", edit.value);
    if (last) {
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(*last), line);
        return;
    }
    for (const auto& more : {std::string(), text("[", edit.table, "]"), line}) lines.push_back(more);
}

bool names(const std::vector<SettingEdit>& edits, const SettingEdit& one) {
    return std::any_of(edits.begin(), edits.end(),
                       [&](const SettingEdit& e) { return e.table == one.table && e.key == one.key; });
}

/// Tests whether `current` has the values of the edits, and otherwise those of `old`.
bool says(const Settings& old, const Settings& current, const std::vector<SettingEdit>& edits) {
    const auto differences = changes(old, current);
    const auto values = all_values(current);
    return std::all_of(differences.begin(), differences.end(),
                       [&](const auto& d) { return names(edits, d); }) &&
           std::all_of(edits.begin(), edits.end(), [&](const auto& e) {
               return std::find(values.begin(), values.end(), e) != values.end();
           });
}

}  // namespace

std::vector<SettingEdit> changes(const Settings& before, const Settings& after) {
    auto old = all_values(before), edits = all_values(after);
    std::erase_if(edits,
                  [&](const SettingEdit& e) { return std::find(old.begin(), old.end(), e) != old.end(); });
    return edits;
}

Expected<std::string> edit_settings(std::string_view toml, const std::string& name,
                                    const std::vector<SettingEdit>& edits) {
    const auto old = read_settings(toml, name);
    if (!old) return old.error();
    auto lines = lines_of(toml);
    for (const auto& edit : edits) apply(edit, lines);
    std::string edited;
    for (const auto& line : lines) edited += line + '\n';
    const auto current = read_settings(edited, name);
    if (current && says(old->settings, current->settings, edits)) return edited;
    return fail(text(name, ": the game cannot change a file written in this way; edit the file by hand"));
}

Expected<void> save_changes(const std::filesystem::path& file, const Settings& before,
                            const Settings& after) {
    const auto edits = changes(before, after);
    if (edits.empty()) return {};
    if (file.empty()) return fail("there is no home folder for the settings: set HOME or XDG_CONFIG_HOME");
    std::error_code error;
    // If the file is a symbolic link, writes to its target, so that the link is kept.
    const auto real = std::filesystem::weakly_canonical(file, error);
    const auto& target = error ? file : real;
    const auto source = read_own_text_file(target, max_edited_file);
    if (!source) return source.error();
    const auto edited = edit_settings(*source, file.string(), edits);
    if (!edited) return edited.error();
    return write_text_file(target, *edited);
}

}  // namespace thaum::game::inline settings
