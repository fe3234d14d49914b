// Encoding and decoding of the log's header, and the limits that both enforce.
#include <cmath>

#include "core/hash.h"
#include "core/text.h"
#include "core/write_rule.h"
#include "input/detail/block.h"

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

bool all_short(const std::vector<std::string>& list) {
    for (const auto& s : list) {
        if (s.size() > string_limit) return false;
    }
    return true;
}

bool strings_short(const LogHeader& h) {
    for (const auto& device : h.devices) {
        if (device.name.size() > string_limit) return false;
    }
    for (const auto& file : h.files) {
        if (file.name.size() > string_limit) return false;
    }
    return h.program.size() <= string_limit && h.rule_set.size() <= string_limit &&
           h.arena.size() <= string_limit && all_short(h.players) && all_short(h.overrides) &&
           all_short(h.parameters);
}

std::string_view device_fault(const DeviceSpec& device, std::size_t players) {
    if (device.player >= players) return "a device's player is not among the players";
    if (static_cast<std::size_t>(device.kind) >= device_kinds) return "a device's kind is unknown";
    if (!std::isfinite(device.look_rad_per_count)) return "a device's look_rad_per_count is not finite";
    if (!std::isfinite(device.turn_rad_per_s)) return "a device's turn_rad_per_s is not finite";
    constexpr auto known = DeviceSpec::invert_y | DeviceSpec::no_forces | DeviceSpec::force_bits |
                           DeviceSpec::weight_bits | DeviceSpec::blow_bits;
    if ((device.flags & ~known) != 0) return "a device's flag is unknown";
    if (device.force_percent() > 100) return "a device's largest force is above 100 %";
    if (device.weight_reduction() > 100) return "a device's reduction of weight is above 100 %";
    if (device.blow_reduction() > 100) return "a device's reduction of blows is above 100 %";
    for (const auto edge : device.box_um) {
        if (edge > DeviceSpec::most_box_um) return "a device's box is larger than 10 m";
    }
    for (const auto percent : device.fluid_reduction) {
        if (percent > 100) return "a device's reduction of a fluid's force is above 100 %";
    }
    return {};
}

/// Returns the first fault of a header; empty if there is none.
std::string_view header_fault(const LogHeader& h) {
    if (h.players.size() > player_limit) return "more than 16 players";
    if (h.devices.size() > max_devices) return "more than 4 devices";
    if (h.files.size() > list_limit) return "more than 1000 data files";
    if (h.overrides.size() > list_limit) return "more than 1000 overrides";
    if (h.parameters.size() > list_limit) return "more than 1000 parameters";
    if (!strings_short(h)) return "a text longer than 65536 bytes";
    for (const auto& device : h.devices) {
        if (const auto fault = device_fault(device, h.players.size()); !fault.empty()) return fault;
    }
    return {};
}

// Lists ------------------------------------------------------------------------------------------

template <class T, class Put>
void put_list(ByteWriter& out, const std::vector<T>& list, Put put) {
    out.put(static_cast<std::uint32_t>(list.size()));
    for (const auto& item : list) put(item);
}

void put_strings(ByteWriter& out, const std::vector<std::string>& list) {
    put_list(out, list, [&](const std::string& s) { out.put_string(s); });
}

/// Reads a list. Stops at the first missing item, so a wrong count costs nothing.
template <class Get>
auto get_list(ByteReader& in, Get get) {
    std::vector<decltype(get())> list;
    const auto count = in.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < count && in.ok(); ++i) list.push_back(get());
    return list;
}

std::vector<std::string> get_strings(ByteReader& in) {
    return get_list(in, [&] { return in.get_string(); });
}

/// Bits of the flags in the file only. They say that the edges of the box, and then the fluid reductions,
/// follow.
constexpr std::uint32_t box_follows = 1U << 31U;
constexpr std::uint32_t fluid_follows = 1U << 30U;

bool has_box(const DeviceSpec& d) { return d.box_um != decltype(d.box_um){}; }
bool has_fluid(const DeviceSpec& d) { return d.fluid_reduction != decltype(d.fluid_reduction){}; }

