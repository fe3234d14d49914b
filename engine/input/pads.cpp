#include "input/pads.h"

#include <SDL.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

#include "core/assert.h"
#include "core/letters.h"
#include "core/text.h"
#include "core/threads.h"
#include "input/detail/pad_places.h"
#include "input/pad_mapping.h"

// How this file sets SDL up, and why:
//
// - SDL's own drivers for some pads (HIDAPI) are off, so that every pad is one of Linux's event devices: the
//   user needs one permission for all, and motors run through that device (input/rumble.h).
// - No events: SDL would queue them. The states are read after each update, and the queue is emptied.
// - No signal handlers: SDL's would replace those of the program, which stop arms and motors before it ends.

namespace thaum::input {
namespace {

std::atomic<bool> alive = false;  // true: a PadReader exists

using Controller = std::unique_ptr<SDL_GameController, decltype(&SDL_GameControllerClose)>;
using Joystick = std::unique_ptr<SDL_Joystick, decltype(&SDL_JoystickClose)>;

/// A string from SDL; if it is null, an empty one.
std::string in_words(const char* words) { return words == nullptr ? "" : words; }

std::string guid_of(int index) {
    std::array<char, 33> words{};
    SDL_JoystickGetGUIDString(SDL_JoystickGetDeviceGUID(index), words.data(), static_cast<int>(words.size()));
    return words.data();
}

/// Current number of a joystick in SDL's list; negative: it is gone.
int index_of(SDL_JoystickID id) {
    for (int i = 0; i < SDL_NumJoysticks(); ++i)
        if (SDL_JoystickGetDeviceInstanceID(i) == id) return i;
    return -1;
}

/// Converts SDL's 16-bit value to -1 to 1. The range of SDL's value is larger by one below 0 than above.
double share_of(std::int16_t value) { return std::max(-1.0, value / 32767.0); }

struct OpenPad {
    SDL_JoystickID id = -1;
    Controller controller{nullptr, SDL_GameControllerClose};
    /// Model of joysticks of the program's own mapping that the pad uses (a mapping says which part of a
    /// joystick is which control); empty: the pad uses a mapping of SDL's.
    std::string own_model{};
};

struct OpenStick {
    SDL_JoystickID id = -1;
    Joystick joystick{nullptr, SDL_JoystickClose};
};

void read_pad(SDL_GameController* from, PadState& to) {
    static_assert(SDL_CONTROLLER_BUTTON_A == 0 && SDL_CONTROLLER_AXIS_LEFTX == 0);
    constexpr std::array buttons{SDL_CONTROLLER_BUTTON_A,
                                 SDL_CONTROLLER_BUTTON_B,
                                 SDL_CONTROLLER_BUTTON_X,
                                 SDL_CONTROLLER_BUTTON_Y,
                                 SDL_CONTROLLER_BUTTON_LEFTSHOULDER,
                                 SDL_CONTROLLER_BUTTON_RIGHTSHOULDER,
                                 SDL_CONTROLLER_BUTTON_BACK,
                                 SDL_CONTROLLER_BUTTON_START,
                                 SDL_CONTROLLER_BUTTON_GUIDE,
                                 SDL_CONTROLLER_BUTTON_LEFTSTICK,
                                 SDL_CONTROLLER_BUTTON_RIGHTSTICK,
                                 SDL_CONTROLLER_BUTTON_DPAD_UP,
                                 SDL_CONTROLLER_BUTTON_DPAD_RIGHT,
                                 SDL_CONTROLLER_BUTTON_DPAD_DOWN,
                                 SDL_CONTROLLER_BUTTON_DPAD_LEFT};
    constexpr std::array axes{SDL_CONTROLLER_AXIS_LEFTX,       SDL_CONTROLLER_AXIS_LEFTY,
                              SDL_CONTROLLER_AXIS_RIGHTX,      SDL_CONTROLLER_AXIS_RIGHTY,
                              SDL_CONTROLLER_AXIS_TRIGGERLEFT, SDL_CONTROLLER_AXIS_TRIGGERRIGHT};
    to.buttons = 0;
    for (std::size_t i = 0; i < buttons.size(); ++i)
        if (SDL_GameControllerGetButton(from, buttons.at(i)) != 0) to.buttons |= 1U << i;
    for (std::size_t i = 0; i < axes.size(); ++i)
        to.axes.at(i) = share_of(SDL_GameControllerGetAxis(from, axes.at(i)));
    // SDL's sticks are positive downwards, those of a PadState upwards.
    to.axes.at(static_cast<std::size_t>(PadAxis::left_y)) *= -1;
    to.axes.at(static_cast<std::size_t>(PadAxis::right_y)) *= -1;
}

void read_stick(SDL_Joystick* from, StickState& to) {
    to.axes.resize(static_cast<std::size_t>(std::max(0, SDL_JoystickNumAxes(from))));
    to.buttons.resize(static_cast<std::size_t>(std::max(0, SDL_JoystickNumButtons(from))));
    to.hats.resize(static_cast<std::size_t>(std::max(0, SDL_JoystickNumHats(from))));
    for (std::size_t i = 0; i < to.axes.size(); ++i)
        to.axes[i] = SDL_JoystickGetAxis(from, static_cast<int>(i));
    for (std::size_t i = 0; i < to.buttons.size(); ++i)
        to.buttons[i] = SDL_JoystickGetButton(from, static_cast<int>(i)) != 0;
    for (std::size_t i = 0; i < to.hats.size(); ++i)
        to.hats[i] = SDL_JoystickGetHat(from, static_cast<int>(i));
}

Expected<void> add_mapping(const std::string& mapping) {
    if (SDL_GameControllerAddMapping(mapping.c_str()) >= 0) return {};
    return fail(text("not a mapping of a pad (", in_words(SDL_GetError()), ")"));
}

}  // namespace

struct PadReader::State {
    std::jthread start{};  ///< thread that initialises SDL; `wait` joins it
    bool began = false;
    std::string fault{};
    /// Mappings (which part of a joystick is which control of a pad) of the program, in the order in which
    /// they were added to SDL.
    std::vector<std::string> mappings{};
    PadPlaces places{};
    Pads pads{};
    std::array<OpenPad, std::tuple_size_v<Pads>> open{};
    std::vector<std::string> left_over{};
    std::vector<Stick> sticks{};
    std::vector<OpenStick> open_sticks{};
    std::vector<std::pair<SDL_JoystickID, bool>>
        plugged{};  ///< joysticks that the last check found, and which of them are pads

