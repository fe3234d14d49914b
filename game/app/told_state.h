// game/app/told_state.h: tells the state of an output, such as the loudspeakers, on the terminal whenever it changes.
#pragma once
#include <cstdint>
#include <string>

namespace thaum::app {

class ToldState {
public:
    /// Prints a state that differs from the last one, after `whose`. An empty state is no news. That all is well is
    /// worth a line only after it was not: `times_opened` is above 0 if the output has worked.
    void tell(const std::string& whose, std::string state, std::uint64_t times_opened);

private:
    std::string told_{};
};

}  // namespace thaum::app
