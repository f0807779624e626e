// The command line as commands declare it: CLI11's parser behind a front, since each file that includes
// its header takes many seconds to compile. Both classes are handles that may be copied; what they refer
// to lives as long as the program's CLI::App.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace deixis::app {

/// Limits of a number; both ends are allowed. Whole limits show as whole numbers.
struct Range {
    Range(int lowest, int highest) : min(lowest), max(highest), whole(true) {}
    Range(double lowest, double highest) : min(lowest), max(highest) {}
    double min;
    double max;
    bool whole = false;
};
struct Above {};     ///< above 0
struct FromZero {};  ///< 0 or above
/// One of these words.
struct OneOf {
    std::vector<std::string> words;
};

/// Wrong usage that is found when all options are known: exit status 2.
[[noreturn]] void rejectUsage(const std::string& where, const std::string& what);
[[noreturn]] void requireUsage(const std::string& what);

class Option {
  public:
    explicit Option(CLI::Option* option) : option_(option) {}

    Option required();
    Option check(const Range& range);
    Option check(Above limit);
    Option check(FromZero limit);
    Option check(const OneOf& words);
    /// `problem` says what is wrong with a text; empty: nothing.
    Option check(std::function<std::string(const std::string&)> problem);
    Option excludes(Option other);
    Option needs(Option other);
    /// So many values; a negative number: at least this many.
    Option expected(int count);
    Option expected(int min, int max);
    Option delimiter(char between);
    /// A name for the value in help, such as FILE.
    Option valueName(const std::string& name);
    /// Help shows what the variable holds, or this text.
    Option showDefault();
    Option showDefault(const std::string& text);
    /// What the variable holds where the option is not named.
    Option defaultValue(const std::string& text);
    /// Takes one value each time that it is named, not all that follow.
    Option oneValueEachTime();
    /// Whether the command line named it; known when the command runs.
    [[nodiscard]] bool given() const;

  private:
    CLI::Option* option_;
};

class Parser {
  public:
    explicit Parser(CLI::App& app) : app_(&app) {}

    /// A command below this one.
    [[nodiscard]] Parser addCommand(const std::string& name, const std::string& what) const;
    /// Whether the command line named a command below this one; known when the command runs.
    [[nodiscard]] bool hasChosen() const;
    /// One of the commands below must be named.
    void requireCommand() const;
    /// Takes all words that follow, whatever they are.
    void takeAllWords() const;
    /// Leaves the command out of help.
    void hide() const;

    /// `names`: "-o,--output", or FILE for a word without a dash. `value`, which must outlive the parsing, is
    /// set where the option is named. Text, numbers, lists of them, and optional numbers (parser.cpp).
    template <class Value>
    Option addOption(const std::string& names, Value& value, const std::string& what) const;
    Option addFlag(const std::string& names, bool& value, const std::string& what) const;
    /// For values that are more than text or a number: `set` may call rejectUsage.
    Option addTextOption(const std::string& names, const std::function<void(const std::string&)>& set,
                         const std::string& what) const;
    Option addNumberOption(const std::string& names, std::function<void(double)> set,
                           const std::string& what) const;

    /// Runs when the command line named this command, all its options known.
    void callback(std::function<void()> run) const;
    void footer(const std::string& text) const;

    [[nodiscard]] CLI::App& app() const { return *app_; }

  private:
    CLI::App* app_;
};

}  // namespace deixis::app
