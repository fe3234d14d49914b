#include "game/jackets/jacket_maker.h"

#include "core/text.h"

namespace thaum::game::inline jackets {

JacketCheck check_by_opening(const Jacket&, input::TactileOutput& output) {
    if (const auto opened = output.open(); !opened)
        return {false, text(": ", opened.error().message), "it is looked for every two seconds in a session"};
    output.close();
    return {true, " can be used", ""};
}

}  // namespace thaum::game::inline jackets
