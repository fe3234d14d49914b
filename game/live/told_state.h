// game/live/told_state.h: prints the state of an output, such as the loudspeakers, on the terminal whenever
// it changes.
#pragma once
#include <cstdint>
#include <string>
#include <utility>

namespace thaum::game::inline live {

class ToldState {
public:
    /// Prints the words `whose` and the state of an output, such as audio::Speakers, if the state differs
    /// from that of the last call.
    template <class Output>
    void tell(const std::string& whose, const Output& output) {
        // read before the report, so that the report is never older than the state
        auto state = output.status();
        tell(whose, std::move(state), output.report().times_opened);
    }

private:
    /// Prints a state that is not empty and differs from the last one. The first state is printed only if
    /// `times_opened`, the number of times that the output was opened, is 0: an output that works from the
    /// start needs no line.
    void tell(const std::string& whose, std::string state, std::uint64_t times_opened);

    std::string told_{};
};

}  // namespace thaum::game::inline live
