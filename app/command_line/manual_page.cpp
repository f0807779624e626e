#include "manual_page.hpp"

#include <fmt/format.h>

namespace deixis::app {

namespace {

/// Text that roff prints as it stands, at the begin of a line, too.
std::string plain(const std::string& text) {
    std::string out;
    bool begins = true;
    for (const char c : text) {
        if (begins && (c == '.' || c == '\'')) out += "\\&";
        begins = c == '\n';
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else if (c == '\'')
            out += "\\(aq";
        else
            out += c;
    }
    return out;
}

std::string bold(const std::string& text) {
    return "\\fB" + plain(text) + "\\fR";
}

/// What is to be typed for it: the value's name, or the choices that there are.
std::string valueOf(const OptionDescription& option) {
    std::string out = "\\fI" + plain(option.value) + "\\fR";
    if (!option.choices.empty() && !option.names.empty()) {
        out.clear();
        for (const std::string& one : option.choices) out += (out.empty() ? "" : "|") + bold(one);
    }
    if (option.repeated) out += " ...";
    return option.value_optional ? "[" + out + "]" : out;
}

std::string synopsis(const CommandDescription& command) {
    std::string out = bold(command.name);
    if (!command.commands.empty()) return out + " \\fICOMMAND\\fR";
    for (const OptionDescription& option : command.options) {
        if (!option.names.empty()) continue;
        out += option.required ? " " + valueOf(option) : " [" + valueOf(option) + "]";
    }
    return out + " [\\fIOPTIONS\\fR]";
}

std::string options(const CommandDescription& command) {
    std::string out;
    for (const OptionDescription& option : command.options) {
        if (command.name.find(' ') != std::string::npos && option.names.size() > 1 &&
            option.names[1] == "--help")
            continue;  // told once
        std::string names;
        for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + bold(name);
        out += fmt::format(".TP\n{}{}{}\n{}\n", names, names.empty() || option.value.empty() ? "" : " ",
                           option.value.empty() ? "" : valueOf(option), plain(option.text));
    }
    return out;
}

std::string commands(const CommandDescription& above) {
    std::string out;
    for (const CommandDescription& command : above.commands) {
        out += fmt::format(".SS {}\n{}\n.PP\n{}\n{}", plain(command.name), synopsis(command),
                           plain(command.text), options(command));
        if (!command.footer.empty()) out += fmt::format(".PP\n.nf\n{}\n.fi\n", plain(command.footer));
        out += commands(command);
    }
    return out;
}

constexpr const char* about_all = R"(.SH EXIT STATUS
.TP
.B 0
Done.
.TP
.B 1
Failed; one line on standard error says why.
.TP
.B 2
The command line is wrong.
.SH ENVIRONMENT
.TP
.B DEIXIS_DATA
A folder whose files are taken before those that ship.
.SH FILES
As they lie from the program:
.TP
.I ../share/deixis
Studies, questionnaires, languages, assumed effects, schemas, fonts and the avatar.
.TP
.I ../share/doc/deixis
What is told at length; begin with
.IR quick\-start.md .
)";

}  // namespace

std::string manualPage(const CommandDescription& program, const std::string& version) {
    std::string title = program.text.substr(program.text.find(": ") + 2);
    title.pop_back();  // the full stop
    return fmt::format(".TH DEIXIS 1 \"\" \"{}\" \"User Commands\"\n", version) +
           fmt::format(".SH NAME\ndeixis \\- {}\n", plain(title)) +
           fmt::format(".SH SYNOPSIS\n{} [\\fIARGUMENTS\\fR] [\\fIOPTIONS\\fR]\n", synopsis(program)) +
           ".SH DESCRIPTION\nA participant shares a 3D space with an avatar, rates how natural its pointing "
           "looks, "
           "and finds which of three balls it pointed at. Deixis runs the study from one text file, keeps "
           "every "
           "answer in an SQLite database, and writes the report with the statistics.\n" +
           ".SH OPTIONS\n" + options(program) + ".SH COMMANDS\n" + commands(program) + about_all;
}

}  // namespace deixis::app
