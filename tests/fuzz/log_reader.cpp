// Fuzzes the reader of match logs. Checksums in a log detect simple damage. Most mutants (mutated logs)
// therefore get correct checksums, so that they also test decompression, the decoder, and the making of the
// match.
#include <zstd.h>

#include <cstring>

#include "core/text.h"
#include "fuzz/fuzz.h"
#include "game/bots/duel.h"
#include "game/match/playback.h"
#include "unit/input_log_samples.h"

namespace thaum::fuzz {
namespace {

namespace detail = input::detail;
namespace samples = input::samples;

constexpr Tick recorded = 1100, max_played = 20;

Bytes bytes_of(const std::string& s) {
    const auto bytes = std::as_bytes(std::span(s));
    return {bytes.begin(), bytes.end()};
}

std::string string_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<std::string> recorded_logs(const Places& places) {
    const samples::Folder folder;
    std::vector<std::string> logs{string_of(samples::small_log(folder))};
    auto data = game::load_match_data(places.assets, {});
    if (!data) return {};
    auto duel = game::make_bot_duel(places.assets, std::make_shared<const game::MatchData>(std::move(*data)),
                                    {"level_1", "level_1"}, 7);
    if (!duel) return {};
    auto& match = *duel->match;
    auto log = input::LogWriter::create(folder / "duel",
                                        game::log_header(match.data(), match.setup(), {"bot 1", "bot 1"}));
    if (!log) return {};
    for (Tick t = 0; t < recorded; ++t) game::tick_and_record(match, duel->next_frame(), &*log);
    log->mark(1);
    if (!game::close_log(*log, match)) return {};
    logs.push_back(string_of(samples::bytes_of(folder / "duel")));
    return logs;
}

/// Whether blocks can be found in a seed. Seeds of the folder tests/fuzz/seeds may be damaged.
bool has_blocks(const std::string& seed) {
    if (seed.size() < detail::preamble_size) return false;
    const auto log = bytes_of(seed);
    if (!detail::decode_preamble(log)) return false;
    auto at = detail::preamble_size + samples::u32_at(log, 12);
    while (at + detail::block_header_size <= log.size())
        at += detail::block_header_size + samples::u32_at(log, at + 12);
    return at == log.size();
}

std::string mutated_payload(const Bytes& log, Random& random) {
    const auto blocks = samples::blocks_of(log);
    const auto& place = blocks[random.below(blocks.size())];
    const auto payload = string_of(std::span(log).subspan(
        place.begin + detail::block_header_size, place.end - place.begin - detail::block_header_size));
    const auto changed = mutate_bytes({payload}, random);
    return string_of(
        samples::with_block(log, place,
                            samples::signed_block(log, place.begin, std::as_bytes(std::span(changed)),
                                                  samples::u32_at(log, place.begin + 8))));
}

std::string mutated_columns(const Bytes& log, Random& random) {
    const auto blocks = samples::blocks_of(log);
    const auto& place = blocks[random.below(blocks.size())];
    std::string raw(samples::u32_at(log, place.begin + 8), '\0');
    ZSTD_decompress(raw.data(), raw.size(), log.data() + place.begin + detail::block_header_size,
                    place.end - place.begin - detail::block_header_size);
    const auto changed = mutate_bytes({raw}, random);
    Bytes packed(ZSTD_compressBound(changed.size()));
    packed.resize(ZSTD_compress(packed.data(), packed.size(), changed.data(), changed.size(), 1));
    return string_of(
        samples::with_block(log, place, samples::signed_block(log, place.begin, packed, changed.size())));
}

std::string body_of(const Bytes& log) {
    return string_of(std::span(log).subspan(detail::preamble_size, samples::u32_at(log, 12)));
}

/// The log with another body (the part after size and checksum) of its header. Both are corrected. The body's
/// checksum also enters the checksums of all blocks, so these are corrected, too.
std::string with_body(const Bytes& log, const std::string& body) {
    Bytes out(log.begin(), log.begin() + static_cast<std::ptrdiff_t>(detail::preamble_size));
    const auto bytes = std::as_bytes(std::span(body));
    out.insert(out.end(), bytes.begin(), bytes.end());
    samples::put_at(out, 12, static_cast<std::uint32_t>(body.size()));
    samples::put_at(out, 16, hash_bytes(bytes, hash_bytes(std::span(out).first(16))));
    // This copy has the new header, from which signed_block takes the value that enters checksums of blocks.
    Bytes signing = out;
    for (const auto& place : samples::blocks_of(log)) {
        const auto block = std::span(log).subspan(place.begin, place.end - place.begin);
        const auto at = signing.size();
        signing.insert(signing.end(), block.begin(), block.end());
        const auto again = samples::signed_block(signing, at, block.subspan(detail::block_header_size),
                                                 samples::u32_at(log, place.begin + 8));
        std::copy(again.begin(), again.end(), signing.begin() + static_cast<std::ptrdiff_t>(at));
    }
    return string_of(signing);
}

std::string mutated_header(const Bytes& log, Random& random) {
    return with_body(log, mutate_bytes({body_of(log)}, random));
}

/// Changes the content of one section and corrects the section's size. In format 1 the body has no sections.
std::string mutated_section(const Bytes& log, Random& random) {
    constexpr std::size_t record_size = 8, size_offset = 4;
    const auto body = body_of(log);
    const auto size_at = [&](std::size_t begin) {
        return ByteReader(std::as_bytes(std::span(body)).subspan(begin + size_offset)).get<std::uint32_t>();
    };
    std::vector<std::size_t> begins;
    for (std::size_t at = 0; at + record_size <= body.size(); at += record_size + size_at(at))
        begins.push_back(at);
    if (samples::preamble_of(log).format == 1 || begins.empty()) return mutated_header(log, random);
    const auto begin = begins[random.below(begins.size())];
    auto content = mutate_bytes({body.substr(begin + record_size, size_at(begin))}, random);
    auto head = body.substr(begin, record_size);
    const auto size = static_cast<std::uint32_t>(content.size());
    std::memcpy(head.data() + size_offset, &size, sizeof size);
    const auto end = std::min(body.size(), begin + record_size + size_at(begin));
    return with_body(log, body.substr(0, begin) + head + content + body.substr(end));
}

std::string mutate(const std::vector<std::string>& seeds, Random& random) {
    const auto& seed = seeds[random.below(seeds.size())];
    const auto how = has_blocks(seed) ? random.below(5) : 0;
    const auto log = bytes_of(seed);
    if (how == 1) return mutated_payload(log, random);
    if (how == 2) return mutated_columns(log, random);
    if (how == 3) return mutated_header(log, random);
    if (how == 4) return mutated_section(log, random);
    return mutate_bytes(seeds, random);
}

Outcome read_to_the_end(input::LogReader& reader) {
    Tick ticks = 0;
    for (input::InputFrame frame; reader.next(frame);) ++ticks;
    if (ticks != reader.ticks()) return {.fault = text("promised ", reader.ticks(), " ticks, gave ", ticks)};
    if (reader.ended_cleanly() != reader.ending_reason().empty())
        return {.fault = text("ending without its reason: ", reader.ending_reason())};
    return {.accepted = true, .refusal = reader.ending_reason()};
}

Outcome read(const std::string& input, const Places& places) {
    const samples::Scratch file(places.scratch / "log");
    auto outcome = [&]() -> Outcome {
        if (!file.set(std::as_bytes(std::span(input))))
            return {.fault = "the scratch folder cannot be written"};
        auto reader = input::LogReader::open(file.path);
        if (!reader) return {.refusal = reader.error().message};
        auto playback = game::Playback::open(file.path, places.assets);
        if (playback) {
            while (playback->match().now() < max_played && playback->step()) {}
        } else if (playback.error().message.find('\n') != std::string::npos) {
            return {.fault = playback.error().message};
        }
        return read_to_the_end(*reader);
    }();
    std::filesystem::remove(file.path);
    return outcome;
}

}  // namespace

const Reader log_reader{"log", recorded_logs, mutate, read};

}  // namespace thaum::fuzz
