// game/live/told_state.h: tells the state of an output, such as the loudspeakers, on
// the terminal whenever it changes.
#pragma once
#include <cstdint>
#include <string>
#include <utility>

namespace thaum::game::inline live {

class ToldState {
public:
    /// Prints the state of an output, such as audio::Speakers, where it differs
    /// from the last one, after `whose`.
    template <class Output>
    void tell(const std::string& whose, const Output& output) {
        auto state = output.status();  // before the report, which may then be newer but not older
        tell(whose, std::move(state), output.report().times_opened);
    }

private:
    /// Prints nothing for an empty state. That the output works is worth a line only after it did not.
    /// `times_opened` is above 0 if the output has worked before.
    void tell(const std::string& whose, std::string state, std::uint64_t times_opened);

    std::string told_{};
};

}  // namespace thaum::game::inline live
