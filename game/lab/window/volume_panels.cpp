#include "game/lab/window/volume_panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/text.h"

namespace thaum::game::inline lab {
namespace {

constexpr float curve_height = 60;
constexpr int columns = 31;  // number of columns of a freehand curve
constexpr float wide = 330, tall = 700;

/// Number of decimals with which numbers in this range have about four digits: none for the values of a CT
/// scan, four for a workspace in m.
int digits_for(double low, double high) {
    const double range = std::max(high - low, 1e-9);
    return std::clamp(4 - static_cast<int>(std::ceil(std::log10(range))), 0, 6);
}

std::string number(double value, double low, double high) { return fixed(value, digits_for(low, high)); }

/// Labels both axes of a curve: what they mean, and the values at their ends.
void show_axes(const char* name, ImVec2 from, ImVec2 to, std::array<double, 3> low_high_top) {
    const auto [low, high, top] = low_high_top;
    const auto grey = IM_COL32(150, 155, 170, 255);
    auto* canvas = ImGui::GetWindowDrawList();
    const float line = ImGui::GetTextLineHeight();
    canvas->AddText({from.x + 4, from.y + 2}, grey, text(number(top, 0, top), " ", name).c_str());
    canvas->AddText({from.x + 4, to.y - line - 2}, grey, number(low, low, high).c_str());
    const auto end = number(high, low, high);
    canvas->AddText({to.x - ImGui::CalcTextSize(end.c_str()).x - 4, to.y - line - 2}, grey, end.c_str());
}

/// Editor of a curve drawn with the mouse: x from low to high, y from 0 to top. Returns whether it changed.
bool curve(const char* name, field::TransferFunction& f, double low, double high, double top) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::InvisibleButton(name, {width, curve_height});
    auto* canvas = ImGui::GetWindowDrawList();
    const ImVec2 to{from.x + width, from.y + curve_height};
    canvas->AddRectFilled(from, to, IM_COL32(25, 28, 40, 255));
    const auto screen = [&](double share) {
        const double y = std::clamp(f(low + share * (high - low)) / top, -0.02, 1.02);
        return ImVec2{from.x + static_cast<float>(share) * width,
                      to.y - static_cast<float>(y) * curve_height};
    };
    for (int i = 0; i < 128; ++i)
        canvas->AddLine(screen(i / 128.0), screen((i + 1) / 128.0), IM_COL32(255, 176, 64, 255), 2);
    show_axes(name, from, to, {low, high, top});
    if (!ImGui::IsItemActive()) return false;
    const auto at = [&](ImVec2 mouse) {
        const double x = std::clamp((mouse.x - from.x) / width, 0.0F, 1.0F);
        const double y = std::clamp((to.y - mouse.y) / curve_height, 0.0F, 1.0F);
        return vec2(low + x * (high - low), y * top);
    };
    const auto& io = ImGui::GetIO();
    const ImVec2 before{io.MousePos.x - io.MouseDelta.x, io.MousePos.y - io.MouseDelta.y};
    field::draw_stroke(f, at(ImGui::IsItemActivated() ? io.MousePos : before), at(io.MousePos),
                       (high - low) / (columns - 1));
    return true;
}

/// A slider. With Ctrl and a click a person can type the number.
bool slider(const char* name, double& value, double low, double high) {
    const bool changed =
        ImGui::SliderScalar(name, ImGuiDataType_Double, &value, &low, &high,
                            text("%.", digits_for(low, high), "f").c_str(), ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) ImGui::SetTooltip("Ctrl + click: type a number");
    return changed;
}

void ask_for_change(const VolumeLabPlan& plan, VolumePanelState& state) {
    state.change = VolumeLabSettings{state.modes, state.feel, plan.view.opacity, state.places};
}

/// A label with the name of its key on the user's keyboard: "undo (Z)".
std::string with_key(std::string_view label, std::string_view name) {
    return text(label, " (", render::key_label(render::key_code(name).value_or(-1)), ")");
}

// ---- volume and device ------------------------------------------------------------------------------------

/// Adds a slider for the time step, if the file has several. The file is read again when the slider is
/// released.
void show_moment(const VolumeLabPlan& plan, VolumePanelState& state) {
    const int frames = plan.lab.source.frames;
    if (frames == 1) return;
    int moment = state.moment.value_or(static_cast<int>(plan.first.moment));
    const auto words = text("%d of ", frames);
    if (ImGui::SliderInt("moment", &moment, 1, frames, words.c_str(), ImGuiSliderFlags_AlwaysClamp))
        state.moment = moment;
    if (ImGui::IsItemDeactivatedAfterEdit()) state.open = NextVolume{plan.first.volume, moment};
    if (!ImGui::IsItemActive()) state.moment.reset();
}

/// Shows notes on the volumes' files, such as what could not be read from them.
void show_notes(const VolumeLabPlan& plan) {
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(255, 200, 120, 255));
    for (const auto& note : plan.notes) ImGui::TextWrapped("%s", note.c_str());
    ImGui::PopStyleColor();
}

