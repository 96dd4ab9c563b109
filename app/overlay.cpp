#include "app/overlay.h"

#include <imgui.h>

#include <cmath>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include "base/error.h"
#include "display/font_atlas.h"

namespace brewster {
namespace {

constexpr float text_height = 15;  // pixels at scale 1

int place_of(Button button) {
    return button == Button::left ? 0 : button == Button::right ? 1 : 2;
}

/// Keys that widgets listen to.
ImGuiKey_ widget_key(const std::string& key) {
    if (key == "Tab") return ImGuiKey_Tab;
    if (key == "Enter") return ImGuiKey_Enter;
    if (key == "Escape") return ImGuiKey_Escape;
    if (key == "Space") return ImGuiKey_Space;
    return ImGuiKey_COUNT;
}

void set_colours(bool light) {
    if (light)
        ImGui::StyleColorsLight();
    else
        ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.Colors[ImGuiCol_WindowBg].w = 0.94f;
    style.Colors[ImGuiCol_TextDisabled] = light ? ImVec4(0.36f, 0.36f, 0.36f, 1) : ImVec4(0.64f, 0.64f, 0.64f, 1);
    // Blue-orange, like the maps: what is chosen is blue, what is held is orange.
    const ImVec4 blue(0.20f, 0.45f, 0.75f, 1.0f), pale(0.20f, 0.45f, 0.75f, 0.35f), orange(0.90f, 0.50f, 0.15f, 1.0f);
    style.Colors[ImGuiCol_CheckMark] = light ? blue : ImVec4(0.45f, 0.70f, 1, 1);
    // The number of a slider stands on it.
    style.Colors[ImGuiCol_SliderGrab] = light ? ImVec4(0.55f, 0.73f, 0.95f, 1) : ImVec4(0.22f, 0.45f, 0.75f, 1);
    style.Colors[ImGuiCol_SliderGrabActive] = style.Colors[ImGuiCol_ButtonActive] = orange;
    style.Colors[ImGuiCol_Header] = style.Colors[ImGuiCol_Button] = pale;
    style.Colors[ImGuiCol_HeaderHovered] = style.Colors[ImGuiCol_ButtonHovered] = ImVec4(0.20f, 0.45f, 0.75f, 0.6f);
}

}  // namespace

Overlay::Overlay(Window& window) : window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavNoCaptureKeyboard;
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);  // its callbacks go on to the window's own
    ImGui_ImplOpenGL3_Init("#version 330 core");
    set_style(1, false);
}

Overlay::~Overlay() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Overlay::set_style(float scale, bool light) {
    const float wanted = scale * window_.content_scale();
    if (wanted == built_scale_ && light == light_) return;
    const bool other_font = wanted != built_scale_;
    built_scale_ = wanted;
    light_ = light;
    ImGui::GetStyle() = ImGuiStyle();
    set_colours(light);
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = style.FrameRounding = style.GrabRounding = 3;
    style.WindowBorderSize = 1;
    style.ScaleAllSizes(built_scale_);
    if (other_font) build_font();
}

void Overlay::build_font() {
    ImGuiIO& io = ImGui::GetIO();
    static const ImWchar characters[] = {0x20,   0xff,   0x391,  0x3c9,  0x2010, 0x2044, 0x2070,
                                         0x209c, 0x2190, 0x21ff, 0x2212, 0x2265, 0};
    io.Fonts->Clear();
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    const std::string_view font = font_file();
    // The atlas only reads what it does not own.
    io.Fonts->AddFontFromMemoryTTF(const_cast<char*>(font.data()), static_cast<int>(font.size()),
                                   std::round(text_height * built_scale_), &config, characters);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    if (!ImGui_ImplOpenGL3_CreateFontsTexture())
        throw Error("the panels' text cannot be made", "graphics driver", "choose a smaller text with settings.json");
}

void Overlay::begin() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    if (scripted_) {
        // Places are in pixels; widgets live in screen coordinates.
        io.MousePos = ImVec2(pointer_.x / io.DisplayFramebufferScale.x, pointer_.y / io.DisplayFramebufferScale.y);
        for (int i = 0; i < 3; ++i) io.MouseDown[i] = buttons_[i];
    }
    ImGui::NewFrame();
}

void Overlay::end() {
    ImGui::Render();
    const ImGuiKey_ key = widget_key(released_key_);
    if (key != ImGuiKey_COUNT) ImGui::GetIO().KeysDown[ImGui::GetIO().KeyMap[key]] = false;
    released_key_.clear();
}

void Overlay::draw() {
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Overlay::script(const InputEvent& event) {
    ImGuiIO& io = ImGui::GetIO();
    scripted_ = true;
    pointer_ = event.place;
    switch (event.kind) {
        case InputEvent::Kind::button_press:
        case InputEvent::Kind::button_release:
            buttons_[place_of(event.button)] = event.kind == InputEvent::Kind::button_press;
            break;
        case InputEvent::Kind::wheel:
            io.MouseWheel += event.notches;
            break;
        case InputEvent::Kind::key_press:
            if (const ImGuiKey_ key = widget_key(event.key); key != ImGuiKey_COUNT) {
                io.KeysDown[io.KeyMap[key]] = true;
                released_key_ = event.key;
            }
            break;
        case InputEvent::Kind::key_release:
        case InputEvent::Kind::motion:
            break;
    }
}

void Overlay::script_text(const std::string& text) {
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
}

bool Overlay::wants_mouse() const {
    return ImGui::GetIO().WantCaptureMouse;
}
bool Overlay::wants_text() const {
    return ImGui::GetIO().WantTextInput;
}
bool Overlay::is_being_used() const {
    return ImGui::IsAnyItemActive();
}
void Overlay::release_keyboard() {
    ImGui::SetWindowFocus(nullptr);
}

}  // namespace brewster
