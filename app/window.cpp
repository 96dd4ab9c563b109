#include "app/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

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

/// Letters are those of the keyboard's layout, not of the key's place.
Key key_of(int key, int scan_code) {
    if (key == GLFW_KEY_HOME) return Key::home;
    const char* name = glfwGetKeyName(key, scan_code);
    const std::string letter = name ? name : "";
    return letter == "n" ? Key::n : letter == "p" ? Key::p : letter == "q" ? Key::q : Key::other;
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

    static void note(GLFWwindow* window, InputEvent event, int modifiers) {
        event.shift = (modifiers & GLFW_MOD_SHIFT) != 0;
        event.control = (modifiers & GLFW_MOD_CONTROL) != 0;
        event.place = of(window).pointer();
        of(window).events_.push_back(event);
    }
    static void key(GLFWwindow* window, int key, int scan_code, int action, int modifiers) {
        if (action == GLFW_RELEASE) return;
        InputEvent event;
        event.kind = InputEvent::Kind::key_press;
        event.key = key_of(key, scan_code);
        note(window, event, modifiers);
    }
    static void button(GLFWwindow* window, int button, int action, int modifiers) {
        if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
        InputEvent event;
        event.kind = action == GLFW_PRESS ? InputEvent::Kind::button_press : InputEvent::Kind::button_release;
        event.button = button_of(button);
        note(window, event, modifiers);
    }
    static void motion(GLFWwindow* window, double, double) { note(window, InputEvent{}, 0); }
    static void wheel(GLFWwindow* window, double, double notches) {
        InputEvent event;
        event.kind = InputEvent::Kind::wheel;
        event.notches = static_cast<float>(notches);
        note(window, event, 0);
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

void Window::swap() {
    glfwSwapBuffers(window_);
}

void Window::wake() {
    glfwPostEmptyEvent();
}

glm::vec2 Window::pointer() const {
    glm::dvec2 place(0.0);
    glm::ivec2 size(1);
    glfwGetCursorPos(window_, &place.x, &place.y);
    glfwGetWindowSize(window_, &size.x, &size.y);
    // Screen coordinates are not pixels where the desktop scales windows.
    return glm::vec2(place * glm::dvec2(framebuffer_size()) / glm::dvec2(glm::max(size, glm::ivec2(1))));
}

}  // namespace brewster
