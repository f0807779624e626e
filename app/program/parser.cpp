#include "app/program/parser.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>

namespace deixis::app {

void rejectUsage(const std::string& where, const std::string& what) {
    throw CLI::ValidationError(where, what);
}

void requireUsage(const std::string& what) {
    throw CLI::RequiredError(what);
}

Option Option::required() {
    option_->required();
    return *this;
}

Option Option::check(const Range& range) {
    if (range.whole)
        option_->check(CLI::Range(static_cast<int>(range.min), static_cast<int>(range.max)));
    else
        option_->check(CLI::Range(range.min, range.max));
    return *this;
}

Option Option::check(Above /*zero*/) {
    option_->check(CLI::PositiveNumber);
    return *this;
}

Option Option::check(FromZero /*on*/) {
    option_->check(CLI::NonNegativeNumber);
    return *this;
}

Option Option::check(const OneOf& words) {
    option_->check(CLI::IsMember(words.words));
    return *this;
}

Option Option::check(std::function<std::string(const std::string&)> problem) {
    option_->check(std::move(problem), "");
    return *this;
}

Option Option::excludes(Option other) {
    option_->excludes(other.option_);
    return *this;
}

Option Option::needs(Option other) {
    option_->needs(other.option_);
    return *this;
}

Option Option::expected(int count) {
    option_->expected(count);
    return *this;
}

Option Option::expected(int min, int max) {
    option_->expected(min, max);
    return *this;
}

Option Option::delimiter(char between) {
    option_->delimiter(between);
    return *this;
}

Option Option::valueName(const std::string& name) {
    option_->type_name(name);
    return *this;
}

Option Option::showDefault() {
    option_->capture_default_str();
    return *this;
}

Option Option::showDefault(const std::string& text) {
    option_->default_str(text);
    return *this;
}

Option Option::defaultValue(const std::string& text) {
    option_->default_val(text);
    return *this;
}

Option Option::oneValueEachTime() {
    option_->allow_extra_args(false);
    return *this;
}

bool Option::given() const {
    return option_->count() > 0;
}

Parser Parser::addCommand(const std::string& name, const std::string& what) const {
    return Parser(*app_->add_subcommand(name, what));
}

bool Parser::hasChosen() const {
    return !app_->get_subcommands().empty();
}

void Parser::requireCommand() const {
    app_->require_subcommand(1);
}

void Parser::takeAllWords() const {
    app_->prefix_command();
}

void Parser::hide() const {
    app_->group("");
}

template <class Value>
Option Parser::addOption(const std::string& names, Value& value, const std::string& what) const {
    return Option(app_->add_option(names, value, what));
}

template Option Parser::addOption(const std::string&, std::string&, const std::string&) const;
template Option Parser::addOption(const std::string&, int&, const std::string&) const;
template Option Parser::addOption(const std::string&, unsigned&, const std::string&) const;
template Option Parser::addOption(const std::string&, std::uint64_t&, const std::string&) const;
template Option Parser::addOption(const std::string&, double&, const std::string&) const;
template Option Parser::addOption(const std::string&, std::optional<int>&, const std::string&) const;
template Option Parser::addOption(const std::string&, std::optional<double>&, const std::string&) const;
template Option Parser::addOption(const std::string&, std::optional<std::string>&, const std::string&) const;
template Option Parser::addOption(const std::string&, std::vector<std::string>&, const std::string&) const;
template Option Parser::addOption(const std::string&, std::vector<int>&, const std::string&) const;
template Option Parser::addOption(const std::string&, std::vector<double>&, const std::string&) const;

Option Parser::addFlag(const std::string& names, bool& value, const std::string& what) const {
    return Option(app_->add_flag(names, value, what));
}

Option Parser::addTextOption(const std::string& names, const std::function<void(const std::string&)>& set,
                             const std::string& what) const {
    return Option(app_->add_option_function<std::string>(names, set, what));
}

Option Parser::addNumberOption(const std::string& names, std::function<void(double)> set,
                               const std::string& what) const {
    return Option(app_->add_option_function<double>(
        names, [set = std::move(set)](const double& value) { set(value); }, what));
}

void Parser::callback(std::function<void()> run) const {
    app_->callback(std::move(run));
}

void Parser::footer(const std::string& text) const {
    app_->footer(text);
}

}  // namespace deixis::app
