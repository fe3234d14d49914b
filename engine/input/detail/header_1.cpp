// Body of the header in format 1, which can always be read but is no longer written. In that format a
// device's settings are bits of its flags, and two further groups of settings follow if a flag says so.
#include "input/detail/header.h"
#include "input/detail/header_parts.h"

namespace thaum::input::detail {
namespace {

/// Bits of a device's flags in a header of format 1.
namespace flag {
constexpr std::uint32_t invert_y = 1U << 0U;
constexpr std::uint32_t no_forces = 1U << 1U;
constexpr std::uint32_t force_shift = 8, weight_shift = 15, blow_shift = 22;
constexpr std::uint32_t percent_bits = 0x7FU;
constexpr std::uint32_t fluid_follows = 1U << 30U;
constexpr std::uint32_t box_follows = 1U << 31U;
constexpr std::uint32_t known = invert_y | no_forces | percent_bits << force_shift |
                                percent_bits << weight_shift | percent_bits << blow_shift | fluid_follows |
                                box_follows;
}  // namespace flag

/// Stands for no limit on the length of a list: bodies of format 1 are at most 1 MiB, which limits their
/// lists.
constexpr std::size_t any_count = 0xffffffffU;

std::uint8_t percent_at(std::uint32_t flags, std::uint32_t shift) {
    return static_cast<std::uint8_t>(flags >> shift & flag::percent_bits);
}

DeviceSpec get_old_device(ByteReader& in) {
    DeviceSpec d;
    d.player = in.get<std::uint32_t>();
    d.kind = in.get<DeviceKind>();
    d.name = in.get_string();
    d.look_rad_per_count = in.get<double>();
    d.turn_rad_per_s = in.get<double>();
    const auto flags = in.get<std::uint32_t>();
    if ((flags & ~flag::known) != 0) in.reject();
    d.invert_y = (flags & flag::invert_y) != 0;
    d.no_forces = (flags & flag::no_forces) != 0;
    d.force_percent = percent_at(flags, flag::force_shift);
    d.weight_reduction = percent_at(flags, flag::weight_shift);
    d.blow_reduction = percent_at(flags, flag::blow_shift);
    if ((flags & flag::box_follows) != 0) {
        for (auto& edge : d.box_um) edge = in.get<std::uint32_t>();
    }
    if ((flags & flag::fluid_follows) != 0) {
        for (auto& percent : d.fluid_reduction) percent = in.get<std::uint8_t>();
    }
    return d;
}

}  // namespace

Expected<LogHeader> decode_body_1(std::span<const std::byte> body) {
    ByteReader in(body);
    LogHeader h;
    get_match(in, h);
    h.players = get_strings(in, any_count);
    h.devices = get_list(in, any_count, [&] { return get_old_device(in); });
    h.files = get_list(in, any_count, [&] { return get_file(in); });
    h.overrides = get_strings(in, any_count);
    h.parameters = get_strings(in, any_count);
    if (!in.ok() || in.left() != 0) return fail("the header is malformed");
    return h;
}

}  // namespace thaum::input::detail
