#include "commands.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "located.hpp"

namespace deixis::conditions {

namespace {

[[noreturn]] void giveUp(const std::string& why) {
    std::fprintf(stderr, "conditions layer: error: %s\n", why.c_str());
    std::abort();
}

/// A line, word by word.
class Line {
  public:
    explicit Line(const std::string& text) : text_(text), words_(text) {}

    std::string word() {
        std::string word;
        if (!(words_ >> word)) bad();
        return word;
    }
    float number() {
        float number = 0.0F;
        if (!(words_ >> number)) bad();
        return number;
    }
    template <typename Value>
    Value oneOf(const std::map<std::string, Value>& choices) {
        const auto found = choices.find(word());
        if (found == choices.end()) bad();
        return found->second;
    }
    [[noreturn]] void bad() const { giveUp("'" + text_ + "' makes no sense"); }

  private:
    std::string text_;
    std::istringstream words_;
};

const std::map<std::string, XrSessionState> states{{"synchronized", XR_SESSION_STATE_SYNCHRONIZED},
                                                   {"visible", XR_SESSION_STATE_VISIBLE},
                                                   {"focused", XR_SESSION_STATE_FOCUSED}};
const std::map<std::string, Tracking> head_trackings{{"tracked", Tracking::tracked},
                                                     {"guessed", Tracking::guessed},
                                                     {"turning", Tracking::turning},
                                                     {"lost", Tracking::lost}};
const std::map<std::string, Tracking> gaze_trackings{
    {"seen", Tracking::tracked}, {"guessed", Tracking::guessed}, {"lost", Tracking::lost}};
const std::map<std::string, Spaces> spaces{{"local_floor", Spaces::local_floor}, {"local", Spaces::local}};
const std::map<std::string, XrResult> losses{{"session", XR_ERROR_SESSION_LOST},
                                             {"instance", XR_ERROR_INSTANCE_LOST}};

/// Frames to wait; 0 after all other commands.
int take(const std::string& text, Conditions& now) {
    Line line(text);
    const std::string what = line.word();
    if (what == "wait") return static_cast<int>(line.number());
    if (what == "headset") {
        now.headset = line.oneOf<bool>({{"missing", false}});
    } else if (what == "spaces") {
        now.spaces = line.oneOf(spaces);
        if (now.spaces == Spaces::local) now.local_height_m = line.number();
    } else if (what == "state") {
        now.max = line.oneOf(states);
    } else if (what == "head") {
        now.head = line.oneOf(head_trackings);
    } else if (what == "gaze") {
        Gaze gaze;
        gaze.tracking = line.oneOf(gaze_trackings);
        gaze.yaw_deg = line.number();
        gaze.pitch_deg = line.number();
        now.gaze = gaze;
    } else if (what == "input") {
        now.input_held = line.oneOf<bool>({{"held", true}, {"passed", false}});
    } else if (what == "recentre") {
        const float x = line.number();
        const float z = line.number();
        const float yaw_deg = line.number();
        now.recentrings.push_back({{turned(yaw_deg, 0.0F), {x, 0.0F, z}}, line.number() / 1e3});
    } else if (what == "exit") {
        now.exit = true;
    } else if (what == "announce") {
        const bool session = line.oneOf<bool>({{"session-loss", true}, {"instance-loss", false}});
        (session ? now.announce_session_loss : now.announce_instance_loss) = true;
    } else if (what == "lose") {
        const XrResult result = line.oneOf(losses);
        now.loss = Loss{result, line.word()};
    } else {
        line.bad();
    }
    return 0;
}

}  // namespace

Commands::Commands() {
    const char* file = std::getenv("DEIXIS_CONDITIONS");
    if (file == nullptr) giveUp("DEIXIS_CONDITIONS names no file of commands");
    file_ = file;
}

void Commands::read(Conditions& conditions, int frame) {
    if (frame < wait_until_) return;
    std::ifstream in(file_, std::ios::binary);
    if (!in) giveUp("there is no file " + file_);
    in.seekg(static_cast<std::streamoff>(read_));
    const std::string added{std::istreambuf_iterator<char>(in), {}};
    // A line without its end is still being written.
    std::size_t start = 0;
    int wait = 0;
    for (std::size_t end = added.find('\n'); end != std::string::npos && wait == 0;
         end = added.find('\n', start)) {
        wait = take(added.substr(start, end - start), conditions);
        start = end + 1;
    }
    wait_until_ = frame + wait;
    read_ += start;
}

}  // namespace deixis::conditions
