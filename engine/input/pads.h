// input/pads.h: game pads, by SDL. SDL knows some hundred models and maps the buttons of each to the layout
// of an Xbox pad. It also accepts any pad whose driver follows Linux's rules for pads. Its environment
// variable SDL_GAMECONTROLLERCONFIG adds mappings.
//
//     PadReader reader(own_mappings);    looks for pads in a thread of its own, which takes some milliseconds
//     const Pads& pads = reader.poll();  as often as needed; pads send no events
//
// The library is Thaum::pads. Only pads.cpp includes SDL, and does not use its windows, events or signals.
// Motors are in input/rumble.h.
#pragma once
#include <memory>

#include "core/error.h"
#include "input/pad_state.h"

namespace thaum::input {

/// All pads of this machine. One thread makes all calls. Only one reader may exist at a time.
class PadReader {
public:
    /// Starts to look for pads in another thread. `mappings` are lines in the form of SDL's
    /// gamecontrollerdb.txt.
    explicit PadReader(std::vector<std::string> mappings = {});
    ~PadReader();
    PadReader(const PadReader&) = delete;
    PadReader& operator=(const PadReader&) = delete;

    /// Current states of the pads. The first call waits until the search for pads has ended.
    const Pads& poll();

    /// Joysticks found by the last `poll` that cannot be used as pads.
    const std::vector<Stick>& sticks() const;
    /// Names of pads that cannot be used because all places in the list of pads are taken.
    const std::vector<std::string>& left_over() const;
    /// Names of pads without a right stick.
    std::vector<std::string> without_right_stick() const;
    /// Why there are no pads at all, or which mapping is faulty; empty: no fault.
    const std::string& fault() const;

    /// Pads that use a mapping passed to the constructor or to `add`, described as joysticks, since such a
    /// mapping names their parts. `guid` of each is the model for which the mapping was made.
    std::vector<Stick> own() const;

    /// Adds a mapping, a line that says which part of a joystick is which control. It turns the joysticks of
    /// its model into pads. The error says what is wrong with it.
    Expected<void> add(const std::string& mapping);
    /// Removes the mappings of a model of joysticks that were passed to the constructor or to `add`. Then
    /// searches for all pads again, which takes some milliseconds.
    void forget(const std::string& model);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace thaum::input
