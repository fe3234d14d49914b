// log_to_csv LOG: the input of a recorded match as a table, a row for each device and tick. The log's header
// is printed to standard error, together with one hash that combines all state hashes of the log.
#include <iostream>

#include "core/hash.h"
#include "core/text.h"
#include "input/log.h"

namespace {

using namespace thaum;

void print_header(const input::LogReader& log) {
    const auto& header = log.header();
    std::cerr << text("recorded by thaum ", header.program, ", rules ", header.rules_version, ", arena ",
                      header.arena, ", ", log.ticks(), " ticks\n");
    for (const auto& device : header.devices)
        std::cerr << text("device of ", header.players[device.player], ": ", device.name, "\n");
    std::uint64_t all = 0;
    for (const auto& record : log.hashes()) all = hash_combine(all, hash_combine(record.state, record.force));
    std::cerr << "hash " << hex(all) << '\n';
}

void print_row(Tick tick, std::size_t device, const input::DeviceSample& sample) {
    std::string row =
        text(tick, ',', device, ',', sample.buttons, ',', unsigned{sample.wand}, ',', sample.away ? 1 : 0);
    for (const auto value : sample.counts) row += text(',', value);
    std::cout << row << '\n';
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "usage: log_to_csv LOG\n";
        return 2;
    }
    auto log = input::LogReader::open(arguments[1]);
    if (!log) {
        std::cerr << log.error().message << '\n';
        return 1;
    }
    print_header(*log);
    std::cout
        << "tick,device,buttons,wand,away,count_0,count_1,count_2,count_3,count_4,count_5,count_6,count_7\n";
    input::InputFrame frame;
    for (Tick tick = 0; log->next(frame); ++tick)
        for (std::size_t i = 0; i < log->header().devices.size(); ++i) print_row(tick, i, frame.devices[i]);
    if (log->ending() == input::LogEnding::clean) return 0;
    std::cerr << log->ending_reason() << '\n';
    return 1;
}
