#include "game/app/panels.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <array>
#include <utility>

namespace thaum::app {
namespace {

/// Keys that text fields of panels need.
constexpr std::array<std::pair<std::string_view, ImGuiKey>, 10> edit_keys{{{"Tab", ImGuiKey_Tab},
                                                                           {"Left", ImGuiKey_LeftArrow},
                                                                           {"Right", ImGuiKey_RightArrow},
                                                                           {"Up", ImGuiKey_UpArrow},
                                                                           {"Down", ImGuiKey_DownArrow},
                                                                           {"Home", ImGuiKey_Home},
                                                                           {"End", ImGuiKey_End},
                                                                           {"Delete", ImGuiKey_Delete},
                                                                           {"Backspace", ImGuiKey_Backspace},
                                                                           {"Enter", ImGuiKey_Enter}}};

void tell_key(std::string_view name, bool pressed) {
    for (const auto& [word, key] : edit_keys)
        if (word == name) ImGui::GetIO().KeysDown[key] = pressed;
}

render::WindowEvents with_mouse(render::WindowEvents heard, const render::WindowEvents& program) {
    heard.mouse_button = [program](int button, bool pressed) {
        auto& io = ImGui::GetIO();
        if (button >= 0 && button < 5) io.MouseDown[button] = pressed;
        if (program.mouse_button && (!io.WantCaptureMouse || !pressed)) program.mouse_button(button, pressed);
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
    return heard;
}

}  // namespace

Panels::Panels(float text_px) {
    ImGui::CreateContext();
    auto& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // places of panels are not kept
    io.FontGlobalScale = text_px / 13;
    for (const auto& [name, key] : edit_keys) io.KeyMap[key] = key;
    ImGui::StyleColorsDark();
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Panels::~Panels() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

render::WindowEvents Panels::listening(const render::WindowEvents& program) {
    render::WindowEvents heard = with_mouse(program, program);
    heard.key = [program](int key, int scancode, bool pressed) {
        tell_key(render::key_name(key), pressed);
        if (program.key && (!ImGui::GetIO().WantTextInput || !pressed)) program.key(key, scancode, pressed);
    };
    heard.character = [program](char32_t character) {
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(character));
        if (program.character) program.character(character);
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
}

}  // namespace thaum::app
