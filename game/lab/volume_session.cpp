#include "game/lab/volume_session.h"

#include <algorithm>

#include "core/file.h"
#include "core/text.h"
#include "field/field_config.h"

namespace thaum::game::inline lab {
namespace {

constexpr std::int64_t session_version = 1;
constexpr std::size_t max_session = std::size_t{1} << 20U;  // largest size of a session's file (bytes)
constexpr Range any{-1e100, 1e100};

std::string points_text(const field::TransferFunction& f) {
    std::string words = "[";
    for (std::uint64_t i = 0; i < f.count; ++i)
        words += text(i == 0 ? "" : ", ", f.points[i].x, ", ", f.points[i].y);
    return words + "]";
}

field::TransferFunction read_points(const ConfigTable& table, std::string_view key) {
    return field::read_transfer(table, key, any, {0, 0});
}

LabMode read_lab_mode(const ConfigTable& table) {
    LabMode mode{.name = table.string("name")};
    if (haptics::find_mode(mode.name) == nullptr) table.report("name", "there is no such mode");
    mode.volume = static_cast<std::size_t>(table.integer("reads", {0, double{max_volumes_beside}}, 0));
    mode.settings.strength = read_points(table, "strength");
    mode.settings.friction = read_points(table, "friction");
    mode.settings.level = table.number("level", any, 0);
    mode.settings.solid_below = table.boolean("solid_below", false);
    mode.settings.magnet = table.number("magnet", {0, 1e6}, 0);
    mode.settings.reach = table.number("reach_m", {1e-6, 1}, mode.settings.reach);
    mode.settings.pitch = table.number("pitch_m", {1e-6, 1}, mode.settings.pitch);
    for (const auto& filter : table.tables("filter")) mode.filters.push_back(field::read_filter(filter, any));
    return mode;
}

void read_feel(const ConfigTable& root, std::vector<FeelPart>& feel) {
    for (const auto& table : root.tables("feel")) {
        const auto kind = table.string("kind");
        const auto numbers = table.numbers("numbers", any, max_feel_numbers, {});
        auto part = feel_part(kind, numbers);
        if (part)
            feel.push_back(*part);
        else
            table.report("kind", part.error().message);
    }
    const auto all = feel_of_parts(feel, {}, 1);
    if (!all) root.report("feel", all.error().message);
}

std::string feel_text(const FeelPart& part) {
    const auto& form = form_of(part.kind);
    std::string words = text("\n[[feel]]\nkind = \"", form.name, "\"\nnumbers = [");
    for (std::size_t i = 0; i < form.count; ++i) words += text(i == 0 ? "" : ", ", part.numbers.at(i));
    return words + "]\n";
}

constexpr double degree = pi / 180;

SessionVolume read_session_volume(const ConfigTable& table) {
    SessionVolume one{.volume = table.string("volume")};
    one.count = table.integer("count", {8, 512}, one.count);
    one.seed = table.integer("seed", {0, 9e15}, one.seed);
    one.moment = table.integer("moment", {1, 1e9}, one.moment);
    const auto n = table.numbers("place", {-360, 360}, 5, {0, 0, 0, 1, 0});
    if (n.size() != 5)
        table.report("place", "must be x, y, z, scale and degrees");
    else
        one.place = {.origin = {n[0], n[1], n[2]}, .yaw = n[4] * degree, .scale = n[3]};
    return one;
}

std::string volume_text(const SessionVolume& one) {
    const auto& p = one.place;
    return text("volume = ", in_quotes(one.volume), "\ncount = ", one.count, "\nseed = ", one.seed,
                one.moment == 1 ? "" : text("\nmoment = ", one.moment), "\nplace = [", p.origin.x, ", ",
                p.origin.y, ", ", p.origin.z, ", ", p.scale, ", ", p.yaw / degree, "]\n");
}

std::optional<SessionView> read_view(const ConfigTable& root) {
    const auto n = root.numbers("view", {-1000, 1000}, 6, {});
    if (n.empty()) return std::nullopt;
    if (n.size() == 6 && n[2] >= 0.1 && n[2] <= 100)
        return SessionView{n[0] * degree, std::clamp(n[1], -86.0, 86.0) * degree, n[2], {n[3], n[4], n[5]}};
    root.report("view", "must be two angles in degrees, a distance from 0.1 to 100, and x, y, z");
    return std::nullopt;
}

std::string view_text(const SessionView& v) {
    return text("view = [", v.yaw / degree, ", ", v.pitch / degree, ", ", v.away, ", ", v.aim.x, ", ",
                v.aim.y, ", ", v.aim.z, "]\n");
}

/// Changes a path that is relative to the session's folder into one that is relative to the working
/// directory.
void find_beside(const std::filesystem::path& folder, std::string& volume) {
    std::error_code ignored;
    const auto file = folder / volume;
    if (std::filesystem::path(volume).is_relative() && std::filesystem::exists(file, ignored))
        volume = file.string();
}

}  // namespace

std::string session_text(const VolumeSession& session) {
    std::string words =
        text("version = ", session_version, '\n', volume_text(session.first),
             "registered = ", session.registered ? "true" : "false", "\ndevice = ", in_quotes(session.device),
             "\nlook = ", session.translucent ? "\"translucent\"" : "\"surface\"",
             "\nlevel = ", session.level, "\nopacity = ", points_text(session.opacity), '\n');
    if (session.view) words += view_text(*session.view);
    for (const SessionVolume& volume : session.beside) words += "\n[[beside]]\n" + volume_text(volume);
    for (const FeelPart& part : session.feel) words += feel_text(part);
    for (const LabMode& mode : session.modes) {
        const auto& s = mode.settings;
        words += text("\n[[mode]]\nname = ", in_quotes(mode.name), "\nreads = ", mode.volume,
                      "\nstrength = ", points_text(s.strength), "\nfriction = ", points_text(s.friction),
                      "\nlevel = ", s.level, "\nsolid_below = ", s.solid_below ? "true" : "false",
                      "\nmagnet = ", s.magnet, "\nreach_m = ", s.reach, "\npitch_m = ", s.pitch, '\n');
        for (const field::Filter& filter : mode.filters)
            words += text("[[mode.filter]]\nkind = \"",
                          field::filter_names()[static_cast<std::size_t>(filter.kind)], "\"\na = ", filter.a,
                          "\nb = ", filter.b, '\n');
    }
    return words;
}

Expected<VolumeSession> read_session(const Config& file) {
    const auto root = file.root();
    VolumeSession session;
    session.first = read_session_volume(root);
    for (const auto& table : root.tables("beside")) session.beside.push_back(read_session_volume(table));
    if (session.beside.size() > max_volumes_beside)
        file.report(text("at most ", max_volumes_beside, " volumes beside the first one"));
    session.registered = root.boolean("registered", false);
    session.device = root.string("device", session.device);
    session.translucent = root.choice("look", {"surface", "translucent"}, 0) == 1;
    session.level = root.number("level", any, 0);
    session.opacity = read_points(root, "opacity");
    session.view = read_view(root);
    read_feel(root, session.feel);
    for (const auto& table : root.tables("mode")) session.modes.push_back(read_lab_mode(table));
    if (session.modes.size() > haptics::primitive_capacity)
        file.report(text("at most ", haptics::primitive_capacity, " modes"));
    if (auto sound = file.check(); !sound) return sound.error();
    return session;
}

Expected<void> save_session(const VolumeSession& session, const std::filesystem::path& file) {
    return write_text_file(file, session_text(session));
}

Expected<VolumeSession> load_session(const std::filesystem::path& file) {
    const auto words = read_text_file(file, max_session);
    if (!words) return words.error();
    const auto config = Config::parse(*words, file.string(), session_version);
    if (!config) return config.error();
    auto session = read_session(*config);
    if (!session) return session;
    find_beside(file.parent_path(), session->first.volume);
    for (auto& volume : session->beside) find_beside(file.parent_path(), volume.volume);
    return session;
}

}  // namespace thaum::game::inline lab