    void begin();
    void find_own_mappings();
    void wait() {
        if (start.joinable()) start.join();
    }
    bool look();
    void open_pads();
    void open_sticks_anew();
};

/// Finds which pads use a mapping of the program. SDL does not report it, and also applies mappings of
/// similar models.
void PadReader::State::find_own_mappings() {
    for (auto& pad : open) {
        pad.own_model.clear();
        if (!pad.controller) continue;
        const std::unique_ptr<char, decltype(&SDL_free)> used(SDL_GameControllerMapping(pad.controller.get()),
                                                              SDL_free);
        const auto found = std::find_if(mappings.rbegin(), mappings.rend(), [&](const auto& mapping) {
            return used && same_pad_controls(mapping, used.get());
        });
        if (found != mappings.rend()) pad.own_model = model_of_mapping(*found);
    }
}

void PadReader::State::begin() {
    SDL_SetHintWithPriority(SDL_HINT_NO_SIGNAL_HANDLERS, "1", SDL_HINT_OVERRIDE);
    SDL_SetHintWithPriority(SDL_HINT_JOYSTICK_HIDAPI, "0", SDL_HINT_OVERRIDE);
    // SDL reports input only while one of its windows has the focus. It has no window here, hence this hint.
    SDL_SetHintWithPriority(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1", SDL_HINT_OVERRIDE);
    began = SDL_Init(SDL_INIT_GAMECONTROLLER) == 0;
    if (!began) {
        fault = text("no pads: SDL does not start: ", in_words(SDL_GetError()));
        return;
    }
    SDL_JoystickEventState(SDL_IGNORE);
    SDL_GameControllerEventState(SDL_IGNORE);
    for (const auto& mapping : mappings)
        if (const auto added = add_mapping(mapping); !added && fault.empty())
            fault = text("'", mapping.substr(0, mapping.find(',')), "': ", added.error().message);
}

/// Checks which joysticks are plugged in. Returns whether something has changed.
bool PadReader::State::look() {
    std::vector<std::pair<SDL_JoystickID, bool>> plugged_in;
    for (int i = 0; i < SDL_NumJoysticks(); ++i)
        plugged_in.emplace_back(SDL_JoystickGetDeviceInstanceID(i), SDL_IsGameController(i) == SDL_TRUE);
    return std::exchange(plugged, plugged_in) != plugged_in;
}

/// Assigns places in the list of pads, and opens and closes pads.
void PadReader::State::open_pads() {
    std::vector<PluggedPad> plugged_in;
    for (std::size_t i = 0; i < plugged.size(); ++i)
        if (plugged[i].second) plugged_in.push_back({plugged[i].first, guid_of(static_cast<int>(i))});
    place_pads(places, plugged_in);
    left_over.clear();
    for (const auto& pad : plugged_in)
        if (std::none_of(places.begin(), places.end(), [&](const auto& place) { return place.id == pad.id; }))
            left_over.push_back(in_words(SDL_JoystickNameForIndex(index_of(pad.id))));
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (open.at(i).id == places.at(i).id) continue;
        open.at(i) = {.id = places.at(i).id};
        pads.at(i) = {};
        const int index = index_of(places.at(i).id);
        if (index < 0) continue;
        open.at(i).controller.reset(SDL_GameControllerOpen(index));
        auto* controller = open.at(i).controller.get();
        if (controller == nullptr) continue;
        pads.at(i) = {.present = true,
                      .name = in_words(SDL_GameControllerName(controller)),
                      .path = in_words(SDL_GameControllerPath(controller))};
    }
}

void PadReader::State::open_sticks_anew() {
    sticks.clear();
    open_sticks.clear();
    for (std::size_t i = 0; i < plugged.size(); ++i) {
        const int index = static_cast<int>(i);
        if (plugged[i].second) continue;
        sticks.push_back({.name = in_words(SDL_JoystickNameForIndex(index)),
                          .path = in_words(SDL_JoystickPathForIndex(index)),
                          .guid = guid_of(index)});
        open_sticks.push_back({plugged[i].first, Joystick(SDL_JoystickOpen(index), SDL_JoystickClose)});
    }
}

PadReader::PadReader(std::vector<std::string> mappings) : state_(std::make_unique<State>()) {
    THAUM_ASSERT(!alive, "there is a reader of pads already");
    alive = true;
    state_->mappings = std::move(mappings);
    auto started = start_thread([state = state_.get()] { state->begin(); });
    if (started)
        state_->start = std::move(*started);
    else
        state_->fault = text("no pads: ", started.error().message);
}

PadReader::~PadReader() {
    state_->wait();
    const bool began = state_->began;
    state_.reset();  // closes all pads
    if (began) SDL_Quit();
    alive = false;
}

const Pads& PadReader::poll() {
    auto& s = *state_;
    s.wait();
    if (!s.began) return s.pads;
    SDL_GameControllerUpdate();
    SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
    if (s.look()) {
        s.open_pads();
        s.find_own_mappings();
        s.open_sticks_anew();
    }
    for (std::size_t i = 0; i < s.pads.size(); ++i)
        if (s.pads.at(i).present) read_pad(s.open.at(i).controller.get(), s.pads.at(i));
    for (std::size_t i = 0; i < s.sticks.size(); ++i)
        if (s.open_sticks[i].joystick) read_stick(s.open_sticks[i].joystick.get(), s.sticks[i].state);
    return s.pads;
}

const std::vector<Stick>& PadReader::sticks() const { return state_->sticks; }

const std::vector<std::string>& PadReader::left_over() const { return state_->left_over; }

std::vector<std::string> PadReader::without_right_stick() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < state_->pads.size(); ++i) {
        auto* controller = state_->open.at(i).controller.get();
        if (state_->pads.at(i).present &&
            SDL_GameControllerHasAxis(controller, SDL_CONTROLLER_AXIS_RIGHTX) == SDL_FALSE)
            names.push_back(state_->pads.at(i).name);
    }
    return names;
}

