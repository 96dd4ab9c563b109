#include "app/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <glm/common.hpp>
#include <utility>

#include "base/error.h"
#include "display/gl_context.h"

namespace brewster {
namespace {

Error glfw_error(const char* what) {
    const char* words = nullptr;
    glfwGetError(&words);
    return Error(std::string(what) + (words ? std::string(": ") + words : ""), "display",
                 "set DISPLAY to a running X server, or draw without a window (brewster shot)");
}

/// Keys that the layout does not name.
std::string special_key(int key) {
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return "Keypad " + std::to_string(key - GLFW_KEY_KP_0);
    switch (key) {
        case GLFW_KEY_SPACE:
            return "Space";
        case GLFW_KEY_ESCAPE:
            return "Escape";
        case GLFW_KEY_ENTER:
            return "Enter";
        case GLFW_KEY_TAB:
            return "Tab";
        case GLFW_KEY_HOME:
            return "Home";
        default:
            return "";
    }
}

/// Letters are those of the keyboard's layout, not of the key's place.
std::string name_of(int key, int scan_code) {
    std::string name = special_key(key);
    if (!name.empty()) return name;
    if (const char* letter = glfwGetKeyName(key, scan_code)) name = letter;
    if (name.size() == 1) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return name;
}

Button button_of(int button) {
    return button == GLFW_MOUSE_BUTTON_MIDDLE  ? Button::middle
           : button == GLFW_MOUSE_BUTTON_RIGHT ? Button::right
                                               : Button::left;
}

}  // namespace

/// GLFW's calls back; they only note what happened.
struct Window::Callbacks {
    static Window& of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

    static bool held(GLFWwindow* window, int left, int right) {
        return glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS;
    }
    static void note(GLFWwindow* window, InputEvent event, int modifiers) {
        event.shift = (modifiers & GLFW_MOD_SHIFT) != 0;
        event.control = (modifiers & GLFW_MOD_CONTROL) != 0;
        event.alt = (modifiers & GLFW_MOD_ALT) != 0;
        event.place = of(window).pointer();
        of(window).events_.push_back(event);
    }
    static int held_modifiers(GLFWwindow* window) {
        return (held(window, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT) ? GLFW_MOD_SHIFT : 0) |
               (held(window, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL) ? GLFW_MOD_CONTROL : 0) |
               (held(window, GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT) ? GLFW_MOD_ALT : 0);
    }
    static void key(GLFWwindow* window, int key, int scan_code, int action, int modifiers) {
        InputEvent event;
        event.kind = action == GLFW_RELEASE ? InputEvent::Kind::key_release : InputEvent::Kind::key_press;
        event.repeat = action == GLFW_REPEAT;
        event.key = name_of(key, scan_code);
        if (!event.key.empty()) note(window, event, modifiers);
    }
    static void button(GLFWwindow* window, int button, int action, int modifiers) {
        if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
        InputEvent event;
        event.kind = action == GLFW_PRESS ? InputEvent::Kind::button_press : InputEvent::Kind::button_release;
        event.button = button_of(button);
        note(window, event, modifiers);
    }
    // Events that come together keep the places they had.
    static void motion(GLFWwindow* window, double x, double y) {
        glm::ivec2 size(1);
        glfwGetWindowSize(window, &size.x, &size.y);
        // Screen coordinates are not pixels where the desktop scales windows.
        const glm::dvec2 pixels = glm::dvec2(of(window).framebuffer_size()) / glm::dvec2(glm::max(size, glm::ivec2(1)));
        of(window).pointer_ = glm::vec2(glm::dvec2(x, y) * pixels);
        note(window, InputEvent{}, held_modifiers(window));
    }
    static void wheel(GLFWwindow* window, double, double notches) {
        InputEvent event;
        event.kind = InputEvent::Kind::wheel;
        event.notches = static_cast<float>(notches);
        note(window, event, held_modifiers(window));
    }
    static void drop(GLFWwindow* window, int count, const char** paths) {
        for (int i = 0; i < count; ++i) of(window).drops_.emplace_back(paths[i]);
    }
    static void damage(GLFWwindow* window) { of(window).damaged_ = true; }
    static void resize(GLFWwindow* window, int, int) { of(window).damaged_ = true; }
};

Window::Window(const std::string& title, glm::ivec2 size) {
    if (!glfwInit()) throw glfw_error("no window can be opened");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (!window_) {
        const Error error = glfw_error("a window with OpenGL 3.3 cannot be opened");
        glfwTerminate();
        throw error;
    }
    glfwMakeContextCurrent(window_);
    try {
        load_gl(glfwGetProcAddress);
    } catch (...) {
        glfwTerminate();
        throw;
    }
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, Callbacks::key);
    glfwSetMouseButtonCallback(window_, Callbacks::button);
    glfwSetCursorPosCallback(window_, Callbacks::motion);
    glfwSetScrollCallback(window_, Callbacks::wheel);
    glfwSetWindowRefreshCallback(window_, Callbacks::damage);
    glfwSetFramebufferSizeCallback(window_, Callbacks::resize);
    glfwSetDropCallback(window_, Callbacks::drop);
}

Window::~Window() {
    glfwTerminate();
}

void Window::poll_events() {
    glfwPollEvents();
}

void Window::wait_events(double seconds) {
    glfwWaitEventsTimeout(seconds);
}

std::vector<InputEvent> Window::take_events() {
    return std::exchange(events_, {});
}

std::vector<std::string> Window::take_drops() {
    return std::exchange(drops_, {});
}

bool Window::take_damage() {
    return std::exchange(damaged_, false);
}

bool Window::close_requested() const {
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

glm::ivec2 Window::framebuffer_size() const {
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

bool Window::hidden() const {
    return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
}

float Window::content_scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(x, 0.5f, 4.0f);
}

void Window::swap() {
    glfwSwapBuffers(window_);
}

void Window::wake() {
    glfwPostEmptyEvent();
}

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::toggle_full_screen() {
    if (glfwGetWindowMonitor(window_)) {
        glfwSetWindowMonitor(window_, nullptr, windowed_place_.x, windowed_place_.y, windowed_size_.x, windowed_size_.y,
                             GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode) return;
    glfwGetWindowPos(window_, &windowed_place_.x, &windowed_place_.y);
    glfwGetWindowSize(window_, &windowed_size_.x, &windowed_size_.y);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::resize(glm::ivec2 size) {
    glfwSetWindowSize(window_, size.x, size.y);
}

void Window::minimise(bool minimised) {
    minimised ? glfwIconifyWindow(window_) : glfwRestoreWindow(window_);
}

void Window::hide() {
    glfwHideWindow(window_);
    glfwPollEvents();  // sends what was asked of the display
}

std::string Window::clipboard() const {
    const char* text = glfwGetClipboardString(window_);
    return text ? text : "";
}

void Window::set_clipboard(const std::string& text) {
    glfwSetClipboardString(window_, text.c_str());
}

void Window::script(const InputEvent& event) {
    pointer_ = event.place;
    events_.push_back(event);
}

}  // namespace brewster
