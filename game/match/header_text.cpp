#include "game/match/header_text.h"

#include "core/one_line.h"
#include "core/text.h"

namespace thaum::game::inline match {
namespace {

std::string shown(const std::string& outside) {
    constexpr std::size_t most = 1000;
    return printable(outside, most);
}

std::string number_of_player(std::uint32_t player) { return text("player ", player + 1); }

std::string file_line(const input::LogReader& log) {
    const auto ending = log.ended_cleanly() ? text("closed with the result: ", shown(log.result()))
                                            : shown(log.ending_reason());
    return text("log: format ", log.format(), ", ", log.ticks(), " ticks, ", log.hashes().size(), " hashes, ",
                log.marks().size(), " marks; ", ending, "\n");
}

std::string match_lines(const input::LogHeader& h) {
    const auto physics = h.physics_library.empty()
                             ? std::string("unknown")
                             : text(shown(h.physics_library), ", ", shown(h.physics_precision));
    return text("program: thaum ", shown(h.program), ", rules version ", h.rules_version, "\n",
                "physics: ", physics, "\n", "maths probe: ", hex(h.maths_probe), "\n",
                "rules: ", shown(h.rule_set), "\n", "arena: ", shown(h.arena), "\n", "seed: ", h.seed, "\n");
}

/// Text of all settings of a device that are not zero.
std::string settings_of(const input::DeviceSpec& d) {
    auto line = text("look_rad_per_count ", d.look_rad_per_count, ", turn_rad_per_s ", d.turn_rad_per_s);
    const auto number = [&](std::string_view name, std::uint8_t percent) {
        if (percent != 0) line += text(", ", name, ' ', static_cast<unsigned>(percent), " %");
    };
    if (d.invert_y) line += ", invert_y";
    if (d.no_forces) line += ", no_forces";
    number("force", d.force_percent);
    number("weight reduced by", d.weight_reduction);
    number("blows reduced by", d.blow_reduction);
    for (std::size_t i = 0; i < d.fluid_reduction.size(); ++i)
        number(text("fluid source ", i + 1, " reduced by"), d.fluid_reduction[i]);
    number("recoil reduced by", d.recoil_reduction);
    number("roughness reduced by", d.roughness_reduction);
    number("aim assist", d.aim_assist);
    if (d.moves_faders) line += ", may move faders";
    if (d.casts_freely) line += ", casts without a button";
    if (d.box_um[0] != 0) line += text(", box ", d.box_um[0], " x ", d.box_um[1], " x ", d.box_um[2], " um");
    return line;
}

std::string device_lines(const input::LogHeader& h) {
    std::string lines;
    for (std::size_t i = 0; i < h.players.size(); ++i)
        lines += text("player ", i + 1, ": ", shown(h.players[i]), "\n");
    for (std::size_t i = 0; i < h.names.size(); ++i)
        if (!h.names[i].empty()) lines += text("name of player ", i + 1, ": ", shown(h.names[i]), "\n");
    for (std::size_t i = 0; i < h.devices.size(); ++i) {
        const auto& d = h.devices[i];
        lines += text("device ", i + 1, ": ", name_of(d.kind), " '", shown(d.name), "' of ",
                      number_of_player(d.player), ", ", settings_of(d), "\n");
    }
    return lines;
}

}  // namespace

std::string header_text(const input::LogReader& log) {
    const auto& h = log.header();
    auto lines = file_line(log) + match_lines(h) + device_lines(h);
    for (const auto& parameter : h.parameters) lines += text("parameter: ", shown(parameter), "\n");
    for (const auto& value : h.overrides) lines += text("override: ", shown(value), "\n");
    for (const auto& file : h.files)
        lines += text("data file: ", shown(file.name), ' ', hex(file.hash), "\n");
    for (const auto& table : h.kinds) {
        for (const auto& kind : table.kinds)
            lines += text("kind: ", shown(table.group), ' ', kind.number, ' ', shown(kind.name), "\n");
    }
    for (const auto& item : h.profile)
        lines += text("profile data: ", shown(item.kind), " '", shown(item.name), "' of ",
                      number_of_player(item.player), ", ", item.bytes.size(), " bytes\n");
    return lines;
}

}  // namespace thaum::game::inline match