const std::string& PadReader::fault() const {
    state_->wait();
    return state_->fault;
}

Expected<void> PadReader::add(const std::string& mapping) {
    state_->wait();
    if (!state_->began) return fail(state_->fault);
    auto added = add_mapping(mapping);
    if (!added) return added;
    state_->mappings.push_back(mapping);
    state_->find_own_mappings();
    return {};
}

std::vector<Stick> PadReader::own() const {
    std::vector<Stick> sticks;
    for (std::size_t i = 0; i < state_->pads.size(); ++i) {
        const auto& open = state_->open.at(i);
        const auto& pad = state_->pads.at(i);
        if (!pad.present || open.own_model.empty()) continue;
        sticks.push_back({.name = pad.name, .path = pad.path, .guid = open.own_model});
        read_stick(SDL_GameControllerGetJoystick(open.controller.get()), sticks.back().state);
    }
    return sticks;
}

// SDL has no function that removes a mapping, so SDL is ended and started again with the other mappings.
void PadReader::forget(const std::string& model) {
    auto& s = *state_;
    s.wait();
    std::erase_if(s.mappings,
                  [&](const auto& mapping) { return same_word(model_of_mapping(mapping), model); });
    if (!s.began) return;
    for (auto& pad : s.open) pad = {};
    for (auto& place : s.places) place.id = -1;  // after this, SDL may number its pads differently
    s.pads = {};
    s.sticks.clear();
    s.open_sticks.clear();
    s.plugged.clear();
    SDL_Quit();
    s.fault.clear();
    s.begin();
}

}  // namespace thaum::input
