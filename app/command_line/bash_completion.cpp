#include "bash_completion.hpp"

#include <fmt/format.h>

namespace deixis::app {

namespace {

struct Tables {
    std::string commands, options, values;  ///< lines of bash's associative arrays
};

void add(std::string& table, const std::string& key, const std::string& words) {
    table += fmt::format("    ['{}']='{}'\n", key, words);
}

/// What may stand for it; @files for any file.
std::string valuesOf(const OptionDescription& option, const KnownWords& known) {
    if (!option.choices.empty()) return fmt::format("{}", fmt::join(option.choices, " "));
    const auto words = known.find(option.names.empty() ? option.value : option.names.back());
    if (words != known.end()) return fmt::format("{}", fmt::join(words->second, " "));
    const bool number = option.value == "NUMBER";
    return number ? "" : "@files";
}

void tabulate(const CommandDescription& command, const KnownWords& known, Tables& tables) {
    std::string commands, options, placed;
    for (const CommandDescription& one : command.commands) {
        commands += (commands.empty() ? "" : " ") + one.name.substr(one.name.rfind(' ') + 1);
        tabulate(one, known, tables);
    }
    for (const OptionDescription& option : command.options) {
        const std::string values = valuesOf(option, known);
        if (option.names.empty() && placed.find(values) == std::string::npos)
            placed += (placed.empty() ? "" : " ") + values;
        for (const std::string& name : option.names) {
            options += (options.empty() ? "" : " ") + name;
            if (!option.value.empty()) add(tables.values, command.name + " " + name, values);
        }
    }
    if (!commands.empty()) add(tables.commands, command.name, commands);
    add(tables.options, command.name, options);
    if (!placed.empty()) add(tables.values, command.name, placed);
}

constexpr const char* script = R"sh(
_deixis() {
    local cur=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=deixis words i
    # "--option=value" comes as three words.
    if [[ $cur == = ]]; then
        cur=
    elif [[ $before == = ]]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    for ((i = 1; i < COMP_CWORD; ++i)); do
        [[ " ${_deixis_commands[$command]-} " != *" ${COMP_WORDS[i]} "* ]] || command+=" ${COMP_WORDS[i]}"
    done
    if [[ $before == -* && -n ${_deixis_values["$command $before"]+known} ]]; then
        words=${_deixis_values["$command $before"]}
    elif [[ $cur == -* ]]; then
        words=${_deixis_options[$command]}
    else
        words="${_deixis_commands[$command]-} ${_deixis_values[$command]-}"
    fi
    COMPREPLY=()
    if [[ " $words " == *" @files "* ]]; then
        compopt -o filenames 2>/dev/null
        mapfile -t COMPREPLY < <(compgen -W "${words//@files/}" -- "$cur"; compgen -f -- "$cur")
    else
        compopt +o default 2>/dev/null
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur")
    fi
}
complete -o default -F _deixis deixis
)sh";

}  // namespace

std::string bashCompletion(const CommandDescription& program, const KnownWords& known) {
    Tables tables;
    tabulate(program, known, tables);
    return "# Completion of deixis's command line in bash, written by the program when it was built.\n"
           "# Global, since bash-completion reads this within a function.\n" +
           fmt::format("declare -gA _deixis_commands=(\n{})\n", tables.commands) +
           fmt::format("declare -gA _deixis_options=(\n{})\n", tables.options) +
           fmt::format("# @files: any file.\ndeclare -gA _deixis_values=(\n{})\n", tables.values) + script;
}

}  // namespace deixis::app
