// Preamble and checksum of the log's header, and the limits that writer and reader enforce. The body has a
// file for each format: header_1.cpp and header_2.cpp.
#include "input/detail/header.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

#include "core/hash.h"
#include "core/text.h"
#include "core/write_rule.h"

namespace thaum::input::detail {
namespace {

constexpr std::string_view magic = recording_magic;
constexpr std::size_t salt_offset = 16;

std::span<const std::byte> bytes_of(std::string_view s) {
    return std::as_bytes(std::span(s.data(), s.size()));
}

std::uint64_t salt_of(std::span<const std::byte> file, std::size_t body_size) {
    return hash_bytes(file.subspan(preamble_size, body_size), hash_bytes(file.first(salt_offset)));
}

// Limits of a header -----------------------------------------------------------------------------

bool kinds_short(const KindTable& table) {
    return table.group.size() <= string_limit &&
           std::all_of(table.kinds.begin(), table.kinds.end(),
                       [](const Kind& k) { return k.name.size() <= string_limit; });
}

bool strings_short(const LogHeader& h) {
    const auto is_short = [](const std::string& s) { return s.size() <= string_limit; };
    const auto all = [](const auto& list, auto holds) {
        return std::all_of(list.begin(), list.end(), holds);
    };
    return is_short(h.program) && is_short(h.rule_set) && is_short(h.arena) && is_short(h.physics_library) &&
           is_short(h.physics_precision) && all(h.players, is_short) && all(h.names, is_short) &&
           all(h.overrides, is_short) && all(h.parameters, is_short) && all(h.kinds, kinds_short) &&
           all(h.devices, [&](const DeviceSpec& device) { return is_short(device.name); }) &&
           all(h.files, [&](const DataFile& file) { return is_short(file.name); }) &&
           all(h.profile, [&](const ProfileData& p) { return is_short(p.kind) && is_short(p.name); });
}

std::string_view device_fault(const DeviceSpec& device, std::size_t players) {
    if (device.player >= players) return "a device's player is not among the players";
    if (static_cast<std::size_t>(device.kind) >= device_kinds) return "a device's kind is unknown";
    if (!std::isfinite(device.look_rad_per_count)) return "a device's look_rad_per_count is not finite";
    if (!std::isfinite(device.turn_rad_per_s)) return "a device's turn_rad_per_s is not finite";
    if (device.force_percent > 100) return "a device's largest force is above 100 %";
    if (device.weight_reduction > 100) return "a device's reduction of weight is above 100 %";
    if (device.blow_reduction > 100) return "a device's reduction of blows is above 100 %";
    if (device.recoil_reduction > 100) return "a device's reduction of recoil is above 100 %";
    if (device.roughness_reduction > 100) return "a device's reduction of roughness is above 100 %";
    if (device.aim_assist > 100) return "a device's aim assist is above 100 %";
    for (const auto edge : device.box_um) {
        if (edge > DeviceSpec::max_box_um) return "a device's box is larger than 10 m";
    }
    for (const auto percent : device.fluid_reduction) {
        if (percent > 100) return "a device's reduction of a fluid's force is above 100 %";
    }
    return {};
}

/// Tests whether the keys of a list are strictly ascending, so that no two are equal.
template <class List, class Key>
bool rises(const List& list, Key key) {
    const auto not_below = [&](const auto& a, const auto& b) { return !(key(a) < key(b)); };
    return std::adjacent_find(list.begin(), list.end(), not_below) == list.end();
}

std::string_view kinds_fault(const std::vector<KindTable>& tables) {
    if (tables.size() > kind_table_limit) return "more than 16 tables of kinds";
    if (!rises(tables, [](const KindTable& table) { return std::string_view(table.group); }))
        return "the tables of kinds are not in the order of their groups";
    for (const auto& table : tables) {
        if (table.kinds.size() > list_limit) return "more than 1000 kinds in a table";
        if (!rises(table.kinds, [](const Kind& kind) { return kind.number; }))
            return "the kinds of a table are not in the order of their numbers";
    }
    return {};
}

std::string_view profile_fault(const std::vector<ProfileData>& items, std::size_t players) {
    if (items.size() > list_limit) return "more than 1000 items of profile data";
    if (!rises(items, [](const ProfileData& item) { return std::tie(item.kind, item.name, item.player); }))
        return "profile data are not in the order of kind, name and player";
    std::size_t size = 0;
    for (const auto& item : items) {
        if (item.player >= players) return "the player of profile data is not among the players";
        size += item.bytes.size();
    }
    if (size > header_limit(format_version)) return "more than 16 MiB of profile data";
    return {};
}

/// Returns the first fault of a header; empty if there is none.
std::string_view header_fault(const LogHeader& h) {
    if (h.players.size() > player_limit) return "more than 16 players";
    if (h.names.size() > h.players.size()) return "more names than players";
    if (h.devices.size() > max_devices) return "more than 4 devices";
    if (h.files.size() > list_limit) return "more than 1000 data files";
    if (h.overrides.size() > list_limit) return "more than 1000 overrides";
    if (h.parameters.size() > list_limit) return "more than 1000 parameters";
    if (!strings_short(h)) return "a text longer than 65536 bytes";
    for (const auto& device : h.devices) {
        if (const auto fault = device_fault(device, h.players.size()); !fault.empty()) return fault;
    }
    if (const auto fault = kinds_fault(h.kinds); !fault.empty()) return fault;
    return profile_fault(h.profile, h.players.size());
}

}  // namespace

Expected<Bytes> encode_header(const LogHeader& header) {
    if (const auto fault = header_fault(header); !fault.empty()) {
        return fail(text("a log cannot hold this header: ", fault));
    }
    const auto body = encode_body(header);
    if (body.size() > header_limit(format_version))
        return fail("a log cannot hold this header: more than 16 MiB");

    Bytes file;
    ByteWriter out(file);
    out.put_bytes(bytes_of(magic));
    out.put(format_version);
    out.put(static_cast<std::uint32_t>(body.size()));
    out.put(hash_bytes(body, hash_bytes(file)));
    out.put_bytes(body);
    return file;
}

Expected<Preamble> decode_preamble(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    const auto found = in.get_bytes(magic.size());
    if (!in.ok() || std::memcmp(found.data(), magic.data(), magic.size()) != 0)
        return fail("not a Thaum log");
    const auto format = in.get<std::uint32_t>();
    const std::size_t size = in.get<std::uint32_t>();
    const auto salt = in.get<std::uint64_t>();
    if (!in.ok()) return fail("the header is cut off");
    if (format > format_version) {
        return fail(text("log format ", format, " is newer than this program reads (", format_version,
                         "): use a newer Thaum, or the file is damaged"));
    }
    if (format == 0 || size > header_limit(format)) return fail("the header is damaged");
    return Preamble{format, size, salt};
}

Expected<LogHeader> decode_header(std::span<const std::byte> file, const Preamble& preamble) {
    if (salt_of(file, preamble.body_size) != preamble.salt) return fail("the header is damaged");
    const auto body = file.subspan(preamble_size, preamble.body_size);
    auto header = preamble.format == 1 ? decode_body_1(body) : decode_body_2(body);
    if (!header) return header;
    if (const auto fault = header_fault(*header); !fault.empty()) {
        return fail(text("the header is malformed: ", fault));
    }
    return header;
}

}  // namespace thaum::input::detail
