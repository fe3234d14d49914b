// input/pads.h: game pads, by SDL. SDL knows some hundred models and how the buttons of each are called in the layout of an
// Xbox pad, and it takes any pad whose driver follows Linux's rules for pads. Its environment variable
// SDL_GAMECONTROLLERCONFIG adds mappings.
//
//     PadReader reader(own_mappings);       looks for pads in a thread of its own, since that takes some milliseconds
//     const Pads& pads = reader.poll();     as often as needed; pads send no events
//
// The library is Thaum::pads. Only pads.cpp knows SDL, of which neither windows nor events nor signals are used. Motors
// have a file of their own (input/rumble.h).
#pragma once
#include <memory>

#include "core/error.h"
#include "input/pad_state.h"

namespace thaum::input {

/// All pads of this machine. One thread makes all calls. Only one reader may exist at a time.
class PadReader {
public:
    /// Begins to look for pads. `mappings` are lines in the form of SDL's gamecontrollerdb.txt.
    explicit PadReader(std::vector<std::string> mappings = {});
    ~PadReader();
    PadReader(const PadReader&) = delete;
    PadReader& operator=(const PadReader&) = delete;

    /// States of the pads now. The first call waits until the look for pads has ended.
    const Pads& poll();

    // What the last `poll` has found:
    /// Joysticks that are no pads.
    const std::vector<Stick>& sticks() const;
    /// Names of pads that cannot play, since Pads has no place for them.
    const std::vector<std::string>& left_over() const;
    /// Names of pads without a right stick.
    std::vector<std::string> without_right_stick() const;
    /// Why there are no pads at all, or which mapping is faulty; empty: all is well.
    const std::string& fault() const;

    /// Pads that play by a mapping of the constructor or of `add`, as joysticks, whose parts such a mapping names. Their
    /// model is that of the mapping.
    std::vector<Stick> own() const;

    /// Adds a mapping, which makes pads of the joysticks of its model. The error says what is wrong with it.
    Expected<void> add(const std::string& mapping);
    /// Takes the mappings of a model back that the constructor or `add` has taken. All pads are looked for again, which
    /// takes some milliseconds.
    void forget(const std::string& model);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace thaum::input