void show_volume(const VolumeLabPlan& plan, VolumePanelState& state) {
    if (ImGui::BeginCombo("volume", plan.first.volume.c_str())) {
        for (const auto name : field::volume_names())
            if (ImGui::Selectable(std::string(name).c_str(), plan.first.volume == name))
                state.open = NextVolume{std::string(name)};
        ImGui::EndCombo();
    }
    ImGui::InputText("file", state.path.data(), state.path.size());
    ImGui::SameLine();
    if (ImGui::SmallButton("open") && state.path[0] != 0) state.open = NextVolume{state.path.data()};
    show_moment(plan, state);
    show_notes(plan);
    if (!ImGui::BeginCombo("device", state.device.c_str())) return;
    for (const auto& name : plan.lab.data.devices) {
        if (ImGui::Selectable(name.c_str(), state.device == name)) state.next_device = name;
    }
    ImGui::EndCombo();
}

void show_places(const VolumeLabPlan& plan, VolumePanelState& state) {
    bool changed = false;
    const double far = 0.5 * plan.lab.data.device.workspace.x;
    for (std::size_t i = 0; i < state.places.size(); ++i) {
        auto& place = state.places[i];
        ImGui::PushID(static_cast<int>(i));
        ImGui::TextUnformatted((i == 0 ? plan.first : plan.beside[i - 1]).volume.c_str());
        const std::array<std::pair<const char*, double*>, 3> axes{
            {{"right (m)", &place.origin.x}, {"up (m)", &place.origin.y}, {"near (m)", &place.origin.z}}};
        for (const auto& [name, value] : axes) changed |= slider(name, *value, -far, far);
        changed |= slider("turn (rad)", place.yaw, -pi, pi);
        changed |= slider("scale", place.scale, 0.1, 3);
        ImGui::PopID();
    }
    if (changed) ask_for_change(plan, state);
}

// ---- modes ------------------------------------------------------------------------------------------------

double highest_property(const VolumeRef& volume, const haptics::Mode& mode) {
    const double range = double{volume.range.high} - double{volume.range.low};
    if (!mode.slope) return volume.range.high;
    return range / volume.finest_spacing();
}

/// The filter that converts the volume into a kind of field that the haptic mode can read; std::nullopt if
/// the mode reads the volume directly.
std::optional<field::FilterKind> leads(const LabMode& mode) {
    using enum field::FilterKind;
    if (mode.filters.empty()) return std::nullopt;
    const auto kind = mode.filters[0].kind;
    if (kind == smooth || kind == scale || kind == clamp) return std::nullopt;
    return kind;
}

