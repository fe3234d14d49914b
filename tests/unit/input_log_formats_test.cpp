// Tests of the formats of the log: format 1 can always be read, and format 2 has room for values that this
// program does not know.
#include <gtest/gtest.h>
#include <zstd.h>

#include "unit/allocations.h"
#include "unit/input_log_samples.h"
#include "unit/message_of.h"

namespace thaum::input {
namespace {

using samples::contains;
using samples::Folder;

/// A log whose header has this body, with a correct size and checksum.
Bytes signed_header(const Bytes& like, std::span<const std::byte> body) {
    Bytes file(like.begin(), like.begin() + detail::preamble_size);
    samples::put_at(file, 12, static_cast<std::uint32_t>(body.size()));
    samples::put_at(file, 16, hash_bytes(body, hash_bytes(std::span(file).first(16))));
    file.insert(file.end(), body.begin(), body.end());
    return file;
}

Bytes body_of(const Bytes& log) {
    const auto body = std::span(log).subspan(detail::preamble_size, samples::preamble_of(log).body_size);
    return {body.begin(), body.end()};
}

Expected<LogHeader> decoded(const Bytes& file) {
    const auto preamble = detail::decode_preamble(file);
    return preamble ? detail::decode_header(file, *preamble) : preamble.error();
}

/// Empty if the header with this body is accepted, otherwise the message of the error.
std::string refusal(const Bytes& like, std::span<const std::byte> body) {
    return message_of(decoded(signed_header(like, body)));
}

/// Offset just after a string in the body of a log's header.
std::size_t behind(const Bytes& body, std::string_view name) {
    const auto bytes = std::as_bytes(std::span(name));
    const auto found = std::search(body.begin(), body.end(), bytes.begin(), bytes.end());
    EXPECT_NE(found, body.end()) << name;
    return static_cast<std::size_t>(found - body.begin()) + name.size();
}

// Format 1 of a log --------------------------------------------------------------------------------

TEST(InputLogFormat1, EveryValueIsRead) {
    const Folder folder;
    ASSERT_TRUE(samples::put_file(folder / "log", samples::log_1()));
    auto reader = LogReader::open(folder / "log").value();
    EXPECT_EQ(reader.format(), 1U);
    EXPECT_EQ(reader.header(), samples::header_1());
    EXPECT_EQ(reader.ticks(), 1100U);
    EXPECT_TRUE(reader.ended_cleanly()) << reader.ending_reason();
    EXPECT_EQ(reader.result(), "2 : 1");
    for (const Tick t : {128U, 640U, 1024U, 1100U}) EXPECT_EQ(reader.hash_at(t), samples::hash_of(t)) << t;
    EXPECT_EQ(reader.marks(), (std::vector<Mark>{{1100, MarkKind::user, 7}}));
    InputFrame frame;
    for (Tick t = 0; reader.next(frame); ++t) ASSERT_EQ(frame, samples::frame_1(t)) << t;
}

TEST(InputLogFormat1, OlderLogsFeelAllOfAFluid) {
    const auto header = read_log_header(THAUM_SOURCE_DIR "/tests/replays/bots_rules_8.thaumlog").value();
    ASSERT_EQ(header.devices.size(), 2U);
    for (const auto& device : header.devices)
        EXPECT_EQ(device.fluid_reduction, (std::array<std::uint8_t, fluid_faders>{}));
}

TEST(InputLogFormat1, SettingsBeyondTheirLimitsAreRefused) {
    const auto log = samples::log_1();
    const auto body = body_of(log);
    ASSERT_EQ(refusal(log, body), "");
    const auto flags_at = behind(body, "device 1") + 2 * sizeof(double);
    const auto flags = ByteReader(std::span(body).subspan(flags_at)).get<std::uint32_t>();
    const auto with_flags = [&](std::uint32_t changed) {
        auto other = body;
        samples::put_at(other, flags_at, changed);
        return refusal(log, other);
    };
    EXPECT_EQ(with_flags(flags), "");
    for (const std::uint32_t unknown : {2U, 7U, 29U})
        EXPECT_TRUE(contains(with_flags(flags | 1U << unknown), "malformed")) << unknown;
    EXPECT_TRUE(contains(with_flags(flags | 101U << 8U), "largest force is above 100 %"));
    EXPECT_TRUE(contains(with_flags(flags | 127U << 15U), "reduction of weight is above 100 %"));
    EXPECT_TRUE(contains(with_flags(flags | 127U << 22U), "reduction of blows is above 100 %"));
    auto other = body;
    samples::put_at(other, flags_at + 4 + 8, DeviceSpec::max_box_um + 1);
    EXPECT_TRUE(contains(refusal(log, other), "box is larger than 10 m"));
    other = body;
    other[flags_at + 4 + 12 + 6] = std::byte{101};
    EXPECT_TRUE(contains(refusal(log, other), "fluid's force is above 100 %"));
}

TEST(InputLogFormat1, ABodyThatIsCutOrTooLargeIsRefused) {
    const auto log = samples::log_1();
    const auto body = body_of(log);
    for (std::size_t size = 0; size < body.size(); ++size)
        EXPECT_NE(refusal(log, std::span(body).first(size)), "") << size;
    auto longer = body;
    longer.push_back(std::byte{});
    EXPECT_NE(refusal(log, longer), "");
    EXPECT_TRUE(contains(refusal(log, Bytes((1U << 20U) + 1)), "damaged"));
}

// Format 2 of a log --------------------------------------------------------------------------------

/// A section of a header: tag, flags, size and content.
Bytes section(std::uint16_t tag, std::uint16_t flags, std::uint32_t size, std::size_t content) {
    Bytes bytes;
    ByteWriter out(bytes);
    out.put(tag);
    out.put(flags);
    out.put(size);
    bytes.resize(bytes.size() + content);
    return bytes;
}

/// Offsets at which the sections of a header's body begin, and the offset of its end.
std::vector<std::size_t> sections_of(const Bytes& body) {
    std::vector<std::size_t> begins{0};
    while (begins.back() < body.size())
        begins.push_back(begins.back() + 8 + samples::u32_at(body, begins.back() + 4));
    return begins;
}

struct HeaderSample {
    LogHeader header = samples::header();
    Bytes file = detail::encode_header(header).value();
    Bytes body = body_of(file);
    std::vector<std::size_t> sections = sections_of(body);
};

TEST(InputLogFormat2, UnknownSectionsAreSkippedUnlessTheyAreNeeded) {
    const HeaderSample sample;
    const auto with = [&](const Bytes& more) {
        auto body = sample.body;
        body.insert(body.end(), more.begin(), more.end());
        return body;
    };
    EXPECT_EQ(decoded(signed_header(sample.file, with(section(40, 0, 3, 3)))), sample.header);
    EXPECT_EQ(
        refusal(sample.file, with(section(40, 1, 3, 3))),
        "the header cannot be read: section 40 is unknown to this program and needed: use a newer Thaum");
    EXPECT_TRUE(contains(refusal(sample.file, with(section(40, 2, 0, 0))), "section 40 has an unknown flag"));
    EXPECT_TRUE(contains(refusal(sample.file, with(section(9, 1, 4, 4))), "section 9 follows section 9"));
    EXPECT_TRUE(contains(refusal(sample.file, with(section(0, 0, 0, 0))), "section 0 follows"));
    EXPECT_TRUE(contains(refusal(sample.file, with(section(40, 0, 4, 3))), "a section is cut off"));
    EXPECT_TRUE(contains(refusal(sample.file, with(section(40, 0, 0xffffffffU, 3))), "a section is cut off"));
}

TEST(InputLogFormat2, ASectionThatIsMissingCutOrTooLongIsRefused) {
    const HeaderSample sample;
    ASSERT_EQ(sample.sections.size(), 10U) << "nine sections";
    for (std::size_t size = 0; size < sample.body.size(); ++size) {
        const bool without_profile = size == sample.sections[8];
        EXPECT_EQ(refusal(sample.file, std::span(sample.body).first(size)).empty(), without_profile) << size;
    }
    for (std::size_t i = 0; i < 8; ++i) {
        auto body = sample.body;
        const auto at = [&](std::size_t offset) {
            return body.begin() + static_cast<std::ptrdiff_t>(offset);
        };
        body.erase(at(sample.sections[i]), at(sample.sections[i + 1]));
        EXPECT_TRUE(contains(refusal(sample.file, body), "a section is missing")) << i;
    }
    for (std::size_t i = 0; i < 9; ++i) {
        auto body = sample.body;
        samples::put_at(body, sample.sections[i] + 4, samples::u32_at(body, sample.sections[i] + 4) + 1);
        body.insert(body.begin() + static_cast<std::ptrdiff_t>(sample.sections[i + 1]), std::byte{});
        EXPECT_TRUE(contains(refusal(sample.file, body), text("section ", i + 1, " is malformed"))) << i;
    }
}

TEST(InputLogFormat2, ACountThatTheFileCannotHoldCostsNothing) {
    const HeaderSample sample;
    for (std::size_t i = 2; i < 9; ++i) {  // the sections that begin with the length of a list
        for (const std::uint32_t count : {0xffffffffU, 1001U}) {
            auto body = sample.body;
            samples::put_at(body, sample.sections[i] + 8, count);
            const auto file = signed_header(sample.file, body);
            const auto before = test::allocations();
            EXPECT_FALSE(decoded(file)) << i;
            EXPECT_LT(test::allocations() - before, 200U) << i;
        }
    }
}

TEST(InputLogFormat2, AListThatIsTooLongIsRefusedBeforeItsItemsAreRead) {
    const HeaderSample sample;
    const auto at = [](Bytes& bytes, std::size_t offset) {
        return bytes.begin() + static_cast<std::ptrdiff_t>(offset);
    };
    // Makes a header with `count` empty overrides (changed values of data files), and returns the number of
    // allocations until it is refused.
    const auto allocations_of = [&](std::uint32_t count, bool accepted) {
        auto overrides = section(6, 1, 4 + 4 * count, 4 + 4 * std::size_t{count});
        samples::put_at(overrides, 8, count);
        auto body = sample.body;
        body.erase(at(body, sample.sections[5]), at(body, sample.sections[6]));
        body.insert(at(body, sample.sections[5]), overrides.begin(), overrides.end());
        const auto file = signed_header(sample.file, body);
        const auto before = test::allocations();
        EXPECT_EQ(decoded(file).has_value(), accepted) << count;
        return test::allocations() - before;
    };
    allocations_of(1000, true);
    EXPECT_EQ(allocations_of(1001, false), allocations_of(4'000'000, false));
}

/// Body of a header whose last device has one more setting.
Bytes with_setting(const HeaderSample& sample, std::uint16_t tag, std::uint16_t flags, std::uint32_t size) {
    auto body = sample.body;
    const auto setting = section(tag, flags, size, size);
    const auto settings_at = behind(body, "device 1");
    const auto settings = samples::u32_at(body, settings_at);
    const auto added = static_cast<std::uint32_t>(setting.size());
    samples::put_at(body, settings_at, settings + added);
    samples::put_at(body, sample.sections[3] + 4, samples::u32_at(body, sample.sections[3] + 4) + added);
    body.insert(body.begin() + static_cast<std::ptrdiff_t>(settings_at + 4 + settings), setting.begin(),
                setting.end());
    return body;
}

TEST(InputLogFormat2, UnknownSettingsOfADeviceAreSkippedUnlessTheyAreNeeded) {
    const HeaderSample sample;
    EXPECT_EQ(decoded(signed_header(sample.file, with_setting(sample, 30, 0, 5))), sample.header);
    EXPECT_EQ(
        refusal(sample.file, with_setting(sample, 30, 1, 5)),
        "the header cannot be read: setting 30 is unknown to this program and needed: use a newer Thaum");
    EXPECT_TRUE(
        contains(refusal(sample.file, with_setting(sample, 30, 4, 5)), "setting 30 has an unknown flag"));
    EXPECT_TRUE(contains(refusal(sample.file, with_setting(sample, 9, 1, 7)), "setting 9 follows setting 9"));
}

TEST(InputLogFormat2, TheHelpWithAimingIsKept) {
    auto sample = HeaderSample();
    for (const int percent : {0, 1, 40, 100}) {
        sample.header.devices[1].aim_assist = static_cast<std::uint8_t>(percent);
        EXPECT_EQ(decoded(detail::encode_header(sample.header).value()), sample.header) << percent;
    }
}

TEST(InputLogFormat2, CastingWithoutAButtonIsKept) {
    auto sample = HeaderSample();
    const auto without = detail::encode_header(sample.header).value();
    sample.header.devices[1].casts_freely = true;
    const auto with = detail::encode_header(sample.header).value();
    EXPECT_EQ(decoded(with), sample.header);
    EXPECT_EQ(with.size(), without.size() + 9) << "a record of one byte, and none for the usual value";
}

TEST(InputLogFormat2, FadersOfADeviceAreKept) {
    auto sample = HeaderSample();
    auto& device = sample.header.devices[1];
    device.set_touch_percent(40, 0);
    device.moves_faders = true;
    const auto read = decoded(detail::encode_header(sample.header).value()).value();
    EXPECT_EQ(read, sample.header);
    const auto faders = read.devices[1].faders();
    EXPECT_EQ(faders[static_cast<std::size_t>(HandFader::recoil) - 1], 40);
    EXPECT_EQ(faders[static_cast<std::size_t>(HandFader::roughness) - 1], 0);
}

TEST(InputLogFormat2, ASettingOfAnotherSizeOrBeyondItsLimitIsRefused) {
    auto sample = HeaderSample();
    sample.header.devices.pop_back();
    sample.header.devices[0].fluid_reduction[6] = 77;
    sample.file = detail::encode_header(sample.header).value();
    sample.body = body_of(sample.file);
    ASSERT_EQ(decoded(sample.file), sample.header);
    const auto settings_at = behind(sample.body, "device 0");
    auto body = sample.body;
    // The device ends with its last setting: a size of four bytes, then seven values of one byte each.
    const auto last = settings_at + 4 + samples::u32_at(body, settings_at) - 1;
    ASSERT_EQ(body[last], std::byte{77});
    body[last] = std::byte{101};
    EXPECT_TRUE(contains(refusal(sample.file, body), "fluid's force is above 100 %"));
    body[last] = std::byte{100};
    EXPECT_EQ(refusal(sample.file, body), "");
    samples::put_at(body, last - 10, std::uint32_t{6});
    EXPECT_NE(refusal(sample.file, body), "");
}

TEST(InputLogFormat2, ProfileDataAreKeptToTheByte) {
    const Folder folder;
    auto header = samples::header();
    Bytes large(15U << 20U);
    for (std::size_t i = 0; i < large.size(); ++i) large[i] = static_cast<std::byte>(hash_value(i, 1));
    header.profile = {{"gesture", "circle", 1, large}, {"gesture", "stroke", 0, {}}, {"network", "", 0, {}}};
    {
        auto writer = LogWriter::create(folder / "log", header).value();
        samples::record(writer, 600, samples::calm_frame);
        ASSERT_TRUE(writer.close("kept"));
    }
    const auto reader = LogReader::open(folder / "log").value();
    EXPECT_EQ(reader.header(), header);
    EXPECT_EQ(reader.format(), 2U);
    EXPECT_EQ(reader.ticks(), 600U);
    EXPECT_TRUE(reader.ended_cleanly()) << reader.ending_reason();
    EXPECT_EQ(read_log_header(folder / "log"), header);
}

TEST(InputLogFormat2, NamesOnTheScreenAreKeptAndOlderReadersSkipThem) {
    const HeaderSample without;
    auto header = without.header;
    header.names = {"Jos\u00e9", "Bot 3"};
    const auto file = detail::encode_header(header).value();
    EXPECT_EQ(decoded(file), header);
    EXPECT_TRUE(decoded(without.file).value().names.empty());
    // The names are the last section. All bytes before them equal those of a log without names.
    const auto body = body_of(file);
    ASSERT_TRUE(std::equal(without.body.begin(), without.body.end(), body.begin()));
    ByteReader names(std::span<const std::byte>(body).subspan(without.body.size()));
    EXPECT_EQ(names.get<std::uint16_t>(), 10U);
    EXPECT_EQ(names.get<std::uint16_t>(), 0U) << "a reader that does not know this section skips it";
}

TEST(InputLogFormat2, NamesForNobodyAndOverlongNamesAreRefused) {
    auto header = samples::header();
    header.names = {"a", "b", "c"};
    EXPECT_TRUE(contains(detail::encode_header(header).error().message, "more names than players"));
    header.names = {std::string(65'537, 'a')};
    EXPECT_TRUE(contains(detail::encode_header(header).error().message, "a text longer than 65536 bytes"));
    const HeaderSample sample;
    for (const std::uint32_t count : {3U, 17U, 0xffffffffU}) {
        auto body = sample.body;
        auto names = section(10, 0, 16, 16);
        samples::put_at(names, 8, count);
        body.insert(body.end(), names.begin(), names.end());
        EXPECT_NE(refusal(sample.file, body), "") << count;
    }
}

// Columns of a log's blocks ------------------------------------------------------------------------

/// An unpacked block with one tick of one device, in which one column has a value and all others are zero.
Bytes raw_tick(std::size_t columns, std::size_t column, std::uint32_t value) {
    Bytes raw;
    ByteWriter out(raw);
    for (std::size_t i = 0; i < columns; ++i) {
        out.put(std::uint8_t{0});
        out.put_varint(i == column ? 3 : 2);
        if (i == column) out.put_varint(std::uint64_t{value} << 1U);
    }
    out.put_varint(0);
    out.put_varint(0);
    return raw;
}

/// The sample of a block with one tick; std::nullopt if the block is refused.
std::optional<DeviceSample> unpacked(const Bytes& raw, std::uint32_t format) {
    Bytes packed(ZSTD_compressBound(raw.size()));
    packed.resize(ZSTD_compress(packed.data(), packed.size(), raw.data(), raw.size(), 1));
    const detail::Preamble log{.format = format, .body_size = 0, .salt = 5};
    const detail::BlockHeader header{detail::BlockKind::ticks,    1, raw.size(), packed.size(), 0,
                                     hash_bytes(packed, log.salt)};
    detail::Unpacker unpacker(1, log);
    const auto block = std::make_unique<detail::Block>();
    if (!unpacker.ticks(header, packed, *block)) return {};
    return block->frames[0].devices[0];
}

TEST(InputLogColumns, Format2HoldsWandAndAbsenceInColumnsOfTheirOwn) {
    constexpr std::size_t columns = 13, buttons = 8, model_age = 9, skips = 10, wand = 11, state = 12;
    const auto at = [&](std::size_t column, std::uint32_t value) {
        return unpacked(raw_tick(columns, column, value), 2);
    };
    EXPECT_EQ(at(0, 0), DeviceSample{});
    EXPECT_EQ(at(buttons, 0x7fffffffU).value().buttons, 0x7fffffffU) << "no bit of the buttons is a wand";
    EXPECT_EQ(at(buttons, 0x7fffffffU).value().wand, 0U);
    EXPECT_EQ(at(wand, 9).value().wand, 9U);
    EXPECT_FALSE(at(wand, 10));
    EXPECT_FALSE(at(wand, 256 + 9)) << "the value is not cut to a byte";
    EXPECT_TRUE(at(state, 1).value().away);
    EXPECT_FALSE(at(state, 2)) << "another bit is for a later program";
    EXPECT_EQ(at(model_age, 65535).value().model_age, 65535U);
    EXPECT_FALSE(at(model_age, 65536));
    EXPECT_FALSE(at(skips, 65536));
    EXPECT_FALSE(unpacked(raw_tick(11, 0, 0), 2)) << "columns are missing";
}

TEST(InputLogColumns, AMovedFaderIsInTheColumnOfTheState) {
    constexpr std::size_t columns = 13, state = 12;
    const auto at = [&](std::uint32_t value) { return unpacked(raw_tick(columns, state, value), 2); };
    const auto moved = at(2U << 8U | 75U << 16U).value();
    EXPECT_EQ(moved.change, (FaderChange{2, 75}));
    EXPECT_FALSE(moved.away);
    EXPECT_TRUE(at(1U | 12U << 8U | 100U << 16U).value().away);
    EXPECT_EQ(at(1U << 8U | 101U << 16U).value().change, (FaderChange{1, force_as_rules}));
    EXPECT_FALSE(at(2U << 8U | 101U << 16U)) << "only the largest force may be as in the data files";
    EXPECT_FALSE(at(1U << 8U | 102U << 16U));
    EXPECT_FALSE(at(13U << 8U)) << "there is no such fader";
    EXPECT_FALSE(at(50U << 16U)) << "a value without a fader";
    EXPECT_FALSE(at(1U << 24U)) << "another bit is for a later program";
}

TEST(InputLogColumns, Format1HoldsTheWandAmongTheButtons) {
    constexpr std::size_t columns = 11, buttons = 8;
    for (std::uint32_t wand = 1; wand <= 9; ++wand) {
        const auto bit = 1U << (wand <= 5 ? 10U + wand : 13U + wand);
        const auto sample = unpacked(raw_tick(columns, buttons, bit | 1U), 1).value();
        EXPECT_EQ(sample.wand, wand);
        EXPECT_EQ(sample.buttons, 1U) << "the wand's bit is no button";
        EXPECT_FALSE(sample.away);
    }
    EXPECT_EQ(unpacked(raw_tick(columns, buttons, 1U << 11U | 1U << 22U), 1).value().wand, 9U);
    EXPECT_EQ(unpacked(raw_tick(columns, buttons, 0), 1), DeviceSample{});
    EXPECT_FALSE(unpacked(raw_tick(13, 0, 0), 1)) << "two columns too many";
}

TEST(InputLogColumns, ABlockIsAtMostAsLargeAsItsFormatAllows) {
    for (const std::uint32_t format : {1U, 2U}) {
        const detail::Preamble log{.format = format, .body_size = 0, .salt = 5};
        const std::size_t columns = format == 1 ? 11 : 13;
        const auto accepted = [&](std::uint16_t ticks, std::size_t raw_size) {
            Bytes head;
            ByteWriter out(head);
            out.put(std::uint32_t{0x4b4c4254});
            out.put(std::uint16_t{1});
            out.put(ticks);
            out.put(static_cast<std::uint32_t>(raw_size));
            out.put(std::uint32_t{20});
            out.put(std::uint64_t{0});
            out.put(std::uint64_t{0});
            out.put(hash_bytes(head, log.salt));
            return detail::decode_block_header(head, log).has_value();
        };
        for (const std::uint16_t ticks : {std::uint16_t{1}, std::uint16_t{512}}) {
            const auto most = 4 * columns * (1 + 7 * std::size_t{ticks}) + 610;
            EXPECT_TRUE(accepted(ticks, most)) << format << ' ' << ticks;
            EXPECT_FALSE(accepted(ticks, most + 1)) << format << ' ' << ticks;
        }
    }
}

}  // namespace
}  // namespace thaum::input
