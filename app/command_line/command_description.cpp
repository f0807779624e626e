#include "command_description.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/program/option_value.hpp"

namespace deixis::app {

namespace {

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
    const OptionValue value = optionValue(option);
    const bool flag = option.get_items_expected_max() == 0;
    if (option.get_positional())
        out.value = option.get_name(true);
    else if (!flag)
        out.value = value.name;
    out.choices = value.choices;
    out.value_optional = !flag && option.get_items_expected_min() == 0;
    out.repeated = option.get_items_expected_max() > 1;
    out.required = option.get_required();
    out.text = sentence(option.get_description());
    if (option.get_positional() && !out.choices.empty())
        out.text += fmt::format(" One of: {}.", fmt::join(out.choices, ", "));
    if (!value.limits.empty()) out.text += fmt::format(" Allowed: {}.", value.limits);
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
