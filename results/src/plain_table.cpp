#include "plain_table.hpp"

#include <fmt/format.h>

namespace deixis::results {

namespace {

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

std::string latexNumber(double value, Print print) {
    if (print == Print::p_value && value < 0.001) return "$<$ 0.001";
    std::string text = fmt::format("{:.3f}", value);
    if (text == "-0.000") text = "0.000";
    return text.starts_with('-') ? "$-$" + text.substr(1) : text;
}

struct LatexCell {
    Print print;
    std::string operator()(std::monostate) const { return "--"; }
    std::string operator()(const std::string& text) const { return escapeLatex(text); }
    std::string operator()(double value) const { return latexNumber(value, print); }
    std::string operator()(long long value) const { return fmt::format("{}", value); }
    std::string operator()(bool value) const { return value ? "yes" : "no"; }
};

}  // namespace

PlainCell knownCell(bool known, double value) {
    return known ? PlainCell(value) : PlainCell();
}

PlainCell plainCell(const std::optional<double>& value) {
    return value ? PlainCell(*value) : PlainCell();
}

std::string csvText(const PlainTable& table) {
    std::vector<ColumnSpec> columns;
    for (const PlainColumn& column : table.columns) columns.push_back({column.name, column.type, ""});
    CsvTable csv(std::move(columns));
    for (const auto& row : table.rows) {
        for (const PlainCell& cell : row) {
            if (const auto* text = std::get_if<std::string>(&cell))
                csv.text(*text);
            else if (const auto* number = std::get_if<double>(&cell))
                csv.number(*number);
            else if (const auto* whole = std::get_if<long long>(&cell))
                csv.whole(*whole);
            else if (const auto* truth = std::get_if<bool>(&cell))
                csv.whole(*truth ? 1 : 0);
            else
                csv.empty();
        }
        csv.endRow();
    }
    return csv.take();
}

std::string latexText(const PlainTable& table) {
    std::string format;
    std::string head;
    for (const PlainColumn& column : table.columns) {
        if (column.print == Print::no) continue;
        format += column.type == ColumnType::text ? 'l' : 'r';
        head += (head.empty() ? "" : " & ") +
                (column.heading.empty() ? escapeLatex(column.name) : column.heading);
    }
    std::string out = fmt::format(
        "% \\usepackage{{booktabs}}\n\\begin{{table}}\n\\centering\n\\caption{{{}}}\n\\label{{tab:{}}}\n"
        "\\begin{{tabular}}{{{}}}\n\\toprule\n{} \\\\\n\\midrule\n",
        escapeLatex(table.caption), table.name, format, head);
    for (const auto& row : table.rows) {
        std::string line;
        bool first = true;
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (table.columns[i].print == Print::no) continue;
            line += (first ? "" : " & ") + std::visit(LatexCell{table.columns[i].print}, row[i]);
            first = false;
        }
        out += line + " \\\\\n";
    }
    return out + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

}  // namespace deixis::results
