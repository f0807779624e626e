// A table in print: LaTeX for the packages booktabs, longtable and graphicx.
#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "results/tables/table.hpp"

namespace deixis::results {

namespace {

constexpr double text_width_pt = 345.0;  // of article at 10 pt, on A4 and letter
constexpr std::size_t max_rows = 35;     // of a page

std::string escapeLatex(std::string_view text) {
    std::string out;
    for (const char c : text) switch (c) {
            case '\\':
                out += "\\textbackslash{}";
                break;
            case '~':
                out += "\\textasciitilde{}";
                break;
            case '^':
                out += "\\textasciicircum{}";
                break;
            // The old font encoding has other signs in these places.
            case '<':
                out += "\\textless{}";
                break;
            case '>':
                out += "\\textgreater{}";
                break;
            case '|':
                out += "\\textbar{}";
                break;
            case '&':
            case '%':
            case '$':
            case '#':
            case '_':
            case '{':
            case '}':
                out += '\\';
                out += c;
                break;
            case '\n':
            case '\r':
            case '\t':
                out += ' ';
                break;
            default:
                if (static_cast<unsigned char>(c) >= 0x20) out += c;
        }
    return out;
}

std::string signedLatex(std::string text) {
    if (text.find_first_not_of("-0.") == std::string::npos && text.starts_with('-')) text.erase(0, 1);
    return text.starts_with('-') ? "$-$" + text.substr(1) : text;
}

std::string latexNumber(double value, Format format) {
    if (format == Format::p_value && value < 0.001) return "$<$ 0.001";
    if (format == Format::rank) return signedLatex(fmt::format("{:.10g}", value));
    return signedLatex(fmt::format("{:.3f}", value));
}

struct LatexCell {
    Format format;
    std::string operator()(std::monostate) const { return "--"; }
    std::string operator()(const std::string& text) const {
        return escapeLatex(format == Format::key ? inWords(text) : text);
    }
    std::string operator()(double value) const { return latexNumber(value, format); }
    std::string operator()(long long value) const { return fmt::format("{}", value); }
    std::string operator()(bool value) const { return value ? "yes" : "no"; }
    std::string operator()(const Interval& of) const {
        if (!of.lower) return "--";
        return fmt::format("{}{}, {}{}", of.lower_included ? '[' : '(', latexNumber(*of.lower, Format::plain),
                           of.upper ? latexNumber(*of.upper, Format::plain) : "--",
                           of.upper_included ? ']' : ')');
    }
    std::string operator()(const JsonValue&) const { return "--"; }
};

bool hasEnds(const Column& column) {
    return column.kind == ColumnKind::estimate && column.ends_in_print;
}

std::string headingOf(const Column& column) {
    return column.latex.empty() ? escapeLatex(inWords(column.name)) : column.latex;
}

/// The cells of one column: of an estimate it and its interval.
std::vector<std::string> cellsOfColumn(const Column& column, const Cell& cell) {
    const auto text = [&](const Cell& of) { return std::visit(LatexCell{column.format}, of.value()); };
    const auto* interval = cell.as<Interval>();
    if (column.kind != ColumnKind::estimate || interval == nullptr) return {text(cell)};
    if (!hasEnds(column)) return {text(interval->estimate)};
    return {text(interval->estimate), text(cell)};
}

/// About how wide a cell is, in letters: commands and braces take no room.
std::size_t lettersOf(const std::string& cell) {
    std::size_t letters = 0;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const auto c = static_cast<unsigned char>(cell[i]);
        if (c == '\\') {
            ++letters;
            while (i + 1 < cell.size() && ((cell[i + 1] >= 'a' && cell[i + 1] <= 'z') || cell[i + 1] == '{'))
                ++i;
        } else if (c != '$' && c != '{' && c != '}' && !continuesCharacter(cell[i])) {
            ++letters;
        }
    }
    return letters;
}

/// What stands between the rules.
struct Body {
    std::string format;
    std::string head;
    std::vector<std::string> rows;
    std::vector<std::string> headings;  ///< above each row; the same for rows that have it in common
    std::size_t columns = 0;
    std::size_t letters = 0;  ///< of the widest cells of all columns
};

Body bodyOf(const Table& table) {
    Body body;
    std::vector<std::size_t> widths;
    const auto add = [&](const std::string& heading, bool text) {
        ++body.columns;
        body.format += text ? 'l' : 'r';
        body.head += (body.head.empty() ? "" : " & ") + heading;
        widths.push_back(lettersOf(heading));
    };
    for (const Column& column : table.columns) {
        if ((column.in & in_print) == 0 || column.heading) continue;
        add(headingOf(column), column.kind == ColumnKind::text);
        if (hasEnds(column)) add("interval", false);
    }
    for (const Table::Row& row : table.rows) {
        std::string heading;
        std::string line;
        std::size_t place = 0;
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            if ((table.columns[i].in & in_print) == 0) continue;
            for (const std::string& cell : cellsOfColumn(table.columns[i], row.cells[i])) {
                if (table.columns[i].heading) {
                    heading += (heading.empty() ? "" : ", ") + cell;
                    continue;
                }
                // After the end of a row a bracket or a star would be its argument.
                if (place == 0 && (cell.starts_with('[') || cell.starts_with('*'))) line += "{}";
                line += (place == 0 ? "" : " & ") + cell;
                widths[place] = std::max(widths[place], lettersOf(cell));
                ++place;
            }
        }
        body.headings.push_back(heading);
        body.rows.push_back(line + " \\\\\n");
    }
    for (const std::size_t width : widths) body.letters += width;
    return body;
}