/// Shows the filters of a mode, and buttons that add one or remove the last one.
bool show_filters(LabMode& chosen) {
    bool changed = false;
    for (std::size_t i = 0; i < chosen.filters.size(); ++i) {
        auto& f = chosen.filters[i];
        ImGui::PushID(static_cast<int>(i));
        ImGui::Text("through %s",
                    std::string(field::filter_names()[static_cast<std::size_t>(f.kind)]).c_str());
        if (f.kind == field::FilterKind::smooth) changed |= slider("samples", f.a, 0, 4);
        if (f.kind == field::FilterKind::scale || f.kind == field::FilterKind::clamp) {
            changed |= ImGui::InputDouble("a", &f.a);
            changed |= ImGui::InputDouble("b", &f.b);
        }
        ImGui::PopID();
    }
    const auto add = [&](const char* name, field::FilterKind kind) {
        if (!ImGui::SmallButton(name) || chosen.filters.size() >= field::max_filters) return;
        chosen.filters.push_back({kind, 1, 1});
        changed = true;
    };
    ImGui::TextUnformatted("data:");
    ImGui::SameLine();
    add("smooth", field::FilterKind::smooth);
    ImGui::SameLine();
    add("scale", field::FilterKind::scale);
    // If the last filter converts between vector and scalar, it cannot be removed: without it the mode could
    // read nothing.
    if (chosen.filters.empty() || leads({.filters = {chosen.filters.back()}})) return changed;
    ImGui::SameLine();
    if (!ImGui::SmallButton("remove the last filter")) return changed;
    chosen.filters.pop_back();
    return true;
}

bool show_settings(const VolumeLab& lab, const haptics::Mode& mode, LabMode& chosen) {
    auto& s = chosen.settings;
    const auto volume = volume_of(lab, chosen.volume);
    const auto& range = volume.range;
    bool changed = show_filters(chosen);
    ImGui::TextWrapped("%s", text(mode.about, "; strength (N) by ", mode.property).c_str());
    const double low = !mode.slope ? std::min(0.0, double{range.low}) : 0;
    changed |= curve("N: strength", s.strength, low, std::max(highest_property(volume, mode), low + 1e-9),
                     lab.data.device.peak_force);
    if (mode.name == "isosurface") {
        changed |= slider("level", s.level, range.low, range.high);
        changed |= slider("magnet (N)", s.magnet, 0, 0.5 * lab.data.device.peak_force);
        changed |= ImGui::Checkbox("solid below the level", &s.solid_below);
    }
    if (mode.name == "isosurface" || mode.name == "surface") {
        double friction = s.friction(0);
        if (slider("friction", friction, 0, 1)) {
            s.friction = field::constant(friction);
            changed = true;
        }
    }
    return changed;
}

/// Text for a haptic mode and the filter that it needs: "snap core by gradient".
std::string words_of(const haptics::ModeOffer& offer) {
    std::string words(offer.mode->name);
    std::ranges::replace(words, '_', ' ');
    if (offer.through) words += text(" by ", field::filter_names()[static_cast<std::size_t>(*offer.through)]);
    return words;
}

/// Shows one haptic mode (a way to feel a field) that can read a volume. Returns whether something changed.
bool show_offer(const VolumeLab& lab, std::size_t volume, const haptics::ModeOffer& offer,
                std::vector<LabMode>& modes) {
    const std::string name(offer.mode->name);
    const auto at = std::ranges::find_if(
        modes, [&](const LabMode& mode) { return mode.volume == volume && mode.name == name; });
    bool on = at != modes.end();
    // A mode that the volume offers with several filters is shown as chosen only once, with the filter in
    // use.
    if (on && offer.through != leads(*at)) return false;
    const auto label = words_of(offer);
    ImGui::PushID(label.c_str());
    bool changed = false;
    const bool ticked = ImGui::Checkbox(label.c_str(), &on);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(offer.mode->about).c_str());
    if (ticked) {
        if (!on) modes.erase(at);
        std::vector<field::Filter> filters;
        if (offer.through) filters.push_back({.kind = *offer.through});
        if (auto chosen = lab_mode(lab, name, std::move(filters), volume); on && chosen)
            modes.push_back(std::move(*chosen));
        changed = true;
    } else if (on) {
        changed = show_settings(lab, *offer.mode, *at);
    }
    ImGui::PopID();
    return changed;
}

