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
    /// Prints nothing for an empty state. A first state is printed only if `times_opened` is 0, because an
    /// output that works from the start needs no line. `times_opened` is above 0 if the output has worked
    /// before.
    void tell(const std::string& whose, std::string state, std::uint64_t times_opened);

    std::string told_{};
};

}  // namespace thaum::game::inline live
