#include "app/program/command_help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/program/help_formatter.hpp"
#include "app/program/option_value.hpp"

namespace deixis::app {

namespace {

constexpr std::size_t help_indent = 30;
constexpr std::size_t help_width = 100;

/// The text in lines up to the width, all but the first indented.
std::string wrapped(const std::string& text, std::size_t indent = help_indent) {
    std::string out;
    std::size_t column = indent;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        if (column > indent && column + 1 + word.size() > help_width) {
            out += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (column > indent) {
            out += ' ';
            ++column;
        }
        out += word;
        column += word.size();
        at = end + 1;
    }
    return out;
}

/// A name, and what it means beside or below it.
std::string entry(const std::string& name, const std::string& meaning) {
    const std::string start = "  " + name;
    if (meaning.empty()) return start + "\n";
    const bool beside = start.size() + 2 <= help_indent;
    return fmt::format(
        "{}{}{}\n", start,
        beside ? std::string(help_indent - start.size(), ' ') : "\n" + std::string(help_indent, ' '),
        wrapped(meaning));
}

std::string replacedAll(std::string text, std::string_view from, std::string_view to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

std::string namesOf(const std::set<CLI::Option*>& options) {
    std::vector<std::string> names;
    for (const CLI::Option* one : options) names.push_back(one->get_name());
    std::sort(names.begin(), names.end());
    return fmt::format("{}", fmt::join(names, ", "));
}

/// A default; of several numbers it has its brackets already.
std::string inBrackets(const std::string& text) {
    return text.starts_with('[') ? text : "[" + text + "]";
}

class HelpFormatter : public CLI::Formatter {
  public:
    std::string make_positionals(const CLI::App* app) const override {
        const auto options = app->get_options(
            [](const CLI::Option* one) { return one->get_positional() && !one->nonpositional(); });
        return options.empty() ? "" : make_group("Arguments", true, options);
    }

    std::string make_option(const CLI::Option* option, bool positional) const override {
        if (positional) return entry(make_option_name(option, true), option->get_description());
        // "-o,--output" reads better with a space.
        std::string name = replacedAll(make_option_name(option, false), ",", ", ");
        name = name.substr(0, name.find('{'));  // of "--no-tracking{false}"
        const OptionValue value = optionValue(*option);
        const bool takes_value = option->get_items_expected_max() > 0;
        const bool may_be_left_out = option->get_items_expected_min() == 0;
        const std::string shown =
            value.choices.empty() ? value.name : fmt::format("{}", fmt::join(value.choices, "|"));
        if (takes_value) name += may_be_left_out ? " [" + shown + "]" : " " + shown;
        std::string meaning = option->get_description();
        if (!value.limits.empty()) meaning += fmt::format(" ({})", value.limits);
        if (takes_value && !may_be_left_out && !option->get_default_str().empty())
            meaning += fmt::format(" {}", inBrackets(option->get_default_str()));
        if (option->get_required()) meaning += " (required)";
        if (!option->get_needs().empty()) meaning += fmt::format("; needs {}", namesOf(option->get_needs()));
        if (!option->get_excludes().empty())
            meaning += fmt::format("; not with {}", namesOf(option->get_excludes()));
        return entry(name, meaning);
    }

    std::string make_usage(const CLI::App* app, std::string name) const override {
        std::string out = "\nUsage: " + name;
        for (const CLI::Option* one : app->get_options())
            if (one->get_positional() && !one->nonpositional()) out += " " + make_option_usage(one);
        for (const CLI::Option* one : app->get_options())
            if (one->get_required() && one->nonpositional())
                out += fmt::format(" {} {}",
                                   one->get_snames().empty() ? "--" + one->get_lnames().front()
                                                             : "-" + one->get_snames().front(),
                                   optionValue(*one).name);
        if (!app->get_subcommands([](const CLI::App*) { return true; }).empty()) out += " COMMAND";
        return out + " [OPTIONS]\n";
    }

    std::string make_description(const CLI::App* app) const override { return app->get_description() + "\n"; }

    std::string make_subcommand(const CLI::App* command) const override {
        return entry(command->get_name(), command->get_description());
    }
};

/// By the option's name: what its value is.
const std::map<std::string, std::string, std::less<>>& valueNames() {
    static const std::map<std::string, std::string, std::less<>> names{
        {"--against", "FILE..."},
        {"--accept-changes", "REASON"},
        {"--animation", "NAME"},
        {"--asked", "FILE..."},
        {"--at", "FILE"},
        {"--avatar", "FILE"},
        {"--balls", "FILE"},
        {"--bandwidth", "RULE"},
        {"--between", "COLUMN"},
        {"--chance", "SHARE"},
        {"--column", "MEANING=NAME"},
        {"--columns", "NAMES"},
        {"--csv", "DIR"},
        {"--db", "DATABASE"},
        {"--effect", "FILE"},
        {"--equivalence", "MEASURE=BOUND"},
        {"--from", "FRAME"},
        {"--group", "NAME"},
        {"--json", "FILE"},
        {"--language", "CODE"},
        {"--latex", "DIR"},
        {"--marker", "JOINT"},
        {"--measure", "NAME"},
        {"--meanshift-bandwidth", "METRES"},
        {"--mp4", "FILE"},
        {"--output", "FILE"},
        {"--paired-by", "COLUMN"},
        {"--parameters", "FILE"},
        {"--participant", "ID"},
        {"--picture", "FILE"},
        {"--png", "DIR"},
        {"--r", "DIR"},
        {"--ray", "NAME"},
        {"--reason", "REASON"},
        {"--report", "FILE"},
        {"--save-effects", "FILE"},
        {"--scale", "MEASURE=LOW..HIGH"},
        {"--screenshot", "FILE"},
        {"--size", "WIDTHxHEIGHT"},
        {"--stations", "WHICH"},
        {"--stimuli", "DIR"},
        {"--study", "STUDY"},
        {"--system", "NAME"},
        {"--targets", "FILE"},
        {"--time", "SECONDS..."},
        {"--to", "FRAME"},
        {"--trace", "FILE"},
        {"--training", "FILE"},
        {"--unit", "UNIT"},
        {"--value", "COLUMN"},
        {"--within", "COLUMN"},
    };
    return names;
}

}  // namespace

void describe(Parser command, const CommandText& text) {
    command.footer(fmt::format("Writes: {}\n\nExample:\n  {}\n\nMore: {}", wrapped(text.writes, 8),
                               replacedAll(text.example, "\n", "\n  "), text.page));
}

std::shared_ptr<CLI::FormatterBase> helpFormatter() {
    return std::make_shared<HelpFormatter>();
}

void nameValues(CLI::App& cli) {
    for (CLI::Option* option : cli.get_options()) {
        if (option->get_items_expected_max() == 0 || option->get_lnames().empty() ||
            !option->get_type_name().starts_with("TEXT"))
            continue;
        if (const auto name = valueNames().find("--" + option->get_lnames().front());
            name != valueNames().end())
            option->type_name(name->second);
    }
    for (CLI::App* command : cli.get_subcommands({})) nameValues(*command);
}

}  // namespace deixis::app