/// Shows the haptic modes (ways to feel a field) that can read one volume, first those that need no filter.
/// Returns whether something changed.
bool show_modes_of(const VolumeLab& lab, std::size_t volume, std::vector<LabMode>& modes) {
    const auto offers = haptics::mode_offers(volume_of(lab, volume).kind());
    bool changed = false;
    for (const auto& offer : offers)
        if (!offer.through) changed |= show_offer(lab, volume, offer, modes);
    if (std::ranges::none_of(offers, [](const auto& offer) { return offer.through.has_value(); }))
        return changed;
    if (!ImGui::TreeNode("more, by the data's derivative")) return changed;
    for (const auto& offer : offers)
        if (offer.through) changed |= show_offer(lab, volume, offer, modes);
    ImGui::TreePop();
    return changed;
}

/// The density at which the first volume's surface is felt; null if no mode lets it be felt.
double* felt_level(VolumePanelState& state) {
    for (LabMode& mode : state.modes)
        if (mode.name == "isosurface" && mode.volume == 0 && !leads(mode)) return &mode.settings.level;
    return nullptr;
}

void show_modes(VolumeLabPlan& plan, VolumePanelState& state) {
    bool changed = false;
    const bool had_level = felt_level(state) != nullptr;
    for (std::size_t volume = 0; volume <= plan.lab.beside.size(); ++volume) {
        ImGui::PushID(static_cast<int>(volume));
        if (!plan.lab.beside.empty())
            ImGui::TextUnformatted((volume == 0 ? plan.first : plan.beside[volume - 1]).volume.c_str());
        changed |= show_modes_of(plan.lab, volume, state.modes);
        ImGui::PopID();
    }
    if (!changed) return;
    if (double* felt = felt_level(state); felt != nullptr && state.one_level)
        (had_level ? plan.view.level : *felt) = had_level ? *felt : plan.view.level;
    ask_for_change(plan, state);
}

// ---- feel of the body as a whole --------------------------------------------------------------------------

/// Largest value on the slider for a number of a part of the body's feel (the force law by which it is felt).
double max_number(const VolumeLab& lab, std::string_view label) {
    if (label == "density" || label == "low" || label == "high") return lab.range.high;
    if (label == "force (N)") return lab.data.device.peak_force;
    if (label == "drag (N s/m)") return lab.data.device.max_damping;
    return label.ends_with("(m)") ? 0.5 * lab.data.device.workspace.x : 1;
}

bool show_part(const VolumeLab& lab, FeelPart& part) {
    const auto& form = form_of(part.kind);
    bool changed = false;
    for (std::size_t i = 0; i < form.count; ++i) {
        const std::string label(form.labels.at(i));
        const double high = max_number(lab, label);
        const bool density = label == "density" || label == "low" || label == "high";
        const bool one_way = label == "force (N)" || label == "drag (N s/m)" || label == "friction";
        changed |= slider(label.c_str(), part.numbers.at(i),
                          density ? double{lab.range.low} : (one_way ? 0 : -high), high);
    }
    return changed;
}

/// A part of a body's feel (the force law) that suits the volume: its numbers can be felt at the first try.
FeelPart usual_part(const VolumeLab& lab, FeelKind kind) {
    const double middle = 0.5 * (double{lab.range.low} + double{lab.range.high});
    const double force = 0.8 * lab.data.device.continuous_force;
    switch (kind) {
        case FeelKind::opacity:
        case FeelKind::attract: return {kind, {force, 1}};
        case FeelKind::shell: return {kind, {middle, lab.range.high, force, 1}};
        case FeelKind::wall: return {kind, {middle, force, 0.2}};
        case FeelKind::gravity: return {kind, {0, -0.25 * force, 0}};
        case FeelKind::plane: return {kind, {0, 0, 0, 0, 0, 1, force}};
    }
    return {};
}

