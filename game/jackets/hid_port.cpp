#include "game/jackets/hid_port.h"

#include <hidapi.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <mutex>
#include <string>

#include "core/text.h"

namespace thaum::game::inline jackets {
namespace {

/// First of the HID usage pages that a maker may define (HID Usage Tables, 3.1). The usage pages of keyboards
/// and mice have lower numbers.
constexpr unsigned first_vendor_page = 0xFF00;

/// Lock for hidapi, which may list, open and close devices in one thread at a time only.
std::mutex& library_mutex() {
    static std::mutex mutex;
    return mutex;
}

class LibraryPort final : public HidPort {
public:
    explicit LibraryPort(hid_device* device) : device_(device) {}
    ~LibraryPort() override {
        const std::lock_guard lock(library_mutex());
        hid_close(device_);
    }

    bool write(std::span<const std::uint8_t> report) override {
        return hid_write(device_, report.data(), report.size()) >= 0;
    }
    bool is_there() override {
        constexpr int max_reports = 16;  // maximum number of reports per call, because
                                         // a device that sends without end must not hold up the caller
        std::array<unsigned char, 64> thrown_away{};
        int got = 1;
        for (int i = 0; i < max_reports && got > 0; ++i)
            got = hid_read_timeout(device_, thrown_away.data(), thrown_away.size(), 0);
        return got >= 0;
    }

private:
    hid_device* device_;
};

struct FoundDevices {
    std::string path{};  ///< the device's first interface with a maker-defined usage page; empty: none
    bool any{};          ///< true: a device with the wanted vendor and product numbers is plugged in
};

FoundDevices find_devices(const HidId& id) {
    FoundDevices found;
    hid_device_info* const all = hid_enumerate(id.vendor, id.product);
    for (const auto* one = all; one != nullptr; one = one->next) {
        found.any = true;
        if (one->usage_page >= first_vendor_page && found.path.empty()) found.path = one->path;
    }
    hid_free_enumeration(all);
    return found;
}

/// Reads a number of exactly four hexadecimal digits.
std::optional<std::uint16_t> hid_number_of(std::string_view words) {
    std::uint16_t number = 0;
    const auto* const end = words.data() + words.size();
    const auto read = std::from_chars(words.data(), end, number, 16);
    return words.size() == 4 && read.ec == std::errc() && read.ptr == end ? std::optional(number)
                                                                          : std::nullopt;
}

}  // namespace

std::string words_of(const HidId& id) {
    const auto digits = [](std::uint16_t number) { return hex(number).substr(hex(number).size() - 4); };
    return text(digits(id.vendor), ":", digits(id.product));
}

std::optional<HidId> read_hid_id(std::string_view words) {
    const auto colon = words.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    const auto vendor = hid_number_of(words.substr(0, colon));
    const auto product = hid_number_of(words.substr(colon + 1));
    return vendor && product ? std::optional(HidId{*vendor, *product}) : std::nullopt;
}

std::vector<std::pair<HidId, std::string>> hid_devices() {
    const std::lock_guard lock(library_mutex());
    std::vector<std::pair<HidId, std::string>> found;
    if (hid_init() != 0) return found;
    hid_device_info* const all = hid_enumerate(0, 0);
    for (const auto* one = all; one != nullptr; one = one->next) {
        if (one->usage_page < first_vendor_page) continue;
        // Other characters than ASCII are rare in device names and become '?'. The numbers still identify the
        // device.
        std::string name;
        for (const wchar_t* c = one->product_string; c != nullptr && *c != L'\0'; ++c)
            name += *c > 0 && *c < 128 ? static_cast<char>(*c) : '?';
        found.emplace_back(HidId{one->vendor_id, one->product_id}, std::move(name));
    }
    hid_free_enumeration(all);
    return found;
}

Expected<std::unique_ptr<HidPort>> open_hid_port(const HidId& id) {
    const std::lock_guard lock(library_mutex());
    if (hid_init() != 0) return fail("the system lists no HID devices");
    const auto found = find_devices(id);
    if (!found.any) return fail("it is not plugged in");
    if (found.path.empty()) return fail("it takes no reports of its maker's own kind, so it is no jacket");
    hid_device* const device = hid_open_path(found.path.c_str());
    if (device == nullptr)
        return fail(
            text("you may not write to ", found.path,
                 R"(; add to /etc/udev/rules.d/60-thaum.rules: SUBSYSTEM=="hidraw", ATTRS{idVendor}==")",
                 words_of(id).substr(0, 4), R"(", TAG+="uaccess")"));
    return std::make_unique<LibraryPort>(device);
}

}  // namespace thaum::game::inline jackets
