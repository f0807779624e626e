#include "command_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <regex>

namespace deixis::app {

namespace {

std::vector<std::string> split(const std::string& text, char by) {
    std::vector<std::string> out;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(by, at), text.size());
        out.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return out;
}

/// Of "TEXT:{a,b}" a and b.
std::vector<std::string> choicesOf(const std::string& type) {
    std::smatch found;
    if (!std::regex_search(type, found, std::regex(R"(\{([^}]*)\})"))) return {};
    return split(found[1].str(), ',');
}

/// Of "INT:INT in [1 - 9999]" " From 1 to 9999."
std::string limitsOf(const std::string& type) {
    std::smatch found;
    if (std::regex_search(type, found, std::regex(R"( in \[(\S+) - (\S+)\])")))
        return fmt::format(" From {} to {}.", found[1].str(), found[2].str());
    if (type.find(":POSITIVE") != std::string::npos) return " Above 0.";
    if (type.find(":NONNEGATIVE") != std::string::npos) return " 0 or more.";
    return "";
}

std::string shownDefault(const std::string& value) {
    const std::filesystem::path path = value;
    return path.is_absolute() ? path.filename().string() + ", which ships" : value;
}

std::string sentence(std::string text) {
    if (!text.empty() && text.back() != '.') text += '.';
    return text;
}

OptionDescription describeOption(const CLI::Option& option) {
    OptionDescription out;
    for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
    const std::string type = option.get_type_name();
    const bool flag = option.get_items_expected_max() == 0;
    if (option.get_positional())
        out.value = option.get_name(true);
    else if (!flag)
        out.value = type.substr(0, type.find(':'));
    out.choices = choicesOf(type);
    out.value_optional = !flag && option.get_items_expected_min() == 0;
    out.repeated = option.get_items_expected_max() > 1;
    out.required = option.get_required();
    out.text = sentence(option.get_description());
    if (option.get_positional() && !out.choices.empty())
        out.text += fmt::format(" One of: {}.", fmt::join(out.choices, ", "));
    out.text += limitsOf(type);
    for (const CLI::Option* other : option.get_needs())
        out.text += fmt::format(" Needs {}.", other->get_name());
    for (const CLI::Option* other : option.get_excludes())
        out.text += fmt::format(" Not with {}.", other->get_name());
    if (!option.get_default_str().empty() && !flag && !out.value_optional)
        out.text += fmt::format(" Default: {}.", shownDefault(option.get_default_str()));
    if (out.required && !out.names.empty()) out.text += " Must be given.";
    return out;
}

}  // namespace

CommandDescription describe(const CLI::App& app, const std::string& above) {
    CommandDescription out;
    out.name = above.empty() ? app.get_name() : above + " " + app.get_name();
    out.text = sentence(app.get_description());
    out.footer = app.get_footer();
    for (const CLI::Option* option : app.get_options())
        if (!option->get_group().empty()) out.options.push_back(describeOption(*option));
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        if (!command->get_group().empty()) out.commands.push_back(describe(*command, out.name));
    return out;
}

}  // namespace deixis::app