void put_device(ByteWriter& out, const DeviceSpec& d) {
    out.put(d.player);
    out.put(d.kind);
    out.put_string(d.name);
    out.put(d.look_rad_per_count);
    out.put(d.turn_rad_per_s);
    out.put(d.flags | (has_box(d) ? box_follows : 0) | (has_fluid(d) ? fluid_follows : 0));
    if (has_box(d)) {
        for (const auto edge : d.box_um) out.put(edge);
    }
    if (has_fluid(d)) {
        for (const auto percent : d.fluid_reduction) out.put(percent);
    }
}

DeviceSpec get_device(ByteReader& in) {
    DeviceSpec d;
    d.player = in.get<std::uint32_t>();
    d.kind = in.get<DeviceKind>();
    d.name = in.get_string();
    d.look_rad_per_count = in.get<double>();
    d.turn_rad_per_s = in.get<double>();
    const auto flags = in.get<std::uint32_t>();
    d.flags = flags & ~(box_follows | fluid_follows);
    if ((flags & box_follows) != 0) {
        for (auto& edge : d.box_um) edge = in.get<std::uint32_t>();
    }
    if ((flags & fluid_follows) != 0) {
        for (auto& percent : d.fluid_reduction) percent = in.get<std::uint8_t>();
    }
    return d;
}

void put_body(ByteWriter& out, const LogHeader& h) {
    out.put_string(h.program);
    out.put(h.rules_version);
    out.put_string(h.rule_set);
    out.put_string(h.arena);
    out.put(h.seed);
    out.put(h.maths_probe);
    put_strings(out, h.players);
    put_list(out, h.devices, [&](const DeviceSpec& d) { put_device(out, d); });
    put_list(out, h.files, [&](const DataFile& f) {
        out.put_string(f.name);
        out.put(f.hash);
    });
    put_strings(out, h.overrides);
    put_strings(out, h.parameters);
}

LogHeader get_body(ByteReader& in) {
    LogHeader h;
    h.program = in.get_string();
    h.rules_version = in.get<std::uint32_t>();
    h.rule_set = in.get_string();
    h.arena = in.get_string();
    h.seed = in.get<std::uint64_t>();
    h.maths_probe = in.get<std::uint64_t>();
    h.players = get_strings(in);
    h.devices = get_list(in, [&] { return get_device(in); });
    h.files = get_list(in, [&] {
        auto name = in.get_string();
        const auto hash = in.get<std::uint64_t>();
        return DataFile{std::move(name), hash};
    });
    h.overrides = get_strings(in);
    h.parameters = get_strings(in);
    return h;
}

}  // namespace

Expected<Bytes> encode_header(const LogHeader& header) {
    if (const auto fault = header_fault(header); !fault.empty()) {
        return fail(text("a log cannot hold this header: ", fault));
    }
    Bytes body;
    ByteWriter body_out(body);
    put_body(body_out, header);
    if (body.size() > header_limit) return fail("a log cannot hold this header: more than 1 MiB");

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
    const auto version = in.get<std::uint32_t>();
    const std::size_t size = in.get<std::uint32_t>();
    const auto salt = in.get<std::uint64_t>();
    if (!in.ok()) return fail("the header is cut off");
    if (version > format_version) {
        return fail(text("log format ", version, " is newer than this program reads (", format_version,
                         "): use a newer Thaum, or the file is damaged"));
    }
    if (version != format_version || size > header_limit) return fail("the header is damaged");
    return Preamble{size, salt};
}

Expected<LogHeader> decode_header(std::span<const std::byte> file, const Preamble& preamble) {
    if (salt_of(file, preamble.body_size) != preamble.salt) return fail("the header is damaged");
    ByteReader in(file.subspan(preamble_size, preamble.body_size));
    auto header = get_body(in);
    if (!in.ok() || in.left() != 0) return fail("the header is malformed");
    if (const auto fault = header_fault(header); !fault.empty()) {
        return fail(text("the header is malformed: ", fault));
    }
    return header;
}

}  // namespace thaum::input::detail
