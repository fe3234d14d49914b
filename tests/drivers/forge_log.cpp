// forge_log HOW LOG FORGED: copies a closed log with one change and correct checksums, as a forger would do
// who wants a false match to be accepted. HOW is the change: same (none); no_hashes, no_middle, no_last
// (leaves out all hashes, one in the middle, or the last one); early_input, late_input (changes the input of
// one tick); result (writes a false result); codes (adds control codes of a terminal to the result).
#include <cstdio>
#include <string_view>

#include "input/log.h"

using namespace thaum;

namespace {

constexpr std::uint64_t removed_tick = 2 * hash_interval;
constexpr Tick early_tick = 200;

bool keeps(std::string_view how, const input::HashRecord& hash, Tick last) {
    if (how == "no_hashes") return false;
    if (how == "no_middle") return hash.tick != removed_tick;
    return how != "no_last" || hash.tick != last;
}

std::string result_of(std::string_view how, const std::string& recorded) {
    if (how == "result") return "player 2 wins by kills, score 0 : 9, after 1.0 s";
    if (how == "codes") return recorded + "\x1b[2J\x07";
    return recorded;
}

Expected<void> forge(std::string_view how, input::LogReader& from, input::LogWriter& to) {
    input::InputFrame frame;
    const auto last = from.ticks();
    for (Tick t = 1; from.next(frame); ++t) {
        if ((how == "late_input" && t == last) || (how == "early_input" && t == early_tick))
            frame.devices[0].counts[input::hand::look_right] += 40;
        to.append(frame);
        const auto hash = from.hash_at(t);
        if (hash && t % hash_interval == 0 && keeps(how, *hash, last))
            to.append_hash(t, hash->state, hash->force);
    }
    const auto end = from.hash_at(last);
    const bool with_end = end && keeps(how, *end, last);
    return to.close(result_of(how, from.result()), with_end ? end : std::nullopt);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return std::fprintf(stderr, "usage: forge_log HOW LOG FORGED\n"), 2;
    auto from = input::LogReader::open(argv[2]);
    if (!from) return std::fprintf(stderr, "%s\n", from.error().message.c_str()), 2;
    auto to = input::LogWriter::create(argv[3], from->header(), input::WhenBehind::wait);
    if (!to) return std::fprintf(stderr, "%s\n", to.error().message.c_str()), 2;
    const auto forged = forge(argv[1], *from, *to);
    return forged ? 0 : (std::fprintf(stderr, "%s\n", forged.error().message.c_str()), 2);
}
