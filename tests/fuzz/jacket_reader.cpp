// Fuzzes the readers of the setting of a tactile jacket and of replies by the bHaptics Player.
#include "core/text.h"
#include "fuzz/fuzz.h"
#include "game/jackets/bhaptics_messages.h"
#include "game/jackets/jacket.h"

namespace thaum::fuzz {
namespace {

Outcome read_reply(const std::string& input, const Places&) {
    const auto reply = game::read_bhaptics_reply(input);
    return reply ? Outcome{.accepted = true} : Outcome{.refusal = reply.error().message};
}

Outcome read_setting(const std::string& input, const Places&) {
    const auto jacket = game::parse_jacket(input);
    if (!jacket) return {.refusal = jacket.error().message};
    const auto output = game::jacket_output(*jacket, 0);
    const bool none = !*jacket;
    if (none != (output == nullptr)) return {.fault = "a jacket without an output"};
    if (none != (jacket->layout().motors == 0)) return {.fault = "no motors"};
    if (none) return {.accepted = true};
    if (jacket->place.empty() && jacket->maker->name != "audio") return {.fault = "no place"};
    // A jacket's place (an address or a device) that is read again must stay the same, since equal places
    // name one device.
    const auto again = jacket->maker->read(jacket->form->word, jacket->place);
    if (!jacket->place.empty() && (!again || *again != jacket->place)) return {.fault = "another place"};
    return {.accepted = true};
}

std::vector<std::string> replies(const Places&) {
    return {
        R"({"ConnectedDeviceCount":2,"ConnectedPositions":["Vest","Head"],"Status":{"Head":[0,0,0,0,0,0]}})"};
}
std::vector<std::string> settings(const Places&) {
    return {"",
            "bhaptics",
            "bhaptics:player:15881",
            "osc:192.168.1.7:1027",
            "osc16:[fe80::1%eth0]:9000",
            "hid:1209:c0de",
            "audio",
            "audio8:Surround 7.1",
            "record:felt.csv"};
}

}  // namespace

const Reader bhaptics_reader{"bhaptics", replies, mutate_text, read_reply};
const Reader jacket_reader{"jacket", settings, mutate_bytes, read_setting};

}  // namespace thaum::fuzz
