#include "app/window/pressed_keys.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace deixis::app {

void PressedKeys::connect(GLFWwindow* window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int, int action, int) {
        const bool held_too = key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT;
        if (action == GLFW_PRESS || (action == GLFW_REPEAT && held_too))
            static_cast<PressedKeys*>(glfwGetWindowUserPointer(from))->keys_.push_back(key);
    });
}

}  // namespace deixis::app
