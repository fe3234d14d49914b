#include "game/lab/window/panels.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <utility>

namespace thaum::game::inline lab {
namespace {

constexpr std::size_t mouse_buttons = 5;

/// Keys that text fields in panels need, numbered after the mouse buttons.
constexpr std::array<std::pair<std::string_view, ImGuiKey>, 18> edit_keys{{
    {"Tab", ImGuiKey_Tab},
    {"Left", ImGuiKey_LeftArrow},
    {"Right", ImGuiKey_RightArrow},
    {"Up", ImGuiKey_UpArrow},
    {"Down", ImGuiKey_DownArrow},
    {"Home", ImGuiKey_Home},
    {"End", ImGuiKey_End},
    {"Delete", ImGuiKey_Delete},
    {"Backspace", ImGuiKey_Backspace},
    {"Enter", ImGuiKey_Enter},
    {"KP_Enter", ImGuiKey_KeyPadEnter},
    {"Esc", ImGuiKey_Escape},
    {"A", ImGuiKey_A},
    {"C", ImGuiKey_C},
    {"V", ImGuiKey_V},
    {"X", ImGuiKey_X},
    {"Y", ImGuiKey_Y},
    {"Z", ImGuiKey_Z},
}};
static_assert(mouse_buttons + edit_keys.size() == Panels::switches);

/// State of a mouse button or key in Dear ImGui: true while it is down.
bool& is_down(std::size_t number) {
    auto& io = ImGui::GetIO();
    return number < mouse_buttons ? io.MouseDown[number]
                                  : io.KeysDown[edit_keys[number - mouse_buttons].second];
}

/// Whether a drop-down list or a question is open.
bool popup_open() {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

}  // namespace

Panels::Panels(float text_px) {
    ImGui::CreateContext();
    auto& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // positions of panels are not saved to a file
    io.FontGlobalScale = text_px / 13;
    for (const auto& [name, key] : edit_keys) io.KeyMap[key] = key;
    ImGui::StyleColorsDark();
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Panels::~Panels() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

void Panels::set(std::size_t number, bool down) {
    if (down) {
        is_down(number) = fresh_[number] = true;
        ended_[number] = false;
    } else if (fresh_[number]) {
        ended_[number] = true;
    } else {
        is_down(number) = false;
    }
}

bool Panels::take_key(std::string_view name, bool pressed) {
    auto& io = ImGui::GetIO();
    if (name == "LeftCtrl" || name == "RightCtrl") io.KeyCtrl = pressed;
    if (name == "LeftShift" || name == "RightShift") io.KeyShift = pressed;
    for (std::size_t i = 0; i < edit_keys.size(); ++i)
        if (edit_keys[i].first == name) set(mouse_buttons + i, pressed);
    if (!pressed) return false;
    if (!popup_open()) return io.WantTextInput;
    if (name == "Esc" && !io.WantTextInput) ImGui::ClosePopupToLevel(0, true);
    return true;
}

void Panels::add_mouse(const render::WindowEvents& program, render::WindowEvents& heard) {
    heard.mouse_button = [this, program](int button, bool pressed) {
        if (button >= 0 && button < static_cast<int>(mouse_buttons))
            set(static_cast<std::size_t>(button), pressed);
        if (program.mouse_button && (!ImGui::GetIO().WantCaptureMouse || !pressed))
            program.mouse_button(button, pressed);
    };
    heard.cursor = [program](double x, double y) {
        auto& io = ImGui::GetIO();
        io.MousePos = {static_cast<float>(x), static_cast<float>(y)};
        if (program.cursor && !io.WantCaptureMouse) program.cursor(x, y);
    };
    heard.wheel = [program](double steps) {
        auto& io = ImGui::GetIO();
        io.MouseWheel += static_cast<float>(steps);
        if (program.wheel && !io.WantCaptureMouse) program.wheel(steps);
    };
}

render::WindowEvents Panels::listening(const render::WindowEvents& program) {
    render::WindowEvents heard = program;
    add_mouse(program, heard);
    heard.key = [this, program](int key, int scancode, bool pressed) {
        if (!take_key(render::key_name(key), pressed) && program.key) program.key(key, scancode, pressed);
    };
    heard.character = [program](char32_t character) {
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(character));
        if (program.character) program.character(character);
    };
    heard.focus = [program](bool focused) {
        auto& io = ImGui::GetIO();
        if (!focused) io.KeyCtrl = io.KeyShift = false;
        if (program.focus) program.focus(focused);
    };
    return heard;
}

void Panels::begin(render::Size size, double seconds) {
    auto& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
    io.DeltaTime = static_cast<float>(seconds > 1e-4 ? seconds : 1e-4);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
}

void Panels::draw() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    for (std::size_t i = 0; i < switches; ++i)
        if (ended_[i]) is_down(i) = false;
    fresh_ = ended_ = {};
}

}  // namespace thaum::game::inline lab
