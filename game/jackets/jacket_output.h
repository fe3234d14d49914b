// game/jackets/jacket_output.h: base class of outputs to jackets. It tells why the jacket is no longer
// connected.
#pragma once
#include <string>

#include "input/tactile_output.h"

namespace thaum::game::inline jackets {

class JacketOutput : public input::TactileOutput {
public:
    std::string fault() final { return fault_; }

protected:
    std::string fault_{};  ///< why the jacket has been given up, in words; empty: it has not been
};

}  // namespace thaum::game::inline jackets
