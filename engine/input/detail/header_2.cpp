// Body of the header in format 2: records ("sections") in ascending order of their tags. The settings of a
// device are records too.
#include "input/detail/header.h"
#include "input/detail/header_parts.h"

namespace thaum::input::detail {
namespace {

/// Tags of sections (the records of a log's header). A new section must take the next number.
enum class Section : std::uint16_t {
    match = 1,
    build,
    players,
    devices,
    files,
    overrides,
    parameters,
    kinds,
    profile,
    names,
};

/// Tags of a device's settings. A new setting must take the next number.
enum class Setting : std::uint16_t {
    look_rad_per_count = 1,
    turn_rad_per_s,
    invert_y,
    no_forces,
    force_percent,
    weight_reduction,
    blow_reduction,
    box_um,
    fluid_reduction,
    aim_assist,
    recoil_reduction,
    roughness_reduction,
    moves_faders,
    casts_freely,
};

// Devices ------------------------------------------------------------------------------------------

/// Appends a setting of a device that is one number, unless it has its default value.
template <class T>
void put_setting(Bytes& out, Setting tag, T value, T usual) {
    if (value == usual) return;
    put_record(out, tag, needed, [&](ByteWriter& to) { to.put(value); });
}

/// Appends a setting of a device that is several numbers, unless all of them are zero.
template <class T, std::size_t n>
void put_settings(Bytes& out, Setting tag, const std::array<T, n>& values) {
    if (values == std::array<T, n>{}) return;
    put_record(out, tag, needed, [&](ByteWriter& to) {
        for (const auto value : values) to.put(value);
    });
}

/// Encodes a device's settings. Those with their default value are left out, except look_rad_per_count and
/// turn_rad_per_s: another version of the program may have other defaults for them.
Bytes settings_of(const DeviceSpec& d) {
    Bytes out;
    put_record(out, Setting::look_rad_per_count, needed,
               [&](ByteWriter& to) { to.put(d.look_rad_per_count); });
    put_record(out, Setting::turn_rad_per_s, needed, [&](ByteWriter& to) { to.put(d.turn_rad_per_s); });
    put_setting(out, Setting::invert_y, d.invert_y, false);
    put_setting(out, Setting::no_forces, d.no_forces, false);
    put_setting(out, Setting::force_percent, d.force_percent, std::uint8_t{});
    put_setting(out, Setting::weight_reduction, d.weight_reduction, std::uint8_t{});
    put_setting(out, Setting::blow_reduction, d.blow_reduction, std::uint8_t{});
    put_settings(out, Setting::box_um, d.box_um);
    put_settings(out, Setting::fluid_reduction, d.fluid_reduction);
    put_setting(out, Setting::aim_assist, d.aim_assist, std::uint8_t{});
    put_setting(out, Setting::recoil_reduction, d.recoil_reduction, std::uint8_t{});
    put_setting(out, Setting::roughness_reduction, d.roughness_reduction, std::uint8_t{});
    put_setting(out, Setting::moves_faders, d.moves_faders, false);
    put_setting(out, Setting::casts_freely, d.casts_freely, false);
    return out;
}

void put_device(ByteWriter& out, const DeviceSpec& d) {
    out.put(d.player);
    out.put(d.kind);
    out.put_string(d.name);
    const auto settings = settings_of(d);
    out.put(static_cast<std::uint32_t>(settings.size()));
    out.put_bytes(settings);
}

template <class T, std::size_t n>
void get_values(ByteReader& in, std::array<T, n>& values) {
    for (auto& value : values) value = in.get<T>();
}

/// Reads one setting of a device. Returns false if its tag is unknown.
bool get_setting(Setting tag, ByteReader& in, DeviceSpec& d) {
    switch (tag) {
        case Setting::look_rad_per_count: d.look_rad_per_count = in.get<double>(); return true;
        case Setting::turn_rad_per_s: d.turn_rad_per_s = in.get<double>(); return true;
        case Setting::invert_y: d.invert_y = in.get<bool>(); return true;
        case Setting::no_forces: d.no_forces = in.get<bool>(); return true;
        case Setting::force_percent: d.force_percent = in.get<std::uint8_t>(); return true;
        case Setting::weight_reduction: d.weight_reduction = in.get<std::uint8_t>(); return true;
        case Setting::blow_reduction: d.blow_reduction = in.get<std::uint8_t>(); return true;
        case Setting::box_um: get_values(in, d.box_um); return true;
        case Setting::fluid_reduction: get_values(in, d.fluid_reduction); return true;
        case Setting::aim_assist: d.aim_assist = in.get<std::uint8_t>(); return true;
        case Setting::recoil_reduction: d.recoil_reduction = in.get<std::uint8_t>(); return true;
        case Setting::roughness_reduction: d.roughness_reduction = in.get<std::uint8_t>(); return true;
        case Setting::moves_faders: d.moves_faders = in.get<bool>(); return true;
        case Setting::casts_freely: d.casts_freely = in.get<bool>(); return true;
    }
    return false;
}

/// Reads a device from a log's header. `fault` receives the first fault of its settings.
DeviceSpec get_device(ByteReader& in, std::string& fault) {
    DeviceSpec d;
    d.player = in.get<std::uint32_t>();
    d.kind = in.get<DeviceKind>();
    d.name = in.get_string();
    ByteReader settings(in.get_bytes(in.get<std::uint32_t>()));
    auto found = read_records(settings, "setting", [&](std::uint16_t tag, ByteReader& value) {
        return get_setting(Setting{tag}, value, d);
    });
    if (fault.empty()) fault = std::move(found);
    return d;
}

// Other sections -----------------------------------------------------------------------------------

void put_match(ByteWriter& out, const LogHeader& h) {
    out.put_string(h.program);
    out.put(h.rules_version);
    out.put_string(h.rule_set);
    out.put_string(h.arena);
    out.put(h.seed);
    out.put(h.maths_probe);
}

void put_kinds(ByteWriter& out, const std::vector<KindTable>& tables) {
    put_list(out, tables, [&](const KindTable& table) {
        out.put_string(table.group);
        put_list(out, table.kinds, [&](const Kind& kind) {
            out.put(kind.number);
            out.put_string(kind.name);
        });
    });
}

std::vector<KindTable> get_kinds(ByteReader& in) {
    return get_list(in, kind_table_limit, [&] {
        KindTable table;
        table.group = in.get_string();
        table.kinds = get_list(in, list_limit, [&] {
            const auto number = in.get<std::uint16_t>();
            return Kind{number, in.get_string()};
        });
        return table;
    });
}

void put_profile(ByteWriter& out, const std::vector<ProfileData>& items) {
    put_list(out, items, [&](const ProfileData& item) {
        out.put_string(item.kind);
        out.put_string(item.name);
        out.put(item.player);
        out.put(static_cast<std::uint32_t>(item.bytes.size()));
        out.put_bytes(item.bytes);
    });
}

std::vector<ProfileData> get_profile(ByteReader& in) {
    return get_list(in, list_limit, [&] {
        ProfileData item;
        item.kind = in.get_string();
        item.name = in.get_string();
        item.player = in.get<std::uint32_t>();
        const auto bytes = in.get_bytes(in.get<std::uint32_t>());
        item.bytes.assign(bytes.begin(), bytes.end());
        return item;
    });
}

/// Reads one section (a record of the header). Returns false if its tag is unknown. `fault` receives the
/// first fault of a device's settings.
bool get_section(Section tag, ByteReader& in, LogHeader& h, std::string& fault) {
    switch (tag) {
        case Section::match: get_match(in, h); return true;
        case Section::build:
            h.physics_library = in.get_string();
            h.physics_precision = in.get_string();
            return true;
        case Section::players: h.players = get_strings(in, player_limit); return true;
        case Section::devices:
            h.devices = get_list(in, max_devices, [&] { return get_device(in, fault); });
            return true;
        case Section::files: h.files = get_list(in, list_limit, [&] { return get_file(in); }); return true;
        case Section::overrides: h.overrides = get_strings(in, list_limit); return true;
        case Section::parameters: h.parameters = get_strings(in, list_limit); return true;
        case Section::kinds: h.kinds = get_kinds(in); return true;
        case Section::profile: h.profile = get_profile(in); return true;
        case Section::names: h.names = get_strings(in, player_limit); return true;
    }
    return false;
}

}  // namespace

Bytes encode_body(const LogHeader& h) {
    Bytes body;
    put_record(body, Section::match, needed, [&](ByteWriter& out) { put_match(out, h); });
    put_record(body, Section::build, 0, [&](ByteWriter& out) {
        out.put_string(h.physics_library);
        out.put_string(h.physics_precision);
    });
    put_record(body, Section::players, needed, [&](ByteWriter& out) { put_strings(out, h.players); });
    put_record(body, Section::devices, needed, [&](ByteWriter& out) {
        put_list(out, h.devices, [&](const DeviceSpec& d) { put_device(out, d); });
    });
    put_record(body, Section::files, needed, [&](ByteWriter& out) {
        put_list(out, h.files, [&](const DataFile& f) {
            out.put_string(f.name);
            out.put(f.hash);
        });
    });
    put_record(body, Section::overrides, needed, [&](ByteWriter& out) { put_strings(out, h.overrides); });
    put_record(body, Section::parameters, needed, [&](ByteWriter& out) { put_strings(out, h.parameters); });
    put_record(body, Section::kinds, needed, [&](ByteWriter& out) { put_kinds(out, h.kinds); });
    if (!h.profile.empty())
        put_record(body, Section::profile, needed, [&](ByteWriter& out) { put_profile(out, h.profile); });
    if (!h.names.empty())
        put_record(body, Section::names, 0, [&](ByteWriter& out) { put_strings(out, h.names); });
    return body;
}

Expected<LogHeader> decode_body_2(std::span<const std::byte> body) {
    constexpr auto last_required = static_cast<std::uint16_t>(Section::kinds);
    LogHeader h;
    std::string device_fault;
    std::uint16_t required = 0;  // number of required sections (records of the header) so far
    ByteReader in(body);
    auto fault = read_records(in, "section", [&](std::uint16_t tag, ByteReader& content) {
        if (tag <= last_required) ++required;
        return get_section(Section{tag}, content, h, device_fault);
    });
    if (!device_fault.empty()) fault = std::move(device_fault);
    if (!fault.empty()) return fail(text("the header cannot be read: ", fault));
    if (required != last_required) return fail("the header cannot be read: a section is missing");
    return h;
}

}  // namespace thaum::input::detail
