// What is typed at a keyboard, as a session takes it: characters, then how often the last one was erased.
#pragma once

#include <string>
#include <vector>

namespace deixis::app {

class TypedText {
  public:
    void type(char32_t character);
    void erase() { keys_.push_back(0); }

    struct Part {
        std::string typed;  ///< UTF-8
        int erased = 0;     ///< after that
    };
    /// As much of what was typed since as one part can say: what was typed after something had been erased
    /// is left for the next.
    [[nodiscard]] Part take();

  private:
    std::vector<char32_t> keys_;  // 0: erased
};

}  // namespace deixis::app
