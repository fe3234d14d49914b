// game/jackets/jacket_output.h: base of the outputs that tell why their jacket is no longer connected.
#pragma once
#include <string>

#include "input/tactile_output.h"

namespace thaum::game::inline jackets {

class JacketOutput : public input::TactileOutput {
public:
    std::string fault() final { return fault_; }

protected:
    std::string fault_{};  ///< words of `fault`; empty: the jacket has not been given up
};

}  // namespace thaum::game::inline jackets
