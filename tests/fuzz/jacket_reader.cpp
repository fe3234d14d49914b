// Readers of a jacket's setting and of a bHaptics Player's replies.
#include "core/text.h"
#include "fuzz/fuzz.h"
#include "game/app/bhaptics_messages.h"
#include "game/app/jacket.h"

namespace thaum::fuzz {
namespace {

Outcome read_reply(const std::string& input, const Places&) {
    const auto reply = app::read_bhaptics_reply(input);
    return reply ? Outcome{.accepted = true} : Outcome{.refusal = reply.error().message};
}

Outcome read_setting(const std::string& input, const Places&) {
    const auto jacket = app::parse_jacket(input);
    if (!jacket) return {.refusal = jacket.error().message};
    const auto output = app::jacket_output(*jacket);
    const bool none = jacket->link == app::Jacket::Link::none;
    if (none != (output == nullptr)) return {.fault = "a jacket without an output"};
    if (!none && (jacket->address.host.empty() || jacket->address.port == 0)) return {.fault = "no address"};
    return {.accepted = true};
}

std::vector<std::string> replies(const Places&) {
    return {
        R"({"ConnectedDeviceCount":2,"ConnectedPositions":["Vest","Head"],"Status":{"Head":[0,0,0,0,0,0]}})"};
}
std::vector<std::string> settings(const Places&) {
    return {"", "bhaptics", "bhaptics:player:15881", "osc:192.168.1.7:1027", "osc16:[fe80::1%eth0]:9000"};
}

}  // namespace

const Reader bhaptics_reader{"bhaptics", replies, mutate_text, read_reply};
const Reader jacket_reader{"jacket", settings, mutate_bytes, read_setting};

}  // namespace thaum::fuzz