/// Rows from `from` on, with their headings.
std::string rowsOf(const Body& body, std::size_t from, std::size_t to) {
    std::string out;
    for (std::size_t i = from; i < to; ++i) {
        if (!body.headings[i].empty() && (i == from || body.headings[i] != body.headings[i - 1]))
            out += fmt::format("{}\\multicolumn{{{}}}{{l}}{{\\emph{{{}}}}} \\\\\n",
                               i == from ? "" : "\\addlinespace\n", body.columns, body.headings[i]);
        out += body.rows[i];
    }
    return out;
}

std::string captionOf(const Table& table) {
    const std::string unit = table.unit.words;
    return escapeLatex(table.caption + (unit.empty() ? "" : ". Unit: " + unit));
}

std::string scaledTable(const Table& table, const Body& body, const std::string& size) {
    std::string out;
    const std::size_t parts = (body.rows.size() + max_rows - 1) / max_rows;
    for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t from = part * body.rows.size() / parts;
        const std::size_t to = (part + 1) * body.rows.size() / parts;
        out += fmt::format(
            "\\begin{{table}}\n\\centering\n\\caption{{{}{}}}\n\\label{{tab:{}{}}}\n{}"
            "\\resizebox{{\\textwidth}}{{!}}{{%\n\\begin{{tabular}}{{{}}}\n\\toprule\n{} \\\\\n\\midrule\n{}"
            "\\bottomrule\n\\end{{tabular}}}}\n\\end{{table}}\n",
            captionOf(table), parts > 1 ? fmt::format(" ({} of {})", part + 1, parts) : "", table.name,
            part > 0 ? fmt::format("_{}", part + 1) : "", size, body.format, body.head,
            rowsOf(body, from, to));
    }
    return out;
}

}  // namespace

std::string latexText(const Table& table) {
    constexpr double letter_pt = 5.3;  // a digit has 5, "m" has 8, "i" has 3
    const Body body = bodyOf(table);
    const auto width = [&](double size, double gap_pt) {
        return size * letter_pt * static_cast<double>(body.letters) +
               2.0 * gap_pt * static_cast<double>(body.columns);
    };
    const bool small = width(1.0, 6.0) > text_width_pt;
    const std::string size = small ? "\\footnotesize\n\\setlength{\\tabcolsep}{3pt}\n" : "";
    const std::string packages = "% \\usepackage{booktabs,longtable,graphicx}\n";
    if (small && width(0.82, 3.0) > text_width_pt) return packages + scaledTable(table, body, size);
    const std::string caption =
        fmt::format("\\caption{{{}}}\n\\label{{tab:{}}}", captionOf(table), table.name);
    const std::string rows = rowsOf(body, 0, body.rows.size());
    if (body.rows.size() > max_rows)
        return fmt::format(
            "{}\\begingroup\n{}\\begin{{longtable}}{{{}}}\n{} \\\\\n\\toprule\n{} \\\\\n\\midrule\n"
            "\\endfirsthead\n\\toprule\n{} \\\\\n\\midrule\n\\endhead\n\\bottomrule\n\\endfoot\n{}"
            "\\end{{longtable}}\n\\endgroup\n",
            packages, size, body.format, caption, body.head, body.head, rows);
    return fmt::format(
        "{}\\begin{{table}}\n\\centering\n{}\n{}\\begin{{tabular}}{{{}}}\n\\toprule\n{} \\\\\n\\midrule\n{}"
        "\\bottomrule\n\\end{{tabular}}\n\\end{{table}}\n",
        packages, caption, size, body.format, body.head, rows);
}

}  // namespace deixis::results