void show_body_feel(const VolumeLabPlan& plan, VolumePanelState& state) {
    if (!plan.lab.carvable()) return ImGui::TextUnformatted("A flow has no body to feel.");
    bool changed = false;
    for (std::size_t i = 0; i < state.feel.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        ImGui::Separator();
        ImGui::TextUnformatted(std::string(form_of(state.feel[i].kind).name).c_str());
        changed |= show_part(plan.lab, state.feel[i]);
        const bool goes = ImGui::SmallButton("remove");
        ImGui::PopID();
        if (!goes) continue;
        state.feel.erase(state.feel.begin() + static_cast<std::ptrdiff_t>(i));
        changed = true;
        break;
    }
    const auto forms = feel_forms();
    for (std::size_t i = 0; i < forms.size(); ++i) {
        if (i % 3 != 0) ImGui::SameLine();
        if (!ImGui::SmallButton(text("+ ", forms[i].name).c_str())) continue;
        state.feel.push_back(usual_part(plan.lab, static_cast<FeelKind>(i)));
        changed = true;
    }
    if (changed) ask_for_change(plan, state);
}

// ---- look, tools, force -----------------------------------------------------------------------------------

void show_look(VolumeLabPlan& plan, VolumePanelState& state) {
    auto& view = plan.view;
    int look = view.look == render::ScanLook::surface ? 0 : 1;
    ImGui::RadioButton("surface", &look, 0);
    ImGui::SameLine();
    ImGui::RadioButton("translucent", &look, 1);
    view.look = look == 0 ? render::ScanLook::surface : render::ScanLook::translucent;
    const double low = plan.lab.range.low, high = std::max(double{plan.lab.range.high}, low + 1e-9);
    if (look == 0) {
        double* felt = felt_level(state);
        if (slider("drawn level", view.level, low, high) && felt != nullptr && state.one_level) {
            *felt = view.level;
            ask_for_change(plan, state);
        }
        if (felt != nullptr && ImGui::Checkbox("draw the level that is felt", &state.one_level) &&
            state.one_level)
            view.level = *felt;
    }
    if (look == 1 && curve("opacity by density", view.opacity, low, high, 1)) ask_for_change(plan, state);
}

void show_tools(const VolumeLab& lab, VolumePanelState& state) {
    if (!lab.carvable()) return ImGui::TextUnformatted("A flow cannot be carved.");
    const auto& tools = lab.data.tools;
    if (ImGui::BeginCombo("tool", tools[state.tool].name.c_str())) {
        for (std::size_t i = 0; i < tools.size(); ++i)
            if (ImGui::Selectable(tools[i].name.c_str(), i == state.tool)) state.tool = i;
        ImGui::EndCombo();
    }
    if (ImGui::Button(with_key("undo", "Z").c_str())) state.history = -1;
    ImGui::SameLine();
    if (ImGui::Button(with_key("redo", "Y").c_str())) state.history = 1;
    ImGui::SameLine();
    if (ImGui::Button("save body")) state.saves = true;
}

void show_force(const VolumeLabFigures& figures, const VolumePanelState& state, double peak) {
    ImGui::Text("force %.2f N, value %.4g", glm::length(figures.force), figures.value);
    const auto words = text("0 to ", fixed(peak, 1), " N, the last ", state.force.size() / 1000, " s");
    ImGui::PlotLines("##force", state.force.data(), static_cast<int>(state.force.size()),
                     static_cast<int>(state.newest), words.c_str(), 0, static_cast<float>(peak),
                     {ImGui::GetContentRegionAvail().x, 70});
}

void show_help() {
    const auto hold = render::key_label(render::key_code("H").value_or(-1));
    const auto words = text(
        "The mouse moves the hand; wheel, PageUp and PageDown move it away or nearer. ", hold,
        " holds the hand where it is: change settings meanwhile, bring the mouse back to the ball and press ",
        hold,
        " again. Left button or Space: tool. Right button: turn the view, middle button: move it. Ctrl and "
        "wheel: "
        "nearer. Draw in a curve to set a strength. The bright ball is the hand on the surface, the small "
        "grey one "
        "the tip of the arm; the further apart, the stronger the force.");
    ImGui::TextWrapped("%s", words.c_str());
}

/// Shows the fixed lower end of the panel: the message about the last action, and controls that are always
/// available.
void show_foot(VolumePanelState& state) {
    if (ImGui::Button("save session")) state.saves_session = true;
    ImGui::SameLine();
    ImGui::Checkbox(with_key("hold the hand", "H").c_str(), &state.hand_held);
    ImGui::TextWrapped("%s", state.note.c_str());
}

/// Asks whether to save a carved body before it is lost. Esc means to stay.
void show_question(UnsavedQuestion& question) {
    using Answer = UnsavedQuestion::Answer;
    constexpr auto title = "The carved body is not saved";
    if (question.before == UnsavedQuestion::Before::nothing) return;
    if (!std::exchange(question.shown, true)) ImGui::OpenPopup(title);
    if (!ImGui::IsPopupOpen(title)) question.answer = Answer::stay;
    const auto middle = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(middle, ImGuiCond_Appearing, {0.5F, 0.5F});
    if (!ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
    const bool leaves = question.before == UnsavedQuestion::Before::leaving;
    if (ImGui::Button(leaves ? "Save and leave" : "Save and open")) question.answer = Answer::save;
    ImGui::SameLine();
    if (ImGui::Button(leaves ? "Leave without saving" : "Open without saving"))
        question.answer = Answer::drop;
    ImGui::SameLine();
    if (ImGui::Button("Stay (Esc)")) question.answer = Answer::stay;
    if (question.answer) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace

bool levels_agree(const VolumeView& view, VolumePanelState& state) {
    const double* felt = felt_level(state);
    return felt == nullptr || *felt == view.level;
}

std::size_t usual_tool(const VolumeLab& lab) {
    const auto& tools = lab.data.tools;
    const auto melt = std::ranges::find(tools, "melt", &field::Tool::name);
    return melt == tools.end() ? 0 : static_cast<std::size_t>(melt - tools.begin());
}

void add_force(VolumePanelState& state, double newtons) {
    state.force[state.newest] = static_cast<float>(newtons);
    state.newest = (state.newest + 1) % state.force.size();
}

void show_panels(VolumeLabPlan& plan, const VolumeLabFigures& figures, VolumePanelState& state) {
    ImGui::SetNextWindowPos({8, 8}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({wide, tall}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("Lab")) {
        const float foot = ImGui::GetFrameHeightWithSpacing() + 3 * ImGui::GetTextLineHeightWithSpacing();
        show_force(figures, state, plan.lab.data.device.peak_force);
        ImGui::BeginChild("parts", {0, -foot});
        if (ImGui::CollapsingHeader("Volume", ImGuiTreeNodeFlags_DefaultOpen)) show_volume(plan, state);
        if (ImGui::CollapsingHeader("Places")) show_places(plan, state);
        if (ImGui::CollapsingHeader("Modes: feel at the hand", ImGuiTreeNodeFlags_DefaultOpen))
            show_modes(plan, state);
        if (ImGui::CollapsingHeader("Feel of the whole body")) show_body_feel(plan, state);
        if (ImGui::CollapsingHeader("Look", ImGuiTreeNodeFlags_DefaultOpen)) show_look(plan, state);
        if (ImGui::CollapsingHeader("Carve", ImGuiTreeNodeFlags_DefaultOpen)) show_tools(plan.lab, state);
        if (ImGui::CollapsingHeader("Help")) show_help();
        ImGui::EndChild();
        show_foot(state);
    }
    ImGui::End();
    show_question(state.question);
}

}  // namespace thaum::game::inline lab
